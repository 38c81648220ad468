# SPDX-License-Identifier: LGPL-2.1-or-later
"""The field that chooses the tool that cuts an operation."""

from __future__ import annotations

from typing import Any

from CNCStepper.machine.processes import MILLING, PROCESSES, TURNING
from CNCStepper.workbench.features.base import entry_of, proxy_type, value_of
from CNCStepper.workbench.features.cycle_operation import jobs_of
from CNCStepper.workbench.features.tool import job_with
from CNCStepper.workbench.features.turning.turning_tool import DRILL, PARTING, TurningTool
from CNCStepper.workbench.panels.fields import ChoiceField
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


def tool_words(tool: Any) -> str:
    """Return how a tool is listed: its number, form and diameter, and its own name where it was given one."""
    from CNCStepper.workbench.panels.unit_values import text_of

    if proxy_type(tool) == TurningTool.Type:
        return turning_tool_words(tool)
    diameter = next(entry for entry in tool.Proxy.PROPERTIES if entry.key == "diameter_mm")
    own = "" if tool.Label.startswith("Tool") else f" – {tool.Label}"
    return f"T{tool.Number}  {text_of(tool.Diameter.Value, diameter)}  {words_of(tool.ToolShape)}{own}"


def turning_tool_words(tool: Any) -> str:
    """Return how a lathe's tool is listed: its number, insert or size, and kind."""
    from CNCStepper.workbench.panels.unit_values import text_of

    key = {PARTING: "width_mm", DRILL: "diameter_mm"}.get(tool.Kind, "")
    size = text_of(value_of(tool, entry_of(tool.Proxy, key)), entry_of(tool.Proxy, key)) if key else tool.Insert
    return f"T{tool.Number}  {size}  {words_of(tool.Kind)}"
