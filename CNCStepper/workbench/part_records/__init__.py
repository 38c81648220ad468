# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measured parts of a lathe in the window: a table of height and diameters, its figures and its plots."""

from __future__ import annotations

from typing import Any


def open_part_records() -> Any:
    """Show the window of part records in front, one for each FreeCAD, and return it."""
    from CNCStepper.workbench.part_records.dialog import NAME, PartRecords
    from CNCStepper.workbench.services.front_window import only_window

    return only_window(PartRecords, NAME)
