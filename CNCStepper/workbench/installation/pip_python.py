# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Python that runs pip: of FreeCAD's own version, for compiled packages must load in FreeCAD."""

from __future__ import annotations

import os
from collections.abc import Mapping

from CNCStepper.control.processes.python_finder import VARIABLE, find_python
from CNCStepper.errors import MissingPackage, Text

CONTAINERS = {"APPIMAGE": "AppImage", "SNAP_REVISION": "Snap", "FLATPAK_ID": "Flatpak"}  # by the variable of each


def find_pip_python(version: str) -> str:
    """Return the path of a Python of that version, one with pip where there is one; takes up to seconds.

    Raises MissingPackage when there is none.
    """
    try:
        return find_python(("pip",), version)
    except MissingPackage:
        return _find_any(version)


def _find_any(version: str) -> str:
    try:
        return find_python((), version)
    except MissingPackage as error:
        raise MissingPackage(
            "pip-python",
            Text("no Python {version} is found outside FreeCAD to run pip with", version=version),
            advice=Text(
                "install Python {version} (Debian and Ubuntu: sudo apt-get install python3-pip), or set the "
                "environment variable {variable} to the path of one",
                version=version,
                variable=VARIABLE,
            ),
        ) from error


def container(variables: Mapping[str, str] = os.environ) -> str:
    """Return in which container FreeCAD runs, which nobody can write into: "AppImage", "Snap", "Flatpak" or ""."""
    return next((name for variable, name in CONTAINERS.items() if variables.get(variable)), "")
