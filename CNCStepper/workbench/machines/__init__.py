# SPDX-License-Identifier: LGPL-2.1-or-later
"""The machine's page: profiles chosen, made, copied and changed, and the machine test."""

from __future__ import annotations

from typing import Any


def open_machines(name: str = "") -> Any:
    """Show the dialog with the profiles, that of `name` where one is given, and return it."""
    from CNCStepper.workbench import packages

    packages.require("pydantic")
    packages.require("platformdirs")
    from CNCStepper.workbench.machines.dialog import shown

    return shown(name)
