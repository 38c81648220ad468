# SPDX-License-Identifier: LGPL-2.1-or-later
"""Slides the parts of a sheet left and down, one after another, until none moves: what a search left loose closes."""

from __future__ import annotations

from dataclasses import replace

import shapely
from shapely import LineString

from CNCStepper.nesting.nesting_model import Budget, Placement, moved
from CNCStepper.nesting.sheet_filling import Filling, Room, Shapes

LEAST_MM = 1e-4  # of a slide
ROUNDS = 4
LEFT, DOWN = (-1.0, 0.0), (0.0, -1.0)


def compacted(room: Room, shapes: Shapes, placements: list[Placement], budget: Budget) -> list[Placement]:
    """Return the placements on one sheet, each slid as far left and down as it goes; locked parts stay."""
    lie = list(placements)
    for _ in range(ROUNDS):
        order = sorted(range(len(lie)), key=lambda number: lie[number].x_mm)
        slid = [_slide(room, shapes, lie, number) for number in order if not budget.over]
        if not any(slid):
            break
    return lie


def _slide(room: Room, shapes: Shapes, lie: list[Placement], number: int) -> bool:
    placement = lie[number]
    if any(placement in item.locked for item in shapes.items):
        return False
    others = Filling(room, shapes)
    for other, kept in enumerate(lie):
        if other != number:
            others.add(kept)
    slid = False
    for way in (LEFT, DOWN):
        longer = _slid(room, shapes, others, placement, way)
        if longer is not None and others.is_free(longer):
            placement = lie[number] = longer
            slid = True
    return slid


def _slid(
    room: Room, shapes: Shapes, others: Filling, placement: Placement, way: tuple[float, float]
) -> Placement | None:
    """Return the placement at the end of its slide, None where it goes less than LEAST_MM."""
    key = placement.item, placement.rotation_deg % 360.0
    fit = room.fit(shapes, key)
    low_x, low_y = fit.bounds[:2] if not fit.is_empty else (placement.x_mm, placement.y_mm)
    reach = placement.x_mm - low_x if way == LEFT else placement.y_mm - low_y
    if not reach > LEAST_MM:
        return None
    begin = (placement.x_mm + way[0] * LEAST_MM, placement.y_mm + way[1] * LEAST_MM)
    line = LineString([begin, (placement.x_mm + way[0] * reach, placement.y_mm + way[1] * reach)])
    free = line.intersection(fit)
    for other in others.placements:
        no_fit = shapes.no_fit((other.item, other.rotation_deg % 360.0), key)
        free = free.difference(moved(no_fit, other.x_mm, other.y_mm))
    start = shapely.Point(begin)
    run = next((part for part in shapely.get_parts(free) if part.length > LEAST_MM and part.dwithin(start, 1e-9)), None)
    if run is None:
        return None
    x, y = min(shapely.get_coordinates(run).tolist(), key=lambda end: end[0] + end[1])
    return replace(placement, x_mm=x, y_mm=y)
