# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_Contour: the tool runs on or beside the lines of the selected drawing."""

from __future__ import annotations

from typing import Any

from CNCStepper.workbench.commands.create_object import Operation
from CNCStepper.workbench.document import default_values
from CNCStepper.workbench.services.translation import QT_TRANSLATE_NOOP, later


class Contour(Operation):
    """Adds a contour to the job."""

    name = "CNCStepper_Contour"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_Contour", "Contour")
    tooltip = QT_TRANSLATE_NOOP("CNCStepper_Contour", "Cuts along the selected lines or faces: outside, inside or on")
    cycle = "contour"
    label = later("Contour")
    no_drawing = later("Select what is to be cut out: a sketch, wires, or faces or edges of a solid")

    def values(self, job: Any, tool: Any, is_drawn: bool) -> dict[str, Any]:
        """Return values that cut through the stock."""
        return default_values.contour(tuple(job.StockSize))
