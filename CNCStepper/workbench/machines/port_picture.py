# SPDX-License-Identifier: LGPL-2.1-or-later
"""A picture of the parallel port's 25 pins: the socket as one looks at it, each pin with its signal and its level.

13 12 11 10  9  8  7  6  5  4  3  2  1        upper row, as on the computer's own socket
  25 24 23 22 21 20 19 18 17 16 15 14         lower row
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from PySide import QtCore, QtGui

from CNCStepper.machine.wiring import INPUT_PINS, OUTPUT_PINS
from CNCStepper.workbench.services.translation import tr

UPPER, LOWER = tuple(range(13, 0, -1)), tuple(range(25, 13, -1))
OUTPUT, INPUT, GROUND = "#5e97d3", "#36b56c", "#6b7785"
ON = "#f7b92f"
SHELL, FACE, INK = "#a9b3bd", "#f3f6f9", "#1b3556"
PITCH_PX, RADIUS_PX, NAME_PX, ROW_PX = 46, 11, 110, 46
HALF_TURN = 180 * 16  # as QPainter counts angles
SIZE = (13 * PITCH_PX + 30, 2 * NAME_PX + 2 * ROW_PX + 24)


class PortPicture(QtGui.QWidget):
    """The pins; names are of the signals on them, levels what is known of each; pulsing pins change all the time."""

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("CNCStepper_Machine_port")
        self.setAccessibleName(tr("Parallel port"))
        self.setSizePolicy(QtGui.QSizePolicy.Policy.Fixed, QtGui.QSizePolicy.Policy.Fixed)
        self.setMouseTracking(True)
        self._names: dict[int, str] = {}
        self._low: set[int] = set()
        self._levels: dict[int, bool] = {}
        self._pulsing: frozenset[int] = frozenset()

    def sizeHint(self) -> Any:
        """Return the size of the whole picture."""
        return QtCore.QSize(*SIZE)

    def minimumSizeHint(self) -> Any:
        """Return the same: names are never cut off."""
        return self.sizeHint()

    def show_pins(self, names: Mapping[int, str], active_low: set[int]) -> None:
        """Show the names of signals by their pins, and which of them are active low."""
        self._names, self._low = dict(names), set(active_low)
        self.update()

    def show_levels(self, levels: Mapping[int, bool], pulsing: frozenset[int] = frozenset()) -> None:
        """Show which pins are high or low, and which have step pulses now; of the others nothing is known."""
        if (levels, pulsing) != (self._levels, self._pulsing):
            self._levels, self._pulsing = dict(levels), pulsing
            self.update()

    def places(self) -> dict[int, Any]:
        """Return the middle of each pin."""
        left, top = 15 + PITCH_PX / 2, NAME_PX + 12 + ROW_PX / 2
        upper = {pin: QtCore.QPointF(left + place * PITCH_PX, top) for place, pin in enumerate(UPPER)}
        lower = {pin: QtCore.QPointF(left + (place + 0.5) * PITCH_PX, top + ROW_PX) for place, pin in enumerate(LOWER)}
        return {**upper, **lower}

    def words(self, pin: int) -> str:
        """Return what is to be said of a pin."""
        kind = tr("output") if pin in OUTPUT_PINS else tr("input") if pin in INPUT_PINS else tr("ground")
        parts = [tr("Pin {0}: {1}").format(pin, kind), self._names.get(pin, "")]
        parts.append(tr("active low") if pin in self._low else "")
        if pin in self._pulsing:
            parts.append(tr("pulsing"))
        elif pin in self._levels:
            parts.append(tr("high") if self._levels[pin] else tr("low"))
        return ", ".join(part for part in parts if part)

    def event(self, event: Any) -> bool:
        """Show what a pin is under the pointer."""
        if event.type() == QtCore.QEvent.Type.ToolTip:
            near = [pin for pin, place in self.places().items() if _near(place, event.pos())]
            QtGui.QToolTip.showText(event.globalPos(), self.words(near[0]) if near else "", self)
            return True
        return bool(super().event(event))

    def paintEvent(self, event: Any) -> None:
        """Draw the socket, the pins and the names."""
        painter = QtGui.QPainter(self)
        painter.setRenderHint(QtGui.QPainter.RenderHint.Antialiasing)
        self._draw_shell(painter)
        for pin, place in self.places().items():
            self._draw_pin(painter, pin, place)
        painter.end()

    def _draw_shell(self, painter: Any) -> None:
        width, top, bottom = SIZE[0], NAME_PX + 8, NAME_PX + 2 * ROW_PX + 16
        corners = [(6, top), (width - 6, top), (width - 22, bottom), (22, bottom)]
        painter.setPen(QtGui.QPen(QtGui.QColor(INK), 2))
        painter.setBrush(QtGui.QColor(SHELL))
        painter.drawPolygon(QtGui.QPolygonF([QtCore.QPointF(*corner) for corner in corners]))

    def _draw_pin(self, painter: Any, pin: int, place: Any) -> None:
        ground = OUTPUT if pin in OUTPUT_PINS else INPUT if pin in INPUT_PINS else GROUND
        high = self._levels.get(pin)
        painter.setPen(QtGui.QPen(QtGui.QColor(INK), 2 if pin in self._names else 1))
        painter.setBrush(QtGui.QColor(ON if high else ground if pin in self._names or high is False else FACE))
        painter.drawEllipse(place, RADIUS_PX, RADIUS_PX)
        box = QtCore.QRectF(place.x() - RADIUS_PX, place.y() - RADIUS_PX, 2 * RADIUS_PX, 2 * RADIUS_PX)
        if pin in self._pulsing:
            painter.setPen(QtCore.Qt.PenStyle.NoPen)
            painter.setBrush(QtGui.QColor(ON))
            painter.drawPie(box, 0, HALF_TURN)
        painter.setPen(QtGui.QColor(INK))
        painter.drawText(box, QtCore.Qt.AlignmentFlag.AlignCenter, str(pin))
        if name := self._names.get(pin):
            self._draw_name(painter, ("¬" if pin in self._low else "") + name, place, up=pin in UPPER)

    def _draw_name(self, painter: Any, name: str, place: Any, up: bool) -> None:
        """Draw a name upright beside the socket, so that thirteen of them have room."""
        painter.save()
        painter.setPen(self.palette().color(QtGui.QPalette.ColorRole.WindowText))
        edge = NAME_PX + 4 if up else NAME_PX + 2 * ROW_PX + 20
        painter.translate(place.x(), edge)
        painter.rotate(-90)
        sides = QtCore.Qt.AlignmentFlag
        box = QtCore.QRectF(0 if up else -NAME_PX, -PITCH_PX / 2, NAME_PX, PITCH_PX)
        aligned = (sides.AlignLeft if up else sides.AlignRight) | sides.AlignVCenter
        painter.drawText(box, int(aligned | QtCore.Qt.TextFlag.TextWordWrap), name)
        painter.restore()


def _near(place: Any, pointer: Any) -> bool:
    return bool((place.x() - pointer.x()) ** 2 + (place.y() - pointer.y()) ** 2 <= RADIUS_PX**2)
