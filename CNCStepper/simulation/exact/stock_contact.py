# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a move touches stock that the moves before it have left.

A point of the tool at height z touches when it lies inside the stock and no earlier move has cut it
down to z. The points lie on the front of the tool's rim, along the move, close together, and RUB_MM inside the
tool, so that a tool that only rubs along a wall it has cut itself touches nothing. To them come the
corners of the common area of move and stock, so that a corner of the stock between the points counts too.
"""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
import shapely

from CNCStepper.kernels import njit
from CNCStepper.simulation.cutter_solid import Cutter
from CNCStepper.simulation.exact.edge_tree import EdgeTree, flat_edges, square_from
from CNCStepper.simulation.stock import Stock
from CNCStepper.simulation.tip_segments import Segments, clipped_below
from CNCStepper.tolerances import SAME_HEIGHT_MM

RUB_MM = 0.005  # contact that is no deeper is no contact
STEP_MM = 0.25  # between the places of the tool on a move
LEVEL_STEP_MM = 0.05  # places on a ramp are checked together within this height: all at its upper end, then the lowest
DISCS = 9  # of a cutter that is not flat are checked, spread over its part below the stock's top
RIM_STEP_MM = 0.25  # between the points of a disc's rim, at most; the places of a move close the gaps
ALONE_STEP_MM = 0.02  # between those of a disc that has one place only
FEWEST_POINTS = 64
MISSES = 64  # as many places that no edge has cut are checked one by one; an index finds the others faster
INNER = (0.7, 0.4, 0.1)  # of the radius, at which points lie inside a rim

Cuts = Iterable[tuple[Cutter, Segments]]  # the tip's path below the stock's top, by cutter, in the order of its rows


class Remaining:
    """The stock and the path that cuts it, for queries of the material left before a given row.

    before: paths whose every move comes before `path`, perhaps read from the disk each time.
    """

    def __init__(self, stock: Stock, path: Cuts, before: Cuts = ()):
        self.stock = stock
        self.outline = stock.outline
        self.path = path
        self.before = before
        self.inside = self.outline.buffer(-RUB_MM, join_style="mitre")
        shapely.prepare(self.outline)

    def first_contact(self, cutter: Cutter, move: Segments) -> tuple[float, ...] | None:
        """Return the first place (x, y, z) where the move, the segments of one row, touches stock, or None."""
        below = clipped_below(move, self.stock.top_mm - RUB_MM)
        places = _places(below)
        for first, last in _runs(np.ceil(places[:, 2] / LEVEL_STEP_MM)):
            run = places[first:last]
            for some in (run, run[[run[:, 2].argmin()]])[: 1 + int(np.ptp(run[:, 2]) > 0)]:
                point = self._contact(cutter, some[:, :2], float(some[:, 2].max()), int(move.row[0]))
                if point is not None:
                    return point
        return None

    def _contact(self, cutter: Cutter, centres: np.ndarray, tip_mm: float, row: int) -> tuple[float, ...] | None:
        under_top_mm = max(self.stock.top_mm - 2 * RUB_MM - tip_mm, 0.0)  # the widest disc that counts is the highest
        heights = np.linspace(0.0, min(cutter.rise_mm, under_top_mm), 1 if cutter.is_flat else DISCS)
        for height, radius in zip(heights, cutter.radius_at(heights), strict=True):
            z_mm = max(tip_mm + height, self.stock.bottom_mm)
            if z_mm >= self.stock.top_mm - RUB_MM:
                continue
            points = self._points(centres, max(radius - RUB_MM, 0.0))
            points = points[shapely.contains_xy(self.outline, points)]
            points = points[self.stock.tops_at(points) > z_mm + RUB_MM]
            open_ = points[~self._cut(points, z_mm + RUB_MM, row)] if len(points) else points
            if len(open_):
                return (*open_[0].tolist(), z_mm)
        return None

    def _points(self, centres: np.ndarray, radius_mm: float) -> np.ndarray:
        """Return the points, float64[n, 2], at which discs about the centres may meet the stock."""
        if radius_mm <= RUB_MM:
            return centres
        way = shapely.LineString(centres) if len(centres) > 1 else shapely.Point(centres[0])
        corners = shapely.get_coordinates(way.buffer(radius_mm, quad_segs=64).intersection(self.inside))
        return np.vstack([corners, _disc_points(centres, radius_mm)]) if len(corners) else corners

    def _cut(self, points: np.ndarray, z_mm: float, row: int) -> np.ndarray:
        """Say which points the moves before `row` have cut down to `z_mm`."""
        cut = np.zeros(len(points), bool)
        for cutter, pieces in self.path:
            _mark_cut(cut, points, z_mm, cutter, pieces[: np.searchsorted(pieces.row, row)])
        for cutter, pieces in self.before:
            if cut.all():
                break
            _mark_cut(cut, points, z_mm, cutter, pieces)
        return cut


def _mark_cut(cut: np.ndarray, points: np.ndarray, z_mm: float, cutter: Cutter, pieces: Segments) -> None:
    """Mark the points, float64[n, 2], that a cutter on these segments has cut down to `z_mm`."""
    low, high = points.min(axis=0) - cutter.radius_mm, points.max(axis=0) + cutter.radius_mm
    near = pieces.low_mm <= z_mm
    for axis in range(2):
        near &= np.minimum(pieces.begin[:, axis], pieces.end[:, axis]) <= high[axis]
        near &= np.maximum(pieces.begin[:, axis], pieces.end[:, axis]) >= low[axis]
    pieces = pieces[near]
    for level_mm in _levels_of(cutter, pieces, z_mm):
        edges = flat_edges(clipped_below(pieces, level_mm))
        radius = cutter.radius_at(np.array([z_mm - level_mm]))[0]
        _find_cut(points, edges, radius * radius, cut)
        open_ = np.flatnonzero(~cut)
        if len(open_):
            cut[open_] = EdgeTree(edges).distance(points[open_]) <= radius


@njit
def _find_cut(points, edges, square, cut):
    """Mark points within a squared distance of an edge: most are near the one that the point before is near to.

    After MISSES points that are near to none the rest is left as it is.
    """
    last, misses = 0, 0
    for k in range(len(points)):
        if misses == MISSES:
            break
        if cut[k]:
            continue
        for step in range(len(edges)):
            edge = (last + step) % len(edges)
            if square_from(edges[edge], points[k, 0], points[k, 1]) <= square:
                cut[k], last = True, edge
                break
        misses += not cut[k]


def _levels_of(cutter: Cutter, pieces: Segments, z_mm: float) -> np.ndarray:
    """Return the heights of the tip to look at: the lowest cut widest, a flat is as wide everywhere."""
    if cutter.is_flat:
        return np.array([z_mm])
    steps = np.r_[pieces.low_mm, pieces.begin[:, 2], pieces.end[:, 2]] / SAME_HEIGHT_MM
    tips = (np.unique(np.ceil(steps)) + 1e-6) * SAME_HEIGHT_MM
    tips = tips[tips < z_mm]
    return tips[np.unique(np.linspace(0, max(len(tips) - 1, 0), 40).astype(int))] if len(tips) else tips


def _places(move: Segments) -> np.ndarray:
    """Return places of the tip along the move, float64[n, 3]; of a plunge only the lowest."""
    flat = np.hypot(*(move.end - move.begin)[:, :2].T) < 1e-9
    found = []
    for begin, end, is_plunge in zip(move.begin, move.end, flat, strict=True):
        count = 1 if is_plunge else int(np.ceil(np.linalg.norm(end - begin) / STEP_MM)) + 1
        low = begin if begin[2] < end[2] else end
        found.append(low[None, :] if is_plunge else np.linspace(begin, end, count))
    return np.vstack(found) if found else np.zeros((0, 3))


def _runs(keys: np.ndarray) -> list[tuple[int, int]]:
    """Return the ranges [first, last) of equal neighbours."""
    if not len(keys):
        return []
    breaks = np.flatnonzero(keys[1:] != keys[:-1]) + 1
    return list(zip(np.r_[0, breaks].tolist(), np.r_[breaks, len(keys)].tolist(), strict=True))


def _disc_points(centres: np.ndarray, radius_mm: float) -> np.ndarray:
    """Return points on the discs about centres one after another: all over the first, on the others' front rims.

    What lies inside a later disc has lain on the front rim of one before, or inside the first.
    """
    step_mm = RIM_STEP_MM if len(centres) > 1 else ALONE_STEP_MM
    rim = _ring(radius_mm, step_mm)
    first = np.vstack([rim, *(_ring(radius_mm * share, step_mm) for share in INNER)])
    ahead = np.diff(centres, axis=0) @ rim.T >= 0.0
    return np.vstack([centres[0] + first, (centres[1:, None, :] + rim)[ahead]])


def _ring(radius_mm: float, step_mm: float) -> np.ndarray:
    angle = np.linspace(0, 2 * np.pi, max(FEWEST_POINTS, int(np.ceil(2 * np.pi * radius_mm / step_mm))), endpoint=False)
    return np.stack([np.cos(angle), np.sin(angle)], axis=1) * radius_mm
