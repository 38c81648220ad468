# SPDX-License-Identifier: LGPL-2.1-or-later
"""Installing the packages that FreeCAD's Python lacks, from the window and without starting FreeCAD again."""

from __future__ import annotations

from typing import Any


def open_installation() -> Any:
    """Show the dialog in front, one for each FreeCAD, and return it; nothing is installed before a click."""
    from CNCStepper.workbench.installation.dialog import NAME, Installer
    from CNCStepper.workbench.services.front_window import only_window

    return only_window(Installer, NAME)
