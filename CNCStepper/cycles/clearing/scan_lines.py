# SPDX-License-Identifier: LGPL-2.1-or-later
r"""The net on which a zigzag walks: parallel lines clipped to a region, and the walls between their ends.

        +----o------o--------+        o  nodes, where a line ends on a wall
       /     |      |        |        edges: the lines, and the stretch of wall from each node to the next one,
      o------+------+--------o        each with its curve
      |      .-o--o-.        |
      o-----o  hole  o-------o        At each height the crossings with the walls are paired from left to right.
      |      '-o--o-'        |        A wall counts from its lower end on and without its upper one, so every closed
       \     |      |        |        wall is crossed an even number of times, at its vertices too.
        +----o------o--------+

Each hole is crossed by some line. From its leftmost crossing on that height the line goes left to another wall, whose
leftmost crossing there lies farther left still, and so on to the outer wall: so the net of one part hangs together.
"""

from __future__ import annotations

import itertools
import math
from dataclasses import dataclass

import numpy as np

from CNCStepper.cycles.passes import require_few_passes
from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.curve_columns import Segments
from CNCStepper.geometry.region import Region
from CNCStepper.tolerances import SAME_MM

BISECTIONS = 52


@dataclass(frozen=True)
class Edge:
    """One line or stretch of wall between two nodes; wall: the number of the loop that it is of, -1 for a line."""

    begin: int
    end: int
    curve: Curve
    wall: int
    length_mm: float

    def other_end(self, forwards: bool) -> int:
        """Return the node at which one arrives."""
        return self.end if forwards else self.begin


@dataclass(frozen=True)
class Crossings:
    """Where heights meet one wall: at which length of it, how far right, and which height, as columns."""

    wall: int
    place_mm: np.ndarray
    right_mm: np.ndarray
    height: np.ndarray


def net_of(part: Region, angle_deg: float, step_mm: float) -> tuple[list[Edge], float]:
    """Return the lines and walls of a region in one part, and how far lines are apart at most: `step_mm` or less.

    Every wall is crossed. Raises CycleError for more than MOST_PASSES lines.

    Walls come first, each in its own direction; then lines from the lowest on, each from left to right, as seen by
    one who looks with `angle_deg` to the right.
    """
    turn = np.exp(-1j * math.radians(angle_deg))
    turned = [_turned(loop, turn) for loop in part.loops]
    heights_mm, apart_mm = _heights(turned, step_mm)
    met = [_crossings(number, chain, heights_mm) for number, chain in enumerate(turned)]
    edges: list[Edge] = []
    nodes, count = [], 0
    for loop, crossings in zip(part.loops, met, strict=True):
        stretches, node = _stretches(loop, crossings, count)
        edges += stretches
        nodes.append(node)
        count += len(stretches)
    return edges + _lines(edges, met, nodes), apart_mm


def _turned(loop: Curve, turn: complex) -> Segments:
    begin, _, sweep = loop.segments
    begin = begin * turn
    return Segments(begin, np.append(begin[1:], begin[0]), sweep).monotone()[1]


def _heights(chains: list[Segments], step_mm: float) -> tuple[np.ndarray, float]:
    """Return the heights of the lines, and how far they are apart.

    They lie evenly from the lowest to the highest place, and one at least is for each wall.
    """
    lows, highs = (
        np.array([of(np.r_[chain.begin.imag, chain.end.imag]) for chain in chains]) for of in (np.min, np.max)
    )
    wide_mm = float(highs.max() - lows.min())
    require_few_passes(wide_mm, step_mm, "stepover_mm")
    count = max(math.ceil(wide_mm / step_mm - 1e-9), 1)
    even = np.linspace(lows.min(), highs.max(), count + 1)[1:-1]
    missed = np.searchsorted(even, lows, "right") >= np.searchsorted(even, highs, "left")
    return np.union1d(even, (lows + highs)[missed] / 2.0), wide_mm / count


