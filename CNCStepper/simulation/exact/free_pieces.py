# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which pieces a program cuts free from a sheet, in which order, and what it cuts into them afterwards.

Each cut takes a band as wide as the kerf. What no band takes is left as pieces. What a band takes and no earlier one
has taken is that cut's own part of the sheet, which connects the pieces beside it until it is cut:

    +-----------+     pieces      R (the rest), A, B
    | R +---+-+ |     own parts   1: round A and B,  2: between A and B
    |   | A |B| |     forwards    cut 1 sets A + 2 + B free from R; cut 2 then cuts into what is free
    |   +---+-+ |     backwards   giving back 2 joins A and B; giving back 1 joins that to R
    +-----------+

So the cuts are gone through backwards with sets that only ever join. The rest is the largest piece at the sheet's edge.
A piece is free from the moment at which its set has no longer joined the rest; the own parts in that set belong to cuts
that come later, which therefore cut into something that nothing holds. One pass, no union for every cut.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
import shapely
from shapely.geometry import Polygon
from shapely.geometry.base import BaseGeometry

from CNCStepper.simulation.check_context import CheckContext, Cutting
from CNCStepper.simulation.cutter_solid import Tools
from CNCStepper.simulation.exact.sheet_cuts import PathPieces, SheetCuts
from CNCStepper.simulation.stock import Stock
from CNCStepper.tolerances import SAME_MM

SLIVER_MM = 0.02  # narrower pieces are rounding
QUAD_SEGMENTS = 8  # of the round ends of a kerf
SHORT_KERFS = 4  # pieces of a wire's one cut are at least that many kerfs long
CUSP_KERFS = 1.5  # from where two kerfs touch, to the far end of the cusp between them
MOST_SAMPLES = 400  # on the edge of a piece, where it is looked up what has cut it
DECIMALS = 6
NEAR_MM = 0.03  # an edge lies half a kerf from the path, within that


@dataclass(frozen=True)
class LaterCut:
    """A cut that goes into a piece which is free already."""

    row: int
    line: int
    place_mm: tuple[float, float]


@dataclass(frozen=True)
class FreePiece:
    """A piece that no more of the sheet holds.

    shape: what is left of it at the program's end, without what is cut into it later. row, line, end_s: with which it
    comes free; end_s is NaN where times were not told. cut: the number of that cut. at_edge: it is at the sheet's edge.
    later: what cuts into it once it is free, in the order of the rows.
    """

    shape: BaseGeometry
    row: int
    line: int
    end_s: float
    cut: int
    at_edge: bool
    later: list[LaterCut]

    @property
    def centre_mm(self) -> tuple[float, float]:
        """Its centre of area."""
        centre = self.shape.centroid
        return centre.x, centre.y

    @property
    def smaller_extent_mm(self) -> float:
        """The smaller side of the box round it."""
        low_x, low_y, high_x, high_y = self.shape.bounds
        return min(high_x - low_x, high_y - low_y)


@dataclass(frozen=True)
class Freed:
    """The pieces that a program has cut free, in order, and the rest of the whole sheet."""

    free: list[FreePiece]
    pieces: list[Polygon]


@dataclass(frozen=True)
class SheetVerdict:
    """The cuts of a program over a sheet, and what they cut free; None for a program that is too long for that."""

    cuts: SheetCuts
    freed: Freed | None

    @property
    def free(self) -> list[FreePiece]:
        """The pieces that come free, in order; none where that is not known."""
        return self.freed.free if self.freed else []

    def told(self) -> list[dict[str, Any]]:
        """Return the free pieces, in order, as the report has them; areas and lengths are rounded to 0.000001."""
        return [
            {
                "area_mm2": round(piece.shape.area, DECIMALS),
                "centre_mm": [round(value, DECIMALS) for value in piece.centre_mm],
                "falls_at_line": piece.line,
                "falls_at_s": round(piece.end_s, DECIMALS) if np.isfinite(piece.end_s) else None,
            }
            for piece in self.free
        ]


def sheet_verdict(
    subject: CheckContext, cutting: Cutting, tools: Tools, stock: Stock | None, ends_s: np.ndarray | None = None
) -> SheetVerdict:
    """Return the pieces that a program cuts free of a sheet; ends_s: the end of every row, float64[n], where known."""
    cuts = SheetCuts(cutting, tools, stock)
    cuts.see(subject, ends_s)
    return SheetVerdict(cuts, freed_pieces(cuts))


def freed_pieces(sheet_cuts: SheetCuts) -> Freed | None:
    """Return the pieces that a program cuts free; None for a program that is too long."""
    if not sheet_cuts.is_complete:
        return None
    path = sheet_cuts.moving
    if not len(path):
        return Freed([], [sheet_cuts.sheet])
    unit = _units(path, sheet_cuts.cutting.process.power == "always")
    return _Sheet(path, unit, sheet_cuts.sheet).freed()


