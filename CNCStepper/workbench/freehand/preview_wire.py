# SPDX-License-Identifier: LGPL-2.1-or-later
"""A line and its points in the 3D view that belong to no document object."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from pivy import coin

from CNCStepper.workbench.freehand.stroke import Point
from CNCStepper.workbench.services.coin_fields import fill_points

LINE = (0.97, 0.62, 0.05)  # amber reads on light and on dark backgrounds
HANDLE = (0.25, 0.55, 0.95)
HOT = (0.16, 0.78, 0.40)  # the point under the pointer; the start, when a release would close the line


class Wire:
    """A polyline with marked points, drawn over everything else in a view; nothing of it can be selected."""

    def __init__(self, view: Any):
        self._root = view.getSceneGraph()
        self._node = coin.SoAnnotation()
        self._placed = coin.SoTransform()
        self._line = coin.SoCoordinate3()
        self._count = coin.SoLineSet()
        self._points = coin.SoCoordinate3()
        self._marks = coin.SoMarkerSet()
        self._hot = coin.SoCoordinate3()
        self._hot_mark = coin.SoMarkerSet()
        self._build()

    def _build(self) -> None:
        unpickable, flat, style = coin.SoPickStyle(), coin.SoLightModel(), coin.SoDrawStyle()
        unpickable.style = coin.SoPickStyle.UNPICKABLE
        flat.model = coin.SoLightModel.BASE_COLOR
        style.lineWidth = 3
        self._marks.markerIndex = coin.SoMarkerSet.SQUARE_FILLED_9_9
        self._hot_mark.markerIndex = coin.SoMarkerSet.CIRCLE_FILLED_9_9
        for node in (unpickable, flat, style, self._placed):
            self._node.addChild(node)
        parts = ((LINE, self._line, self._count), (HANDLE, self._points, self._marks), (HOT, self._hot, self._hot_mark))
        for colour, coordinates, shape in parts:
            part, base = coin.SoSeparator(), coin.SoBaseColor()
            base.rgb = colour
            for node in (base, coordinates, shape):
                part.addChild(node)
            self._node.addChild(part)
        self.draw([])

    def show(self) -> None:
        """Put it into the view."""
        self._root.addChild(self._node)

    def hide(self) -> None:
        """Take it out of the view."""
        self._root.removeChild(self._node)

    def place(self, placement: Any) -> None:
        """Lay the plane of all points at a FreeCAD placement."""
        self._placed.translation = tuple(placement.Base)
        self._placed.rotation = tuple(placement.Rotation.Q)

    def draw(self, line: Sequence[Point], points: Sequence[Point] = (), hot: Point | None = None) -> None:
        """Show a polyline, its points as handles, and one highlighted point."""
        for coordinates, shape, row in (
            (self._line, self._count, line),
            (self._points, self._marks, points),
            (self._hot, self._hot_mark, [hot] if hot is not None else []),
        ):
            fill_points(coordinates.point, [(x, y, 0.0) for x, y in row])
            count = shape.numVertices if shape is self._count else shape.numPoints
            count.setValue(len(row))
