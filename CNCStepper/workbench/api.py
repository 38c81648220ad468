# SPDX-License-Identifier: LGPL-2.1-or-later
"""Making and editing the document objects from a script, in a window or in freecadcmd.

    import FreeCAD
    from CNCStepper.workbench import api

    document = FreeCAD.newDocument()
    job = api.new_job(document, machine="table-a", stock_size_mm=(100, 70, 20))
    cutter = api.add_tool(job, number=1, diameter_mm=6, feed_mm_min=800, plunge_mm_min=200)
    api.add_elliptical_pocket(job, tool=cutter, radius_x_mm=40, radius_y_mm=25, depth_mm=10)
    document.recompute()
    print(api.program_text(job))

The keys are those of job files; the unit of each value is its key's suffix. A bad value raises JobError
and leaves the document as it was. What only shows when cutting (a tool wider than the pocket) shows in
the recompute, as the object's error state; `program_text` then refuses.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

from CNCStepper.errors import CNCStepperError, JobError
from CNCStepper.workbench import program_file
from CNCStepper.workbench.features.base import Feature, edit
from CNCStepper.workbench.features.elliptical_pocket import EllipticalPocket
from CNCStepper.workbench.features.engrave import Engrave
from CNCStepper.workbench.features.freehand import Freehand
from CNCStepper.workbench.features.job import Job
from CNCStepper.workbench.features.preview import Preview
from CNCStepper.workbench.features.tool import Tool

__all__ = [
    "add_elliptical_pocket",
    "add_engrave",
    "add_freehand",
    "add_tool",
    "edit",
    "new_job",
    "program_text",
]


def new_job(document: Any, **values: Any) -> Any:
    """Return a new CNCStepper_Job in `document`, with a preview of its program; `values` by the job's keys."""
    job = _add(document, "App::FeaturePython", Job, values)
    import Path  # noqa: F401  # FreeCAD learns the type of its Path objects from this module

    _add(document, "Path::FeaturePython", Preview, {"job": job})
    return job


def add_tool(job: Any, **values: Any) -> Any:
    """Return a new CNCStepper_Tool among the job's tools; its number is the next free one unless given."""
    numbers = [tool.Number for tool in job.Tools]
    tool = _add(job.Document, "App::FeaturePython", Tool, {"number": max(numbers, default=0) + 1, **values})
    job.Tools = [*job.Tools, tool]
    return tool


def add_elliptical_pocket(job: Any, **values: Any) -> Any:
    """Return a new CNCStepper_EllipticalPocket at the end of the job, from a `drawing` or from numbers."""
    return _add_operation(job, EllipticalPocket, values)


def add_engrave(job: Any, **values: Any) -> Any:
    """Return a new CNCStepper_Engrave of a `drawing` at the end of the job."""
    return _add_operation(job, Engrave, values)


def add_freehand(
    document: Any, points_mm: Iterable[Sequence[float]], tolerance_mm: float = 0.0, closed: bool = False
) -> Any:
    """Return a new CNCStepper_Freehand through points (X, Y or X, Y, Z) in drawing order."""
    values = {"points_mm": list(points_mm), "tolerance_mm": tolerance_mm, "closed": closed}
    return _add(document, "Part::FeaturePython", Freehand, values)


def program_text(job: Any) -> str:
    """Return the job's program; raises JobError when there is none, or one that the drawing has left behind."""
    for obj in [job, *job.OutListRecursive]:
        if not obj.isValid():
            raise JobError("object-failed", f"{obj.Label}: {obj.getStatusString()}", advice="mend that object first")
    stale = [obj.Label for obj in [job, *job.OutListRecursive] if "Touched" in obj.State]
    if stale:
        raise JobError("program-stale", f"{stale[0]} has changed since the program was made", advice="recompute")
    text = program_file.load(job)
    if not text:
        raise JobError("program-missing", f"{job.Label} has no program: {job.Message}", advice="recompute")
    return text


def _add_operation(job: Any, kind: type[Feature], values: dict[str, Any]) -> Any:
    tool = {"tool": job.Tools[-1]} if job.Tools else {}
    operation = _add(job.Document, "App::FeaturePython", kind, {**tool, **values})
    job.Operations = [*job.Operations, operation]
    return operation


def _add(document: Any, freecad_type: str, kind: type[Feature], values: dict[str, Any]) -> Any:
    obj = document.addObject(freecad_type, kind.Type)
    obj.Label = kind.Type.removeprefix("CNCStepper_")
    try:
        kind(obj)
        edit(obj, **values)
    except CNCStepperError:
        document.removeObject(obj.Name)
        raise
    return obj
