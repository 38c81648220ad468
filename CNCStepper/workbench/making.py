# SPDX-License-Identifier: LGPL-2.1-or-later
"""From document objects to the core: the job as the core's own model, its program, an operation's setup."""

from __future__ import annotations

from typing import Any

from CNCStepper.cycles.form import Setup
from CNCStepper.gcode.interpret import interpret
from CNCStepper.job.make import make_program
from CNCStepper.job.model import Job
from CNCStepper.machine.profile import validated
from CNCStepper.state import Start
from CNCStepper.toolpath import Toolpath
from CNCStepper.workbench.clamps import clamps_content
from CNCStepper.workbench.features.base import values
from CNCStepper.workbench.features.job import active_operations
from CNCStepper.workbench.features.tool import model_of
from CNCStepper.workbench.machines import machine_of
from CNCStepper.workbench.stock import stock_content

__all__ = ["job_of", "machine_of", "program", "read_back", "setup_of"]


def program(obj: Any) -> str:
    """Return the program of a job object; raises what the core raises."""
    job = job_of(obj)
    pairs = zip(active_operations(obj), job.operation, strict=True)
    ready = tuple(each.Proxy.cut_once(cycle, job.setup(cycle)) for each, cycle in pairs)
    return make_program(job.model_copy(update={"operation": ready}), machine_of(obj), obj.Label).program


def job_of(obj: Any) -> Job:
    """Return a job object as the core's checked model."""
    operations = active_operations(obj)
    tools = {operation.Tool.Name: operation.Tool for operation in operations}
    content = {key: value for key, value in values(obj).items() if key in Job.model_fields}
    content["stock"], content["clamp"] = stock_content(obj), clamps_content(obj)
    content["operation"] = tuple(each.Proxy.cycle(each, tuple(obj.WorkOrigin)) for each in operations)
    content["tool"] = tuple(model_of(tool) for tool in tools.values())
    return validated(Job, content, obj.Label)


def setup_of(job: Any, tool: Any) -> Setup:
    """Return what a job object gives an operation with that tool; raises JobError for the tool."""
    return Setup(model_of(tool), float(job.Clearance), float(job.Retract))


def read_back(job: Any, text: str) -> Toolpath:
    """Return the table of moves of a job's program text, in work coordinates (its work zero is not known)."""
    return interpret(text, Start(), dialect=machine_of(job).controller, file=job.Label)
