# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colours of letters that mean something, as they read in FreeCAD's theme: darker on a light ground, lighter on a dark.

A theme of FreeCAD is a style sheet, which gives some kinds of widgets their colours and others none: what a label gets
is what counts.
"""

from __future__ import annotations

from typing import Any

ERROR, WARNING, GOOD = "#c62828", "#9a5b00", "#1f7a3c"
ON_DARK = {ERROR: "#ff8a80", WARNING: "#f2b24a", GOOD: "#6fcf8b"}
PROBE = "CNCStepper_theme_probe"
HALF = 127  # of a colour's lightness

_label: Any = None


def letters(colour: str) -> str:
    """Return a colour of those above as it reads in the theme of now; another one as it is."""
    return ON_DARK.get(colour, colour) if is_dark() else colour


def is_dark() -> bool:
    """Return whether FreeCAD's theme writes light letters on a dark ground."""
    label = _probe()
    return bool(label.palette().color(label.foregroundRole()).lightness() > HALF)


def _probe() -> Any:
    """Return a label that is never seen, with the theme's colours."""
    global _label
    if _label is None:  # it lives as long as FreeCAD's window does
        import FreeCADGui
        from PySide import QtGui

        _label = QtGui.QLabel(FreeCADGui.getMainWindow())
        _label.setObjectName(PROBE)
        _label.hide()
    _label.ensurePolished()
    return _label
