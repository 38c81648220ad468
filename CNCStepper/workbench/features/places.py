# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where holes stand: the properties that drilling, boring and thread milling share, and what a drawing gives them."""

from __future__ import annotations

from collections import defaultdict
from dataclasses import replace
from itertools import chain
from typing import Any

from CNCStepper.cycles.holes.hole_parameters import PATTERNS, PLACES
from CNCStepper.cycles.parameter import declared
from CNCStepper.errors import CycleError, Text
from CNCStepper.workbench.features.base import ENUMERATION, INTEGER, Property, values
from CNCStepper.workbench.features.cycle_operation import drawings_of, drawn
from CNCStepper.workbench.features.operation import Operation
from CNCStepper.workbench.features.parameters import property_of
from CNCStepper.workbench.services.translation import later

DRAWN = "drawing"
KIND = "pattern_kind"
ORDER = ("points_mm", "centre_mm", "radius_mm", "start_mm", "end_mm", "count", "start_deg", "end_deg", "origin_mm",
         "spacing_mm", "columns", "rows", "rotation_deg")  # fmt: skip


def pattern_properties() -> dict[str, Property]:
    """Return a property for each key of the patterns, which counts with the kinds that have that key."""
    found: dict[str, Property] = {}
    kinds: defaultdict[str, tuple[str, ...]] = defaultdict(tuple)
    for kind, *fields in map(declared, PATTERNS):
        for row in chain.from_iterable(field.rows for field in fields):
            kinds[row.key] += kind.choices
            found[row.key] = replace(property_of(row, "pattern_", "place_"), only=(KIND, kinds[row.key]))
    return found


PATTERN = (
    Property(KIND, "Places", ENUMERATION, PLACES, later("Places"), later("The places of the holes"), "bolt_circle",
             choices=(DRAWN, *(choice for pattern in PATTERNS for choice in declared(pattern)[0].choices))),
    *drawn(PLACES, later("The circles and points of sketches, or the circular edges of solids"),
           only=(KIND, (DRAWN,))),
    *map(pattern_properties().__getitem__, ORDER),
)  # fmt: skip
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
