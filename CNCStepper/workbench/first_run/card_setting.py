# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether the card was closed, in FreeCAD's parameters: then it does not come again by itself."""

from __future__ import annotations

GROUP = "User parameter:BaseApp/Preferences/Mod/CNCStepper/FirstSteps"
CLOSED = "Closed"


def was_closed() -> bool:
    """Return whether a person has closed the card."""
    import FreeCAD

    return bool(FreeCAD.ParamGet(GROUP).GetBool(CLOSED, False))


def remember_closed(closed: bool = True) -> None:
    """Keep that the card was closed, or is to come again."""
    import FreeCAD

    FreeCAD.ParamGet(GROUP).SetBool(CLOSED, closed)
