# SPDX-License-Identifier: LGPL-2.1-or-later
"""How deep the tool enters material that must stay.

What is to stay is the stock without the removals. At height z the tool may be in U(z): every removal
whose bottom lies at or below z, and the air beside the stock. A point q of the tool at height z lies

    min( top - z,  min over the removals' bottoms b of  hypot( beyond(q, U(b)), max(b - z, 0) ) )

deep in it: the way up, the way to the wall, the way up to the floor. The deepest point of a disc of
radius r whose centre lies s inside a smooth wall is r - s beyond it. That bounds every wall from above,
so a bound finds the worst pieces of path, and points on their discs then give the exact value.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import cached_property, partial

import numpy as np
import shapely

from CNCStepper.simulation.cutter_solid import Cutter
from CNCStepper.simulation.exact.edge_tree import EdgeTree, flat_edges
from CNCStepper.simulation.exact.segment_blocks import Blocks, joined
from CNCStepper.simulation.exact.wall_distance import Region, climbed, zoomed
from CNCStepper.simulation.stock import HeightField
from CNCStepper.simulation.tip_segments import Segments, shortened, split_ramps
from CNCStepper.tolerances import SAME_HEIGHT_MM, WORST_PLACE_MM

SMALL_MM = 0.0003  # what flattening may add; less is no gouge
FIELD_STEP_MM = 1.0  # over a height field a piece counts with the highest top near parts of this length
RAMP_STEP_MM = 0.05  # a ramp counts with the lower end of parts of this height
WORST_PIECES = 64
FEW_PIECES = 4  # of these are computed first: they often show that no other can be worse
COARSE_DISCS = 32  # by which pieces that enter nothing are sorted out
FACE_RINGS = 12  # on the face of a cutter that is not flat
MOST_AT_ONCE = 2_000_000  # discs of pieces
MOST_PARTS = 500_000  # into which ramps are cut at once
MOST_RANKED = WORST_PIECES * 1023  # pieces that are held by falling bound
ROUND_RAD = np.arange(72) * np.pi / 36


@dataclass(frozen=True)
class Worst:
    """The worst of its kind: how much, where (work coordinates), and the row of the table that is to blame."""

    depth_mm: float = 0.0
    place_mm: tuple[float, ...] | None = None
    row: int = -1


@dataclass(frozen=True)
class ProtectedMaterial:
    """What is to stay: U(b) by falling bottom b, between the stock's bottom and top, or under a field's heights."""

    bottoms_mm: tuple[float, ...]
    regions: tuple[Region, ...]
    top_mm: float
    stock_bottom_mm: float
    field: HeightField | None = None

    def tops(self, pieces: Segments, radius_mm: float) -> np.ndarray:
        """Return the highest top that a cutter of that radius can meet on each piece, float64[n]."""
        if self.field is None:
            return np.full(len(pieces), self.top_mm)
        low = np.minimum(pieces.begin, pieces.end)[:, :2] - radius_mm
        return self.field.highest_mm(low, np.maximum(pieces.begin, pieces.end)[:, :2] + radius_mm)

    def depth(self, points: np.ndarray, z_mm: np.ndarray) -> np.ndarray:
        """Return how deep points float64[n, 2] at heights z lie in material that must stay."""
        depth = (self.top_mm if self.field is None else self.field.tops_at(points)) - z_mm
        for bottom_mm, region in zip(self.bottoms_mm, self.regions, strict=True):
            up_mm = np.maximum(bottom_mm - z_mm, 0)
            open_ = np.flatnonzero(depth > up_mm)  # the distance up to the floor is too long for the others
            depth[open_] = np.minimum(depth[open_], np.hypot(region.beyond(points[open_]), up_mm[open_]))
        return np.maximum(depth, 0.0)


@dataclass(frozen=True)
class Entries:
    """Pieces of path of one cutter with what bounds their gouge: the disc that enters deepest."""

    cutter: Cutter
    pieces: Segments
    bound_mm: np.ndarray
    height_mm: np.ndarray  # of that disc above the tip
    radius_mm: np.ndarray

    def __getitem__(self, which: np.ndarray | slice) -> Entries:
        columns = (self.bound_mm, self.height_mm, self.radius_mm)
        return Entries(self.cutter, self.pieces[which], *(column[which] for column in columns))


@dataclass(frozen=True)
class PathEntries:
    """The entries of one cutter's path, computed again block after block at each iteration.

    engraves: which of some entries are no gouge, but engrave, bool[n].
    """

    cutter: Cutter
    blocks: Blocks
    kept: ProtectedMaterial
    engraves: Callable[[Entries], np.ndarray]

    def __iter__(self) -> Iterator[tuple[Entries, Entries]]:
        """Yield the entries that cut an area, and those that engrave."""
        for pieces in self.blocks:
            for some in self._short(pieces):
                found = entries(self.cutter, some, self.kept, self.lowest_mm)
                engraved = self.engraves(found)
                yield found[~engraved], found[engraved]

    @cached_property
    def lowest_mm(self) -> float:
        """The lowest height of the tip, but not below the stock."""
        lowest_mm = min((float(pieces.low_mm.min(initial=np.inf)) for pieces in self.blocks), default=np.inf)
        return min(max(lowest_mm, self.kept.stock_bottom_mm), self.kept.top_mm)

    def before(self, place: tuple[float, ...], row: int) -> Iterator[Entries]:
        """Yield the entries that cut an area, of the rows before one, that may reach a place."""
        lowest_mm, near = self.lowest_mm, Blocks(self.blocks, partial(_before, place, row, self.cutter.radius_mm))
        path = replace(self, blocks=near)
        path.__dict__["lowest_mm"] = lowest_mm
        yield from (rest for rest, _ in path)

    def _short(self, pieces: Segments) -> Iterator[Segments]:
        """Yield the pieces in runs that are cut into MOST_PARTS parts or a few more."""
        way = np.abs(pieces.end - pieces.begin)
        parts = 1.0 + way[:, 2] / RAMP_STEP_MM
        if self.kept.field is not None:
            parts *= 1.0 + np.hypot(way[:, 0], way[:, 1]) / max(self.cutter.radius_mm, FIELD_STEP_MM)
        run = (np.cumsum(parts) // MOST_PARTS).astype(np.int64)
        for some in np.split(np.arange(len(run)), np.flatnonzero(np.diff(run)) + 1):
            yield pieces if len(some) == len(pieces) else pieces[some]


def _before(place: tuple[float, ...], row: int, radius_mm: float, pieces: Segments) -> Segments:
    """Return the pieces of the rows before one whose box is within a radius of a place."""
    near = pieces.row < row
    for axis in range(2):
        near &= np.minimum(pieces.begin[:, axis], pieces.end[:, axis]) <= place[axis] + radius_mm + WORST_PLACE_MM
        near &= np.maximum(pieces.begin[:, axis], pieces.end[:, axis]) >= place[axis] - radius_mm - WORST_PLACE_MM
    return pieces[near]


def entries(cutter: Cutter, pieces: Segments, kept: ProtectedMaterial, lowest_mm: float) -> Entries:
    """Return the pieces (ramps in short parts) with the bound of their gouge.

    lowest_mm: of the whole path's tips; the discs that stand for the cutter depend on it.
    """
    pieces = split_ramps(pieces, RAMP_STEP_MM)
    if kept.field is not None:
        pieces = shortened(pieces, max(cutter.radius_mm, FIELD_STEP_MM))
    inside = np.stack([region.inside(pieces) for region in kept.regions]) if kept.regions else None
    tip = np.maximum(pieces.low_mm, kept.stock_bottom_mm)
    tops = kept.tops(pieces, cutter.radius_mm)
    heights, radii = cutter.discs(kept.top_mm - lowest_mm)
    bound, height, radius = np.zeros(len(pieces)), np.zeros(len(pieces)), np.full(len(pieces), cutter.radius_mm)
    every = np.arange(len(pieces))
    for part in _parts(every, COARSE_DISCS):
        bound[part] = _bound(_of(inside, part), tip[part], tops[part], kept, *_hull(heights, radii))[0]
    for part in _parts(every[bound > SMALL_MM], len(heights)):
        bound[part], disc = _bound(_of(inside, part), tip[part], tops[part], kept, heights, radii)
        height[part], radius[part] = heights[disc], radii[disc]
    return Entries(cutter, pieces, bound, height, radius)


def _of(inside: np.ndarray | None, part: np.ndarray) -> np.ndarray | None:
    return None if inside is None else inside[:, part]


def _parts(rows: np.ndarray, discs: int) -> list[np.ndarray]:
    """Return the rows in parts small enough for an array of all their discs."""
    return np.array_split(rows, 1 + len(rows) * discs // MOST_AT_ONCE)


def _hull(heights: np.ndarray, radii: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return few discs that surely enter as deep as the many: each as low as the last and as wide as the next."""
    some = np.unique(np.linspace(0, len(heights) - 1, COARSE_DISCS + 1).astype(int))
    return heights[some[: max(len(some) - 1, 1)]], radii[some[min(len(some) - 1, 1) :]]


