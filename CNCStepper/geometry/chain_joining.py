# SPDX-License-Identifier: LGPL-2.1-or-later
"""Loose pieces of a drawing, in any order and direction, as chains; what nearly meets is reported with its place.

Ends within `same_mm` of each other meet. Where two meet, their pieces become one; where more meet, those
two that continue straightest, then the next two. A piece keeps its drawn direction where its chain allows.

        a ---->---- b ----<---- c        ends at b meet: one chain a b c, its second piece turned round
                       d ----            b and d lie apart by more than `same_mm`, by less than `near_mm`: a Gap
"""

from __future__ import annotations

import itertools
from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import shapely

from CNCStepper.errors import GeometryError, Text
from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.curve_bundle import Bundle, bundle_of
from CNCStepper.geometry.curve_columns import Segments, complex_of
from CNCStepper.tolerances import COINCIDENT_MM, JOINED_ENDS_MM

NEAR_MM = 1.0
MEASURED = 16_384  # pieces that are measured at once
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
    if not pieces:
        return {}, ()
    chains, first, gaps = joined_bundle(bundle_of(pieces), same_mm, near_mm)
    found = zip(first.tolist(), chains.curves(), strict=True)
    return {number: pieces[number] if pieces[number].closed else chain for number, chain in found}, gaps


