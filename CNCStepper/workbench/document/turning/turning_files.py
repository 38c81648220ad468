# SPDX-License-Identifier: LGPL-2.1-or-later
"""Job files of a lathe in and out: a job object as the text of a job file, and the objects of a job that a file holds.

job object ──► turning_job_of ──► save_turning_job
file ──► TurningJob ──► opened: job, tools, an object by points for each profile, operations
"""

from __future__ import annotations

from collections.abc import Generator
from pathlib import Path
from typing import TYPE_CHECKING, Any

from CNCStepper.errors import CNCStepperError, Text
from CNCStepper.workbench.features.turning.turning_tool import keys_of

if TYPE_CHECKING:
    from CNCStepper.job.turning.profile_form import ProfileForm
    from CNCStepper.job.turning.turning_job import TurningJob, TurningSetup

TABLES = ("stock", "chuck", "tailstock")


def export_turning_job(obj: Any, path: Path) -> None:
    """Write a lathe's job object as a job file; a machine's file is named by its whole path. Raises JobError."""
    from CNCStepper.job.turning.turning_job_text import save_turning_job
    from CNCStepper.workbench.document.turning.core_turning_job import turning_job_of

    save_turning_job(with_whole_machine(turning_job_of(obj), obj), path)


def with_whole_machine(job: Any, obj: Any) -> Any:
    """Return a core's job, or its set-up, of a job object with the file of its machine by its whole path."""
    from CNCStepper.machine.profile import profile_names

    named = job.machine in profile_names() or Path(job.machine).is_absolute() or not obj.Document.FileName
    machine = job.machine if named else str(Path(obj.Document.FileName).parent / job.machine)
    return job.model_copy(update={"machine": machine})


def turning_objects_of(document: Any, job: TurningJob, path: Path) -> Generator[None, None, tuple[Any, list[str]]]:
    """Return the new lathe job object of a file's job, and what of it the objects do not hold.

    Yields after each object, so that a window can see to its events.
    """
    from CNCStepper.job.model import machine_path
    from CNCStepper.workbench.document.turning.core_turning_job import turning_job_of

    obj = yield from _opened(document, job, str(machine_path(job.machine, path.parent)), path.stem)
    yield
    try:
        return obj, _differences(turning_job_of(obj), job)
    except CNCStepperError as error:  # the operation that cannot be made says it too
        return obj, [error.sentence]


def _opened(document: Any, job: TurningJob, machine: str, label: str) -> Generator[None, None, Any]:
    from CNCStepper.workbench import api

    obj = api.new_lathe_job(document, **setup_values(job, machine))
    obj.Label = label
    tools, profiles = {}, {}
    for tool in job.tool:
        yield
        tools[tool.number] = api.add_tool(obj, **keys_of(tool))
    for form in job.profile:
        yield
        profiles[form.name] = _profile(document, form, job)
    for operation in job.operation:
        yield
        content = operation.model_dump(exclude={"cycle", "tool", "profile"})
        drawing = profiles.get(getattr(operation, "profile", ""))
        api.add_operation(obj, operation.cycle, drawing, tool=tools[operation.tool], **content)
    return obj


def setup_values(job: TurningSetup, machine: str) -> dict[str, Any]:
    """Return the values of a job object by its keys, those of a table with its name before them; no bore of a bar."""
    content = job.model_dump(exclude={"tool", "profile", "operation", "start", *TABLES})
    content["machine"] = machine
    for name in TABLES:
        table = getattr(job, name)
        content |= {f"{name}_{key}": value for key, value in (table.model_dump() if table else {}).items()}
    if job.stock.form == "bar":
        del content["stock_bore_mm"]
    content["tailstock_by"] = "given" if job.tailstock else "none"
    if job.start is not None:
        content |= {"start_by": "given", "start_x_mm": job.start[0], "start_z_mm": job.start[1]}
    return content


def _profile(document: Any, form: ProfileForm, job: TurningJob) -> Any:
    """Return the object by points of a profile; a drawing's has those of its lines and arcs."""
    from CNCStepper.job.turning.profile_rows import lines_of
    from CNCStepper.job.turning.section_sides import profile_rows
    from CNCStepper.workbench import api

    rows = form.points if form.points is not None else profile_rows(job.curves[form.name], job.x_is)
    obj = api.add_profile(document, lines_of(rows), job.x_is)
    obj.Label = form.name
    return obj


def _differences(made: TurningJob, job: TurningJob) -> list[str]:
    """Return what of a file's job its objects do not hold, as sentences."""
    found: list[str] = []
    for number, (ours, theirs) in enumerate(zip(made.operation, job.operation, strict=True), start=1):
        for key in type(theirs).model_fields:
            if key != "profile" and getattr(ours, key) != getattr(theirs, key):
                found.append(Text("operation {number} has another {key} than its file", number=number, key=key))
    for number, tool in job.tools.items():
        own = made.tools.get(number, tool)
        if (own.outline(), own.words) != (tool.outline(), tool.words):
            found.append(Text("tool {number} is not quite that of its file", number=number))
    return found
