# SPDX-License-Identifier: LGPL-2.1-or-later
"""Zigzag: parallel lines to and fro, joined along the walls, then once round each wall.

     .--<--------<--.         From the end of a line the tool takes the shortest way over the net (scan_lines.py) to the
     '-->-------->--.         nearest line that is not cut: along the wall to the next line, which cuts what is cut
     .--<--------<--'         anyhow later, or, at the end of a branch, back over what is cut. So each part of the
     '-->-------->--'         room is one run, however many islands stand in it.

Lines alternate, so climb or conventional is only the direction round the walls. Nothing stays: what is within the
tool's radius of a wall is cut on the way round it. Farther inside, the whole disc of the tool about a place lies in
the room; a line is at most half a step beside the place, so it crosses that disc, by at least the chord there. For
this reason lines shorter than that chord are left out; they serve as ways only.
"""

from __future__ import annotations

import heapq
import itertools
import math
from collections.abc import Callable

from CNCStepper.cycles.clearing.pattern import Area, Pass, Run
from CNCStepper.cycles.clearing.scan_lines import Edge, neighbours, net_of, walls_of
from CNCStepper.geometry.curve import joined
from CNCStepper.geometry.region import Region

SURE = 0.98  # of the chord: rounding must not leave a line out that is needed
Step = tuple[int, bool]  # an edge's number and whether it is run forwards


def zigzag(area: Area, angle_deg: float = 0.0) -> list[Run]:
    """Return one run for each part of the room, with lines at `angle_deg` and at most the stepover apart.

    Raises CycleError for more than MOST_PASSES lines.
    """
    return [_Walk(part, area, angle_deg).run() for part in area.room.parts()]


class _Walk:
    """The walk over the net of one part: where the tool is, what is cut, and the way so far."""

    def __init__(self, part: Region, area: Area, angle_deg: float):
        self._edges, self._apart_mm = net_of(part, angle_deg, area.stepover_mm)
        self._leaving = neighbours(self._edges)
        self._forwards = area.climb
        half_mm = min(area.stepover_mm / 2.0, area.tool_mm)
        self._shortest_mm = SURE * 2.0 * math.sqrt(area.tool_mm**2 - half_mm**2)
        self._cut = [False] * len(self._edges)
        self._way: list[tuple[Step, bool, int]] = []  # each step, whether that edge was cut before, and the stage
        self._here = self._stage = 0

    def run(self) -> Run:
        """Return the whole walk as passes."""
        self._lines()
        self._walls()
        return Run(tuple(_passes(self._edges, self._way)), self._apart_mm)

    def _lines(self) -> None:
        missing = {n for n, edge in enumerate(self._edges) if edge.wall < 0 and edge.length_mm >= self._shortest_mm}
        if missing:
            self._here = self._edges[min(missing)].begin
        while missing:
            self._go(lambda node: any(number in missing for number, _ in self._leaving[node]))
            line = next(step for step in self._leaving[self._here] if step[0] in missing)
            self._step(line)
            missing.discard(line[0])

    def _walls(self) -> None:
        walls = walls_of(self._edges)
        while walls:
            self._go(lambda node: self._wall_at(node) in walls)
            wall = walls.pop(self._wall_at(self._here))
            first = [self._edges[number].begin for number in wall].index(self._here)
            round_ = wall[first:] + wall[:first]
            self._stage += 1
            for number in round_ if self._forwards else round_[::-1]:
                self._cut[number] = False  # the round along the wall is a pass, not a link
                self._step((number, self._forwards))

    def _wall_at(self, node: int) -> int:
        return self._edges[self._leaving[node][0][0]].wall

    def _step(self, step: Step) -> None:
        self._way.append((step, self._cut[step[0]], self._stage))
        self._cut[step[0]] = True
        self._here = self._edges[step[0]].other_end(step[1])

    def _go(self, is_goal: Callable[[int], bool]) -> None:
        """Take the shortest way to the nearest goal (Dijkstra 1959)."""
        came: dict[int, tuple[int, Step]] = {}
        heap = [(0.0, self._here, -1, (-1, True))]
        while True:
            far_mm, node, before, step = heapq.heappop(heap)
            if node not in came:
                came[node] = before, step
                if is_goal(node):
                    break
                for number, forwards in self._leaving[node]:
                    edge = self._edges[number]
                    heapq.heappush(heap, (far_mm + edge.length_mm, edge.other_end(forwards), node, (number, forwards)))
        way = []
        while node != self._here:
            node, step = came[node]
            way.append(step)
        for step in reversed(way):
            self._step(step)


def _passes(edges: list[Edge], way: list[tuple[Step, bool, int]]) -> list[Pass]:
    """Return steps over what is cut already as links, all others as roughing passes, each wall's round as its own."""
    passes: list[Pass] = []
    rough = 0
    for (was_cut, _), group in itertools.groupby(way, key=lambda one: one[1:]):
        curves = [edges[n].curve if forwards else edges[n].curve.reversed() for (n, forwards), _, _ in group]
        rough += not was_cut
        passes.append(Pass("link" if was_cut else f"roughing {rough}", joined(curves)))
    return passes