def _bound(inside, tip, tops, kept: ProtectedMaterial, heights, radii) -> tuple[np.ndarray, np.ndarray]:
    """Return for each piece the deepest entry of its discs, and which disc that is."""
    z = tip[:, None] + heights
    depth = tops[:, None] - z
    for k, bottom_mm in enumerate(kept.bottoms_mm):
        beyond = np.maximum(radii - inside[k][:, None], 0.0)
        depth = np.minimum(depth, np.hypot(beyond, np.maximum(bottom_mm - z, 0.0)))
    disc = depth.argmax(axis=1) if len(depth) else np.zeros(0, np.int64)
    return np.maximum(depth[np.arange(len(depth)), disc], 0.0), disc


class Ranked:
    """The entries of a path that may gouge deepest, by falling bound: MOST_RANKED of them, then those behind them.

    last: bound and number of the one that these come after.
    """

    def __init__(self, path: PathEntries, last: tuple[float, int] = (np.inf, -1)):
        self.path, self._last = path, last
        self.top: Entries | None = None
        self.are_all = True  # that the path has
        self._numbers = np.zeros(0, np.int64)  # of the top ones, in the order of the path
        self._seen = 0

    def add(self, found: Entries) -> None:
        """Take the next entries of the path."""
        numbers = self._seen + np.arange(len(found.bound_mm))
        self._seen += len(numbers)
        bound_mm, (last_mm, last) = found.bound_mm, self._last
        later = (bound_mm < last_mm) | ((bound_mm == last_mm) & (numbers > last))
        open_ = (bound_mm > SMALL_MM) & later
        self.are_all &= bool(later.all())
        if self.top is None or open_.any():
            top = found[open_] if self.top is None else _joined(self.top, found[open_])
            numbers = np.r_[self._numbers, numbers[open_]]
            order = np.argsort(-top.bound_mm, kind="stable")
            self.are_all &= len(order) <= MOST_RANKED
            self.top, self._numbers = top[order[:MOST_RANKED]], numbers[order[:MOST_RANKED]]

    def behind(self) -> Ranked | None:
        """Return the entries behind these; None where there are none."""
        if self.top is None or len(self._numbers) < MOST_RANKED:
            return None
        further = Ranked(self.path, (float(self.top.bound_mm[-1]), int(self._numbers[-1])))
        for rest, _ in self.path:
            further.add(rest)
        return further

    def before(self, place: tuple[float, ...], row: int) -> Iterator[Entries]:
        """Yield at least the path's entries of the rows before one that reach a place."""
        if self.are_all and self.top is not None:
            return iter([self.top])
        return self.path.before(place, row)


