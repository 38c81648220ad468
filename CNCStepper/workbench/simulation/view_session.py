# SPDX-License-Identifier: LGPL-2.1-or-later
"""The 3D view while a simulation is open: objects that cover it are hidden, and shown again at the end."""

from __future__ import annotations

from typing import Any

from CNCStepper.workbench.features.base import proxy_type
from CNCStepper.workbench.simulation.view_menu import DEPTH, FARTHER, ISOMETRIC, NEARER, WHOLE, XY, ZY

LOOKS = {  # what FreeCAD's view does one after another
    ISOMETRIC: ("viewIsometric", "fitAll"),
    XY: ("viewTop", "fitAll"),
    ZY: ("viewRight", "fitAll"),
    DEPTH: ("viewTop", "fitAll"),
    NEARER: ("zoomIn",),
    FARTHER: ("zoomOut",),
    WHOLE: ("fitAll",),
}
ABOVE_DEG, BESIDE_DEG = 22.0, 18.0  # from where a lathe's part is looked at
LEVEL = 1e-6  # of a view's direction along a plane


def view_of(document: Any) -> Any:
    """Return a 3D view of a document, the active one if it is one, or None."""
    import FreeCADGui

    views = views_of(document)
    active = FreeCADGui.getDocument(document.Name).ActiveView
    return active if active in views else next(iter(views), None)


def views_of(document: Any) -> list[Any]:
    """Return the 3D views of a document."""
    import FreeCADGui

    return list(FreeCADGui.getDocument(document.Name).mdiViewsOfType("Gui::View3DInventor"))


def point_in_plane(view: Any, pixel: tuple[int, int], origin_mm: tuple[float, ...]) -> tuple[float, ...] | None:
    """Return the place from an origin, in the plane of its X and Z, that is seen at a pixel; None for none."""
    import FreeCAD

    camera, seen = view.getCameraNode(), view.getPoint(*pixel)
    along = view.getViewDirection()
    if "Perspective" in camera.getTypeId().getName().getString():
        along = seen - FreeCAD.Vector(*camera.position.getValue().getValue())
    if abs(along.y) < LEVEL:
        return None
    place = seen + along * ((origin_mm[1] - seen.y) / along.y) - FreeCAD.Vector(*origin_mm)
    return (place.x, place.y, place.z)


class Stage:
    """A 3D view, seen from above at a slant, without solids and without the preview of the job's path."""

    def __init__(self, job: Any, view: Any):
        self._document, self._document_name = job.Document, job.Document.Name
        self._view = view
        self._camera = view.getCamera()
        self._hidden: list[Any] = []
        for obj in job.Document.Objects:
            if _in_the_way(obj):
                self.hide(obj)

    def hide(self, obj: Any) -> None:
        """Hide an object until `restore`."""
        obj.ViewObject.Visibility = False
        self._hidden.append(obj)

    def look(self, name: str = ISOMETRIC) -> None:
        """Look as an entry of the view's menu says, at once: a camera that still moves later would undo `restore`."""
        moves = self._view.isAnimationEnabled()
        self._view.setAnimationEnabled(False)
        for step in LOOKS[name]:
            getattr(self._view, step)()
        self._view.setAnimationEnabled(moves)

    def look_from_the_side(self) -> None:
        """Look at a lathe's part with Z to the right and X up, from a little above and beside it, at once."""
        import FreeCAD

        moves = self._view.isAnimationEnabled()
        self._view.setAnimationEnabled(False)
        vector = FreeCAD.Vector
        straight = FreeCAD.Rotation(vector(0, 0, 1), vector(1, 0, 0), vector(0, 1, 0), "XYZ")
        above = FreeCAD.Rotation(vector(1, 0, 0), -ABOVE_DEG)
        beside = FreeCAD.Rotation(vector(0, 1, 0), BESIDE_DEG)
        self._view.setCameraOrientation(straight.multiply(beside).multiply(above).Q)
        self._view.fitAll()
        self._view.setAnimationEnabled(moves)

    def restore(self) -> None:
        """Show what was hidden, and look as before; what was deleted or closed meanwhile is left alone."""
        if self.show_again() and self._view in views_of(self._document):
            self._view.setCamera(self._camera)

    def show_again(self) -> bool:
        """Show what was hidden and is still there; return whether the document is."""
        import FreeCAD

        if self._document_name not in FreeCAD.listDocuments():
            return False
        left = set(self._document.Objects)
        for obj in self._hidden:
            if obj in left:
                obj.ViewObject.Visibility = True
        return True


def _in_the_way(obj: Any) -> bool:
    shown = getattr(obj, "ViewObject", None)
    if shown is None or not shown.Visibility:
        return False
    if proxy_type(obj) == "CNCStepper_Preview":
        return True
    return obj.isDerivedFrom("Part::Feature") and bool(obj.Shape.Faces)
