# SPDX-License-Identifier: LGPL-2.1-or-later
"""The dock's settings in FreeCAD's parameters, and the user's units and decimal separator."""

from __future__ import annotations

from typing import Any

from CNCStepper.machine.controller_family import BAUD
from CNCStepper.workbench.dock.model.port_choices import VIRTUAL
from CNCStepper.workbench.services.number_format import INCH, MM, Lengths

GROUP = "User parameter:BaseApp/Preferences/Mod/CNCStepper/Dock"
INCH_NAMES = ("in", "ft", '"', "'", "thou", "mil", "yd", "mi")
JOG_FEED_MM_MIN = 1000.0
MACHINE = "table-a"


def last_port() -> str:
    """Return what was opened last; the virtual grbl for a newcomer."""
    return _group().GetString("Port", VIRTUAL)


def last_baud() -> int:
    """Return the baud rate used last."""
    return _group().GetInt("Baud", BAUD)


def remember_port(port: str, baud: int) -> None:
    """Keep what was opened, for the next time."""
    _group().SetString("Port", port)
    _group().SetInt("Baud", baud)


def last_machine() -> str:
    """Return the profile of the machine that was chosen last."""
    return _group().GetString("Machine", MACHINE)


def remember_machine(name: str) -> None:
    """Keep the profile that was chosen."""
    _group().SetString("Machine", name)


def sounds_on() -> bool:
    """Return whether the window makes sounds."""
    return _group().GetBool("Sounds", True)


def switch_sounds(on: bool) -> None:
    """Let the window make sounds, or not."""
    _group().SetBool("Sounds", on)


def live_on() -> bool:
    """Return whether the cut under way is shown in the 3D view."""
    return _group().GetBool("Live", False)


def switch_live(on: bool) -> None:
    """Let the cut under way be shown, or not."""
    _group().SetBool("Live", on)


def jog_feed_mm_min() -> float:
    """Return the feed for jogging used last."""
    return _group().GetFloat("JogFeed", JOG_FEED_MM_MIN)


def remember_jog_feed(feed_mm_min: float) -> None:
    """Keep the feed for jogging."""
    _group().SetFloat("JogFeed", feed_mm_min)


def lengths() -> Lengths:
    """Return millimetres or inches, as FreeCAD's unit system has them; a table is never read in metres or feet."""
    import FreeCAD

    unit = FreeCAD.Units.Quantity("25 mm").getUserPreferred()[2]
    return INCH if unit in INCH_NAMES else MM


def decimal_point() -> str:
    """Return the decimal sign of FreeCAD's locale."""
    from PySide import QtCore

    point = QtCore.QLocale().decimalPoint()
    return point if isinstance(point, str) else chr(ord(point))


def _group() -> Any:
    import FreeCAD

    return FreeCAD.ParamGet(GROUP)
