# SPDX-License-Identifier: LGPL-2.1-or-later
"""Loose pieces of a drawing, in any order and direction, as chains; what nearly meets is reported with its place.

Ends within `same_mm` of each other meet. Where two meet, their pieces become one; where more meet, those
two that continue straightest, then the next two. A piece keeps its drawn direction where its chain allows.

        a ---->---- b ----<---- c        ends at b meet: one chain a b c, its second piece turned round
                       d ----            b and d lie apart by more than `same_mm`, by less than `near_mm`: a Gap
"""

from __future__ import annotations

import operator
from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import shapely

from CNCStepper.errors import GeometryError, Text
from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.curve_columns import Segments, complex_of
from CNCStepper.tolerances import COINCIDENT_MM, JOINED_ENDS_MM

NEAR_MM = 1.0
MOST_PAIRS = 2_000_000  # of ends that lie close together


@dataclass(frozen=True)
class Gap:
    """Two ends of chains that nearly meet: a point halfway between them and how far they are apart."""

    place_mm: tuple[float, float]
    size_mm: float


def chained(
    pieces: Sequence[Curve], same_mm: float = JOINED_ENDS_MM, near_mm: float = NEAR_MM
) -> tuple[tuple[Curve, ...], tuple[Gap, ...]]:
    """Return the pieces as chains, in the order of their first pieces, and the gaps left, the smallest first.

    A piece no longer than `same_mm` lies within one place: what it would join is joined without it.
    """
    chains, gaps = numbered_chains(pieces, same_mm, near_mm)
    return tuple(chains.values()), gaps


