# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_WireCut: parts cut out of foam by a hot wire, in one way from the sheet's edge."""

from __future__ import annotations

from typing import Any

from CNCStepper.cycles.contours.contour_parameters import LINES
from CNCStepper.cycles.wire_cutting.wire_parameters import WireParameters
from CNCStepper.workbench.features.base import DISTANCE, INTEGER, Property
from CNCStepper.workbench.features.cycle_operation import OPERATION, drawn
from CNCStepper.workbench.features.operation import Operation, drawn_lines
from CNCStepper.workbench.features.parameters import MADE, properties_of
from CNCStepper.workbench.services.translation import later


class WireCut(Operation):
    """The proxy of a cut with a hot wire along all chains of lines in a drawing."""

    Type = "CNCStepper_WireCut"
    CYCLE = "wire_cut"
    BY = ("hot-wire",)
    PROPERTIES = (
        *OPERATION,
        *drawn(LINES, later("The sketch, wires or faces to cut: closed lines are parts and holes in turn")),
        *properties_of(WireParameters),
        Property("parts", "Parts", INTEGER, MADE, later("Parts"), later("How many parts are cut free"), 0,
                 output=True),
        Property("used_kerf_mm", "KerfUsed", DISTANCE, MADE, later("Kerf"), later("The width of the cut"), 0.0,
                 output=True),
    )  # fmt: skip

    def cycle_values(self, obj: Any, origin_mm: tuple[float, ...]) -> dict[str, Any]:
        """Return the parameters and the drawings' curves."""
        curves = drawn_lines(obj, origin_mm, "choose a sketch, wires or faces for it").curves
        return {**self.given(self.known(obj)), "curves": tuple(each.curve for each in curves)}

    def figures(self, obj: Any) -> dict[str, float]:
        """Return what the cycle reports; its kerf stands under a key of its own beside the parameter's."""
        found = super().figures(obj)
        return {**found, "used_kerf_mm": found.get("kerf_mm", 0.0)}
