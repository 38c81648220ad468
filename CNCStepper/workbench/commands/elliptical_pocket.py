# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_EllipticalPocket: a pocket from the selected ellipse, or from numbers."""

from __future__ import annotations

from typing import Any

from CNCStepper.workbench.commands.create_object import Operation
from CNCStepper.workbench.document import default_values
from CNCStepper.workbench.services.translation import QT_TRANSLATE_NOOP, later


class EllipticalPocket(Operation):
    """Adds an elliptical pocket to the job."""

    name = "CNCStepper_EllipticalPocket"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_EllipticalPocket", "Elliptical pocket")
    tooltip = QT_TRANSLATE_NOOP("CNCStepper_EllipticalPocket", "Cuts a pocket: the selected ellipse, or one by numbers")
    cycle = "elliptical_pocket"
    label = later("Elliptical pocket")

    def values(self, job: Any, tool: Any, is_drawn: bool) -> dict[str, Any]:
        """Return values that fit the stock and the tool."""
        return default_values.pocket(tuple(job.StockSize), job.StockOrigin, float(tool.Diameter), is_drawn)
