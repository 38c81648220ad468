# SPDX-License-Identifier: LGPL-2.1-or-later
"""The active 3D view shows all there is."""

from __future__ import annotations

from typing import Any


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