def _crossings(wall: int, chain: Segments, heights_mm: np.ndarray) -> Crossings:
    low, high = np.minimum(chain.begin.imag, chain.end.imag), np.maximum(chain.begin.imag, chain.end.imag)
    first = np.searchsorted(heights_mm, low, "left")
    counts = np.searchsorted(heights_mm, high, "left") - first
    row = np.repeat(np.arange(len(counts)), counts)
    height = np.arange(len(row)) - np.repeat(np.cumsum(counts) - counts - first, counts)
    pieces, lengths_mm = chain.rows(row), chain.length_mm
    share = _share_at(pieces, heights_mm[height])
    before_mm = np.cumsum(lengths_mm) - lengths_mm
    return Crossings(wall, before_mm[row] + share * lengths_mm[row], pieces.at(share).real, height)


def _share_at(pieces: Segments, heights_mm: np.ndarray) -> np.ndarray:
    """Return at which share of its length each piece, which only rises or only falls, reaches a height within it."""
    rises = pieces.end.imag > pieces.begin.imag
    low, high = np.zeros(len(rises)), np.ones(len(rises))
    for _ in range(BISECTIONS):
        middle = (low + high) / 2.0
        before = (pieces.at(middle).imag < heights_mm) == rises
        low, high = np.where(before, middle, low), np.where(before, high, middle)
    return (low + high) / 2.0


def _stretches(loop: Curve, crossings: Crossings, first: int) -> tuple[list[Edge], np.ndarray]:
    """Return a wall cut at its crossings, nodes numbered on from `first`, and the node of each crossing."""
    order = np.argsort(crossings.place_mm, kind="stable")
    start_mm, whole_mm = float(crossings.place_mm[order[0]]), loop.length_mm
    place_mm = crossings.place_mm[order] - start_mm
    place_mm[whole_mm - place_mm <= SAME_MM] = 0.0
    order, place_mm = order[np.argsort(place_mm, kind="stable")], np.sort(place_mm)
    new = np.diff(place_mm, prepend=-1.0) > SAME_MM
    pieces = loop.started_at_length(start_mm).split(place_mm[new][1:])
    count = len(pieces)
    node = np.empty(len(order), int)
    node[order] = first + np.cumsum(new) - 1
    edges = [
        Edge(first + k, first + (k + 1) % count, piece, crossings.wall, piece.length_mm)
        for k, piece in enumerate(pieces)
    ]
    return edges, node


def _lines(walls: list[Edge], met: list[Crossings], nodes: list[np.ndarray]) -> list[Edge]:
    height, right_mm = np.concatenate([one.height for one in met]), np.concatenate([one.right_mm for one in met])
    node = np.concatenate(nodes)[np.lexsort((right_mm, height))]
    return [_line(walls, left, right) for left, right in node.reshape(-1, 2).tolist() if left != right]


def _line(walls: list[Edge], left: int, right: int) -> Edge:
    curve = Curve(np.array([walls[left].curve.xy[0], walls[right].curve.xy[0]]), np.zeros(1))
    return Edge(left, right, curve, -1, curve.length_mm)


def neighbours(edges: list[Edge]) -> list[list[tuple[int, bool]]]:
    """Return for each node the edges that leave it: their number, and whether they are run forwards."""
    leaving: list[list[tuple[int, bool]]] = [[] for _ in range(1 + max(edge.begin for edge in edges))]
    for number, edge in enumerate(edges):
        leaving[edge.begin].append((number, True))
        leaving[edge.end].append((number, False))
    return leaving


def walls_of(edges: list[Edge]) -> dict[int, list[int]]:
    """Return the numbers of the edges of each wall, in its own order."""
    walls = ((edge.wall, number) for number, edge in enumerate(edges) if edge.wall >= 0)
    return {wall: [number for _, number in group] for wall, group in itertools.groupby(walls, key=lambda one: one[0])}
