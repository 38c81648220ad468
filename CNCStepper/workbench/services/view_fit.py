# SPDX-License-Identifier: LGPL-2.1-or-later
"""The active 3D view shows all there is."""

from __future__ import annotations


def show_all() -> None:
    """Let the active 3D view show all there is: what is new is seldom where the camera looks.

    Without a window there is none.
    """
    import FreeCAD

    if FreeCAD.GuiUp:
        import FreeCADGui

        FreeCADGui.SendMsgToActiveView("ViewFit")
