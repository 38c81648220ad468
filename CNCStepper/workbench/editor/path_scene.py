# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the editor adds to FreeCAD's 3D view: the way of the program, and the way of the cursor's line on top of it.

view's scene graph
  root (not pickable) ── place (the work zero) ── rapids ── feeds ── line: thick, seen through all ── its end
"""

from __future__ import annotations

from typing import Any

import numpy as np

from CNCStepper.simulation.views.polylines import Lines
from CNCStepper.workbench.simulation import coin_nodes as nodes
from CNCStepper.workbench.simulation.scene import FEED_RGB, RAPID_RGB

NAME = "CNCStepper_Editor"
LINE_RGB = (0.95, 0.45, 0.0)
LINE_PX, END_PX = 5.0, 10.0


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
        end.vertexProperty.getValue().vertex.setValues(0, 1, points[-1:].copy())
        self._line.addChild(nodes.in_front())
        self._line.addChild(style)
        self._line.addChild(nodes.plain(LINE_RGB))
        self._line.addChild(nodes.lines(points, np.full(len(way), 2)))
        self._line.addChild(end)

    def remove(self) -> None:
        """Take everything out of the 3D view."""
        if self._graph.findChild(self._root) >= 0:
            self._graph.removeChild(self._root)