def _joined(some: Entries, more: Entries) -> Entries:
    columns = (np.r_[getattr(some, name), getattr(more, name)] for name in ("bound_mm", "height_mm", "radius_mm"))
    return Entries(some.cutter, joined([some.pieces, more.pieces]), *columns)


def deepest(ranked: Ranked, kept: ProtectedMaterial) -> Worst:
    """Return the exact deepest gouge of a path.

    Pieces are looked at by falling bound, until no bound is deeper than what was found: slivers between removals that
    touch give many pieces a large bound, among which a true gouge would hide.
    """
    best, count = Worst(), WORST_PIECES
    further: Ranked | None = ranked
    while further and further.top:
        top, first = further.top, 0
        while first < len(top.bound_mm) and top.bound_mm[first] > best.depth_mm + SAME_HEIGHT_MM:
            here = _deepest_of(top[first : first + count], ranked, kept)
            best = max(best, here, key=lambda worst: worst.depth_mm)
            first, count = first + count, 2 * count
        further = further.behind() if first >= len(top.bound_mm) else None
    return best


def _deepest_of(worst: Entries, found: Ranked, kept: ProtectedMaterial) -> Worst:
    """Return the deepest gouge of some pieces, of all those found."""
    centres, index = _centres(worst.pieces, kept)
    centres, index = _promising(centres, index, worst, kept)
    tip = np.maximum(centres[:, 2], kept.stock_bottom_mm)
    best = _best_on_discs(centres, tip, index, worst, kept, np.tile(ROUND_RAD, (len(centres), 1)), (0.0, 0.5, 1.0))
    fine = best.angle + np.linspace(-np.pi / 36, np.pi / 36, 201)
    fine_best = _best_on_discs(
        centres[[best.centre]], tip[[best.centre]], index[[best.centre]], worst, kept, fine[None, :], (1.0,)
    )
    best = max(best, fine_best, key=lambda candidate: candidate.depth)
    place = _climbed_inside(best, worst, kept) if worst.cutter.is_flat else _on_face(best, centres, index, worst, kept)
    depth = float(kept.depth(np.array([place[:2]]), np.array([place[2]]))[0])
    return Worst(depth, place, _first_row(place, found, kept, int(worst.pieces.row[best.piece])))


