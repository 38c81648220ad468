# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two programs compared in the window: which two, one picture of both, their figures."""

from __future__ import annotations

from typing import Any


def open_comparison(first: Any = None) -> Any:
    """Show the window in front, one for each FreeCAD, with an object's program as the first one, and return it."""
    from CNCStepper.workbench.comparison.dialog import NAME, Comparison
    from CNCStepper.workbench.services.front_window import only_window

    window = only_window(Comparison, NAME)
    window.offer(first)
    return window