def numbered_chains(
    pieces: Sequence[Curve], same_mm: float = JOINED_ENDS_MM, near_mm: float = NEAR_MM
) -> tuple[dict[int, Curve], tuple[Gap, ...]]:
    """Return the chains and gaps as `chained` does, each chain under the number of its first piece, ascending."""
    lengths_mm, closed = _measures(pieces)
    long = {number: pieces[number] for number in np.flatnonzero(lengths_mm > same_mm).tolist()}
    loose = [number for number in long if not closed[number]]
    partner = _partners([long[number] for number in loose], same_mm)
    chains = {number: piece for number, piece in long.items() if closed[number]}
    loose_chains = []
    for walk in _walks(partner):
        parts = [long[loose[end // 2]] if end % 2 == 0 else long[loose[end // 2]].reversed() for end in walk]
        chain = chains[loose[min(walk) // 2]] = _one(parts, closed=partner[walk[0]] == walk[-1] ^ 1)
        loose_chains += [] if chain.closed else [(loose[min(walk) // 2], chain)]
    loose_chains.sort(key=operator.itemgetter(0))
    return dict(sorted(chains.items())), _gaps([chain for _, chain in loose_chains], near_mm)


def _measures(pieces: Sequence[Curve]) -> tuple[np.ndarray, np.ndarray]:
    """Return how long each piece is and whether it is closed, of all pieces at once."""
    if not pieces:
        return np.empty(0), np.empty(0, bool)
    counts = np.array([len(piece.bulge) for piece in pieces])
    last = np.cumsum(counts + 1) - 1  # the last vertex of each piece
    vertices = complex_of(np.concatenate([piece.xy for piece in pieces]))
    chords_mm = np.delete(np.abs(np.diff(vertices)), last[:-1])
    half_rad = 2.0 * np.arctan(np.abs(np.concatenate([piece.bulge for piece in pieces])))
    lengths_mm = chords_mm / np.sinc(half_rad / np.pi)  # of an arc: chord half / sin(half)
    first_rows = np.cumsum(counts) - counts
    return np.add.reduceat(lengths_mm, first_rows), np.abs(vertices[last] - vertices[last - counts]) <= COINCIDENT_MM


def _partners(pieces: Sequence[Curve], same_mm: float) -> np.ndarray:
    """Return the end that follows each end, int64[2 n], -1 for none; end 2 i begins piece i, 2 i + 1 ends it."""
    partner = np.full(2 * len(pieces), -1)
    places, outward = _ends(pieces)
    for meeting in _groups(places, same_mm):
        if len(meeting) == 2:
            first, second = meeting
            partner[first], partner[second] = second, first
            continue
        ends = np.array(meeting)
        one, other = (ends[index] for index in np.triu_indices(len(ends), 1))
        turns = np.abs(np.angle(-outward[one] / outward[other]))
        order = np.lexsort((other, one, turns))  # the straightest first
        for a, b in zip(one[order].tolist(), other[order].tolist(), strict=True):
            if partner[a] < 0 and partner[b] < 0:
                partner[a], partner[b] = b, a
    return partner


def _ends(pieces: Sequence[Curve]) -> tuple[np.ndarray, np.ndarray]:
    """Return where all ends lie and in which direction each leaves its piece, complex128[2 n] both."""
    if not pieces:
        return np.empty(0, complex), np.empty(0, complex)
    xy = np.array([piece.xy[index] for piece in pieces for index in (0, 1, -2, -1)])
    ends = complex_of(xy).reshape(-1, 2)  # rows: the first and the last segment of each piece in turn
    sweep = 4.0 * np.arctan([piece.bulge[index] for piece in pieces for index in (0, -1)])
    segments = Segments(ends[:, 0], ends[:, 1], sweep)
    first = np.arange(len(ends)) % 2 == 0
    places = np.where(first, segments.begin, segments.end)
    return places, np.where(first, -segments.direction(0.0), segments.direction(1.0))


def _groups(places: np.ndarray, same_mm: float) -> list[list[int]]:
    """Return the places that meet at least one other within `same_mm`, by groups, all in ascending order."""
    root = np.arange(len(places))
    for a, b in _close_pairs(places, same_mm).tolist():
        low, high = sorted((_root_of(root, a), _root_of(root, b)))
        root[high] = low
    groups = defaultdict(list)
    for place in range(len(places)):
        groups[_root_of(root, place)].append(place)
    return [group for group in groups.values() if len(group) > 1]


def _close_pairs(places: np.ndarray, within_mm: float) -> np.ndarray:
    """Return the pairs of places within a distance of each other, int64[k, 2], ascending, the lower one first."""
    _require_apart(places, within_mm)
    points = shapely.points(places.real, places.imag)
    one, other = shapely.STRtree(points).query(points, predicate="dwithin", distance=within_mm)
    pairs = np.column_stack([one, other])[one < other]
    return pairs[np.lexsort(pairs.T[::-1])]


def _require_apart(places: np.ndarray, within_mm: float) -> None:
    """Raise GeometryError where so many places lie close to each other that their pairs fill the memory."""
    if not len(places):
        return
    _, counts = np.unique(
        np.floor(places.real / within_mm) + 1j * np.floor(places.imag / within_mm), return_counts=True
    )
    pairs = float((counts.astype(float) ** 2).sum() / 2.0)
    if pairs > MOST_PAIRS:
        raise GeometryError(
            "chains-crowded",
            Text("too many ends of lines lie within {within_mm:g} mm of each other", within_mm=within_mm),
            value=Text("{counts} at one place", counts=int(counts.max())),
            limit=f"{MOST_PAIRS} pairs",
            advice="correct the drawing's unit, or take out what is drawn twice",
        )


def _root_of(root: np.ndarray, place: int) -> int:
    while root[place] != place:
        root[place] = root[root[place]]
        place = int(root[place])
    return place


def _walks(partner: np.ndarray) -> list[list[int]]:
    """Return each chain as the ends at which its pieces are entered, in the sense of its first piece."""
    done, walks = np.zeros(len(partner) // 2, bool), []
    for piece in range(len(done)):
        if not done[piece]:
            forward = _followed(partner, 2 * piece)
            if partner[forward[-1] ^ 1] == 2 * piece:
                walks.append(forward)  # round and back
            else:
                behind = _followed(partner, 2 * piece + 1)[1:]
                walks.append([end ^ 1 for end in reversed(behind)] + forward)
            done[np.array(walks[-1]) // 2] = True
    return walks


def _followed(partner: np.ndarray, entered: int) -> list[int]:
    """Return the ends at which pieces are entered from this one on, to the chain's end or once round."""
    walk = [entered]
    while (following := int(partner[walk[-1] ^ 1])) not in (-1, entered):
        walk.append(following)
    return walk


def _one(parts: Sequence[Curve], closed: bool) -> Curve:
    """Return pieces as one curve; each begins where the one before it ended, however little it was off."""
    xy = np.vstack([parts[0].xy[:1], *(part.xy[1:] for part in parts)])
    if closed:
        xy[-1] = xy[0]
    return Curve.trusted(xy, np.concatenate([part.bulge for part in parts]))


def _gaps(chains: Sequence[Curve], near_mm: float) -> tuple[Gap, ...]:
    """Return the gaps between ends, each end in one gap at most."""
    return tuple(Gap(_middle(ends), abs(ends[0] - ends[1])) for _, ends in nearly_meeting(chains, near_mm))


def nearly_meeting(chains: Sequence[Curve], near_mm: float) -> list[tuple[tuple[int, int], tuple[complex, complex]]]:
    """Return the pairs of ends of open chains within a distance, nearest first, and where they lie; each end once.

    End 2 i begins chain i, end 2 i + 1 ends it. The ends of one chain that is hardly longer than their distance are no
    pair.
    """
    ends = complex_of(np.array([chain.xy[index] for chain in chains for index in (0, -1)]).reshape(-1, 2))
    pairs = _close_pairs(ends, near_mm)
    sizes = np.abs(ends[pairs[:, 0]] - ends[pairs[:, 1]])
    taken: set[int] = set()
    found = []
    for row in np.argsort(sizes, kind="stable").tolist():
        a, b = pairs[row].tolist()
        if not taken & {a, b} and not _is_whole(chains, a, b, float(sizes[row])):
            taken |= {a, b}
            found.append(((a, b), (complex(ends[a]), complex(ends[b]))))
    return found


def _middle(ends: tuple[complex, complex]) -> tuple[float, float]:
    middle = (ends[0] + ends[1]) / 2.0
    return middle.real, middle.imag


def _is_whole(chains: Sequence[Curve], a: int, b: int, size_mm: float) -> bool:
    """Return whether two ends are those of one short chain, which has its length between them and no gap."""
    return a // 2 == b // 2 and chains[a // 2].length_mm < 2.0 * size_mm
