# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands that add an operation to a job, in the order of the toolbar."""

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
    no_drawing = later("Select the area to clear: a sketch, closed wires, or faces of a solid")

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


class Contour(Operation):
    """Adds a contour to the job."""

    name = "CNCStepper_Contour"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_Contour", "Contour")
    tooltip = QT_TRANSLATE_NOOP("CNCStepper_Contour", "Cuts along the selected lines or faces: outside, inside or on")
    cycle = "contour"
    label = later("Contour")
    no_drawing = later("Select the lines to cut: a sketch, wires, or faces or edges of a solid")

    def values(self, job: Any, tool: Any, is_drawn: bool) -> dict[str, Any]:
        """Return values that cut through the stock."""
        return default_values.contour(tuple(job.StockSize))


class Holes(Operation):
    """Adds an operation that makes holes; diameter_key: of the diameter that follows from the tool, "" for none."""

    diameter_key = ""

    def values(self, job: Any, tool: Any, is_drawn: bool) -> dict[str, Any]:
        """Return values that fit the stock: in a pattern in its middle, or where the drawing says.

        Circles that are drawn have their own diameters, which 0 stands for.
        """
        values = default_values.holes(tuple(job.StockSize), job.StockOrigin, is_drawn)
        diameter_mm = 0.0 if is_drawn else default_values.bored(float(tool.Diameter))
        return values | ({self.diameter_key: diameter_mm} if self.diameter_key else {})


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
    diameter_key = "diameter_mm"


class Thread(Holes):
    """Adds thread milling to the job."""

    name = "CNCStepper_Thread"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_Thread", "Thread")
    tooltip = QT_TRANSLATE_NOOP("CNCStepper_Thread", "Mills threads at the selected circles, or in a pattern")
    cycle = "thread"
    label = later("Thread")
    diameter_key = "major_diameter_mm"


class Engrave(Operation):
    """Adds an engraving to the job."""

    name = "CNCStepper_Engrave"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_Engrave", "Engrave")
    tooltip = QT_TRANSLATE_NOOP("CNCStepper_Engrave", "Cuts along the lines of the selected drawing")
    cycle = "engrave"
    label = later("Engraving")
    no_drawing = later("Select the lines to engrave: a sketch, a wire, a B-spline or a freehand line")

    def values(self, job: Any, tool: Any, is_drawn: bool) -> dict[str, Any]:
        """Return values that fit the stock."""
        return default_values.engraving(tuple(job.StockSize))


class SheetCut(Operation):
    """Adds a cut out of sheet to the job."""

    name = "CNCStepper_SheetCut"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_SheetCut", "Sheet cut")
    tooltip = QT_TRANSLATE_NOOP("CNCStepper_SheetCut", "Cuts parts out of sheet by torch, laser, jet, knife or point")
    cycle = "sheet_cut"
    label = later("Sheet cut")
    no_drawing = later("Select the lines to cut: a sketch, wires, or faces or edges of a solid")

    def values(self, job: Any, tool: Any, is_drawn: bool) -> dict[str, Any]:
        """Return nothing: process and chart give the values."""
        return {}


class WireCut(Operation):
    """Adds a cut with a hot wire to the job."""

    name = "CNCStepper_WireCut"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_WireCut", "Wire cut")
    tooltip = QT_TRANSLATE_NOOP("CNCStepper_WireCut", "Cuts parts out of foam with a hot wire, in from the edge")
    cycle = "wire_cut"
    label = later("Wire cut")
    no_drawing = later("Select the lines to cut: a sketch, wires, or faces or edges of a solid")

    def values(self, job: Any, tool: Any, is_drawn: bool) -> dict[str, Any]:
        """Return nothing: process and chart give the values."""
        return {}


AREAS = (Face, Pocket, RectangularPocket, CircularPocket, EllipticalPocket)
LINES_AND_HOLES = (Contour, Drill, Bore, Thread, Engrave)
SHEETS = (SheetCut, WireCut)
