# SPDX-License-Identifier: LGPL-2.1-or-later
"""The editor's part of the 3D view: made when there is something to show, and gone when the editor is.

view's scene graph
  root (not pickable) ── place (the work zero) ── rapids ── feeds ── line: thick, seen through all ── its end

Clicks in the view are reported with their place and the camera; FreeCAD gets them too.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from PySide import QtCore

from CNCStepper.simulation.views.path_lines import Lines
from CNCStepper.workbench.services.coin_fields import fill_points
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.view_colours import FEED_RGB, MARKER_RGB, RAPID_RGB
from CNCStepper.workbench.simulation import coin_nodes as nodes

TYPE = QtCore.QEvent.Type
LEFT = QtCore.Qt.MouseButton.LeftButton
STILL_PX = 4  # a press and a release that lie nearer together are a click
NAME = "CNCStepper_Editor"
LINE_PX, END_PX = 5.0, 10.0


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


class EditorScene:
    """The nodes of one editor in one 3D view; `remove` takes all away."""

    def __init__(self, view: Any, work_origin_mm: tuple[float, float, float]):
        from pivy import coin

        self._graph = view.getSceneGraph()
        self._root = coin.SoSeparator()
        self._root.setName(NAME)
        unpickable = coin.SoPickStyle()
        unpickable.style = coin.SoPickStyle.UNPICKABLE
        self.origin_mm = work_origin_mm
        place = coin.SoTranslation()
        place.translation = work_origin_mm
        self._path, self._line = nodes.separator(), nodes.separator()
        for node in (unpickable, place, self._path, self._line):
            self._root.addChild(node)
        self._graph.addChild(self._root)

    def show_path(self, rapids: Lines, feeds: Lines) -> None:
        """Show another path."""
        self._path.removeAllChildren()
        for lines, rgb in ((rapids, RAPID_RGB), (feeds, FEED_RGB)):
            self._path.addChild(nodes.separator(nodes.plain(rgb), nodes.lines(lines.points, lines.counts)))

    def show_line(self, way: list[list[list[float]]]) -> None:
        """Show the way of one line, segments [[x, y, z], [x, y, z]] each, instead of the one before."""
        from pivy import coin

        self._line.removeAllChildren()
        if not way:
            return
        points = np.array(way, np.float32).reshape(-1, 3)
        style = coin.SoDrawStyle()
        style.lineWidth, style.pointSize = LINE_PX, END_PX
        end = coin.SoPointSet()
        end.vertexProperty = coin.SoVertexProperty()
        fill_points(end.vertexProperty.getValue().vertex, points[-1:])
        self._line.addChild(nodes.in_front())
        self._line.addChild(style)
        self._line.addChild(nodes.plain(MARKER_RGB))
        self._line.addChild(nodes.lines(points, np.full(len(way), 2)))
        self._line.addChild(end)

    def remove(self) -> None:
        """Take everything out of the 3D view."""
        if self._graph.findChild(self._root) >= 0:
            self._graph.removeChild(self._root)


class EditorStage:
    """Shows a program's way in a document's 3D view, or in the active one's for a file; `picked` gets each click."""

    def __init__(self, picked: Callable[[dict[str, Any]], None]):
        self._picked = picked
        self._scene: EditorScene | None = None
        self._clicks: Clicks | None = None
        self._view: Any = None

    @property
    def shown(self) -> bool:
        """Whether there is a view that shows it."""
        return self._scene is not None

    def show(self, source: Any, path: Path) -> None:
        """Show the lines of a file, in the view of a source's document."""
        from CNCStepper.job.editing.path_segments import read_lines

        view = _view_of(source)
        if view is not self._view or (self._scene and self._scene.origin_mm != source.origin_mm):
            self.clear()
        if view is None:
            return
        if self._scene is None:
            self._view = view
            self._scene = EditorScene(view, source.origin_mm)
            self._clicks = Clicks(view, source.origin_mm, self._picked)
        self._scene.show_path(*read_lines(path))

    def show_line(self, way: list[list[list[float]]]) -> None:
        """Show the way of one line."""
        if self._scene is not None:
            self._scene.show_line(way)

    def clear(self) -> None:
        """Take all out of the view."""
        if self._clicks is not None:
            self._clicks.end()
        if self._scene is not None:
            self._scene.remove()
        self._clicks = self._scene = self._view = None


def _view_of(source: Any) -> Any:
    import FreeCAD

    from CNCStepper.workbench.simulation.view_session import view_of

    document = source.document if source.alive else None
    document = document or FreeCAD.ActiveDocument
    return view_of(document) if document is not None else None
