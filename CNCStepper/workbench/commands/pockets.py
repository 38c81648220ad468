# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_Pocket, _RectangularPocket, _CircularPocket and _Face: areas that are cleared."""

from __future__ import annotations

from typing import Any

from CNCStepper.workbench.commands.create_object import Operation
from CNCStepper.workbench.document import default_values
from CNCStepper.workbench.services.translation import QT_TRANSLATE_NOOP, later


class Pocket(Operation):
    """Adds a pocket of any region to the job."""

    name = "CNCStepper_Pocket"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_Pocket", "Pocket")
    tooltip = QT_TRANSLATE_NOOP("CNCStepper_Pocket", "Clears what the selected closed lines or faces enclose")
    cycle = "pocket"
    label = later("Pocket")
    no_drawing = later("Select what is to be cleared: a sketch, closed wires, or faces of a solid")

    def values(self, job: Any, tool: Any, is_drawn: bool) -> dict[str, Any]:
        """Return values that fit the stock and the tool."""
        return default_values.area(tuple(job.StockSize), float(tool.Diameter))


class RectangularPocket(Operation):
    """Adds a rectangular pocket to the job."""

    name = "CNCStepper_RectangularPocket"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_RectangularPocket", "Rectangular pocket")
    tooltip = QT_TRANSLATE_NOOP(
        "CNCStepper_RectangularPocket", "Cuts a pocket: the selected rectangle, or one by numbers"
    )
    cycle = "rectangular_pocket"
    label = later("Rectangular pocket")

    def values(self, job: Any, tool: Any, is_drawn: bool) -> dict[str, Any]:
        """Return values that fit the stock and the tool."""
        return default_values.rectangle(tuple(job.StockSize), job.StockOrigin, float(tool.Diameter), is_drawn)


class CircularPocket(Operation):
    """Adds a circular pocket to the job."""

    name = "CNCStepper_CircularPocket"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_CircularPocket", "Circular pocket")
    tooltip = QT_TRANSLATE_NOOP("CNCStepper_CircularPocket", "Cuts a pocket: the selected circle, or one by numbers")
    cycle = "circular_pocket"
    label = later("Circular pocket")

    def values(self, job: Any, tool: Any, is_drawn: bool) -> dict[str, Any]:
        """Return values that fit the stock and the tool."""
        return default_values.circle(tuple(job.StockSize), job.StockOrigin, float(tool.Diameter), is_drawn)


class Face(Operation):
    """Adds a facing to the job."""

    name = "CNCStepper_Face"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_Face", "Face")
    tooltip = QT_TRANSLATE_NOOP("CNCStepper_Face", "Makes the top flat: of the stock, or of what is selected")
    cycle = "face"
    label = later("Facing")

    def values(self, job: Any, tool: Any, is_drawn: bool) -> dict[str, Any]:
        """Return values that fit the stock and the tool."""
        return default_values.face(tuple(job.StockSize), float(tool.Diameter))
