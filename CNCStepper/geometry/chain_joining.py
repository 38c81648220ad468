# SPDX-License-Identifier: LGPL-2.1-or-later
"""Loose pieces of a drawing, in any order and direction, as chains; what nearly meets is reported with its place.

Ends within `same_mm` of each other meet. Where two meet, their pieces become one; where more meet, those
two that continue straightest, then the next two. A piece keeps its drawn direction where its chain allows.

        a ---->---- b ----<---- c        ends at b meet: one chain a b c, its second piece turned round
                       d ----            b and d lie apart by more than `same_mm`, by less than `near_mm`: a Gap
"""

from __future__ import annotations

from array import array
from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from CNCStepper.errors import GeometryError, Text
from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.curve_bundle import Bundle, bundle_of, runs
from CNCStepper.geometry.curve_columns import Segments, complex_of
from CNCStepper.tolerances import COINCIDENT_MM, JOINED_ENDS_MM

NEAR_MM = 1.0
MEASURED = 16_384  # pieces that are measured at once
MOST_PAIRS = 2_000_000  # of ends that lie close together
WIDER, SMALLEST_SQUARE_MM = 1.0 + 1e-6, 1e-3  # a square of ends is wider than their distance, however it is rounded
HALF, FAR_SQUARE = 32, 1 << 30  # bits of a square's number along each axis, and what makes it positive


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
    del lengths_mm
    loose = np.flatnonzero(long & ~closed).astype(np.int32)
    if not len(loose):
        return pieces.where(long), np.flatnonzero(long), ()
    partner = _partners(pieces, loose, same_mm)
    entered, lengths = _walks(array("i", partner.tobytes()))
    heads = np.cumsum(lengths) - lengths
    ends_met = partner[entered[heads]] == entered[heads + lengths - 1] ^ 1
    del partner, heads
    whole = np.flatnonzero(long & closed).astype(np.int32)  # a closed piece stays as it is
    entered = np.concatenate([2 * whole, 2 * loose[entered // 2] + entered % 2])
    lengths = np.concatenate([np.ones(len(whole), int), lengths])
    first = np.minimum.reduceat(entered, np.cumsum(lengths) - lengths) // 2
    order = np.argsort(first, kind="stable")
    snapped = np.concatenate([np.zeros(len(whole), bool), ends_met])
    if len(whole):  # else they are in order
        entered = entered[runs((np.cumsum(lengths) - lengths)[order], lengths[order])]
    chains = _assembled(pieces, entered, lengths[order])
    del entered, lengths
    _snap(chains, snapped[order])
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


def _partners(pieces: Bundle, loose: np.ndarray, same_mm: float) -> np.ndarray:
    """Return the end that follows each end of loose pieces, int32[2 n], -1 for none; end 2 i begins piece i."""
    places = _places_of(pieces, loose)
    pairs = _close_pairs(places, same_mm)
    partner = np.full(len(places), -1, np.int32)
    del places
    meetings = np.bincount(pairs.ravel(), minlength=len(partner)).astype(np.int32)
    alone = (meetings[pairs] == 1).all(axis=1)
    del meetings
    partner[pairs[alone, 0]], partner[pairs[alone, 1]] = pairs[alone, 1], pairs[alone, 0]
    for ends_here in _groups(pairs[~alone]):
        meeting = np.array(ends_here)
        outward = _outward(pieces, loose, meeting)
        rows = np.triu_indices(len(meeting), 1)
        one, other = (meeting[index] for index in rows)
        turns = np.abs(np.angle(-outward[rows[0]] / outward[rows[1]]))
        order = np.lexsort((other, one, turns))  # the straightest first
        for a, b in zip(one[order].tolist(), other[order].tolist(), strict=True):
            if partner[a] < 0 and partner[b] < 0:
                partner[a], partner[b] = b, a
    return partner


def _places_of(pieces: Bundle, which: np.ndarray) -> np.ndarray:
    """Return where the ends of some pieces lie, complex128[2 n]."""
    first, places = pieces.first, np.empty((len(which), 2, 2))
    for at in range(0, len(which), MEASURED):
        own = which[at : at + MEASURED]
        begin = first[own] + own
        places[at : at + MEASURED, 0], places[at : at + MEASURED, 1] = (
            pieces.xy[begin],
            pieces.xy[begin + pieces.counts[own]],
        )
    return places.view(complex).reshape(-1)


def _outward(pieces: Bundle, loose: np.ndarray, ends: np.ndarray) -> np.ndarray:
    """Return in which direction ends of loose pieces leave their piece, complex128[k]."""
    which, is_last = loose[ends // 2], ends % 2
    segment = pieces.first[which] + is_last * (pieces.counts[which] - 1)
    corners = complex_of(pieces.xy[np.column_stack([segment, segment + 1]) + which[:, None]].reshape(-1, 2))
    segments = Segments(corners[::2], corners[1::2], 4.0 * np.arctan(pieces.bulge[segment]))
    return np.where(is_last, segments.direction(1.0), -segments.direction(0.0))


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
    """Return the pairs of places within a distance of each other, int32[k, 2], ascending, the lower one first.

    The places are sorted by squares hardly wider than the distance; each meets those of its own square and of the four
    behind it.
    """
    square_mm = max(within_mm * WIDER, SMALLEST_SQUARE_MM)
    key = np.empty(len(places), np.int64)
    for first in range(0, len(places), MEASURED):
        squares = np.floor(places[first : first + MEASURED].view(float) / square_mm).astype(np.int64) + FAR_SQUARE
        key[first : first + MEASURED] = (squares[::2] << HALF) + squares[1::2]
    order = np.argsort(key, kind="stable").astype(np.int32)
    key.sort(kind="stable")
    _require_apart(key, within_mm)
    found = [np.empty((0, 2), np.int32)]
    for first in range(0, len(key), MEASURED):
        rows = np.arange(first, min(first + MEASURED, len(key)))
        for behind in (0, 1, (1 << HALF) - 1, 1 << HALF, (1 << HALF) + 1):
            begin = rows + 1 if not behind else np.searchsorted(key, key[rows] + behind)
            counts = np.searchsorted(key, key[rows] + behind, "right") - begin
            one, other = order[np.repeat(rows, counts)], order[runs(begin, counts)]
            apart = places[one] - places[other]
            near = np.sqrt(apart.real**2 + apart.imag**2) <= within_mm
            found.append(np.sort(np.column_stack([one[near], other[near]]), axis=1))
    pairs = np.concatenate(found)
    del key, order, found
    return pairs[np.lexsort(pairs.T[::-1])]


def _require_apart(keys: np.ndarray, within_mm: float) -> None:
    """Raise GeometryError where so many places lie in one square that their pairs fill the memory; keys ascend."""
    if not len(keys):
        return
    counts = np.diff(np.flatnonzero(np.diff(keys, prepend=keys[0] - 1, append=keys[-1] + 1)))
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


def _walks(partner: array[int]) -> tuple[np.ndarray, np.ndarray]:
    """Return the ends at which pieces are entered, int32[n], chain after chain, and how many each has, int64[c].

    Each chain has the sense of its first piece.
    """
    done, entered, lengths = bytearray(len(partner) // 2), array("i"), array("q")
    for piece in range(len(done)):
        if not done[piece]:
            walk = _followed(partner, 2 * piece)
            if partner[walk[-1] ^ 1] != 2 * piece:  # it does not go round and back
                behind = _followed(partner, 2 * piece + 1)[1:]
                walk = array("i", [end ^ 1 for end in reversed(behind)]) + walk
            entered += walk
            lengths.append(len(walk))
            for end in walk:
                done[end // 2] = True
    return np.frombuffer(entered, np.int32), np.frombuffer(lengths, np.int64)


def _followed(partner: array[int], entered: int) -> array[int]:
    """Return the ends at which pieces are entered from this one on, to the chain's end or once round."""
    walk = array("i", [entered])
    while (following := partner[walk[-1] ^ 1]) not in (-1, entered):
        walk.append(following)
    return walk


def _assembled(pieces: Bundle, entered: np.ndarray, lengths: np.ndarray) -> Bundle:
    """Return a chain for each walk, `lengths` pieces long; each piece begins where the one before it ended.

    `entered` is the end at which each piece is entered.
    """
    counts = pieces.counts[entered // 2]
    ends = np.cumsum(lengths)
    heads = ends - lengths  # the first piece of each chain
    chain_counts = np.add.reduceat(counts, heads) if len(heads) else counts
    vertices = np.concatenate([[0], np.cumsum(chain_counts + 1)])  # where each chain begins
    xy, bulge, first = np.empty((int(vertices[-1]), 2)), np.empty(int(counts.sum())), pieces.first
    chain = 0
    while chain < len(lengths):
        following = max(int(np.searchsorted(ends, heads[chain] + MEASURED, "right")), chain + 1)
        own = slice(int(heads[chain]), int(ends[following - 1]))
        places = slice(int(vertices[chain]), int(vertices[following]))
        segments = slice(places.start - chain, places.stop - following)
        begins = heads[chain:following] - own.start, vertices[chain:following] - places.start
        _assemble(pieces, first, entered[own], begins, xy[places], bulge[segments])
        chain = following
    return Bundle(xy, bulge, chain_counts)


def _assemble(
    pieces: Bundle,
    first: np.ndarray,
    entered: np.ndarray,
    begins: tuple[np.ndarray, np.ndarray],
    xy: np.ndarray,
    bulge: np.ndarray,
) -> None:
    """Write the vertices and bulges of some chains; `begins`: the first piece and the first vertex of each."""
    heads, starts = begins
    piece, turned = entered // 2, entered % 2 == 1
    counts = pieces.counts[piece]
    place = np.arange(counts.sum()) - np.repeat(np.cumsum(counts) - counts, counts)
    back = np.repeat(turned, counts)
    segment = np.repeat(first[piece], counts) + np.where(back, np.repeat(counts, counts) - 1 - place, place)
    inner = np.ones(len(xy), bool)
    inner[starts] = False
    xy[inner] = pieces.xy[segment + np.repeat(piece, counts) + ~back]  # the vertex at which each segment ends
    xy[starts] = pieces.xy[(first[piece] + piece + np.where(turned, counts, 0))[heads]]
    bulge[:] = np.where(back, -pieces.bulge[segment], pieces.bulge[segment])


def _snap(chains: Bundle, closed: np.ndarray) -> None:
    """Make the last vertex the first one of those chains that are closed, bool[c]."""
    begin = chains.first + np.arange(len(closed))
    chains.xy[(begin + chains.counts)[closed]] = chains.xy[begin[closed]]


def _gaps(chains: Bundle, near_mm: float) -> tuple[Gap, ...]:
    """Return the gaps between ends of open chains, each end in one gap at most."""
    opened = np.flatnonzero(~chains.closed)
    return tuple(Gap(_middle(ends), abs(ends[0] - ends[1])) for _, ends in _meeting(chains, opened, near_mm))


def nearly_meeting(chains: Sequence[Curve], near_mm: float) -> list[tuple[tuple[int, int], tuple[complex, complex]]]:
    """Return the pairs of ends of open chains within a distance, nearest first, and where they lie; each end once.

    End 2 i begins chain i, end 2 i + 1 ends it. The ends of one chain that is hardly longer than their distance are no
    pair.
    """
    return _meeting(bundle_of(chains), np.arange(len(chains)), near_mm) if chains else []


def _meeting(
    chains: Bundle, opened: np.ndarray, near_mm: float
) -> list[tuple[tuple[int, int], tuple[complex, complex]]]:
    """Return what `nearly_meeting` does, of the open ones among some chains, counted among themselves."""
    ends = _places_of(chains, opened)
    pairs = _close_pairs(ends, near_mm)
    sizes = np.abs(ends[pairs[:, 0]] - ends[pairs[:, 1]])
    taken: set[int] = set()
    found = []
    for row in np.argsort(sizes, kind="stable").tolist():
        a, b = pairs[row].tolist()
        if not taken & {a, b} and not _is_whole(chains, opened, a, b, float(sizes[row])):
            taken |= {a, b}
            found.append(((a, b), (complex(ends[a]), complex(ends[b]))))
    return found


def _middle(ends: tuple[complex, complex]) -> tuple[float, float]:
    middle = (ends[0] + ends[1]) / 2.0
    return middle.real, middle.imag


def _is_whole(chains: Bundle, opened: np.ndarray, a: int, b: int, size_mm: float) -> bool:
    """Return whether two ends are those of one short chain, which has its length between them and no gap."""
    if a // 2 != b // 2:
        return False
    (length_mm,), _ = _measured(chains.taken(opened[[a // 2]]))
    return bool(length_mm < 2.0 * size_mm)
