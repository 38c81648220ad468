# SPDX-License-Identifier: LGPL-2.1-or-later
"""The user's own tools, materials and cut charts: tables that are searched, edited, imported and exported."""

from __future__ import annotations

from typing import Any


def open_libraries() -> Any:
    """Show the dialog with the three tables, and return it."""
    from CNCStepper.workbench import packages

    packages.require("pydantic")
    packages.require("platformdirs")
    from CNCStepper.workbench.libraries.dialog import shown

    return shown()