def _promising(
    centres: np.ndarray, index: np.ndarray, worst: Entries, kept: ProtectedMaterial
) -> tuple[np.ndarray, np.ndarray]:
    """Return the centres of those pieces that can enter deeper than the first few do, by more than nothing."""
    few = index < FEW_PIECES
    angles = np.tile(ROUND_RAD, (int(few.sum()), 1))
    tip = np.maximum(centres[few, 2], kept.stock_bottom_mm)
    best = _best_on_discs(centres[few], tip, index[few], worst, kept, angles, (0.0, 0.5, 1.0))
    rest = (index == best.piece) | (worst.bound_mm[index] > best.depth + SAME_HEIGHT_MM)
    return centres[rest], index[rest]


def _first_row(place: tuple[float, ...], found: Ranked, kept: ProtectedMaterial, row: int) -> int:
    """Return the row that cuts the place first: not the one that leaves a hole, but the one that makes it."""
    first = row
    for some in found.before(place, row):
        earlier = some.pieces[(some.bound_mm > SMALL_MM) & (some.pieces.row < row)]
        rise = place[2] - np.maximum(earlier.low_mm, kept.stock_bottom_mm)
        beside = shapely.distance(shapely.linestrings(flat_edges(earlier)), shapely.Point(place[:2]))
        cuts = (rise >= -WORST_PLACE_MM) & (beside <= some.cutter.radius_at(rise) + WORST_PLACE_MM)
        first = min(first, int(earlier.row[cuts].min(initial=row)))
    return first


def _climbed_inside(best: _Best, worst: Entries, kept: ProtectedMaterial) -> tuple[float, ...]:
    """Return the place moved to where it is deepest within the discs of those pieces that go as low."""
    z_mm = best.place[2]
    tip = np.maximum(worst.pieces.low_mm, kept.stock_bottom_mm)
    lower = tip + worst.height_mm <= z_mm + 1e-9
    path, radius_mm = EdgeTree.of_pieces(worst.pieces[lower]), float(worst.radius_mm[lower].min())

    def depth(points: np.ndarray) -> np.ndarray:
        within = path.distance(points) <= radius_mm
        return np.where(within, kept.depth(points, np.full(len(points), z_mm)), -1.0)

    (found,) = climbed(np.array([best.place[:2]]), depth, step_mm=radius_mm / 8, stop_mm=1e-4)
    climbed_place = (*found.tolist(), z_mm)
    return climbed_place if depth(found[None, :])[0] > best.depth else best.place


