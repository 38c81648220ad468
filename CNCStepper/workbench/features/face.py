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
from CNCStepper.workbench.features.operation import OPERATION, Operation, drawings_of, drawn, drawn_lines
from CNCStepper.workbench.services.translation import later

ANGLED = PATTERN_VALUES[0]


class Face(Operation):
    """The proxy of a facing; without a drawing it faces the whole stock."""

    Type = "CNCStepper_Face"
    CYCLE = "face"
    CLOSED = True
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

    def cycle_values(self, obj: Any, origin_mm: tuple[float, ...]) -> dict[str, Any]:
        """Return the parameters, and the drawings' outermost closed curves where there are some."""
        if not drawings_of(obj):
            return self.given(values(obj))
        outlines, islands = drawn_lines(obj, origin_mm, "").nested
        if islands:
            self.remarks = (*self.remarks, "what lies inside an outline is faced with it")
        return {**self.given(values(obj)), "outlines": outlines}
