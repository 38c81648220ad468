# SPDX-License-Identifier: LGPL-2.1-or-later
"""From document objects to the core: the job as the core's own model, its program, one operation for trial."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from CNCStepper.cycles.form import Answer, Setup
from CNCStepper.gcode.interpret import interpret
from CNCStepper.job.make import make_program
from CNCStepper.job.model import Job
from CNCStepper.machine.profile import Machine, load_machine, profile_names, validated
from CNCStepper.state import Start
from CNCStepper.toolpath import TableBuilder, Toolpath
from CNCStepper.workbench.features.base import values
from CNCStepper.workbench.features.job import active_operations
from CNCStepper.workbench.features.tool import model_of


def program(obj: Any) -> str:
    """Return the program of a job object; raises what the core raises."""
    return make_program(job_of(obj), machine_of(obj), obj.Label).program


def job_of(obj: Any) -> Job:
    """Return a job object as the core's checked model."""
    operations = active_operations(obj)
    tools = {operation.Tool.Name: operation.Tool for operation in operations}
    content = {key: value for key, value in values(obj).items() if key in Job.model_fields}
    content["stock"] = {"size_mm": values(obj)["stock_size_mm"], "origin": obj.StockOrigin}
    content["operation"] = tuple(each.Proxy.cycle(each, tuple(obj.WorkOrigin)) for each in operations)
    content["tool"] = tuple(model_of(tool) for tool in tools.values())
    return validated(Job, content, obj.Label)


def machine_of(obj: Any) -> Machine:
    """Return the machine of a job object; a profile's file is looked for beside the document, its dialect set."""
    name = obj.Machine
    if name not in profile_names() and obj.Document.FileName:
        name = str(Path(obj.Document.FileName).parent / name)
    machine = load_machine(name)
    return machine.model_copy(update={"controller": obj.Dialect}) if obj.Dialect else machine


def trial(job: Any, tool: Any, cycle: Any) -> Answer:
    """Return what a cycle answers when it is cut alone, as in its job; raises CycleError."""
    setup = Setup(model_of(tool), float(job.Clearance), float(job.Retract))
    return cycle.cut(setup, TableBuilder(Start()))


def read_back(job: Any, text: str) -> Toolpath:
    """Return the table of moves of a job's program text, in work coordinates (its work zero is not known)."""
    return interpret(text, Start(), dialect=machine_of(job).controller, file=job.Label)
