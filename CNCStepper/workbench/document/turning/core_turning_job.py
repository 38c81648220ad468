# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a lathe's document objects to the core: its job as the core's own model, and its programs."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from CNCStepper.job.turning import turning_transfer
from CNCStepper.job.turning.turning_job import Chuck, Tailstock, TurnedStock, TurningJob, TurningSetup, require_lathe
from CNCStepper.machine.profile import Machine, validated
from CNCStepper.toolpath import Toolpath
from CNCStepper.workbench.calculation import result_cache
from CNCStepper.workbench.document.machine_of_job import machine_of
from CNCStepper.workbench.document.operation_order import active_operations
from CNCStepper.workbench.document.turning.profile_of_operation import profile_pair, rows_of, side_of
from CNCStepper.workbench.features.base import values
from CNCStepper.workbench.features.cycle_operation import tool_of
from CNCStepper.workbench.features.program import is_of_a_file
from CNCStepper.workbench.features.program_job import part_of
from CNCStepper.workbench.features.turning.turning_tool import model_of

MADE_BY_DRILLING = "turn_drill"


def lathe_of(obj: Any) -> Machine:
    """Return the machine of a lathe's job object; raises JobError for one without X and Z."""
    return require_lathe(machine_of(obj))


def check_setup(obj: Any) -> None:
    """Raise JobError for a machine that is no lathe, or a stock, chuck or tailstock that cannot be."""
    lathe_of(obj)
    content = obj.Proxy.given(values(obj))
    validated(TurnedStock, content["stock"], obj.Label)
    validated(Chuck, content["chuck"], obj.Label)
    if content["tailstock"]:
        validated(Tailstock, content["tailstock"], obj.Label)


def turning_setup_of(obj: Any) -> TurningSetup:
    """Return what a lathe's job object has before its operations, with all its tools; raises JobError for a bad one."""
    content = obj.Proxy.given(values(obj)) | {"tool": tuple(map(model_of, obj.Tools))}
    return validated(TurningSetup, content, obj.Label)


def turning_job_of(obj: Any, operations: Sequence[Any] | None = None) -> TurningJob:
    """Return a lathe's job object as the core's checked model; operations: of those alone, None for all active ones."""
    used = active_operations(obj) if operations is None else operations
    content, profiles = obj.Proxy.given(values(obj)), _profiles(used, obj.XIs)
    tools = {tool_of(operation).Name: tool_of(operation) for operation in used}
    numbers = [tool for tool in obj.Tools if tool.Name in tools]
    content["tool"] = tuple(map(model_of, numbers + [tool for tool in tools.values() if tool not in numbers]))
    content["profile"] = [{"name": name, "points": rows} for name, rows in profiles.values()]
    content["operation"] = tuple(each.Proxy.operation(each, _profile_name(each, profiles)) for each in used)
    return validated(TurningJob, content, obj.Label)


def _profiles(operations: Sequence[Any], x_is: str) -> dict[Any, tuple[str, list[Any]]]:
    """Return names and rows of the profiles that operations follow, by drawing, edges and side; each counts once."""
    found: dict[Any, tuple[str, list[Any]]] = {}
    names: set[str] = set()
    for operation in operations:
        pair, key = profile_pair(operation), _key(operation)
        if pair is not None and key not in found:
            name = pair[0].Label if pair[0].Label not in names else f"{pair[0].Label} {len(names) + 1}"
            names.add(name)
            found[key] = (name, rows_of(pair, x_is, key[2]))
    return found


def _profile_name(operation: Any, profiles: dict[Any, tuple[str, list[Any]]]) -> str:
    key = _key(operation)
    return profiles[key][0] if key in profiles else ""


def _key(operation: Any) -> tuple[str, tuple[str, ...], str]:
    pair = profile_pair(operation)
    return (pair[0].Name, pair[1], side_of(operation)) if pair else ("", (), "")


def programs(obj: Any) -> list[tuple[str, str]]:
    """Return the names and texts of the programs of a lathe's job object; raises what the core raises.

    What the cut process has made is taken.
    """
    if result_cache.any_known() and (answer := result_cache.answer_to(program_question(obj))) is not None:
        return list(answer.texts)  # type: ignore[union-attr]
    return turning_transfer.program_texts(turning_job_of(obj), lathe_of(obj), obj.Label)


def program_question(obj: Any) -> dict[str, Any]:
    """Return what the cut process is asked for the programs of a job object; raises JobError for a bad job."""
    content = turning_transfer.content_of(turning_job_of(obj), lathe_of(obj))
    return {"turned_program": content, "title": obj.Label}


def cut_question(obj: Any, operation: Any) -> dict[str, Any]:
    """Return what the cut process is asked for the figures of an operation of a job object; raises JobError."""
    return {"turned_cut": turning_transfer.content_of(_cut_alone(obj, operation), lathe_of(obj))}


def cut_for_trial(obj: Any, operation: Any) -> tuple[dict[str, float], tuple[str, ...]]:
    """Return figures and warnings of an operation, cut as its job would; raises CycleError."""
    if result_cache.any_known() and (answer := result_cache.answer_to(cut_question(obj, operation))) is not None:
        return answer.figures, answer.warnings  # type: ignore[union-attr]
    return turning_transfer.last_cut(_cut_alone(obj, operation), lathe_of(obj))


def _cut_alone(obj: Any, operation: Any) -> TurningJob:
    """Return a job of an operation and of the holes that were drilled before it, into which a boring bar may go."""
    before = []
    for each in obj.Operations:
        if each.Name == operation.Name:
            break
        if each.Active and each.Proxy.CYCLE == MADE_BY_DRILLING and not each.Problem:
            before.append(each)
    return turning_job_of(obj, [*before, operation])


def proof_question(obj: Any, program: Any) -> Callable[[Path, str], None]:
    """Return what writes the request for the proof of a job's, an edited or a G-code file's program into a folder."""
    from CNCStepper.job.turning.prove_program import TurnedBar
    from CNCStepper.job.turning.turning_proof_folder import write_file_question, write_job_question

    machine = lathe_of(obj)
    if is_of_a_file(program):
        stock = validated(TurnedStock, obj.Proxy.given(values(obj))["stock"], obj.Label)
        bar = TurnedBar(stock.diameter_mm, stock.length_mm, stock.bore_mm, stock.face_mm)
        tools = list(map(model_of, obj.Tools))
        return lambda folder, text: write_file_question(folder, text, bar, tools, machine)
    job, part = turning_job_of(obj), part_of(obj, obj.ProgramParts)
    title = str(obj.Label)
    return lambda folder, text: write_job_question(folder, text, job, machine, part, title)


def comparison_content(obj: Any) -> dict[str, Any]:
    """Return what cuts a job's programs where two are compared; raises JobError for a bad job."""
    content = turning_transfer.content_of(turning_job_of(obj), lathe_of(obj))
    tools = [model_of(tool).model_dump(mode="json", exclude_none=True) for tool in obj.Tools]
    return {**content, "part": part_of(obj, obj.ProgramParts), "tools": tools}


def read_back(obj: Any, text: str) -> Toolpath:
    """Return the table of moves of a program's text in the document: X is the radius, Z the part's."""
    return turning_transfer.read_back(turning_job_of(obj), lathe_of(obj), text, obj.Label)
