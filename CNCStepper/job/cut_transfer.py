# SPDX-License-Identifier: LGPL-2.1-or-later
"""Jobs as the window and the cut process hand them to each other, and what both make of them; without FreeCAD."""

from __future__ import annotations

import functools
import json
from collections import deque
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from CNCStepper.cycles.cycle import Cycle
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.job.make import is_split, make_parts, make_program
from CNCStepper.job.model import Job, StockForm, operation_of
from CNCStepper.job.path_commands import commands, gcode
from CNCStepper.job.request_digest import Content
from CNCStepper.machine.cut_data import CutData
from CNCStepper.machine.profile import Machine, validated
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.state import Start
from CNCStepper.toolpath import Toolpath

_machines: deque[tuple[Machine, Content]] = deque(maxlen=4)


def content_of(job: Job, operations: Sequence[dict[str, Any]] | None = None) -> dict[str, Any]:
    """Return a job as plain data, its curves within it; operations: theirs, where that is at hand."""
    if operations is None:
        operations = [operation.model_dump(mode="json") for operation in job.operation]
    return {**job.model_dump(mode="json", exclude={"operation"}), "operation": operations}


def machine_content(machine: Machine) -> Content:
    """Return a machine as plain data, which is kept for the last ones."""
    found = next((content for known, content in _machines if known is machine), None)
    if found is None:
        found = Content(machine.model_dump(mode="json"))
        _machines.append((machine, found))
    return found


def job_from(content: dict[str, Any], machine: dict[str, Any]) -> Job:
    """Return the job of `content_of`, as that machine cuts it; raises JobError."""
    return job_from_content(content).on(machine_from(machine))


def job_from_content(content: dict[str, Any]) -> Job:
    """Return the job of `content_of`; raises JobError."""
    job: Job = validated(Job, {**content, "operation": _operations(content)}, "job")
    return job


def setting_from(content: dict[str, Any], machine: dict[str, Any]) -> Job:
    """Return a job of which only the first operation is cut: the tools of the others are missing; raises JobError."""
    parts = {
        "stock": validated(StockForm, content["stock"], "stock"),
        "tool": tuple(validated(Tool, raw, "tool") for raw in content["tool"]),
        "operation": _operations(content),
        "cut_data": validated(CutData, row, "cut_data") if (row := content.get("cut_data")) else None,
    }
    return Job.model_construct(**{**content, **parts}).on(machine_from(machine))


def _operations(content: dict[str, Any]) -> tuple[Cycle, ...]:
    return tuple(operation_of(raw, Path(), f"operation {n}") for n, raw in enumerate(content["operation"], 1))


def machine_from(content: dict[str, Any]) -> Machine:
    """Return the machine of `machine_content`; raises JobError."""
    return _machine(json.dumps(content))


@functools.lru_cache(maxsize=4)
def _machine(content: str) -> Machine:
    return validated(Machine, json.loads(content), "machine")


def program_texts(job: Job, machine: Machine, title: str) -> list[tuple[str, str]]:
    """Return the names and texts of a job's programs; raises the errors of `make`.

    It is one without a name, or several where the machine wants one a tool.
    """
    if is_split(job, machine):
        return [(part.file_name, part.program) for part in make_parts(job, machine, title)]
    return [("", make_program(job, machine, title).program)]


def read_back(job: Job | None, machine: Machine, text: str, file: str) -> Toolpath:
    """Return the table of moves of a program text, in work coordinates (its work zero is not known).

    job: where the machine takes the tools' lengths from its table.
    """
    start = Start()
    if job is not None:
        start = job.started(start, machine) or start
    return interpret(text, start, dialect=machine.language(), file=file)


def path_text(job: Job | None, machine: Machine, text: str, file: str) -> str:
    """Return a program's moves as FreeCAD's Path reads them."""
    return gcode(commands(read_back(job, machine, text, file)))
