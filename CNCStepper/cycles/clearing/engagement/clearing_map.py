# SPDX-License-Identifier: LGPL-2.1-or-later
r"""The map of one room, made and grown: what is wanted of it, the way through it so far, and the wants still open.

The way is planned in a room smaller by `inset` and with a tool thinner than the true one:

    true radius >= radius + 0.75 cells + 1.2 inset      so what lies between cleared nodes is cleared too, and the
                                                        passes may be refitted within inset / 2
"""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from CNCStepper.cycles.clearing.engagement.map_kernels import Map, cut_until, flip_inside, spread
from CNCStepper.cycles.clearing.pattern import Area, Opening
from CNCStepper.errors import CycleError, Text
from CNCStepper.geometry.region import Region
from CNCStepper.kernels import COMPILED

CELLS = 32  # a radius, at least, where the map allows
CELLS_A_STEPOVER = 4.0
MOST_NODES = 24_000_000 if COMPILED else 500_000
BETWEEN = 0.75  # cells: no place is farther from a node
INSET = 0.004  # of the radius, at least
INSET_TOLERANCES = 0.4
INSETS = 1.2
WALL = 1.0  # cells beyond the radius that suffice where the wall pass follows
LEAST_WALL = 0.1  # the same, about places where that would be too much for it
LONGEST_WAY = 2_000_000 if COMPILED else 100_000  # vertices
AROUND = 64  # vertices of the opening


def inset_mm(area: Area) -> float:
    """Return by how much the planned room is smaller than the true one."""
    return max(INSET * area.tool_mm, INSET_TOLERANCES * area.tolerance_mm)


class MapSnapshot(NamedTuple):
    """A part of a map as it was, and how many nodes the front had."""

    window: tuple[slice, slice]
    field: np.ndarray
    vertex: np.ndarray
    met: int


@dataclass
class ClearingMap:
    """A map and its way: vertices, float64[n, 2], of which `count` are used.

    begins, parents: at which vertex each walk begins, and the same place on an earlier walk, from where it sets off.
    The first one is the opening.
    """

    map: Map
    way: np.ndarray
    count: int
    front: np.ndarray
    met: np.ndarray
    begins: list[int]
    parents: list[int]

    @property
    def place(self) -> np.ndarray:
        """The end of the path."""
        return self.way[self.count - 1]

    def add(self, points: np.ndarray) -> None:
        """Extend the path along points where all is cut already; raises CycleError when it is full."""
        if self.count + len(points) >= len(self.way):
            raise CycleError(
                "blocks-many",
                "the operation is too long for one program",
                value=Text("more than {way} steps", way=len(self.way)),
                advice="make stepover_mm larger",
            )
        self.way[self.count : self.count + len(points)] = points
        self.count += len(points)

    def branch(self, index: int) -> None:
        """Begin a walk at the way's vertex `index`."""
        self.begins.append(self.count)
        self.parents.append(index)
        self.add(self.way[index : index + 1])

    def drop(self) -> None:
        """Take the last walk back, whose cuts are undone."""
        self.count = self.begins.pop()
        self.parents.pop()

    def walks(self) -> Iterator[tuple[int, int, int]]:
        """Yield each walk but the opening: where it sets off, its first vertex, and one past its last."""
        ends = [*self.begins[2:], self.count]
        yield from zip(self.parents[1:], self.begins[1:], ends, strict=True)

    def before(self, index: int, lead_mm: float) -> int:
        """Return the vertex from which one comes to vertex `index`, along walks, after `lead_mm`."""
        while lead_mm > 0.0 and index > 0:
            walk = bisect_right(self.begins, index) - 1
            if index == self.begins[walk] > self.parents[walk]:
                index = self.parents[walk]
            else:
                lead_mm -= math.dist(self.way[index], self.way[index - 1])
                index -= 1
        return index

    def back(self, here: int, there: int) -> np.ndarray:
        """Return the way along walks from one vertex to another, float64[n, 2]."""
        down, up = self._trunk(there), self._trunk(here)
        while len(up) > 1 and len(down) > 1 and up[-2][0] == down[-2][0]:
            del up[-1], down[-1]
        (_, left), (_, right) = up.pop(), down.pop()
        ways = [self.way[begin : end + 1][::-1] for begin, end in up]
        ways.append(self.way[left : right + 1] if left <= right else self.way[right : left + 1][::-1])
        ways += [self.way[begin : end + 1] for begin, end in reversed(down)]
        return np.vstack(ways)

    def _trunk(self, index: int) -> list[tuple[int, int]]:
        """Return from where to where one goes along each walk, from vertex `index` back to the opening."""
        found: list[tuple[int, int]] = []
        while not found or found[-1][0] > 0:
            walk = bisect_right(self.begins, index) - 1
            found.append((self.begins[walk], index))
            index = self.parents[walk]
        return found

    def open(self, opening: Opening, tool_mm: float) -> None:
        """Cut the opening: a turn of the tool, and all that lies within it."""
        turns = np.linspace(0.0, 2.0 * math.pi, AROUND + 1)
        self.add(opening.centre_mm + (opening.radius_mm - tool_mm) * np.column_stack([np.cos(turns), np.sin(turns)]))
        self.cut(0, AROUND + 1)

    def cut(self, begin: int, end: int) -> None:
        """Cut along the way's vertices from `begin` to before `end`."""
        cut_until(self.map, self.way, begin, end - 1, math.inf, 0.0, self.front, self.met)

    def fill(self) -> None:
        """Undo all cuts, but not the path."""
        self.map.field.fill(self.map.far)
        self.map.vertex.fill(-1)
        self.met[0] = 0

    def kept(self, index: int, reach_mm: float) -> MapSnapshot:
        """Return what a walk may change that ends within `reach_mm` of the way's vertex `index`."""
        chart = self.map
        column, row = ((self.way[index] - (chart.x, chart.y)) / chart.cell).astype(int).tolist()
        reach = math.ceil((reach_mm + chart.far) / chart.cell) + 2
        window = slice(max(row - reach, 0), row + reach), slice(max(column - reach, 0), column + reach)
        return MapSnapshot(window, chart.field[window].copy(), chart.vertex[window].copy(), int(self.met[0]))

    def restore(self, kept: MapSnapshot) -> None:
        """Undo the changes of a walk since."""
        self.map.field[kept.window], self.map.vertex[kept.window] = kept.field, kept.vertex
        self.met[0] = kept.met

    def copied(self) -> ClearingMap:
        """Return the same chart with a map of its own to cut."""
        own = self.map._replace(field=self.map.field.copy(), vertex=self.map.vertex.copy(), need=self.map.need.copy())
        return replace(self, map=own, front=self.front.copy(), met=self.met.copy())

    def require_cleared(self, places: np.ndarray) -> bool:
        """Want the walls about places, float64[n, 2], cleared all but whole; return whether that is anything new."""
        field, need, cell = self.map.field, self.map.need, self.map.cell
        near = np.full_like(field, self.map.far)
        for place in places:
            spread(near, self.map.x, self.map.y, cell, self.map.far, np.array([place, place]))
        more = (near < self.map.far) & (need > self.map.radius + LEAST_WALL * cell) & (need < self.map.far)
        need[more] = self.map.radius + LEAST_WALL * cell
        np.minimum(self.map.vertex, self.count - 1, out=self.map.vertex)  # cut by a walk's end that was taken back
        found = np.flatnonzero((self.map.vertex >= 0) & (need < self.map.far) & (field > need))
        self.front[: len(found)], self.met[0] = found, len(found)
        return bool(more.any())

    def uncleared_nodes(self) -> np.ndarray:
        """Return the flat numbers of the nodes that are wanted and not cleared."""
        wanted = self.map.need < self.map.far
        return np.flatnonzero(wanted & (self.map.field > self.map.need))

    def at(self, node: int) -> tuple[float, float]:
        """Return the place of a node."""
        row, column = divmod(int(node), self.map.field.shape[1])
        return self.map.x + column * self.map.cell, self.map.y + row * self.map.cell