def _units(path: PathPieces, is_one_cut: bool) -> np.ndarray:
    """Return into which unit each segment goes, int64[n]: its cut, or of a wire's cut a piece of some length."""
    if not is_one_cut:
        return np.unique(path.cut, return_inverse=True)[1]
    length = np.hypot(path.ends_mm[:, 2] - path.ends_mm[:, 0], path.ends_mm[:, 3] - path.ends_mm[:, 1])
    stretch = (np.cumsum(length) // np.maximum(2 * SHORT_KERFS * path.radius_mm, SAME_MM)).astype(np.int64)
    new = (np.diff(stretch, prepend=-1) != 0) | (np.diff(path.cut, prepend=-1) != 0)
    return np.cumsum(new) - 1


class _Sheet:
    """A sheet, the bands that units of the path take of it, and the pieces that are left."""

    def __init__(self, path: PathPieces, unit: np.ndarray, sheet: Polygon):
        self.path, self.unit, self.sheet = path, unit, sheet
        self.firsts = np.flatnonzero(np.diff(unit, prepend=-1))
        bands = self._bands()
        self.own, self.own_unit = self._own_parts(bands)
        left = shapely.difference(sheet, shapely.union_all(bands))
        pieces = shapely.get_parts(left)
        self.pieces = pieces[~shapely.is_empty(shapely.buffer(pieces, -SLIVER_MM / 2))]
        self.is_at_edge = shapely.intersects(sheet.exterior, self.pieces)

    def freed(self) -> Freed:
        """Return the pieces that come free, in order."""
        if not len(self.pieces):
            return Freed([], [])
        found = [self._piece(unit, nodes) for unit, nodes in _Sets(self).separated()]
        return Freed(sorted((one for one in found if one), key=lambda one: one.row), self.pieces.tolist())

    @cached_property
    def rest(self) -> int:
        """The number of the piece that counts as the rest of the sheet."""
        area = shapely.area(self.pieces)
        return int(np.where(self.is_at_edge, area, area - area.max() - 1).argmax())

    def neighbours(self) -> np.ndarray:
        """Return pairs of nodes that touch, the pieces first and the own parts behind them, int64[n, 2]."""
        tree, count = shapely.STRtree(self.own), len(self.pieces)
        piece, own = tree.query(self.pieces, predicate="dwithin", distance=SAME_MM)
        one, other = tree.query(self.own, predicate="dwithin", distance=SAME_MM)
        apart = one < other
        return np.vstack([np.column_stack([piece, own + count]), np.column_stack([one, other])[apart] + count])

    def _bands(self) -> np.ndarray:
        """Return the kerf of each unit, object[units]."""
        chained = (self.path.ends_mm[1:, :2] == self.path.ends_mm[:-1, 2:]).all(axis=1)
        new = np.append(True, ~chained | (np.diff(self.unit) != 0))
        chain = np.cumsum(new) - 1
        index = np.concatenate([chain, chain[new]])
        points = np.concatenate([self.path.ends_mm[:, 2:], self.path.ends_mm[new, :2]])
        order = np.lexsort([np.r_[np.ones(len(chain)), np.zeros(int(new.sum()))], index])
        lines = shapely.linestrings(points[order], indices=index[order])
        bands = shapely.buffer(lines, self.path.radius_mm[new], quad_segs=QUAD_SEGMENTS)
        of_unit = self.unit[new]
        if len(of_unit) == len(self.firsts):
            return bands
        parts = np.split(bands, np.flatnonzero(np.diff(of_unit)) + 1)
        return np.array([shapely.union_all(part) for part in parts])

    def _own_parts(self, bands: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return what of the sheet each band takes and no earlier one has, as polygons, with their units."""
        shapely.prepare(self.sheet)
        own = bands.copy()
        beside = np.flatnonzero(~shapely.covers(self.sheet, bands))
        own[beside] = shapely.intersection(bands[beside], self.sheet)
        later, earlier = shapely.STRtree(bands).query(bands, predicate="intersects")
        which = earlier < later
        later, earlier = later[which], earlier[which]
        order = np.argsort(later, kind="stable")
        later, earlier = later[order], earlier[order]
        for unit, some in zip(np.unique(later), np.split(earlier, np.flatnonzero(np.diff(later)) + 1), strict=False):
            own[unit] = shapely.difference(own[unit], shapely.union_all(bands[some]))
        parts, number = shapely.get_parts(own, return_index=True)
        wide = (shapely.get_type_id(parts) == shapely.GeometryType.POLYGON) & ~shapely.is_empty(
            shapely.buffer(parts, -SLIVER_MM / 2)
        )
        return parts[wide], number[wide]

    def _piece(self, unit: int, nodes: list[int]) -> FreePiece | None:
        """Return the piece that a unit sets free; nodes: its pieces and own parts. None where only slivers are left."""
        count = len(self.pieces)
        numbers = np.array([node for node in nodes if node < count], int)
        own = np.array([node - count for node in nodes if node >= count and not self._closes(unit, node - count)], int)
        if not len(numbers):
            return None
        segment = self._closing_segment(unit, self.pieces[numbers])
        first = self.firsts[self.own_unit[own]]
        later = [
            LaterCut(int(self.path.row[at]), int(self.path.line[at]), _place(self.own[number]))
            for at, number in sorted(zip(first.tolist(), own.tolist(), strict=True))
        ]
        shapes = self.pieces[numbers]
        return FreePiece(
            shapes[0] if len(shapes) == 1 else shapely.multipolygons(shapes),
            int(self.path.row[segment]),
            int(self.path.line[segment]),
            float(self.path.end_s[segment]),
            int(self.path.cut[segment]),
            bool(self.is_at_edge[numbers].any()),
            later,
        )

    def _closes(self, unit: int, own: int) -> bool:
        """Return whether an own part is the cusp that one cut leaves for its next unit, where its kerf meets itself."""
        if self.own_unit[own] != unit + 1 or self.path.cut[self.firsts[unit]] != self.path.cut[self.firsts[unit + 1]]:
            return False
        end_mm = self.path.ends_mm[self.firsts[unit + 1] - 1, 2:]
        away_mm = np.hypot(*(shapely.get_coordinates(self.own[own]) - end_mm).T).max()
        return bool(away_mm <= CUSP_KERFS * 2 * self.path.radius_mm[self.firsts[unit]])

    def _closing_segment(self, unit: int, shapes: np.ndarray) -> int:
        """Return the segment up to which a unit must be cut for the pieces to come free from it.

        Every point of their outer edges was cut first by some segment; the last one of these ends the cut round them.
        """
        last = self.firsts[unit + 1] if unit + 1 < len(self.firsts) else len(self.path)
        rings = shapely.get_exterior_ring(shapes)
        steps = np.maximum(shapely.length(rings) / MOST_SAMPLES, self.path.radius_mm[self.firsts[unit]])
        points = shapely.points(shapely.get_coordinates(shapely.segmentize(rings, steps)))
        near_mm = float(self.path.radius_mm[self.firsts[unit]]) + NEAR_MM
        point, segment = self.path.tree.query(points, predicate="dwithin", distance=near_mm)
        cut_first = np.full(len(points), len(self.path))
        np.minimum.at(cut_first, point, segment)
        done = cut_first[cut_first < last]
        return int(done.max()) if len(done) else int(last) - 1


class _Sets:
    """Sets of nodes that join as the units of a path are given back, the last one first."""

    def __init__(self, sheet: _Sheet):
        self.sheet = sheet
        count = len(sheet.pieces) + len(sheet.own)
        self.of = list(range(count))
        self.members: dict[int, list[int]] = {node: [node] for node in range(count)}
        self.unit = np.r_[np.full(len(sheet.pieces), len(sheet.firsts)), sheet.own_unit]
        pairs = sheet.neighbours()
        both = np.vstack([pairs, pairs[:, ::-1]])
        both = both[self.unit[both[:, 1]] >= self.unit[both[:, 0]]]  # to pieces joined before, or at the same time
        both = both[np.argsort(both[:, 0], kind="stable")]
        self.begin = np.searchsorted(both[:, 0], np.arange(count + 1))
        self.touched = both[:, 1]

    def separated(self) -> Iterator[tuple[int, list[int]]]:
        """Yield each unit that sets something free from the rest, with the nodes of that; the last one first."""
        own = np.arange(len(self.sheet.pieces), len(self.of))
        own = own[np.argsort(-self.unit[own], kind="stable")]
        breaks = np.flatnonzero(np.diff(self.unit[own])) + 1
        for nodes in np.split(own, breaks):
            if len(nodes):
                yield from self._given_back(int(self.unit[nodes[0]]), nodes.tolist())

    def _given_back(self, unit: int, nodes: list[int]) -> Iterator[tuple[int, list[int]]]:
        pairs = [(node, other) for node in nodes for other in self.touched[self.begin[node] : self.begin[node + 1]]]
        fresh = set(nodes)
        before = {self.root(other): () for _, other in pairs if other not in fresh}
        rest = self.root(self.sheet.rest)
        held = {root: list(self.members[root]) for root in before if root != rest}
        for node, other in pairs:
            self._join(node, int(other))
        rest = self.root(rest)
        for root, members in held.items():
            if self.root(root) == rest:
                yield unit, members

    def root(self, node: int) -> int:
        """Return the representative of a node's set."""
        while self.of[node] != node:
            self.of[node] = self.of[self.of[node]]
            node = self.of[node]
        return node

    def _join(self, one: int, other: int) -> None:
        one, other = self.root(one), self.root(other)
        if one == other:
            return
        if len(self.members[one]) < len(self.members[other]):
            one, other = other, one
        self.of[other] = one
        self.members[one] += self.members.pop(other)


def _place(polygon: Polygon) -> tuple[float, float]:
    point = polygon.representative_point()
    return point.x, point.y
