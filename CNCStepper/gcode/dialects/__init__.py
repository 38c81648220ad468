# SPDX-License-Identifier: LGPL-2.1-or-later
"""The dialects by name; each is one small definition in a file of its own."""

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.dialects.form import ArcRule, Dialect, Writing
from CNCStepper.gcode.dialects.grbl import GRBL
from CNCStepper.gcode.dialects.linuxcnc import LINUXCNC
from CNCStepper.gcode.dialects.thesis_a import THESIS_A

__all__ = ["ArcRule", "Dialect", "Writing", "dialect", "dialect_named", "dialect_names"]

_DIALECTS = {one.name: one for one in (GRBL, LINUXCNC, THESIS_A)}


def dialect_names() -> list[str]:
    """Return the names that `dialect` knows."""
    return sorted(_DIALECTS)


def dialect(name: str | Dialect) -> Dialect:
    """Return the dialect called `name` (a Dialect is returned as it is); raises ProgramError when there is none."""
    if isinstance(name, Dialect):
        return name
    if name not in _DIALECTS:
        raise ProgramError(
            "unknown-dialect",
            f"there is no dialect '{name}'",
            advice=f"use one of: {', '.join(dialect_names())}",
        )
    return _DIALECTS[name]


dialect_named = dialect  # for functions that have an argument called `dialect`
