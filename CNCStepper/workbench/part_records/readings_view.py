# SPDX-License-Identifier: LGPL-2.1-or-later
"""A plot of readings less their nominal length: a dot for each part, the mean, and its standard deviation as a band."""

from __future__ import annotations

from typing import Any

from PySide import QtCore, QtGui

from CNCStepper.machine.axis_tests import Readings
from CNCStepper.workbench.part_records.records_table import local
from CNCStepper.workbench.services.translation import tr

LEAST_PX = (240, 170)
MARGIN_PX, SCALE_PX, DOT_PX = 8, 58, 4
HEADROOM = 0.15  # of the range, above and below
LEAST_RANGE_MM = 0.002  # a plot of equal readings is as high as this
MEAN_COLOUR, BAND_COLOUR, DOT_COLOUR = "#d3461f", QtGui.QColor(95, 151, 211, 70), "#1f6fb2"
DECIMALS = 4


class ReadingsView(QtGui.QWidget):
    """See the module; title: what was measured, in the user's language."""

    def __init__(self, name: str, title: str, parent: Any):
        super().__init__(parent)
        self.setObjectName(name)
        self.setMinimumSize(*LEAST_PX)
        self.setToolTip(tr("A dot for each part; dashed: the nominal; red: the mean; the band: the standard deviation"))
        self._title = title
        self._readings: Readings | None = None
        self._nominal_mm = 0.0

    def show_readings(self, readings: Readings | None, nominal_mm: float) -> None:
        """Show other readings; None for none."""
        self._readings, self._nominal_mm = readings, nominal_mm
        self.update()

    def paintEvent(self, event: Any) -> None:
        """Draw the plot; Qt calls this."""
        painter = QtGui.QPainter(self)
        painter.setRenderHint(QtGui.QPainter.RenderHint.Antialiasing)
        palette = self.palette()
        painter.fillRect(self.rect(), palette.color(QtGui.QPalette.ColorRole.Base))
        painter.setPen(palette.color(QtGui.QPalette.ColorRole.Text))
        painter.drawText(self.rect().adjusted(0, MARGIN_PX, 0, 0), QtCore.Qt.AlignmentFlag.AlignHCenter, self._title)
        if self._readings is not None:
            self._draw(painter, self._readings)
        painter.end()

    def _draw(self, painter: Any, readings: Readings) -> None:
        """Draw band, lines and dots of the readings."""
        top = 2 * MARGIN_PX + painter.fontMetrics().height()
        room = QtCore.QRectF(self.rect()).adjusted(SCALE_PX, top, -MARGIN_PX, -top)
        errors_mm = [value - self._nominal_mm for value in readings.values_mm]
        mean_mm, deviation_mm = readings.mean_mm - self._nominal_mm, readings.deviation_mm
        scale = _Scale(room, [0.0, *errors_mm, mean_mm - deviation_mm, mean_mm + deviation_mm])
        band = QtCore.QRectF(room.left(), scale.y(mean_mm + deviation_mm), room.width(), 0.0)
        band.setBottom(scale.y(mean_mm - deviation_mm))
        painter.fillRect(band, BAND_COLOUR)
        ink = painter.pen().color()
        _level(painter, scale.y(0.0), room, QtGui.QPen(ink, 1, QtCore.Qt.PenStyle.DashLine))
        _level(painter, scale.y(mean_mm), room, QtGui.QPen(QtGui.QColor(MEAN_COLOUR), 1.5))
        painter.setPen(ink)
        for value_mm in (scale.low_mm, scale.high_mm):
            words = QtCore.QRectF(0, scale.y(value_mm) - top / 2, SCALE_PX - 4, top)
            side = QtCore.Qt.AlignmentFlag.AlignRight | QtCore.Qt.AlignmentFlag.AlignVCenter
            painter.drawText(words, side, local(value_mm, DECIMALS))
        _dots(painter, room, [scale.y(error_mm) for error_mm in errors_mm], ink)


class _Scale:
    """Pixels of lengths: the highest at the top of the room, the lowest at its bottom."""

    def __init__(self, room: Any, values_mm: list[float]):
        spare_mm = HEADROOM * max(max(values_mm) - min(values_mm), LEAST_RANGE_MM)
        self.low_mm, self.high_mm = min(values_mm) - spare_mm, max(values_mm) + spare_mm
        self._room = room

    def y(self, value_mm: float) -> float:
        """Return the pixel of a length."""
        share = (value_mm - self.low_mm) / (self.high_mm - self.low_mm)
        return float(self._room.bottom() - share * self._room.height())


def _level(painter: Any, y: float, room: Any, pen: Any) -> None:
    painter.setPen(pen)
    painter.drawLine(QtCore.QPointF(room.left(), y), QtCore.QPointF(room.right(), y))


def _dots(painter: Any, room: Any, heights: list[float], ink: Any) -> None:
    """Draw a dot for each part, and the number of the first and the last below them."""
    for number, y in enumerate(heights):
        x = room.left() + room.width() * (number + 0.5) / len(heights)
        painter.setPen(QtCore.Qt.PenStyle.NoPen)
        painter.setBrush(QtGui.QColor(DOT_COLOUR))
        painter.drawEllipse(QtCore.QPointF(x, y), DOT_PX, DOT_PX)
        if number in (0, len(heights) - 1):
            painter.setPen(ink)
            words = QtCore.QRectF(x - SCALE_PX, room.bottom() + 2, 2 * SCALE_PX, painter.fontMetrics().height() + 2)
            painter.drawText(words, QtCore.Qt.AlignmentFlag.AlignCenter, str(number + 1))
