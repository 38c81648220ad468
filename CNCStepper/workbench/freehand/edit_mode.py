# SPDX-License-Identifier: LGPL-2.1-or-later
"""Editing a freehand line: its points are handles in the 3D view."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from CNCStepper.errors import GeometryError
from CNCStepper.workbench import api, packages
from CNCStepper.workbench.document.undo_steps import undo_step
from CNCStepper.workbench.freehand.draw_mode import active_view
from CNCStepper.workbench.freehand.drawing_plane import PlaneView
from CNCStepper.workbench.freehand.mode import Mode, say
from CNCStepper.workbench.freehand.stroke import Point
from CNCStepper.workbench.services.translation import tr

REACH_PIXELS = 8  # the pointer takes hold of a point this near, and of the line a little nearer
SHOWN = {"Points", "Tolerance", "Closed", "Placement"}


class Handles(Mode):
    """The points of one line, as the wire has them; the first change makes them the line's own points."""

    def __init__(self, line: Any, changed: Callable[[], None] | None):
        packages.require("numpy", "shapely")
        super().__init__(active_view(), line.Document)
        self._line = line
        self._tell = changed
        self._points: list[Point] = []
        self._before: list[Point] = []  # as the line has them
        self._height_mm = 0.0
        self._near: int | None = None  # the handle under the pointer
        self._dragged: int | None = None
        self._read()

    def _read(self) -> None:
        """Take the points from the line."""
        import FreeCAD

        from CNCStepper.workbench.drawings.freehand_points import freehand_curve

        line = self._line
        rows = [tuple(point) for point in line.Points]
        self._height_mm, drawn = freehand_curve(rows, float(line.Tolerance), 0.0, bool(line.Closed))  # no ends of arcs
        kept = drawn.xy
        self._points = [(float(x), float(y)) for x, y in (kept[:-1] if line.Closed else kept)]
        self._before = list(self._points)
        height = FreeCAD.Placement(FreeCAD.Vector(0, 0, self._height_mm), FreeCAD.Rotation())
        self._sight = PlaneView(self.view, line.getGlobalPlacement() * height)
        self.wire.place(self._sight.placement)
        self._show()

    def _show(self) -> None:
        ring = [*self._points, self._points[0]] if self._line.Closed else self._points
        held = self._dragged if self._dragged is not None else self._near
        self.wire.draw(ring, self._points, None if held is None else self._points[held])

    def hint(self) -> None:
        """Say what can be done with the points."""
        say(tr("Drag a point to move it, the line to add one; Delete takes the point under the pointer. Esc: done."))

    def pressed(self, pixel: Point, shift: bool) -> bool:
        """Take hold of the point under the pointer, or of a new one on the line; all else is FreeCAD's."""
        point = self._sight.point(pixel)
        if point is None:
            return False
        reach_mm = REACH_PIXELS * self._sight.pixel_mm(pixel)
        self._dragged = self._handle_at(point, reach_mm)
        if self._dragged is None:
            self._dragged = self._new_handle(point, reach_mm / 2)
        self._show()
        return self._dragged is not None

    def moved(self, pixel: Point, shift: bool) -> bool:
        """Move the point that is held; else mark the one under the pointer."""
        point = self._sight.point(pixel)
        if point is None:
            return False
        if self._dragged is not None:
            self._points[self._dragged] = point
            self._show()
            return True
        near = self._handle_at(point, REACH_PIXELS * self._sight.pixel_mm(pixel))
        if near != self._near:
            self._near = near
            self._show()
        return False

    def released(self, pixel: Point) -> bool:
        """Give the line its new points; a press that moved nothing changes nothing."""
        moved, self._dragged = self._dragged is not None and self._points != self._before, None
        if moved:
            self._write(tr("Move a point"))
        self.hint()
        self.moved(pixel, shift=False)  # the pointer still stands on it
        return True

    def wants(self, key: str) -> bool:
        """Delete over a point, Esc while one is dragged; Esc and Enter otherwise where no panel is there for them."""
        if key == "delete":
            return self._near is not None
        return self._tell is None or self._dragged is not None

    def key(self, key: str) -> None:
        """Give up a drag, leave, or take away the point under the pointer."""
        if key == "delete" and self._near is not None and len(self._points) > (3 if self._line.Closed else 2):
            del self._points[self._near]
            self._near = None
            self._write(tr("Delete a point"))
        elif self._dragged is not None:
            self._dragged = None
            self._read()
        elif key != "delete":
            self.leave()

    def _handle_at(self, point: Point, reach_mm: float) -> int | None:
        nearest = min(range(len(self._points)), key=lambda number: math.dist(self._points[number], point))
        return nearest if math.dist(self._points[nearest], point) <= reach_mm else None

    def _new_handle(self, point: Point, reach_mm: float) -> int | None:
        """Return the number of a point put into the part of the line under the pointer, None beside the line."""
        ends = [*self._points[1:], *(self._points[:1] if self._line.Closed else [])]
        gaps = [_distance(point, one, other) for one, other in zip(self._points, ends, strict=False)]
        number = min(range(len(gaps)), key=gaps.__getitem__)
        if gaps[number] > reach_mm:
            return None
        self._points.insert(number + 1, point)
        return number + 1

    def _write(self, step: str) -> None:
        """Give the line its points in one undo step, or in the transaction that a task panel has open."""
        import FreeCAD

        points_mm = [(x, y, self._height_mm) for x, y in self._points]
        if FreeCAD.getActiveTransaction() is not None:
            api.edit(self._line, points_mm=points_mm, tolerance_mm=0.0)
            self.document.recompute([self._line])
            if self._tell is not None:
                self._tell()
            return
        with undo_step(self.document, step):
            api.edit(self._line, points_mm=points_mm, tolerance_mm=0.0)
            self.document.recompute()

    def slotChangedObject(self, changed: Any, name: str) -> None:
        """Follow what undo, a panel or a script does to the line; FreeCAD calls this."""
        if changed == self._line and name in SHOWN and self._dragged is None and self._line.Points:
            self._near = None
            try:
                self._read()
            except GeometryError:  # a script gave it points that make no line: the object itself says why
                self.leave()

    def slotDeletedObject(self, deleted: Any) -> None:
        """Leave with the line; FreeCAD calls this."""
        if deleted == self._line:
            self.leave()


def _distance(point: Point, one: Point, other: Point) -> float:
    """Return the distance of a point from the straight part between two others."""
    (px, py), (ax, ay), (bx, by) = point, one, other
    length2 = (bx - ax) ** 2 + (by - ay) ** 2
    along = 0.0 if length2 == 0 else max(0.0, min(1.0, ((px - ax) * (bx - ax) + (py - ay) * (by - ay)) / length2))
    return math.dist(point, (ax + along * (bx - ax), ay + along * (by - ay)))
