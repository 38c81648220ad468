# SPDX-License-Identifier: LGPL-2.1-or-later
"""The order of a job's operations: moved, duplicated, and pasted ones taken into the job of their original.

Nothing leaves a job here. The caller opens the transaction.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from CNCStepper.errors import JobError, Text
from CNCStepper.workbench.document.pasted_tools import remove_soon
from CNCStepper.workbench.features.base import is_job, is_tool, original_of, proxy_type


def is_operation(obj: Any) -> bool:
    """Return whether an object is one of our operations."""
    return bool(getattr(getattr(obj, "Proxy", None), "CYCLE", ""))


def active_operations(job: Any) -> list[Any]:
    """Return the operations that the program holds, in order."""
    return [operation for operation in job.Operations if operation.Active]


def job_of(part: Any) -> Any:
    """Return the job that holds an operation or a tool, None where none does."""
    if part is None:
        return None
    return next((job for job in part.InList if is_job(job) and part in (*job.Operations, *job.Tools)), None)


def move(job: Any, operations: Sequence[Any], beside: Any = None, after: bool = True) -> None:
    """Place operations of a job, in their present order, before or after another one of it.

    beside: None puts them at the end of the job. Raises JobError for an operation of another job, and moves nothing.
    """
    for each in [*operations, *([beside] if beside is not None else [])]:
        if each not in job.Operations:
            what = Text("'{each}' is no operation of '{job}'", each=each.Label, job=job.Label)
            advice = "choose operations of one job"
            raise JobError("operation-elsewhere", what, advice=advice)
    if beside in operations:
        return
    moved = [each for each in job.Operations if each in operations]
    order = [each for each in job.Operations if each not in moved]
    at = len(order) if beside is None else order.index(beside) + after
    order[at:at] = moved
    if order != job.Operations:
        job.Operations = order


def step(operations: Sequence[Any], by: int) -> None:
    """Move operations of one job a place up (-1) or down (1); those at the end stay."""
    job = job_of(operations[0])
    order = list(job.Operations)
    wall = -1 if by < 0 else len(order)
    for place in sorted(map(order.index, operations), reverse=by > 0):
        if place + by == wall:
            wall = place
        else:
            order.insert(place + by, order.pop(place))
    if order != job.Operations:
        job.Operations = order


def can_step(operations: Sequence[Any], by: int) -> bool:
    """Return whether a step would change the order of operations of one job."""
    order = list(job_of(operations[0]).Operations)
    at_the_end = order[: len(operations)] if by < 0 else order[-len(operations) :]
    return set(at_the_end) != set(operations)


def duplicate(operations: Sequence[Any]) -> list[Any]:
    """Return copies of operations, each behind its original in the job, with the same tool and drawings."""
    return [each.Document.copyObject(each, False) for each in operations]  # FreeCAD's copy is taken in, as a pasted one


def take_in(copy: Any) -> None:
    """Take a copied or pasted operation or tool into the job of its original, behind it, or into the only job.

    An operation keeps the tool of its original where that is one of the job's. Where the document has several jobs
    and none of them holds the original, the copy stays outside.
    """
    original = original_of(copy)
    if (original is None and not copy.Proxy.is_copy) or job_of(copy) is not None:
        return
    job = job_of(original) or _only_job(copy)
    if job is None:
        return
    if is_operation(copy):
        if original is not None and original.Tool in job.Tools:
            spare, copy.Tool = copy.Tool, original.Tool  # not the copy of it that FreeCAD makes along
            if spare is not None and spare is not original.Tool:
                remove_soon(spare)
        elif is_tool(copy.Tool) and copy.Tool not in job.Tools:
            add_tool(job, copy.Tool, None)
        job.Operations = _behind(list(job.Operations), original, copy)
    else:
        add_tool(job, copy, original)


def add_tool(job: Any, tool: Any, behind: Any) -> None:
    """Add a tool to those of a job, behind another one or at the end, with the next free number where its is taken."""
    numbers = [other.Number for other in job.Tools]
    if tool.Number in numbers:
        tool.Number = max(numbers) + 1
    job.Tools = _behind(list(job.Tools), behind, tool)


def _behind(parts: list[Any], original: Any, copy: Any) -> list[Any]:
    """Return a row of parts with a copy behind its original and the copies of that which are there already."""
    if original not in parts:
        return [*parts, copy]
    at = parts.index(original) + 1
    return [*parts[:at], copy, *parts[at:]]


def _only_job(copy: Any) -> Any:
    """Return the one job of a copy's document that takes its kind, None for none or several."""
    jobs = [obj for obj in copy.Document.Objects if proxy_type(obj) == copy.Proxy.JOB_TYPE]
    return jobs[0] if len(jobs) == 1 else None
