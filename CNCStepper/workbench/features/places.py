# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where holes stand: the properties that drilling, boring and thread milling share, and what a drawing gives them."""

from __future__ import annotations

from typing import Any

from CNCStepper.errors import CycleError, Text
from CNCStepper.workbench.features.base import (
    ANGLE,
    DISTANCE,
    ENUMERATION,
    INTEGER,
    POINTS,
    POSITION,
    Property,
    values,
)
from CNCStepper.workbench.features.common import CUT, PATH
from CNCStepper.workbench.features.operation import Operation, drawings_of, drawn
from CNCStepper.workbench.services.translation import later

PLACES = later("Places")
DRAWN = "drawing"
KIND = "pattern_kind"
ROUND, COUNTED = (KIND, ("bolt_circle", "arc")), (KIND, ("bolt_circle", "arc", "line"))

PATTERN = (
    Property(KIND, "Places", ENUMERATION, PLACES, later("Places"), later("Where the holes stand"), "bolt_circle",
             choices=(DRAWN, "bolt_circle", "grid", "line", "arc", "points")),
    *drawn(PLACES, later("The circles and points of sketches, or the circular edges of solids"),
           only=(KIND, (DRAWN,))),
    Property("pattern_points_mm", "PlacePoints", POINTS, PLACES, later("Points"), later("One hole at each point"),
             ((0.0, 0.0, 0.0),), only=(KIND, ("points",)), plane=True),
    Property("pattern_centre_mm", "PlaceCentre", POSITION, PLACES, later("Centre"),
             later("The middle of the circle, from the work zero"), (0.0, 0.0), only=ROUND, plane=True),
    Property("pattern_radius_mm", "PlaceRadius", DISTANCE, PLACES, later("Radius"),
             later("From the middle of the circle to the holes"), 20.0, only=ROUND),
    Property("pattern_start_mm", "PlaceStart", POSITION, PLACES, later("First hole"),
             later("Where the row begins, from the work zero"), (-30.0, 0.0), only=(KIND, ("line",)), plane=True),
    Property("pattern_end_mm", "PlaceEnd", POSITION, PLACES, later("Last hole"), later("Where the row ends"),
             (30.0, 0.0), only=(KIND, ("line",)), plane=True),
    Property("pattern_count", "PlaceCount", INTEGER, PLACES, later("Count"), later("How many holes"), 6, only=COUNTED),
    Property("pattern_start_deg", "PlaceStartAngle", ANGLE, PLACES, later("Start angle"),
             later("From X to the first hole, counter-clockwise"), 0.0, only=ROUND),
    Property("pattern_end_deg", "PlaceEndAngle", ANGLE, PLACES, later("End angle"), later("From X to the last hole"),
             90.0, only=(KIND, ("arc",))),
    Property("pattern_origin_mm", "PlaceOrigin", POSITION, PLACES, later("First hole"),
             later("The corner where the grid begins, from the work zero"), (-30.0, -20.0), only=(KIND, ("grid",)),
             plane=True),
    Property("pattern_spacing_mm", "PlaceSpacing", POSITION, PLACES, later("Spacing"),
             later("From hole to hole along X and along Y"), (20.0, 20.0), only=(KIND, ("grid",)), plane=True),
    Property("pattern_columns", "PlaceColumns", INTEGER, PLACES, later("Columns"), later("How many holes along X"), 4,
             only=(KIND, ("grid",))),
    Property("pattern_rows", "PlaceRows", INTEGER, PLACES, later("Rows"), later("How many holes along Y"), 3,
             only=(KIND, ("grid",))),
    Property("pattern_rotation_deg", "PlaceRotation", ANGLE, PLACES, later("Rotation"),
             later("Of the grid about its first hole"), 0.0, only=(KIND, ("grid",))),
)  # fmt: skip
THROUGH = Property("through_mm", "Through", DISTANCE, CUT, later("Beyond"),
                   later("How much deeper the tool goes, to come out below"), 0.0)  # fmt: skip
ORDER = Property("order", "Order", ENUMERATION, PATH, later("Order"),
                 later("The order in which the holes are made"), "short", choices=("short", "given"))  # fmt: skip
HOLES = Property("holes", "Holes", INTEGER, later("Figures"), later("Holes"), later("How many holes are made"), 0,
                 output=True)  # fmt: skip


class Places(Operation):
    """The proxy of an operation that makes holes."""

    TABLES = ("pattern",)
    PICKS_LINES = True

    @classmethod
    def look(cls, drawing: Any, picked: tuple[str, ...]) -> None:
        """Raise GeometryError when the drawing wants no holes."""
        from CNCStepper.workbench.drawings.holes import holes_of

        holes_of(drawing, picked)

    def given(self, found: dict[str, Any]) -> dict[str, Any]:
        """Return the parameters; a pattern that is drawn is none of them yet."""
        content = super().given(found)
        pattern = content.pop("pattern")
        if pattern["kind"] == DRAWN:
            return content
        if pattern["kind"] == "grid":
            pattern["count"] = (pattern.pop("columns"), pattern.pop("rows"))
        return {**content, "pattern": pattern}

    def cycle_values(self, obj: Any, origin_mm: tuple[float, ...]) -> dict[str, Any]:
        """Return the parameters, and the places that the drawing gives."""
        content = self.given(values(obj))
        return content if "pattern" in content else {**content, "pattern": self.drawn_pattern(obj, origin_mm)}

    def drawn_pattern(self, obj: Any, origin_mm: tuple[float, ...]) -> dict[str, Any]:
        """Return the pattern that the drawings give, from the work zero: circles, points where they have any."""
        from CNCStepper.geometry.curve import circle
        from CNCStepper.workbench.drawings.holes import remarks

        holes = drawn_holes(obj)
        self.remarks = tuple(remarks(drawings_of(obj), holes))
        centres = [(x - origin_mm[0], y - origin_mm[1]) for x, y in (hole.centre_mm for hole in holes)]
        radii = [hole.diameter_mm / 2 for hole in holes]
        if not all(radii):
            return {"kind": "points", "points_mm": centres}
        return {"kind": "circles", "circles": [circle(*each) for each in zip(centres, radii, strict=True)]}


def drawn_holes(obj: Any) -> list[Any]:
    """Return the holes that an operation's drawings want; raises CycleError where it has none.

    Where the order is to be short, that of the drawings does not matter.
    """
    from CNCStepper.workbench.drawings.holes import holes_of_all

    pairs = drawings_of(obj)
    if not pairs:
        advice = "choose a sketch with circles or points, or give the places by numbers"
        raise CycleError("drawing-missing", Text("{obj} has no drawing", obj=obj.Label), advice=advice)
    if obj.Order == "short":
        pairs = tuple(sorted(pairs, key=lambda pair: pair[0].ID))
    return holes_of_all(pairs)
