# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files of pulse letters in the window: drawn, counted, sent, led back, and pulses by hand."""

from __future__ import annotations

from typing import Any


def open_letters() -> Any:
    """Show the window of pulse letters in front, one for each FreeCAD, and return it."""
    import FreeCADGui

    from CNCStepper.workbench.letters.dialog import NAME, Letters

    window = FreeCADGui.getMainWindow()
    shown = window.findChild(Letters, NAME) or Letters(window)
    shown.show()
    shown.raise_()
    shown.activateWindow()
    return shown
