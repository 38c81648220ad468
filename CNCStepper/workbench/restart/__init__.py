# SPDX-License-Identifier: LGPL-2.1-or-later
"""Restart a program in its middle: choose the place, see what the restart does, send it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from CNCStepper.workbench.proving.latest_proof import Sender


def open_restart(program: Any, send: Sender, line: int = 0, said: Sequence[tuple[str, str]] = ()) -> Any:
    """Open the task panel in which the restart of a job or an edited program is chosen; return it.

    send: is given the program and the place that were chosen. line: from which it is proposed, 0 for none.
    said: what is known of the job that did not end, a name and its words each, shown on top.
    Raises JobError when another task panel stands open, and for the program of a lathe.
    """
    import FreeCADGui

    from CNCStepper.errors import JobError
    from CNCStepper.workbench.features.base import LATHE_JOB, proxy_type
    from CNCStepper.workbench.features.program import job_behind
    from CNCStepper.workbench.panels.view_task_panel import require_free
    from CNCStepper.workbench.restart.task import RestartTask

    if proxy_type(job_behind(program)) == LATHE_JOB:
        what = "the program of a lathe cannot be restarted in its middle"
        raise JobError("restart-lathe", what, advice="set the work zero anew and send it whole")
    require_free()
    task = RestartTask(program, send, line, said)
    FreeCADGui.Control.showDialog(task)
    task.begin()
    return task
