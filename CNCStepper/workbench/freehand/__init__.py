# SPDX-License-Identifier: LGPL-2.1-or-later
"""Freehand lines in the 3D view: `start` draws them with the mouse, `edit` moves the points of one that is there.

Nothing but the left button, Esc, Enter and Delete is taken from FreeCAD, and only while this goes on: the wheel
and the other buttons work as ever, in every style of navigation.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from CNCStepper.workbench.freehand.mode import Mode

_going_on: list[Mode] = []  # at most one


def start() -> None:
    """Draw lines in the active 3D view until Esc, or until this is called again there.

    The plane is Draft's working plane where the user has set one, else the XY plane at the work zero of the job
    (selected, or the document's first), else at Z = 0. Press, move, release: there is the line; the next may follow.
    While Shift is held the line goes straight to the pointer, in multiples of 45 degrees when it is near one.
    A release beside the start closes the line. Esc gives up the line being drawn; Esc between two lines ends drawing.
    Raises JobError where no 3D view is active, MissingPackage without numpy or shapely.
    """
    from CNCStepper.workbench.freehand.draw_mode import Drawing, active_view

    view = active_view()
    again = any(isinstance(mode, Drawing) and mode.view is view for mode in _going_on)
    leave()
    if not again:
        _begin(Drawing(view))


def edit(line: Any, changed: Callable[[], None] | None = None) -> None:
    """Show the points of a CNCStepper_Freehand as handles, until Esc, Enter or `leave`.

    Drag a point to move it, drag the line between two points to add one, press Delete over a point to take it away.
    Each of these is one undo step, or belongs to the transaction that is open, as that of a task panel. A panel gives
    `changed`, which is called after each, and ends the editing itself with `leave`.
    Raises JobError where no 3D view of the line's document is active, MissingPackage without numpy or shapely.
    """
    from CNCStepper.workbench.freehand.edit_mode import Handles

    leave()
    _begin(Handles(line, changed))


def leave() -> None:
    """End drawing or editing, if either goes on; a line that is half drawn is given up."""
    for mode in list(_going_on):
        mode.leave()


def going_on() -> bool:
    """Return whether the user draws or edits a line at the moment."""
    return bool(_going_on)


def _begin(mode: Mode) -> None:
    mode.begin()
    mode.on_left = _going_on.clear
    _going_on.append(mode)
