# SPDX-License-Identifier: LGPL-2.1-or-later
"""The button with the directions from which a simulation is looked at, and with its zoom.

The directions are those of `cncstepper simulate --view`. A frame is dragged by FreeCAD's own command; its mouse turns
and moves the view as ever.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

from PySide import QtGui

from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.translation import later, tr

ISOMETRIC, XY, ZY, DEPTH = "isometric", "xy", "zy", "depth"
NEARER, FARTHER, WHOLE, FRAME = "nearer", "farther", "whole", "frame"
ENTRIES = (
    (
        (ISOMETRIC, later("Isometric")),
        (XY, later("XY, from above")),
        (ZY, later("ZY, from the side")),
        (DEPTH, later("Depth, from above without the path")),
    ),
    (
        (NEARER, later("Zoom in")),
        (FARTHER, later("Zoom out")),
        (WHOLE, later("Show all")),
        (FRAME, later("Drag a frame to zoom into")),
    ),
)


def view_button(chosen: Callable[[str], None], parent: Any = None) -> Any:
    """Return the button with its menu; chosen: called with the name of an entry."""
    button = QtGui.QPushButton(tr("View"), parent)
    button.setObjectName("CNCStepper_Simulation_view")
    button.setToolTip(tr("From where the part is looked at, and how near; the mouse turns and moves it as ever"))
    menu = QtGui.QMenu(button)
    menu.setObjectName("CNCStepper_Simulation_view_menu")
    for number, group in enumerate(ENTRIES):
        if number:
            menu.addSeparator()
        for name, text in group:
            action = menu.addAction(tr(text))
            action.setObjectName(f"CNCStepper_Simulation_view_{name}")
            action.triggered.connect(guarded(partial(_choose, chosen, name)))
    button.setMenu(menu)
    return button


def _choose(chosen: Callable[[str], None], name: str, *_: Any) -> None:
    """Hand on a name without what Qt says of the action."""
    chosen(name)
