# SPDX-License-Identifier: LGPL-2.1-or-later
r"""Ways from the end of a walk to the begin of the next, over ground that is cut.

    ////////////        o    end of a walk, beside material
    /////o.    ///      P Q  places beside it with a margin to all that is not cut, walls too
    ////  P---.          ---  by rapids, a little above the floor
    ///        `-Q      ...  at the feed, as is all the rest of a run
    ///          'o/

A place is clear where every node of the map within the tool's radius and the margin is cut. Clear places on a coarse
grid are searched breadth first; that chain is then cut short, each straight stretch clear as a whole. Where there is
no such way, as between close walls, or where it is not worth lifting for, the link stays on the floor.
"""

from __future__ import annotations

import math

import numpy as np

from CNCStepper.cycles.clearing.engagement.clearing_map import ClearingMap
from CNCStepper.cycles.clearing.engagement.map_kernels import engaged, nodes, square_from, value_at
from CNCStepper.cycles.clearing.pattern import Pass
from CNCStepper.geometry.curve import from_points
from CNCStepper.kernels import njit
from CNCStepper.tolerances import COINCIDENT_MM

MARGIN = 0.05  # of the radius: rapids keep it to walls and material
STRIDE = 0.25  # of the radius: between the places of the coarse grid
ASIDE = 0.05  # of the radius: between the rings on which a clear place beside another is looked for
RINGS = 10
WAYS = 24
WORTH = 0.5  # of the radius: shorter links stay on the floor
LOOK = 0.1  # of the radius: between the sample places of a straight link
SLACK = 0.004  # of the radius: a chip that rounding may show where all is cut
EIGHT = np.array([(0, 1), (1, 0), (0, -1), (-1, 0), (1, 1), (1, -1), (-1, -1), (-1, 1)])


