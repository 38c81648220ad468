# SPDX-License-Identifier: LGPL-2.1-or-later
"""Windows beside FreeCAD's own: one of each, brought to the front."""

from __future__ import annotations

from typing import Any


def only_window(kind: type, name: str) -> Any:
    """Show the window of a kind in front, one for each FreeCAD, and return it; name: of its object."""
    import FreeCADGui

    parent = FreeCADGui.getMainWindow()
    return in_front(parent.findChild(kind, name) or kind(parent))


def in_front(window: Any) -> Any:
    """Show a window in front of the others, and return it."""
    window.show()
    window.raise_()
    window.activateWindow()
    return window
