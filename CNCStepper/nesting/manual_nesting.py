# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts that a person places: moved, turned, locked, added, removed; each change is judged exactly before it is taken.

    wanted place ──► rotation that is allowed ──► judge.py against the sheet and its parts ──► taken, or refused
                                                                                                with the reason
Items may be the parts of a nest or the programs of an arrangement. A part is known by its number in `parts`.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np
import shapely
from shapely import Point, Polygon

from CNCStepper.errors import JobError, Text
from CNCStepper.nesting.judge import conflict, lies_within
from CNCStepper.nesting.nesting_model import (
    Budget,
    Item,
    Placement,
    Sheet,
    Spacing,
    allowed_rotations_deg,
    placed,
    turned,
)
from CNCStepper.nesting.sheet_filling import Filling, Room, Shapes

FREE_TURN_DEG = 1.0  # to whole degrees a part of any rotation is turned
PLACE_DECIMALS = 3  # of a mm, to which a place by hand is rounded
REACH_STEPS = 24  # halvings of the way towards a place that is taken


@dataclass(frozen=True)
class PlacedPart:
    """A part on a sheet; a locked one is moved by nobody."""

    placement: Placement
    locked: bool = False


class ManualNest:
    """The parts on the sheets, and how many of each item are wanted."""

    def __init__(
        self, items: Sequence[Item], sheets: Sequence[Sheet], spacing: Spacing, parts: Sequence[PlacedPart] = ()
    ):
        self.items, self.sheets, self.spacing = tuple(items), tuple(sheets), spacing
        self.parts = list(parts)
        self._polygons = [self.polygon_at(part.placement) for part in parts]

    @property
    def placements(self) -> list[Placement]:
        """Where all parts lie."""
        return [part.placement for part in self.parts]

    def counts(self) -> list[tuple[int, int]]:
        """Return how many of each item lie there, and how many are wanted."""
        lie = np.bincount([part.placement.item for part in self.parts], minlength=len(self.items)).tolist()
        return [(count, item.count) for count, item in zip(lie, self.items, strict=True)]

    def polygon_at(self, placement: Placement) -> Polygon:
        """Return the exact outline of an item at a place."""
        return placed(self.items[placement.item].exact, placement)

    def polygon(self, number: int) -> Polygon:
        """Return the exact outline of a part."""
        return self._polygons[number]

    def part_at(self, sheet: int, x_mm: float, y_mm: float) -> int | None:
        """Return the part under a place of a sheet, None where there is none; of parts in holes the inner one."""
        place = Point(x_mm, y_mm)
        return next((number for number in self._on(sheet) if self._polygons[number].covers(place)), None)

    def problem(self, placement: Placement, besides: int | None = None) -> str:
        """Return why an item may not lie at a place, "" where it may; besides: the part that would move there."""
        item, sheet = self.items[placement.item], self.sheets[placement.sheet]
        polygon = self.polygon_at(placement)
        if item.stock != sheet.stock:
            return Text("part '{name}' lies on a sheet of other stock", name=item.name)
        if not lies_within(polygon, sheet.outline, self.spacing.margin_mm):
            return Text("part '{name}' lies beyond the sheet '{sheet}'", name=item.name, sheet=sheet.name)
        for number in self._near(placement.sheet, polygon):
            if number != besides and conflict(polygon, self._polygons[number], self.spacing.gap_mm):
                other = self.items[self.parts[number].placement.item].name
                return Text("parts '{one}' and '{other}' are too close", one=item.name, other=other)
        return ""

    def move(self, number: int, placement: Placement) -> None:
        """Move a part to a place; raises JobError where it is locked or may not lie there, and changes nothing."""
        if self.parts[number].locked:
            raise JobError("nest-locked-part", "the part is locked", advice="unlock it before you move it")
        self._require(placement, number)
        self.parts[number] = PlacedPart(placement)
        self._polygons[number] = self.polygon_at(placement)

    def add(self, placement: Placement) -> int:
        """Add a part at a place and return its number; raises JobError where it may not lie there."""
        self._require(placement, None)
        self.parts.append(PlacedPart(placement))
        self._polygons.append(self.polygon_at(placement))
        return len(self.parts) - 1

    def remove(self, number: int) -> None:
        """Take a part away; those behind it get the numbers before theirs."""
        del self.parts[number], self._polygons[number]

    def lock(self, number: int, locked: bool) -> None:
        """Lock a part, or unlock it."""
        self.parts[number] = replace(self.parts[number], locked=locked)

    def moved_by(self, number: int, x_mm: float, y_mm: float, sheet: int | None = None) -> Placement:
        """Return where a part lies when it is moved by a length, rounded; `sheet` is the one it comes to."""
        own = self.parts[number].placement
        x, y = (round(value, PLACE_DECIMALS) + 0.0 for value in (own.x_mm + x_mm, own.y_mm + y_mm))
        return replace(own, sheet=own.sheet if sheet is None else sheet, x_mm=x, y_mm=y)

    def turned_by(self, number: int, angle_deg: float) -> Placement:
        """Return where a part lies when it is turned about the middle of its box, to the nearest allowed rotation."""
        own = self.parts[number].placement
        return self.turned_to(own, own.rotation_deg + angle_deg)

    def turned_to(self, own: Placement, rotation_deg: float) -> Placement:
        """Return a placement with the allowed rotation that is nearest; the middle of its box stays."""
        angle = self._nearest_deg(own, rotation_deg)
        exact = self.items[own.item].exact
        before, after = self.polygon_at(own).envelope.centroid, turned(exact, angle).envelope.centroid
        x, y = (round(value, PLACE_DECIMALS) + 0.0 for value in (before.x - after.x, before.y - after.y))
        return replace(own, x_mm=x, y_mm=y, rotation_deg=angle)

    def next_rotation_deg(self, number: int, sense: int = 1) -> float:
        """Return by how much a part is turned to its next allowed rotation, 0 where it has only one; any: by 90 deg."""
        own = self.parts[number].placement
        allowed = allowed_rotations_deg(self.items[own.item], self.sheets[own.sheet])
        if allowed is None:
            return 90.0 * sense
        steps = [(sense * (angle - own.rotation_deg)) % 360.0 for angle in allowed]
        return sense * min((step for step in steps if 1e-9 < step < 360.0 - 1e-9), default=0.0)

    def reached(self, number: int, wanted: Placement) -> Placement:
        """Return the place nearest to a wanted one on the straight way there at which the part may lie."""
        own = self.parts[number].placement
        if own.sheet != wanted.sheet or not self.problem(wanted, number):
            return wanted
        if own.rotation_deg != wanted.rotation_deg:
            return own
        free, taken, found = 0.0, 1.0, own
        for _ in range(REACH_STEPS):
            share = (free + taken) / 2.0
            place = self.moved_by(number, share * (wanted.x_mm - own.x_mm), share * (wanted.y_mm - own.y_mm))
            if self.problem(place, number):
                taken = share
            else:
                free, found = share, place
        return found

    def overlapping(self) -> list[int]:
        """Return the parts that may not lie where they do, as after a change of their drawings or of the spacing."""
        return [number for number, part in enumerate(self.parts) if self.problem(part.placement, number)]

    def _nearest_deg(self, own: Placement, rotation_deg: float) -> float:
        allowed = allowed_rotations_deg(self.items[own.item], self.sheets[own.sheet])
        if allowed is None:
            return round(rotation_deg / FREE_TURN_DEG) * FREE_TURN_DEG % 360.0
        off = [abs((angle - rotation_deg + 180.0) % 360.0 - 180.0) for angle in allowed]
        return allowed[int(np.argmin(off))] if allowed else own.rotation_deg

    def _on(self, sheet: int) -> Iterator[int]:
        return (number for number, part in enumerate(self.parts) if part.placement.sheet == sheet)

    def _near(self, sheet: int, polygon: Polygon) -> Iterator[int]:
        """Yield the parts of a sheet whose boxes come within the gap of a polygon's."""
        gap_mm = self.spacing.gap_mm
        left, low, right, high = polygon.bounds
        for number in self._on(sheet):
            box = self._polygons[number].bounds
            beside = box[0] > right + gap_mm or box[2] < left - gap_mm
            if not (beside or box[1] > high + gap_mm or box[3] < low - gap_mm):
                yield number

    def _require(self, placement: Placement, number: int | None) -> None:
        if what := self.problem(placement, number):
            raise JobError("nest-place", what, advice="choose another place")


