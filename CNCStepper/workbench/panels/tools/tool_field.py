# SPDX-License-Identifier: LGPL-2.1-or-later
"""The field that chooses the tool that cuts an operation."""

from __future__ import annotations

from typing import Any

from CNCStepper.machine.processes import MILLING, PROCESSES, TURNING
from CNCStepper.workbench.features.cycle_operation import jobs_of
from CNCStepper.workbench.features.tool import job_with
from CNCStepper.workbench.panels.fields import ChoiceField
from CNCStepper.workbench.panels.tools.tool_words import tool_words
from CNCStepper.workbench.services.choice_labels import words_of


class ToolField(ChoiceField):
    """One of the job's tools."""

    def choices(self) -> list[tuple[Any, str]]:
        """Return the tools of the job that holds the operation."""
        jobs = jobs_of(self.obj)
        tools = [tool for tool in jobs[0].Tools if fits(tool, jobs[0]) or tool == self.obj.Tool] if jobs else []
        return [(tool, tool_words(tool)) for tool in tools]


class ShapeField(ChoiceField):
    """One of the forms that a tool may have: of those with which its job's process cuts."""

    def choices(self) -> list[tuple[Any, str]]:
        """Return the forms; milling takes all, as a beam cuts a contour too."""
        job = job_with(self.obj)
        shapes = self.entry.choices if job is None or job.Process == MILLING.name else PROCESSES[job.Process].shapes
        own = (self.obj.ToolShape,) if self.obj.ToolShape not in shapes else ()
        return [(shape, words_of(shape)) for shape in (*shapes, *own)]


def fits(tool: Any, job: Any) -> bool:
    """Return whether the process of a job cuts with a tool; milling and turning take all."""
    if job.Process == TURNING:
        return True
    return job.Process == MILLING.name or tool.FromChart or tool.ToolShape in PROCESSES[job.Process].shapes
