# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files of pulse letters in the window: drawn, counted, sent, led back, and pulses by hand."""

from __future__ import annotations

from typing import Any


def open_letters() -> Any:
    """Show the window of pulse letters in front, one for each FreeCAD, and return it."""
    from CNCStepper.workbench.letters.dialog import NAME, Letters
    from CNCStepper.workbench.services.front_window import only_window

    return only_window(Letters, NAME)
