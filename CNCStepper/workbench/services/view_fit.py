# SPDX-License-Identifier: LGPL-2.1-or-later
"""The active 3D view shows all there is, or one place."""

from __future__ import annotations

from typing import Any

NEAR_MM = 20.0  # what is seen around a place, from the lower to the upper side of the view


def show_all() -> None:
    """Let the active 3D view show all there is: what is new is seldom where the camera looks.

    Without a window there is none.
    """
    import FreeCAD

    if FreeCAD.GuiUp:
        import FreeCADGui

        FreeCADGui.SendMsgToActiveView("ViewFit")


def look_at_lathe() -> None:
    """Look at the XZ plane, in which a lathe's tool moves: Z to the right, X upwards."""
    import FreeCAD
    import FreeCADGui

    shown = FreeCADGui.activeDocument()
    view: Any = shown.activeView() if shown is not None else None
    if hasattr(view, "setCameraOrientation"):
        x, y, z = (FreeCAD.Vector(*axis) for axis in ((1, 0, 0), (0, 1, 0), (0, 0, 1)))
        view.setCameraOrientation(FreeCAD.Rotation(z, x, y, "XYZ"))


def show_place(x_mm: float, y_mm: float) -> None:
    """Move the active view to a place on the plane Z 0; its camera keeps its direction. Only 3D views move."""
    import FreeCADGui
    from pivy import coin

    view = FreeCADGui.activeDocument().activeView()
    if not hasattr(view, "getCameraNode"):
        return
    camera, place = view.getCameraNode(), coin.SbVec3f(x_mm, y_mm, 0.0)
    if hasattr(camera, "height"):
        camera.height = NEAR_MM
    else:
        camera.focalDistance = NEAR_MM
    ahead = camera.orientation.getValue().multVec(coin.SbVec3f(0.0, 0.0, -1.0))
    camera.position = place - ahead * camera.focalDistance.getValue()
