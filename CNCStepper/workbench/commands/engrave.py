# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_Engrave: the tool follows the lines of the selected drawing."""

from __future__ import annotations

from typing import Any

from CNCStepper.workbench.commands.create_object import Operation
from CNCStepper.workbench.document import default_values
from CNCStepper.workbench.services.translation import QT_TRANSLATE_NOOP, later


class Engrave(Operation):
    """Adds an engraving to the job."""

    name = "CNCStepper_Engrave"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_Engrave", "Engrave")
    tooltip = QT_TRANSLATE_NOOP("CNCStepper_Engrave", "Cuts along the lines of the selected drawing")
    cycle = "engrave"
    label = later("Engraving")
    no_drawing = later("Select what is to be engraved: a sketch, a wire, a B-spline or a freehand line")

    def values(self, job: Any, tool: Any, is_drawn: bool) -> dict[str, Any]:
        """Return values that fit the stock."""
        return default_values.engraving(tuple(job.StockSize))
