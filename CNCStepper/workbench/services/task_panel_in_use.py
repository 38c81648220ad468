# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's task panel, of which there is one."""

from __future__ import annotations

from CNCStepper.errors import JobError


def require_free() -> None:
    """Raise JobError when another task is open in the task panel."""
    import FreeCADGui

    if FreeCADGui.Control.activeDialog():
        raise JobError("task-open", "another task is open in the task panel", advice="close it first")
