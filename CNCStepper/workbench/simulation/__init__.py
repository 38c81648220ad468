# SPDX-License-Identifier: LGPL-2.1-or-later
"""Check and simulate: the cut part in FreeCAD's 3D view, the tool running along the path, and the findings."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any


def open_simulation(job_object: Any, restart: Callable[[Any, int], object]) -> Any:
    """Open the task panel of a job's simulation and return it; another open task panel is left alone.

    restart: what its button does with the program and the line under way. Raises JobError when there is one.
    """
    import FreeCADGui

    from CNCStepper.workbench.features.base import LATHE_JOB, proxy_type
    from CNCStepper.workbench.features.program import job_behind
    from CNCStepper.workbench.panels.view_task_panel import require_free
    from CNCStepper.workbench.simulation.task import SimulationTask
    from CNCStepper.workbench.simulation.turned_task import TurnedSimulationTask

    require_free()
    kind = TurnedSimulationTask if proxy_type(job_behind(job_object)) == LATHE_JOB else SimulationTask
    task = kind(job_object, restart)
    FreeCADGui.Control.showDialog(task)
    task.begin()
    return task