class Links:
    """Finds ways in a chart whose way is planned, while that is cut anew; for a tool of radius `tool_mm`.

    outside_mm: by which links at the feed may be out of the planned room.
    """

    def __init__(self, chart: ClearingMap, tool_mm: float, outside_mm: float):
        self._chart, self._map, self._tool_mm, self._outside_mm = chart, chart.map, tool_mm, outside_mm
        self._reach_mm = (1.0 + MARGIN) * tool_mm
        self._stride = max(int(STRIDE * tool_mm / self._map.cell), 1)
        shape = [-(-count // self._stride) for count in self._map.field.shape]
        self._clear = np.zeros(shape, bool)
        self._came = np.empty(shape, np.int64)
        self._queue = np.empty(self._came.size, np.int64)

    def link(self, here: int, there: int) -> list[Pass]:
        """Return the way from one vertex of the chart's way to another over what is cut; none where they are one."""
        begin, end = self._chart.way[here], self._chart.way[there]
        hop = self._hop(begin, end)
        if hop is None:
            return straight(self._floor(self._chart.back(here, there)))
        aside, back = np.array([begin, hop[0]]), np.array([hop[-1], end])
        return [*straight(aside), *straight(hop, lifted=True), *straight(back)]

    def _hop(self, here: np.ndarray, there: np.ndarray) -> np.ndarray | None:
        """Return a way for rapids between clear places beside two others, float64[n, 2], None where there is none."""
        if math.dist(here, there) < WORTH * self._tool_mm:
            return None
        ends = [
            nearest_clear_place(self._map, *place, self._tool_mm, self._reach_mm, self._outside_mm)
            for place in (here, there)
        ]
        if np.isnan(ends).any():
            return None
        (ax, ay), (bx, by) = ends
        if clear(self._map, ax, ay, bx, by, self._reach_mm):
            return np.array(ends)
        own = self._stride, self._clear, self._came, self._queue
        count = search(self._map, ax, ay, bx, by, self._reach_mm, *own)
        if not count:
            return None
        way = np.vstack([ends[0], self._places(self._queue[:count]), ends[1]])
        return way[shortcut(self._map, way, self._reach_mm, math.nan)]

    def _floor(self, back: np.ndarray) -> np.ndarray:
        """Return a way at the feed from the begin of a chain of places that the tool has been at to its end."""
        if free(self._map, *back[0], *back[-1], self._tool_mm, self._outside_mm):
            return back[[0, -1]]
        kept = back[shortcut(self._map, back, self._tool_mm, self._outside_mm)]
        return kept[shortcut(self._map, kept, self._tool_mm, self._outside_mm)]

    def _places(self, nodes: np.ndarray) -> np.ndarray:
        rows, columns = np.divmod(nodes, self._clear.shape[1])
        step_mm = self._stride * self._map.cell
        return np.column_stack([self._map.x + columns * step_mm, self._map.y + rows * step_mm])


def straight(points: np.ndarray, *, lifted: bool = False) -> list[Pass]:
    """Return the link along points, float64[n, 2]; none where they are all at one place."""
    apart = np.concatenate([[True], np.hypot(*np.diff(points, axis=0).T) > COINCIDENT_MM])
    return [Pass("link", from_points(points[apart]), lifted)] if apart.sum() > 1 else []


@njit
def clear(chart, ax, ay, bx, by, reach):
    """Return whether all nodes within `reach` of the straight way from a to b are cut."""
    dx, dy = bx - ax, by - ay
    square = dx * dx + dy * dy
    first, last = nodes(chart.y, chart.cell, chart.field.shape[0], min(ay, by) - reach, max(ay, by) + reach)
    for row in range(first, last):
        y = chart.y + row * chart.cell
        beside_mm = max(y - max(ay, by), min(ay, by) - y, 0.0)
        half = math.sqrt(max(reach * reach - beside_mm * beside_mm, 0.0))
        begin, end = nodes(chart.x, chart.cell, chart.field.shape[1], min(ax, bx) - half, max(ax, bx) + half)
        for column in range(begin, end):
            if chart.field[row, column] > chart.radius:
                x = chart.x + column * chart.cell
                if square_from(x - ax, y - ay, dx, dy, square) <= reach * reach:
                    return False
    return True


@njit
def nearest_clear_place(chart, x, y, radius, reach, outside):
    """Return the nearest clear place that a free straight way leads to, found on rings; NaNs where there is none."""
    for ring in range(RINGS + 1):
        for way in range(WAYS if ring else 1):
            angle = 2.0 * math.pi * way / WAYS
            there_x = x + ring * ASIDE * radius * math.cos(angle)
            there_y = y + ring * ASIDE * radius * math.sin(angle)
            found = clear(chart, there_x, there_y, there_x, there_y, reach)
            if found and free(chart, x, y, there_x, there_y, radius, outside):
                return there_x, there_y
    return math.nan, math.nan


@njit
def search(chart, ax, ay, bx, by, reach, stride, known, came, queue):
    """Write to `queue` the nodes of the coarse grid on a clear way from a to b; return how many, 0 for none.

    known: bool[rows, columns], the nodes found clear so far, for the next search too. came, queue: for its own use.
    """
    rows, columns = known.shape
    step = stride * chart.cell
    came[:] = -1
    found = done = 0
    near_row, near_column = int((by - chart.y) / step), int((bx - chart.x) / step)
    for row in range(max(near_row, 0), min(near_row + 2, rows)):
        for column in range(max(near_column, 0), min(near_column + 2, columns)):
            if clear(chart, bx, by, chart.x + column * step, chart.y + row * step, reach):
                came[row, column] = row * columns + column
                queue[found] = row * columns + column
                found += 1
    while done < found:
        node = queue[done]
        done += 1
        row, column = node // columns, node % columns
        x, y = chart.x + column * step, chart.y + row * step
        if abs(x - ax) < step and abs(y - ay) < step and clear(chart, ax, ay, x, y, reach):
            return _back(came, queue, node)
        for down, right in EIGHT:
            to_row, to_column = row + down, column + right
            if 0 <= to_row < rows and 0 <= to_column < columns and came[to_row, to_column] < 0:
                if not known[to_row, to_column]:
                    x, y = chart.x + to_column * step, chart.y + to_row * step
                    known[to_row, to_column] = clear(chart, x, y, x, y, reach)
                if known[to_row, to_column]:
                    came[to_row, to_column] = node
                    queue[found] = to_row * columns + to_column
                    found += 1
    return 0


@njit
def _back(came, queue, node):
    """Write the way from a node back to where the search began to `queue` and return how many nodes it has."""
    columns, count = came.shape[1], 1
    queue[0] = node
    while came[node // columns, node % columns] != node:
        node = came[node // columns, node % columns]
        queue[count] = node
        count += 1
    return count


@njit
def free(chart, ax, ay, bx, by, radius, outside):
    """Return whether a tool may go straight from a to b: nothing is cut, and it stays in the room but for `outside`."""
    away = math.hypot(bx - ax, by - ay)
    if away == 0.0:
        return True
    cosine, sine = (bx - ax) / away, (by - ay) / away
    parts = math.ceil(away / (LOOK * radius))
    for k in range(1, parts + 1):
        x, y = ax + (bx - ax) * k / parts, ay + (by - ay) * k / parts
        if value_at(chart, chart.room, x, y) < -outside:
            return False
        if engaged(chart, x, y, cosine, sine, radius, SLACK * radius)[0] > 0.0:
            return False
    return True


@njit
def shortcut(chart, points, radius, outside):
    """Return which points of a chain, float64[n, 2], a shorter one keeps, int64[m].

    It is free for a tool of `radius`, but for `outside`; where that is NaN it is clear within `radius`.
    """
    kept = np.empty(len(points), np.int64)
    kept[0], count, here = 0, 1, 0
    while here < len(points) - 1:
        reach, there = len(points) - 1 - here, here + 1
        while reach > 1:
            index = here + reach
            ax, ay = points[here]
            bx, by = points[index]
            if math.isnan(outside):
                goes = clear(chart, ax, ay, bx, by, radius)
            else:
                goes = free(chart, ax, ay, bx, by, radius, outside)
            if goes:
                there = index
                break
            reach = reach * 4 // 5
        here = there
        kept[count] = here
        count += 1
    return kept[:count]