def filled(nest: ManualNest, item: int, sheet: int, budget: Budget) -> list[Placement]:
    """Return where more parts of an item find place on a sheet, besides those that lie there, until the budget ends."""
    filling = Filling(Room(sheet, nest.sheets[sheet], nest.spacing), Shapes(nest.items, nest.spacing))
    for part in nest.parts:
        if part.placement.sheet == sheet:
            filling.add(part.placement)
    before = len(filling.placements)
    if nest.items[item].stock == nest.sheets[sheet].stock:
        while not budget.over and filling.place(item):
            pass
    return filling.placements[before:]


def in_rows(sheets: Sequence[Sheet], gap_mm: float) -> list[tuple[float, float]]:
    """Return where the lower left corners of the sheets' boxes are drawn so that they lie side by side, mm."""
    found, x_mm = [], 0.0
    for sheet in sheets:
        left, low, right, _ = sheet.outline.bounds
        found.append((x_mm - left, -low))
        x_mm += right - left + gap_mm
    return found


def sheet_at(
    sheets: Sequence[Sheet], corners: Sequence[tuple[float, float]], x_mm: float, y_mm: float
) -> tuple[int, float, float] | None:
    """Return the sheet at a place of the drawing by `in_rows`, and the place on it; None beside all."""
    for number, (sheet, (left, low)) in enumerate(zip(sheets, corners, strict=True)):
        if shapely.box(*sheet.outline.bounds).covers(Point(x_mm - left, y_mm - low)):
            return number, x_mm - left, y_mm - low
    return None
