# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_Drill, _Bore and _Thread: holes at the selected circles and points, or in a pattern."""

from __future__ import annotations

from typing import Any

from CNCStepper.workbench.commands.create_object import Operation
from CNCStepper.workbench.document import default_values
from CNCStepper.workbench.services.translation import QT_TRANSLATE_NOOP, later


class Holes(Operation):
    """Adds an operation that makes holes."""

    def values(self, job: Any, tool: Any, is_drawn: bool) -> dict[str, Any]:
        """Return values that fit the stock: in a pattern in its middle, or at the drawing's places."""
        return default_values.holes(tuple(job.StockSize), job.StockOrigin, is_drawn)


class Drill(Holes):
    """Adds drilling to the job."""

    name = "CNCStepper_Drill"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_Drill", "Drill")
    tooltip = QT_TRANSLATE_NOOP("CNCStepper_Drill", "Drills at the selected circles and points, or in a pattern")
    cycle = "drill"
    label = later("Drilling")


class Bore(Holes):
    """Adds boring to the job."""

    name = "CNCStepper_Bore"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_Bore", "Bore")
    tooltip = QT_TRANSLATE_NOOP("CNCStepper_Bore", "Cuts holes wider than the tool along helices: the selected circles")
    cycle = "bore"
    label = later("Boring")

    def values(self, job: Any, tool: Any, is_drawn: bool) -> dict[str, Any]:
        """Return values that fit the stock and the tool; circles that are drawn have their own diameters."""
        values = super().values(job, tool, is_drawn)
        return {**values, "diameter_mm": 0.0 if is_drawn else default_values.bored(float(tool.Diameter))}


class Thread(Holes):
    """Adds thread milling to the job."""

    name = "CNCStepper_Thread"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_Thread", "Thread")
    tooltip = QT_TRANSLATE_NOOP("CNCStepper_Thread", "Mills threads at the selected circles, or in a pattern")
    cycle = "thread"
    label = later("Thread")

    def values(self, job: Any, tool: Any, is_drawn: bool) -> dict[str, Any]:
        """Return values that fit the stock; circles that are drawn have their own diameters."""
        values = super().values(job, tool, is_drawn)
        return {**values, "major_diameter_mm": 0.0 if is_drawn else default_values.bored(float(tool.Diameter))}
