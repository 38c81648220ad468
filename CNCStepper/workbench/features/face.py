# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_Face: faces the top of the stock, or the area that a drawing encloses."""

from __future__ import annotations

from typing import Any

from CNCStepper.cycles.facing.face_parameters import FaceParameters
from CNCStepper.workbench.features.base import values
from CNCStepper.workbench.features.cycle_operation import OPERATION, drawings_of, drawn
from CNCStepper.workbench.features.operation import Operation, drawn_lines
from CNCStepper.workbench.features.parameters import PASSES, properties_of
from CNCStepper.workbench.services.translation import later


class Face(Operation):
    """The proxy of a facing; without a drawing it faces the whole stock."""

    Type = "CNCStepper_Face"
    CYCLE = "face"
    CLOSED = True
    NO_DRAWING = later("the whole stock")
    PROPERTIES = (
        *OPERATION,
        *drawn(later("Region"), later("Closed lines around the area to face; without them the whole stock")),
        *properties_of(FaceParameters),
        *PASSES,
    )

    def cycle_values(self, obj: Any, origin_mm: tuple[float, ...]) -> dict[str, Any]:
        """Return the parameters, and the drawings' outermost closed curves where there are some."""
        if not drawings_of(obj):
            return self.given(values(obj))
        outlines, islands = drawn_lines(obj, origin_mm, "").nested
        if islands:
            self.remarks = (*self.remarks, "what lies inside an outline is faced with it")
        return {**self.given(values(obj)), "outlines": outlines}