def _on_face(
    best: _Best, centres: np.ndarray, index: np.ndarray, worst: Entries, kept: ProtectedMaterial
) -> tuple[float, ...]:
    """Return the deepest place on the lower face of a cutter that is not flat.

    At any place seen from above the tool enters deepest where it is lowest, so that only x and y are looked for:
    first about each centre, then ever finer where that was deepest, against all pieces that go as low.
    """
    cutter = worst.cutter
    radius, angle = cutter.radius_mm * np.arange(1, FACE_RINGS + 1) / FACE_RINGS, ROUND_RAD[::2]
    face = np.stack([np.outer(radius, np.cos(angle)), np.outer(radius, np.sin(angle))], axis=2).reshape(-1, 2)
    rise = cutter.heights_at(np.repeat(radius * (1 - 1e-12), len(angle)))
    points = (centres[:, None, :2] + face).reshape(-1, 2)
    tips = np.maximum(centres[:, 2], kept.stock_bottom_mm)
    k = int(kept.depth(points, (tips[:, None] + rise).ravel()).argmax())
    tip = float(tips[k // len(face)])
    lower = np.maximum(worst.pieces.low_mm, kept.stock_bottom_mm) <= tip + 1e-9
    lower[index[k // len(face)]] = True
    path = EdgeTree.of_pieces(worst.pieces[lower])

    def height(places: np.ndarray) -> np.ndarray:
        return tip + cutter.heights_at(path.distance(places))

    def depth(places: np.ndarray) -> np.ndarray:
        z = height(places)
        return np.where(np.isfinite(z), kept.depth(places, np.where(np.isfinite(z), z, 0.0)), -1.0)

    starts = np.array([points[k], best.place[:2]])
    place = zoomed(starts[depth(starts).argmax()], depth, cutter.radius_mm / FACE_RINGS, stop_mm=1e-5)
    found = (*place.tolist(), float(height(place[None, :])[0]))
    return found if depth(place[None, :])[0] > best.depth else best.place


@dataclass(frozen=True)
class _Best:
    depth: float
    place: tuple[float, ...]
    centre: int
    piece: int
    angle: float


def _best_on_discs(centres, tip, index, worst: Entries, kept: ProtectedMaterial, angles: np.ndarray, shares) -> _Best:
    """Return the deepest of points on the discs about the centres, at these angles and shares of the radius."""
    arms = np.stack([np.cos(angles), np.sin(angles)], axis=2)
    reach = worst.radius_mm[index][:, None] * np.asarray(shares)
    points = centres[:, None, None, :2] + reach[:, :, None, None] * arms[:, None, :, :]
    z = np.broadcast_to((tip + worst.height_mm[index])[:, None, None], points.shape[:3])
    depth = kept.depth(points.reshape(-1, 2), z.ravel())
    k = int(depth.argmax())
    centre, _, angle = np.unravel_index(k, points.shape[:3])
    place = (*points.reshape(-1, 2)[k].tolist(), float(z.ravel()[k]))
    return _Best(float(depth[k]), place, int(centre), int(index[centre]), float(angles[centre, angle]))


def _centres(pieces: Segments, kept: ProtectedMaterial) -> tuple[np.ndarray, np.ndarray]:
    """Return both ends of the pieces and their points nearest to each wall, with the index of the piece."""
    points = [pieces.begin, pieces.end]
    flat = flat_edges(pieces)
    for region in kept.regions:
        edge, _ = region.edges.nearest(flat)
        if len(region.edges.edges):
            ways = shapely.shortest_line(*(shapely.linestrings(edges) for edges in (flat, region.edges.edges[edge])))
            points.append(_on_pieces(shapely.get_coordinates(ways)[::2], pieces))
    return np.vstack(points), np.tile(np.arange(len(pieces)), len(points))


def _on_pieces(flat: np.ndarray, pieces: Segments) -> np.ndarray:
    """Return points float64[n, 2] on the pieces seen from above with their heights; on a plunge the lower end's."""
    length = np.hypot(*(pieces.end - pieces.begin)[:, :2].T)
    share = np.hypot(*(flat - pieces.begin[:, :2]).T) / np.where(length > 0, length, 1.0)
    height = pieces.begin[:, 2] + (pieces.end - pieces.begin)[:, 2] * share
    return np.column_stack([flat, np.where(length > 0, height, pieces.low_mm)])
