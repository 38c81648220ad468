# SPDX-License-Identifier: LGPL-2.1-or-later
"""The plane that is drawn on, and where the pointer meets it."""

from __future__ import annotations

import math
from typing import Any

from CNCStepper.workbench.features.base import JOB, proxy_type
from CNCStepper.workbench.freehand.stroke import Point

EDGE_ON = 0.05  # the cosine below which the plane is seen from its edge, where nobody can point at it


def working_plane(document: Any) -> Any:
    """Return the placement of a new line's plane: Draft's if the user has set one, else XY at the job's work zero."""
    import FreeCAD

    draft = getattr(FreeCAD, "DraftWorkingPlane", None)  # exists once Draft was opened; weak: it follows the view
    if draft is not None and not draft.weak:
        return draft.getPlacement()
    job = _job(document)
    return FreeCAD.Placement(FreeCAD.Vector(0, 0, job.WorkOrigin.z if job else 0.0), FreeCAD.Rotation())


def _job(document: Any) -> Any:
    """Return the selected job, else the document's first; None where there is none."""
    import FreeCADGui

    chosen = [obj for obj in FreeCADGui.Selection.getSelection(document.Name) if proxy_type(obj) == JOB]
    return next(iter([*chosen, *(obj for obj in document.Objects if proxy_type(obj) == JOB)]), None)


class PlaneView:
    """A plane as a 3D view sees it; pixels count from the lower left corner, as OpenGL's do."""

    def __init__(self, view: Any, placement: Any):
        self.view = view
        self.placement = placement

    def point(self, pixel: Point) -> Point | None:
        """Return where the plane lies under a pixel, in the plane's own mm; None where it is seen from its edge."""
        import FreeCAD

        x, y = (round(number) for number in pixel)
        through = self.view.getPoint(x, y)
        direction = self.view.getViewDirection()
        if self.view.getCameraType() == "Perspective":
            direction = (through - FreeCAD.Vector(*self.view.getCameraNode().position.getValue())).normalize()
        there = self.placement.inverse()
        start, along = there.multVec(through), there.Rotation.multVec(direction)
        if abs(along.z) < EDGE_ON:
            return None
        met = start - along * (start.z / along.z)
        return (met.x, met.y)

    def pixel_mm(self, pixel: Point) -> float:
        """Return how long a pixel is on the plane under `pixel`, across or up, whichever is longer.

        The plane must be seen there: ask `point` first.
        """
        here, across, up = (self.point((pixel[0] + dx, pixel[1] + dy)) for dx, dy in ((0, 0), (10, 0), (0, 10)))
        return max(math.dist(here, other) / 10 for other in (across, up) if here and other)
