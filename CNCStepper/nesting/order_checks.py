# SPDX-License-Identifier: LGPL-2.1-or-later
"""Refuses an order before any time is spent on it: each refusal names the part or sheet, the value and the limit."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import shapely
from shapely import Polygon

from CNCStepper.errors import JobError, Text
from CNCStepper.nesting.judge import sheet_faults
from CNCStepper.nesting.nesting_model import (
    MOST_PARTS,
    Item,
    Sheet,
    Spacing,
    allowed_rotations_deg,
    tried_rotations_deg,
    turned,
)
from CNCStepper.tolerances import TOUCHING_PARTS_MM

LEAST_AREA_MM2 = 1e-6
MOST_MM = 1e6
HOLES = (  # a word of what shapely says of a polygon, and what we say
    ("outside", "a hole of {name} lies beyond its outline"),
    ("nested", "a hole of {name} lies in another one"),
)


def polygon_from(
    name: str, points: Sequence[Sequence[float]], holes: Sequence[Sequence[Sequence[float]]] = ()
) -> Polygon:
    """Return the polygon with these corners, mm; raises JobError for too few, no numbers, no area, crossing sides."""
    for ring in (points, *holes):
        _require_ring(name, ring)
    polygon = Polygon(points, holes)
    if not polygon.is_valid:
        raise _crossing(name, shapely.is_valid_reason(polygon))
    if polygon.area < LEAST_AREA_MM2:
        what = Text("the outline of {name} has no area", name=name)
        raise _refusal("nest-area", what, f"{polygon.area:g} mm2", "correct its corners")
    return shapely.remove_repeated_points(polygon)


def _crossing(name: str, why: str) -> JobError:
    """Return the refusal of a polygon of which shapely says why, as in "Self-intersection[5 5]"."""
    kind, _, place = why.rstrip("]").partition("[")
    what = next((told for word, told in HOLES if word in kind), "the outline of {name} crosses itself")
    value = "X{} Y{}".format(*place.split()) if place else ""
    return _refusal("nest-crossing", Text(what, name=name), value, "draw it anew")


def _require_ring(name: str, ring: Sequence[Sequence[float]]) -> None:
    try:
        corners = np.asarray(ring, float)
    except (TypeError, ValueError):
        corners = np.zeros((0, 0))
    if corners.ndim != 2 or corners.shape[1] != 2 or len(corners) < 3:
        what = Text("the outline of {name} needs three corners or more, each of two numbers", name=name)
        raise _refusal("nest-corners", what, f"{len(corners)} corners", "write it as [[x, y], [x, y], [x, y]]")
    if not np.isfinite(corners).all() or np.abs(corners).max() > MOST_MM:
        wrong = corners[~(np.abs(corners) <= MOST_MM).all(axis=1)][0]
        what = Text("a corner of {name} lies nowhere", name=name)
        raise _refusal(
            "nest-number", what, f"{wrong[0]:g}, {wrong[1]:g}", Text("keep within {most:g} mm", most=MOST_MM)
        )


def require_count(name: str, count: object) -> int:
    """Return a count of parts; raises JobError for one that is no whole number from 1 to MOST_PARTS."""
    if isinstance(count, bool) or not isinstance(count, int) or not 1 <= count <= MOST_PARTS:
        what = Text("the count of {name} is no whole number within its bounds", name=name)
        raise JobError("nest-count", what, value=f"{count}", limit=f"1 to {MOST_PARTS}", advice="split the order")
    return count


def require_order(items: Sequence[Item], sheets: Sequence[Sheet], spacing: Spacing) -> None:
    """Raise JobError for an order without parts or sheets, of too many parts, or with one that fits on no sheet.

    A locked part that cannot stay where it is is refused too.
    """
    if not items or not sheets:
        raise JobError("nest-empty", "an order needs a part and a sheet", advice="add them")
    for name, value in (("the gap", spacing.gap_mm), ("the margin", spacing.margin_mm)):
        if not 0.0 <= value <= MOST_MM:
            what, between = (
                Text("{what} is out of bounds", what=name),
                Text("give 0 to {most_mm:g} mm", most_mm=MOST_MM),
            )
            raise JobError("nest-spacing", what, value=f"{value:g} mm", advice=between)
    if (total := sum(item.count + len(item.locked) for item in items)) > MOST_PARTS:
        advice = "split the order"
        raise JobError(
            "nest-count", "the order has too many parts", value=f"{total}", limit=f"{MOST_PARTS}", advice=advice
        )
    for item in items:
        _require_locked(item, sheets)
        _require_room(item, sheets, spacing)
    _require_locked_places(items, sheets, spacing)


def _require_locked(item: Item, sheets: Sequence[Sheet]) -> None:
    for placement in item.locked:
        if not 0 <= placement.sheet < len(sheets):
            what = Text("a locked part of {name} lies on a sheet that is not there", name=item.name)
            raise _refusal("nest-locked", what, f"sheet {placement.sheet}", "sheets count from 0")


def _require_locked_places(items: Sequence[Item], sheets: Sequence[Sheet], spacing: Spacing) -> None:
    """Raise JobError where a locked part lies beyond its sheet or on another one: nothing moves it from there."""
    locked = [placement for item in items for placement in item.locked]
    for number in sorted({placement.sheet for placement in locked}):
        own = [placement for placement in locked if placement.sheet == number]
        if fault := next(sheet_faults(items, sheets[number], spacing, own), None):
            what = Text("a locked part cannot stay where it is: {fault}", fault=fault)
            raise JobError("nest-locked-place", what, advice="unlock it, or move it")


def _require_room(item: Item, sheets: Sequence[Sheet], spacing: Spacing) -> None:
    """Raise JobError where no sheet of its stock has the size that an item needs in any rotation."""
    own = [sheet for sheet in sheets if sheet.stock == item.stock]
    if not own:
        stocks = ", ".join(sorted({f"'{sheet.stock}'" for sheet in sheets}))
        what = Text("there is no sheet of the stock of {name}", name=item.name)
        raise JobError("nest-stock", what, value=f"'{item.stock}'", limit=stocks, advice="add one")
    if all(allowed_rotations_deg(item, sheet) == () for sheet in own):
        what = Text("the grain allows none of the rotations of {name}", name=item.name)
        raise JobError("nest-grain", what, advice="correct rotations_deg or grain_deg")
    if not any(_may_lie(item, sheet, spacing) for sheet in own):
        size = f"{_size(item.outline.bounds)} mm"
        rooms = ", ".join(sorted({_size(sheet.outline.bounds) for sheet in own}))
        what = Text("{name} is larger than every sheet of its stock", name=item.name)
        advice = "take it out, allow other rotations, or add a larger sheet"
        raise JobError("nest-part-large", what, value=size, limit=f"{rooms} mm", advice=advice)


def _may_lie(item: Item, sheet: Sheet, spacing: Spacing) -> bool:
    low_x, low_y, high_x, high_y = sheet.outline.bounds
    rim = 2.0 * spacing.margin_mm - TOUCHING_PARTS_MM
    for angle in tried_rotations_deg(item, sheet):
        left, bottom, right, top = turned(item.outline, angle).bounds
        if right - left <= high_x - low_x - rim and top - bottom <= high_y - low_y - rim:
            return True
    return False


def _size(bounds: tuple[float, float, float, float]) -> str:
    return f"{bounds[2] - bounds[0]:g} x {bounds[3] - bounds[1]:g}"


def _refusal(code: str, what: str, value: str, advice: str) -> JobError:
    return JobError(code, what, value=value, advice=advice)


def require_finite(name: str, value: object) -> float:
    """Return a number; raises JobError for what is none."""
    if isinstance(value, bool) or not isinstance(value, int | float) or not math.isfinite(value):
        raise _refusal("nest-number", Text("{name} is no number", name=name), f"{value}", "write a number")
    return float(value)
