# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measured parts of a lathe in the window: a table of height and diameters, its figures and its plots."""

from __future__ import annotations

from typing import Any


def open_part_records() -> Any:
    """Show the window of part records in front, one for each FreeCAD, and return it."""
    import FreeCADGui

    from CNCStepper.workbench.part_records.dialog import NAME, PartRecords

    window = FreeCADGui.getMainWindow()
    shown = window.findChild(PartRecords, NAME) or PartRecords(window)
    shown.show()
    shown.raise_()
    shown.activateWindow()
    return shown
