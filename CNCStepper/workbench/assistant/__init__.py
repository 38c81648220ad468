# SPDX-License-Identifier: LGPL-2.1-or-later
"""The machine assistant: from a port, or none, to a saved machine profile. Loads nothing of Qt."""

from __future__ import annotations

from typing import Any


def open_assistant() -> Any:
    """Show the assistant in front, in FreeCAD's language, and return it."""
    from CNCStepper.workbench import packages

    packages.require("pydantic")
    packages.require("platformdirs")
    from CNCStepper.workbench.assistant.wizard import shown

    return shown()