def clearing_map_of(room: Region, area: Area, stepover_mm: float) -> ClearingMap:
    """Return the map of a planned room, nothing cut; coarser than wanted where that is too large."""
    inset = inset_mm(area)
    loops = [np.ascontiguousarray(loop.points(inset / 4.0)) for loop in room.loops]
    low, high = (
        np.min([loop.min(axis=0) for loop in loops], axis=0),
        np.max([loop.max(axis=0) for loop in loops], axis=0),
    )
    cell = _cell_mm(area, stepover_mm, high - low)
    radius = area.tool_mm - BETWEEN * cell - INSETS * inset
    far = area.tool_mm + 3.0 * cell
    x, y = (low - far - 2.0 * cell).tolist()
    columns, rows = (np.ceil((high - low + 2.0 * far) / cell).astype(int) + 5).tolist()
    near, inside = np.full((rows, columns), far, np.float32), np.zeros((rows, columns), bool)
    for loop in loops:
        spread(near, x, y, cell, far, loop)
        flip_inside(inside, x, y, cell, loop)
    need = np.where(near <= radius, radius + WALL * cell, np.where(inside, radius, 2.0 * far)).astype(np.float32)
    field, vertex = np.full_like(near, far), np.full(near.shape, -1, np.int32)
    chart = Map(field, vertex, need, np.where(inside, near, -near), x, y, cell, far, radius, 0.0)
    front = np.empty(int((need < far).sum()) + 1, np.int64)
    return ClearingMap(chart, np.zeros((LONGEST_WAY, 2)), 0, front, np.zeros(1, np.int64), [0], [0])


def _cell_mm(area: Area, stepover_mm: float, size_mm: np.ndarray) -> float:
    fine_mm = min(area.tool_mm / CELLS, stepover_mm / CELLS_A_STEPOVER)
    wide_mm = size_mm + 2.5 * area.tool_mm
    return max(fine_mm, math.sqrt(float(wide_mm[0] * wide_mm[1]) / MOST_NODES))
