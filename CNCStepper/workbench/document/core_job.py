# SPDX-License-Identifier: LGPL-2.1-or-later
"""From document objects to the core: the job as the core's own model, its program, an operation's setup."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from CNCStepper.cycles.cycle import Setup
from CNCStepper.job import cut_transfer
from CNCStepper.job.cut_transfer import content_of, machine_content, program_texts
from CNCStepper.job.deferred_fitting import once
from CNCStepper.job.model import Job, StockForm, depends_on_contours
from CNCStepper.job.request_digest import Content
from CNCStepper.job.templates.common_kerf import require_kerf
from CNCStepper.machine.profile import validated
from CNCStepper.toolpath import Toolpath
from CNCStepper.workbench.calculation import result_cache
from CNCStepper.workbench.document.clamps import clamps_content
from CNCStepper.workbench.document.cut_chart_of_job import cut_data_of
from CNCStepper.workbench.document.machine_of_job import machine_of
from CNCStepper.workbench.document.operation_order import active_operations
from CNCStepper.workbench.document.stock_of_job import stock_content
from CNCStepper.workbench.features.base import problem_of, values
from CNCStepper.workbench.features.cycle_operation import linked_drawings
from CNCStepper.workbench.features.program import is_of_a_file, job_behind
from CNCStepper.workbench.features.tool import model_of, tool_content

__all__ = [
    "cut_question",
    "job_of",
    "language_of",
    "machine_of",
    "program_question",
    "programs",
    "proven_with",
    "read_back",
    "setup_of",
    "without_operations",
]


def programs(obj: Any) -> list[tuple[str, str]]:
    """Return the names and texts of the programs of a job object; raises what the core raises.

    It is one without a name, or several where the machine wants one a tool. What the cut process has made is taken.
    """
    if result_cache.any_known() and (answer := result_cache.answer_to(program_question(obj))) is not None:
        return list(answer.texts)  # type: ignore[union-attr]
    job = job_of(obj).on(machine_of(obj))
    pairs = zip(active_operations(obj), job.operation, strict=True)
    ready = tuple(each.Proxy.cut_once(cycle, job.setup(cycle)) for each, cycle in pairs)
    return program_texts(job.model_copy(update={"operation": ready}), machine_of(obj), obj.Label)


def program_question(obj: Any) -> dict[str, Any]:
    """Return what the cut process is asked for the programs of a job object; raises JobError for a bad job."""
    return {
        "program": content_of(job_of(obj), _contents(obj, active_operations(obj))),
        "machine": machine_content(machine_of(obj)),
        "title": obj.Label,
    }


def cut_question(obj: Any, operation: Any, cycle: Any) -> dict[str, Any]:
    """Return what the cut process is asked for the cut of an operation of a job object, whose cycle is given."""
    seen = once("contours", obj, lambda: _contour_contents(obj)) if depends_on_contours(cycle) else []
    others = [content for name, content in seen if name != operation.Name]
    given = once("given", obj, lambda: content_of(_bare(obj), []))
    own = {"tool": [tool_content(operation.Tool)], "operation": [*_contents(obj, [operation]), *others]}
    return {"cut": given | own, "machine": machine_content(machine_of(obj))}


def _contents(obj: Any, operations: Sequence[Any]) -> list[Content]:
    return [each.Proxy.content(each, tuple(obj.WorkOrigin)) for each in operations]


def _contour_contents(obj: Any) -> list[tuple[str, Content]]:
    """Return the names and the contents of a job object's contours on which the cuts of others depend."""
    contours = _contours(obj)
    return list(zip([each.Name for each in contours], _contents(obj, contours), strict=True))


def job_of(obj: Any) -> Job:
    """Return a job object as the core's checked model; raises JobError for a kerf that is not that of its nest."""
    operations = active_operations(obj)
    tools = {operation.Tool.Name: operation.Tool for operation in operations}
    job = _model(obj, operations, list(tools.values()))
    require_kerf(job, _nested_kerfs_mm(operations))
    return job


def _nested_kerfs_mm(operations: Sequence[Any]) -> dict[int, float]:
    """Return the kerf of the nest for each operation on a sheet whose parts share cuts, by its number from 1."""
    found = {}
    for number, operation in enumerate(operations, start=1):
        if operation.Proxy.CYCLE != "sheet_cut":
            continue
        groups = (drawing.getParentGroup() for drawing in linked_drawings(operation))
        if kerfs_mm := [float(kerf) for group in groups if (kerf := getattr(group, "SharedKerf", 0.0))]:
            found[number] = kerfs_mm[0]
    return found


def without_operations(obj: Any) -> Job:
    """Return a job object as the core's checked model with all of its tools, and none of its operations."""
    return _model(obj, [], obj.Tools)


def proven_with(program: Any) -> Job:
    """Return with what a job's, an edited or a file's program is proven; a file's has nothing of the operations."""
    job = job_behind(program)
    return _model(job, [], job.Tools) if is_of_a_file(program) else job_of(job)


def language_of(program: Any) -> str:
    """Return the dialect in which a program is read; that of a file takes the feed of its job's chart for a missing F.

    Raises JobError for a chart that cannot be read or does not cover the job.
    """
    job = job_behind(program)
    row = cut_data_of(job) if is_of_a_file(program) else None
    return machine_of(job).language("", row.feed_mm_min if row else 0.0)


def _model(obj: Any, operations: Sequence[Any], tools: Sequence[Any]) -> Job:
    content = {key: value for key, value in values(obj).items() if key in Job.model_fields}
    content["stock"], content["clamp"] = stock_content(obj), clamps_content(obj)
    content["cut_data"] = cut_data_of(obj)
    content["operation"] = tuple(each.Proxy.cycle(each, tuple(obj.WorkOrigin)) for each in operations)
    content["tool"] = tuple(map(model_of, tools))
    return validated(Job, content, obj.Label)


def setup_of(obj: Any, operation: Any, cycle: Any) -> Setup:
    """Return what a job object gives one of its operations, whose cycle is given, whatever is wrong with the others.

    Raises JobError for the tool or the stock.
    """
    return _setting(obj, operation, cycle).on(machine_of(obj)).setup(cycle)


def _setting(obj: Any, operation: Any, cycle: Any) -> Job:
    """Return a job of one operation and of what else counts for it."""
    seen = [each for each in _contours(obj) if each is not operation] if depends_on_contours(cycle) else []
    contours = [each.Proxy.cycle(each, tuple(obj.WorkOrigin)) for each in seen]
    return _bare(obj).model_copy(update={"tool": (model_of(operation.Tool),), "operation": (cycle, *contours)})


def _bare(obj: Any) -> Job:
    """Return what a job object gives each of its operations, without them and their tools."""
    return Job.model_construct(
        machine=obj.Machine,
        clearance_mm=float(obj.Clearance),
        retract_mm=float(obj.Retract),
        stock=validated(StockForm, stock_content(obj), obj.Label),
        tool=(),
        operation=(),
        process=obj.Process,
        material=obj.Material,
        cut_data=cut_data_of(obj),
    )


def _contours(obj: Any) -> list[Any]:
    """Return the operations on which the cuts of others depend, without those that cannot be made."""
    contours = [each for each in active_operations(obj) if each.Proxy.CYCLE == "contour"]
    return [each for each in contours if not problem_of(each)]


def read_back(job: Any, text: str) -> Toolpath:
    """Return the table of moves of a job's program text, in work coordinates (its work zero is not known)."""
    machine = machine_of(job)
    return cut_transfer.read_back(job_of(job) if machine.tool_length == "table" else None, machine, text, job.Label)
