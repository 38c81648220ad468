# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drawing freehand lines: press, move, release; every release makes one CNCStepper_Freehand in one undo step."""

from __future__ import annotations

from typing import Any

from CNCStepper.errors import JobError
from CNCStepper.workbench import api, packages
from CNCStepper.workbench.document.undo_steps import undo_step
from CNCStepper.workbench.freehand.drawing_plane import PlaneView, working_plane
from CNCStepper.workbench.freehand.mode import Mode, say
from CNCStepper.workbench.freehand.stroke import Point, Stroke
from CNCStepper.workbench.services.translation import tr


def active_view() -> Any:
    """Return the 3D view in front; raises JobError when there is none."""
    import FreeCADGui

    view = FreeCADGui.ActiveDocument.ActiveView if FreeCADGui.ActiveDocument else None
    if not hasattr(view, "graphicsView"):
        raise JobError("no-view", tr("there is no 3D view to draw in"), advice=tr("open a document or its 3D view"))
    return view


class Drawing(Mode):
    """The user draws in `view` until Esc."""

    def __init__(self, view: Any):
        packages.require("numpy", "shapely")
        import FreeCAD

        super().__init__(view, FreeCAD.ActiveDocument)
        self._sight = PlaneView(view, working_plane(self.document))
        self._stroke: Stroke | None = None
        self.wire.place(self._sight.placement)

    def hint(self) -> None:
        """Say how to draw."""
        say(tr("Draw a line: press the left button, move, release. Shift: straight. Esc: end drawing."))

    def pressed(self, pixel: Point, shift: bool) -> bool:
        """Begin a stroke where the pointer meets the plane."""
        start = self._sight.point(pixel)
        if start is None:
            say(tr("The working plane is seen from its edge: turn the view to draw on it."))
            return True
        self._stroke = Stroke(start, self._sight.pixel_mm(pixel))
        return True

    def moved(self, pixel: Point, shift: bool) -> bool:
        """Let the stroke grow."""
        point = self._sight.point(pixel)
        if self._stroke is not None and point is not None:
            self._stroke.move(point, straight=shift)
            self._show(self._stroke)
        return True

    def _show(self, stroke: Stroke) -> None:
        self.wire.draw(stroke.points, hot=stroke.points[0] if stroke.closing else None)
        say(
            tr("Release to close the line. Esc: give up this line.")
            if stroke.closing
            else tr("Release: done. Release at the start: close the line. Shift: straight. Esc: give up this line.")
        )

    def released(self, pixel: Point) -> bool:
        """Make the line; a click that drew nothing makes none."""
        stroke, self._stroke = self._stroke, None
        self.wire.draw([])
        points, closed = stroke.line() if stroke is not None else ([], False)
        if stroke is None or not points:
            self.hint()
            return True
        line = self._make(points, closed, stroke.tolerance_mm)
        say(tr("{0}: {1} points, within {2:g} mm of the drawn line. Draw the next one, or Esc: end drawing.").format(
            line.Label, line.Kept, stroke.tolerance_mm))  # fmt: skip
        return True

    def _make(self, points: list[Point], closed: bool, tolerance_mm: float) -> Any:
        """Return the new line, selected."""
        import FreeCADGui

        with undo_step(self.document, tr("Draw a freehand line")):
            line = api.add_freehand(self.document, points, tolerance_mm=tolerance_mm, closed=closed)
            line.Label = tr("Freehand")
            line.Placement = self._sight.placement
            self.document.recompute([line])
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(line)
        return line

    def wants(self, key: str) -> bool:
        """Esc alone."""
        return key == "escape"

    def key(self, key: str) -> None:
        """Give up the stroke; without one, end drawing."""
        if self._stroke is None:
            self.leave()
            return
        self._stroke = None
        self.wire.draw([])
        self.hint()
