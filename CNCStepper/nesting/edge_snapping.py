# SPDX-License-Identifier: LGPL-2.1-or-later
"""Moves parts of a sheet on by little until their straight edges face each other exactly at the gap.

A move is taken where the judge allows it, the part faces its neighbours over a longer stretch than before, and the
parts reach no farther along X. Locked parts stay.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np
import shapely
from shapely import Polygon

from CNCStepper.geometry.curve import Curve, from_points
from CNCStepper.nesting.common_lines import LEAST_COMMON_MM, facing_edges
from CNCStepper.nesting.nesting_model import Budget, Placement, placed
from CNCStepper.nesting.sheet_filling import Filling, Room, Shapes
from CNCStepper.tolerances import COMMON_LINE_MM, SAME_MM

REACH_MM = 5.0  # how much farther apart than the gap two edges may be
PARALLEL = 1e-6  # sine of the angle between edges that are parallel
ROUNDS = 2
MOST_MOVES = 12  # tried of one part, the shortest first


def edge_to_edge(room: Room, shapes: Shapes, placements: list[Placement], budget: Budget) -> list[Placement]:
    """Return the placements on one sheet with edges moved together."""
    lie = list(placements)
    for _ in range(ROUNDS):
        moved = [_snap(room, shapes, lie, number) for number in range(len(lie)) if not budget.over]
        if not any(moved):
            break
    return lie


def facing_mm(room: Room, shapes: Shapes, placements: Sequence[Placement]) -> float:
    """Return over what length the parts of a sheet face each other at the gap."""
    outlines = [_outline(shapes, placement) for placement in placements]
    facings = facing_edges(outlines, [0] * len(outlines), room.spacing.gap_mm)
    return float(sum(facing.middle.length for facing in facings))


def _snap(room: Room, shapes: Shapes, lie: list[Placement], number: int) -> bool:
    """Move one part where that makes its edges common; return whether it was moved."""
    placement = lie[number]
    if any(placement in item.locked for item in shapes.items):
        return False
    gap_mm = shapes.spacing.gap_mm
    polygon = placed(shapes.items[placement.item].exact, placement)
    near = [
        other
        for each, other in enumerate(lie)
        if each != number and placed(shapes.items[other.item].exact, other).dwithin(polygon, gap_mm + REACH_MM)
    ]
    outlines = [_outline(shapes, other) for other in near]
    before_mm = _common_mm(_outline(shapes, placement), outlines, gap_mm)
    others = Filling(room, shapes)
    for other in near:
        others.add(other)
    for way in _moves(_outline(shapes, placement), outlines, gap_mm):
        tried = replace(placement, x_mm=placement.x_mm + float(way[0]), y_mm=placement.y_mm + float(way[1]))
        gain_mm = _common_mm(_outline(shapes, tried), outlines, gap_mm) - before_mm
        if gain_mm > LEAST_COMMON_MM and not _reaches_farther(shapes, lie, tried) and others.is_free(tried):
            lie[number] = tried
            return True
    return False


def _reaches_farther(shapes: Shapes, lie: Sequence[Placement], tried: Placement) -> bool:
    ends = [placed(shapes.items[each.item].exact, each).bounds[2] for each in lie]
    return placed(shapes.items[tried.item].exact, tried).bounds[2] > max(ends) + SAME_MM


def _outline(shapes: Shapes, placement: Placement) -> Curve:
    polygon = shapely.geometry.polygon.orient(Polygon(placed(shapes.items[placement.item].exact, placement).exterior))
    return from_points(np.asarray(polygon.exterior.coords)[:-1], closed=True)


def _common_mm(outline: Curve, others: Sequence[Curve], gap_mm: float) -> float:
    """Return how much of a part's outline faces others at the gap."""
    facings = facing_edges([outline, *others], [0] * (1 + len(others)), gap_mm)
    return float(sum(facing.middle.length for facing in facings if facing.parts[0] == 0))


def _moves(outline: Curve, others: Sequence[Curve], gap_mm: float) -> list[np.ndarray]:
    """Return the moves that bring an edge of a part to the gap from one of another part, the shortest first."""
    found = [way for other in others for way in _moves_to(outline, other, gap_mm)]
    return sorted(found, key=lambda way: float(np.hypot(*way)))[:MOST_MOVES]


def _moves_to(outline: Curve, other: Curve, gap_mm: float) -> Iterator[np.ndarray]:
    own, theirs = np.diff(outline.xy, axis=0), np.diff(other.xy, axis=0)
    own_way, their_way = own / np.hypot(*own.T)[:, None], theirs / np.hypot(*theirs.T)[:, None]
    sines = own_way[:, :1] * their_way[:, 1] - own_way[:, 1:] * their_way[:, 0]
    facing = (np.abs(sines) < PARALLEL) & (own_way @ their_way.T < 0.0)
    for row, column in np.argwhere(facing).tolist():
        right = np.array([own_way[row, 1], -own_way[row, 0]])
        farther_mm = float((other.xy[column] - outline.xy[row]) @ right) - gap_mm
        along = [float((end - outline.xy[row]) @ own_way[row]) for end in other.xy[column : column + 2]]
        overlaps = min(along[0], float(np.hypot(*own[row]))) - max(along[1], 0.0) > LEAST_COMMON_MM
        if overlaps and COMMON_LINE_MM / 2.0 < farther_mm <= REACH_MM:
            yield farther_mm * right
