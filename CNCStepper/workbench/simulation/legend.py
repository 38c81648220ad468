# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the colours of the 3D view mean: a scale of depths, rapids and feeds."""

from __future__ import annotations

from typing import Any

from PySide import QtCore, QtGui

from CNCStepper.workbench.services.quantity_format import length_text
from CNCStepper.workbench.services.translation import tr
from CNCStepper.workbench.simulation.scene import FEED_RGB, RAPID_RGB

BAR_PX = 12
GAP_PX = 4


class Legend(QtGui.QWidget):
    """A bar of colours from the deepest cut to the top, labelled in the user's units, and the two kinds of lines."""

    def __init__(self, deepest_mm: float, top_mm: float, parent: Any = None):
        super().__init__(parent)
        self.setObjectName("CNCStepper_Simulation_legend")
        self._range_mm = (deepest_mm, top_mm)
        line_px = self.fontMetrics().height()
        self.setMinimumHeight(BAR_PX + 2 * line_px + 3 * GAP_PX)
        self.setToolTip(tr("Height above the top of the stock; lines: where the tool's tip goes"))

    def paintEvent(self, event: Any) -> None:
        """Paint it; Qt calls this."""
        painter = QtGui.QPainter(self)
        self._paint_bar(painter)
        self._paint_heights(painter)
        self._paint_lines(painter)
        painter.end()

    def _paint_bar(self, painter: Any) -> None:
        from CNCStepper.simulation.views.depth_colours import MATERIAL

        gradient = QtGui.QLinearGradient(0, 0, self.width(), 0)
        for place, colour in enumerate(MATERIAL):
            gradient.setColorAt(place / (len(MATERIAL) - 1), QtGui.QColor(colour))
        painter.fillRect(0, 0, self.width(), BAR_PX, gradient)

    def _paint_heights(self, painter: Any) -> None:
        low, high = self._range_mm
        height = self.fontMetrics().height()
        for share, side in ((0.0, "AlignLeft"), (0.5, "AlignHCenter"), (1.0, "AlignRight")):
            place = QtCore.QRect(0, BAR_PX + GAP_PX, self.width(), height)
            align = getattr(QtCore.Qt.AlignmentFlag, side)
            painter.drawText(place, align, length_text(low + (high - low) * share))

    def _paint_lines(self, painter: Any) -> None:
        metrics = self.fontMetrics()
        y, x, sample = BAR_PX + 2 * GAP_PX + metrics.height(), 0, 2 * metrics.height()
        for rgb, text in ((FEED_RGB, tr("feed")), (RAPID_RGB, tr("rapid"))):
            painter.setPen(QtGui.QPen(QtGui.QColor.fromRgbF(*rgb), 2))
            middle = y + metrics.height() // 2
            painter.drawLine(x, middle, x + sample, middle)
            painter.setPen(self.palette().color(QtGui.QPalette.ColorRole.WindowText))
            painter.drawText(x + sample + GAP_PX, y + metrics.ascent(), text)
            x += sample + metrics.boundingRect(text).width() + 5 * GAP_PX
