# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_Pocket: the area inside the closed lines of a drawing, without its islands."""

from __future__ import annotations

from typing import Any

from CNCStepper.cycles.pockets.pocket_parameters import PocketParameters
from CNCStepper.workbench.features.base import values
from CNCStepper.workbench.features.cycle_operation import OPERATION, drawn
from CNCStepper.workbench.features.operation import Operation, drawn_lines
from CNCStepper.workbench.features.parameters import PASSES, REST, properties_of
from CNCStepper.workbench.services.translation import later


class Pocket(Operation):
    """The proxy of a pocket; the outermost closed lines are its outlines, those in them islands, and so on."""

    Type = "CNCStepper_Pocket"
    CYCLE = "pocket"
    CLOSED = True
    PROPERTIES = (
        *OPERATION,
        *drawn(later("Region"), later("A sketch, wires or faces: closed lines, those inside are islands")),
        *properties_of(PocketParameters),
        *PASSES,
        *REST,
    )

    def cycle_values(self, obj: Any, origin_mm: tuple[float, ...]) -> dict[str, Any]:
        """Return the parameters, and the drawings' closed curves as outlines and islands."""
        outlines, islands = drawn_lines(obj, origin_mm, "choose a sketch, closed wires or faces for it").nested
        return {**self.given(values(obj)), "outlines": outlines, "islands": islands}
