# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hears clicks in a 3D view without taking them away from FreeCAD, and says where they are and how the view sees."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from PySide import QtCore

from CNCStepper.workbench.services.messages import guarded

TYPE = QtCore.QEvent.Type
LEFT = QtCore.Qt.MouseButton.LeftButton
STILL_PX = 4  # a press and a release that lie nearer together are a click


class Clicks(QtCore.QObject):
    """Calls `clicked` with the question of `workers/program_editor.py`, "pick", from `__init__` until `end`."""

    def __init__(self, view: Any, origin_mm: tuple[float, float, float], clicked: Callable[[dict[str, Any]], None]):
        super().__init__()
        self._view, self._origin_mm, self._clicked = view, origin_mm, clicked
        self._pressed: Any = None
        for widget in self._widgets():
            widget.installEventFilter(self)

    def end(self) -> None:
        """Hear nothing any more."""
        for widget in self._widgets():
            widget.removeEventFilter(self)

    def eventFilter(self, widget: Any, event: Any) -> bool:
        """Hear a press and its release, and let FreeCAD have both; Qt calls this."""
        if isinstance(event, QtCore.QEvent):
            if event.type() == TYPE.MouseButtonPress and event.button() == LEFT:
                self._pressed = _place(event)
            elif event.type() == TYPE.MouseButtonRelease and event.button() == LEFT and self._pressed is not None:
                moved = (_place(event) - self._pressed).manhattanLength()
                self._pressed = None
                if moved < STILL_PX:
                    self._click(widget, _place(event))
        return False

    @guarded
    def _click(self, widget: Any, place: Any) -> None:
        size = [widget.width(), widget.height()]
        matrix = seen_by(self._view.getCameraNode(), size, self._origin_mm)
        self._clicked({"matrix": matrix, "size": size, "at": [place.x(), size[1] - 1 - place.y()]})

    def _widgets(self) -> list[Any]:
        """Return the widget with the mouse; [] when the view was closed. It is never kept."""
        try:
            return [self._view.graphicsView().viewport()]
        except (RuntimeError, ReferenceError):  # as the versions of FreeCAD say that a view is gone
            return []


def _place(event: Any) -> Any:
    """Return where a mouse event is in its widget, as Qt 5 and Qt 6 say it."""
    return event.position().toPoint() if hasattr(event, "position") else event.pos()


def seen_by(camera: Any, size: list[int], origin_mm: tuple[float, float, float]) -> list[list[float]]:
    """Return the matrix with which a camera turns (x, y, z, 1), a row, of the work into the picture from -1 to 1."""
    import numpy as np

    aspect = size[0] / size[1]
    volume = camera.getViewVolume(aspect)
    if aspect < 1:  # as SoCamera does it when it adjusts itself to a window that is higher than wide
        volume.scale(1 / aspect)
    matrix = np.array(volume.getMatrix().getValue(), float)
    shift = np.eye(4)
    shift[3, :3] = origin_mm
    return [[float(value) for value in row] for row in shift @ matrix]
