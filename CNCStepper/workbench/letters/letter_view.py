# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of pulse letters: the way seen from above, and a timeline of three axes; both with the place reached."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from PySide import QtCore, QtGui

from CNCStepper.motion.signals.letter_track import LetterTrack
from CNCStepper.workbench.services.translation import tr

MOST_POINTS = 4000  # that are drawn of a way
MARGIN_PX, LABEL_PX, DOT_PX = 14, 26, 4
ALL, DONE, HERE, GRID = "#9aa7b5", "#1f6fb2", "#d3461f", "#c9d1d9"
AXIS_COLOURS = ("#c0392b", "#27803f", "#2f5fb0")
SWITCHES = "#b5851b"


class _Picture(QtGui.QWidget):
    """The track that is shown, and the pulse that is reached; a click chooses a pulse."""

    def __init__(self, name: str, least_px: tuple[int, int], chosen: Callable[[int], None]) -> None:
        super().__init__()
        self.setObjectName(f"CNCStepper_Letters_{name}")
        self.setMinimumSize(*least_px)
        self.track: LetterTrack | None = None
        self.pulse = 0
        self._drawn = np.zeros(1, np.int64)  # the pulses whose places are drawn
        self._chosen = chosen

    def show_track(self, track: LetterTrack) -> None:
        """Show another way, at its begin."""
        self.track, self.pulse = track, 0
        self._drawn = np.unique(np.linspace(0, track.pulses, MOST_POINTS).astype(np.int64))
        self.update()

    def show_pulse(self, pulse: int) -> None:
        """Show how far it is."""
        if pulse != self.pulse:
            self.pulse = pulse
            self.update()

    def paintEvent(self, event: Any) -> None:
        """Draw it."""
        painter = QtGui.QPainter(self)
        painter.setRenderHint(QtGui.QPainter.RenderHint.Antialiasing)
        painter.fillRect(self.rect(), self.palette().color(QtGui.QPalette.ColorRole.Base))
        if self.track is not None:
            self.draw(painter, self.track)
        painter.end()

    def mousePressEvent(self, event: Any) -> None:
        """Choose the pulse under the pointer."""
        if self.track is not None:
            self._chosen(self.pulse_at(event.pos(), self.track))

    def draw(self, painter: Any, track: LetterTrack) -> None:
        """Draw a track."""
        raise NotImplementedError

    def pulse_at(self, place: Any, track: LetterTrack) -> int:
        """Return the pulse at a place of the picture."""
        raise NotImplementedError


class WayView(_Picture):
    """X to the right, Y up, in steps; the way that is done in another colour."""

    def draw(self, painter: Any, track: LetterTrack) -> None:
        """Draw the way, its begin and the place that is reached."""
        points = self._points(track)
        done = int(np.searchsorted(self._drawn, self.pulse, side="right"))
        here = self._pixels(track.places[self.pulse][None, :2], track)
        _line(painter, points, ALL, 1)
        _line(painter, np.vstack([points[:done], here]), DONE, 2)
        _dot(painter, points[0], GRID)
        _dot(painter, here[0], HERE)

    def pulse_at(self, place: Any, track: LetterTrack) -> int:
        """Return the pulse that is drawn nearest to a place."""
        away = self._points(track) - (place.x(), place.y())
        return int(self._drawn[int((away**2).sum(axis=1).argmin())])

    def _points(self, track: LetterTrack) -> np.ndarray:
        return self._pixels(track.places[self._drawn, :2], track)

    def _pixels(self, places: np.ndarray, track: LetterTrack) -> np.ndarray:
        low, high = track.places[:, :2].min(axis=0), track.places[:, :2].max(axis=0)
        room = np.array([self.width(), self.height()]) - 2 * MARGIN_PX
        scale = float((room / np.maximum(high - low, 1)).min())
        middle = np.array([self.width(), self.height()]) / 2
        return middle + (places - (low + high) / 2) * scale * (1, -1)


class Timeline(_Picture):
    """X, Y and Z below each other over the pulses, marks where devices are switched, and a line at the pulse."""

    def draw(self, painter: Any, track: LetterTrack) -> None:
        """Draw the three axes."""
        across = self._across(self._drawn, track)
        for switch in track.switches:
            x = float(self._across(np.array([switch.row]), track)[0])
            painter.setPen(QtGui.QPen(QtGui.QColor(SWITCHES), 1, QtCore.Qt.PenStyle.DotLine))
            painter.drawLine(QtCore.QPointF(x, 0), QtCore.QPointF(x, self.height()))
        for axis, colour in enumerate(AXIS_COLOURS):
            top, bottom = self._band(axis)
            values = track.places[:, axis]
            low, high = int(values.min()), int(values.max())
            heights = bottom - (values[self._drawn] - low) * (bottom - top) / max(high - low, 1)
            painter.setPen(QtGui.QColor(GRID))
            painter.drawLine(QtCore.QPointF(0, bottom + 4), QtCore.QPointF(self.width(), bottom + 4))
            painter.setPen(self.palette().color(QtGui.QPalette.ColorRole.Text))
            painter.drawText(QtCore.QPointF(6, (top + bottom) / 2 + 4), "XYZ"[axis])
            _line(painter, np.column_stack([across, heights]), colour, 2)
        x = float(self._across(np.array([self.pulse]), track)[0])
        painter.setPen(QtGui.QPen(QtGui.QColor(HERE), 2))
        painter.drawLine(QtCore.QPointF(x, 0), QtCore.QPointF(x, self.height()))

    def pulse_at(self, place: Any, track: LetterTrack) -> int:
        """Return the pulse over a place."""
        share = (place.x() - LABEL_PX) / max(self.width() - LABEL_PX - MARGIN_PX, 1)
        return round(min(max(share, 0.0), 1.0) * track.pulses)

    def _across(self, pulses: np.ndarray, track: LetterTrack) -> np.ndarray:
        return np.asarray(LABEL_PX + pulses / max(track.pulses, 1) * (self.width() - LABEL_PX - MARGIN_PX))

    def _band(self, axis: int) -> tuple[float, float]:
        height = self.height() / 3
        return axis * height + 8, (axis + 1) * height - 8


def on_words(track: LetterTrack, pulse: int) -> str:
    """Return in words which devices are on after a pulse."""
    names = {"spindle_cw": tr("spindle"), "mist": tr("mist"), "flood": tr("flood")}
    return ", ".join(names[name] for name in track.on_after(pulse)) or tr("nothing")


def _line(painter: Any, points: np.ndarray, colour: str, width: int) -> None:
    painter.setPen(QtGui.QPen(QtGui.QColor(colour), width))
    painter.drawPolyline(QtGui.QPolygonF([QtCore.QPointF(x, y) for x, y in points.tolist()]))


def _dot(painter: Any, place: np.ndarray, colour: str) -> None:
    painter.setPen(QtCore.Qt.PenStyle.NoPen)
    painter.setBrush(QtGui.QColor(colour))
    painter.drawEllipse(QtCore.QPointF(*place.tolist()), DOT_PX, DOT_PX)
    painter.setBrush(QtCore.Qt.BrushStyle.NoBrush)