def joined_bundle(
    pieces: Bundle, same_mm: float = JOINED_ENDS_MM, near_mm: float = NEAR_MM
) -> tuple[Bundle, np.ndarray, tuple[Gap, ...]]:
    """Return the pieces as chains, the number of each one's first piece, int64[c] ascending, and the gaps left."""
    lengths_mm, closed = _measures(pieces)
    long = lengths_mm > same_mm
    loose = np.flatnonzero(long & ~closed)
    if not len(loose):
        return pieces.where(long), np.flatnonzero(long), ()
    partner = _partners(_ends_of(pieces, loose), same_mm)
    walks = [[2 * number] for number in np.flatnonzero(long & closed).tolist()]
    snapped = [False] * len(walks)  # a closed piece stays as it is
    numbers = loose.tolist()
    for walk in _walks(partner.tolist()):
        walks.append([2 * numbers[end // 2] + end % 2 for end in walk])
        snapped.append(partner[walk[0]] == walk[-1] ^ 1)
    first = np.array([min(walk) // 2 for walk in walks], np.int64)
    order = np.argsort(first)
    chains = _assembled(pieces, [walks[number] for number in order.tolist()], np.array(snapped, bool)[order])
    return chains, first[order], _gaps(chains, near_mm)


def _measures(pieces: Bundle) -> tuple[np.ndarray, np.ndarray]:
    """Return how long each piece is and whether it is closed."""
    found = [_measured(block) for block in pieces.blocks(MEASURED)]
    lengths_mm, closed = zip(*found, strict=True) if found else ([np.empty(0)], [np.empty(0, bool)])
    return np.concatenate(lengths_mm), np.concatenate(closed)


def _measured(pieces: Bundle) -> tuple[np.ndarray, np.ndarray]:
    """Return what `_measures` does, of all pieces at once."""
    last = np.cumsum(pieces.counts + 1) - 1  # the last vertex of each piece
    vertices = complex_of(pieces.xy)
    chords_mm = np.delete(np.abs(np.diff(vertices)), last[:-1])
    half_rad = 2.0 * np.arctan(np.abs(pieces.bulge))
    lengths_mm = chords_mm / np.sinc(half_rad / np.pi)  # of an arc: chord half / sin(half)
    apart_mm = np.abs(vertices[last] - vertices[last - pieces.counts])
    return np.add.reduceat(lengths_mm, pieces.first), apart_mm <= COINCIDENT_MM


def _partners(ends: tuple[np.ndarray, np.ndarray], same_mm: float) -> np.ndarray:
    """Return the end that follows each end, int64[2 n], -1 for none; end 2 i begins piece i, 2 i + 1 ends it.

    `ends` are their places and in which direction each leaves its piece.
    """
    places, outward = ends
    partner = np.full(len(places), -1)
    pairs = _close_pairs(places, same_mm)
    alone = (np.bincount(pairs.ravel(), minlength=len(places))[pairs] == 1).all(axis=1)
    partner[pairs[alone]] = pairs[alone, ::-1]
    for ends_here in _groups(pairs[~alone]):
        meeting = np.array(ends_here)
        one, other = (meeting[index] for index in np.triu_indices(len(meeting), 1))
        turns = np.abs(np.angle(-outward[one] / outward[other]))
        order = np.lexsort((other, one, turns))  # the straightest first
        for a, b in zip(one[order].tolist(), other[order].tolist(), strict=True):
            if partner[a] < 0 and partner[b] < 0:
                partner[a], partner[b] = b, a
    return partner


def _ends_of(pieces: Bundle, which: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return where all ends of some pieces lie and in which direction each leaves its piece, complex128[2 n] both."""
    first, count = pieces.first[which], pieces.counts[which]
    begin = first + which  # the first vertex of each
    vertices = np.column_stack([begin, begin + 1, begin + count - 1, begin + count]).reshape(-1, 2)
    ends = complex_of(pieces.xy)[vertices]  # rows: the first and the last segment of each piece in turn
    sweep = 4.0 * np.arctan(pieces.bulge[np.column_stack([first, first + count - 1]).ravel()])
    segments = Segments(ends[:, 0], ends[:, 1], sweep)
    is_first = np.arange(len(ends)) % 2 == 0
    places = np.where(is_first, segments.begin, segments.end)
    return places, np.where(is_first, -segments.direction(0.0), segments.direction(1.0))


def _groups(pairs: np.ndarray) -> list[list[int]]:
    """Return the ends that meet by pairs as groups, all in ascending order."""
    root: dict[int, int] = {}
    for a, b in pairs.tolist():
        low, high = sorted((_root_of(root, a), _root_of(root, b)))
        root[high] = low
    groups = defaultdict(list)
    for end in sorted(root):
        groups[_root_of(root, end)].append(end)
    return list(groups.values())


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


def _root_of(root: dict[int, int], end: int) -> int:
    root.setdefault(end, end)
    while root[end] != end:
        root[end] = root[root[end]]
        end = root[end]
    return end


def _walks(partner: list[int]) -> list[list[int]]:
    """Return each chain as the ends at which its pieces are entered, in the sense of its first piece."""
    done, walks = bytearray(len(partner) // 2), []
    for piece in range(len(done)):
        if not done[piece]:
            walk = _followed(partner, 2 * piece)
            if partner[walk[-1] ^ 1] != 2 * piece:  # it does not go round and back
                behind = _followed(partner, 2 * piece + 1)[1:]
                walk = [end ^ 1 for end in reversed(behind)] + walk
            walks.append(walk)
            for end in walk:
                done[end // 2] = True
    return walks


def _followed(partner: list[int], entered: int) -> list[int]:
    """Return the ends at which pieces are entered from this one on, to the chain's end or once round."""
    walk = [entered]
    while (following := partner[walk[-1] ^ 1]) not in (-1, entered):
        walk.append(following)
    return walk


def _assembled(pieces: Bundle, walks: Sequence[Sequence[int]], closed: np.ndarray) -> Bundle:
    """Return a chain for each walk; each piece begins where the one before it ended, however little it was off.

    The last vertex becomes the first where `closed`, bool[c].
    """
    entered = np.fromiter(itertools.chain.from_iterable(walks), np.int64)
    piece, turned = entered // 2, entered % 2 == 1
    counts = pieces.counts[piece]
    place = np.arange(counts.sum()) - np.repeat(np.cumsum(counts) - counts, counts)
    back = np.repeat(turned, counts)
    segment = np.repeat(pieces.first[piece], counts) + np.where(back, np.repeat(counts, counts) - 1 - place, place)
    end = segment + np.repeat(piece, counts) + ~back  # the vertex at which each segment ends
    heads = np.cumsum([0, *map(len, walks)])[:-1]  # the first piece of each chain
    chain_counts = np.add.reduceat(counts, heads) if len(heads) else counts
    begin = np.cumsum(chain_counts + 1) - chain_counts - 1  # the first vertex of each chain
    xy = np.empty((len(end) + len(heads), 2))
    inner = np.ones(len(xy), bool)
    inner[begin] = False
    xy[inner] = pieces.xy[end]
    xy[begin] = pieces.xy[(pieces.first[piece] + piece + np.where(turned, counts, 0))[heads]]
    xy[(begin + chain_counts)[closed]] = xy[begin[closed]]
    return Bundle(xy, np.where(back, -pieces.bulge[segment], pieces.bulge[segment]), chain_counts)


def _gaps(chains: Bundle, near_mm: float) -> tuple[Gap, ...]:
    """Return the gaps between ends of open chains, each end in one gap at most."""
    opened = chains.where(~chains.closed)
    found = nearly_meeting(opened.curves(), near_mm) if len(opened.counts) else []
    return tuple(Gap(_middle(ends), abs(ends[0] - ends[1])) for _, ends in found)


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
