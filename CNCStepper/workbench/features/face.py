# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_Face: the top of the stock, or of what a drawing encloses, made flat."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from CNCStepper.workbench.features.base import DISTANCE, Property, values
from CNCStepper.workbench.features.common import (
    DEPTH,
    DIRECTION,
    ENTRY,
    FINISH_FEED,
    FINISH_STEPDOWN,
    PASSES,
    PATH,
    PATTERN,
    PATTERN_VALUES,
    STEPDOWN,
    STEPOVER,
    TOLERANCE,
)
from CNCStepper.workbench.features.operation import OPERATION, Operation, drawn, drawn_curves
from CNCStepper.workbench.shapes import require_closed
from CNCStepper.workbench.words import later

ANGLED = PATTERN_VALUES[0]


class Face(Operation):
    """The proxy of a facing; without a drawing it faces the whole stock."""

    Type = "CNCStepper_Face"
    CYCLE = "face"
    NO_DRAWING = later("the whole stock")
    PROPERTIES = (
        *OPERATION,
        *drawn(later("Region"), later("Closed lines round what is faced; without it the whole stock")),
        DEPTH,
        STEPDOWN,
        STEPOVER,
        replace(PATTERN, default="zigzag", choices=("zigzag", "oneway", "spiral")),
        ANGLED,
        DIRECTION,
        replace(FINISH_STEPDOWN, default=0.0),
        replace(FINISH_FEED, text=later("The feed of the last pass; 0: the tool's own feed")),
        Property("overhang_mm", "Overhang", DISTANCE, PATH, later("Overhang"),
                 later("How far the tool's rim runs over the edge"), 1.0),
        TOLERANCE,
        *ENTRY,
        *PASSES,
    )  # fmt: skip

    @classmethod
    def look(cls, drawing: Any, picked: tuple[str, ...]) -> None:
        """Raise GeometryError unless all lines of the drawing are closed."""
        require_closed(drawing, picked)

    def cycle_values(self, obj: Any, origin_mm: tuple[float, ...]) -> dict[str, Any]:
        """Return the parameters, and the drawing's closed curves where there is one."""
        if obj.Drawing is None:
            return self.given(values(obj))
        from CNCStepper.workbench.nesting import nested

        outlines, _ = nested(drawn_curves(obj, origin_mm, ""), obj.Drawing.Label)
        return {**self.given(values(obj)), "outlines": outlines}
