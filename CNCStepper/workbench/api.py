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

import importlib
import os
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from CNCStepper.atomic_file import write_whole
from CNCStepper.errors import CNCStepperError, JobError, OutputError, Place, Text
from CNCStepper.machine.processes import PROCESSES
from CNCStepper.workbench import packages
from CNCStepper.workbench.document import program_file
from CNCStepper.workbench.features.base import Feature, edit, require_parts
from CNCStepper.workbench.features.catalogue import operation_class
from CNCStepper.workbench.features.drawings.drawing import Drawing
from CNCStepper.workbench.features.drawings.nest import Nest, PartValues, set_parts
from CNCStepper.workbench.features.drawings.shape import Shape
from CNCStepper.workbench.features.drawings.slices import Slices
from CNCStepper.workbench.features.drawings.text import Text as TextObject
from CNCStepper.workbench.features.freehand import Freehand
from CNCStepper.workbench.features.job import Job
from CNCStepper.workbench.features.preview import Preview
from CNCStepper.workbench.features.program import Program, fingerprint, program_of_file
from CNCStepper.workbench.features.programs.arrangement import Arrangement, set_sources
from CNCStepper.workbench.features.tool import Tool
from CNCStepper.workbench.features.turning.lathe_job import LatheJob
from CNCStepper.workbench.features.turning.turning_profile import TurningProfile
from CNCStepper.workbench.features.turning.turning_tool import TurningTool

if TYPE_CHECKING:
    from CNCStepper.job.model import Job as Model
    from CNCStepper.machine.tools.stored_tool import StoredTool

__all__ = [
    "add_drawing",
    "add_elliptical_pocket",
    "add_engrave",
    "add_freehand",
    "add_operation",
    "add_profile",
    "add_shape",
    "add_slices",
    "add_stored_tool",
    "add_text",
    "add_tool",
    "chart_tool",
    "edit",
    "edit_program",
    "import_drawing",
    "import_tools",
    "job_model",
    "new_job",
    "new_lathe_job",
    "program_text",
    "reload_drawing",
    "require_valid",
    "save_program",
    "slice_solid",
]


UNKNOWN = {"feed_mm_min": 0, "plunge_mm_min": 0, "spindle_rpm": 0}  # of a tool whose file does not say it


def new_job(document: Any, **values: Any) -> Any:
    """Return a new CNCStepper_Job in `document`, with a preview of its program; `values` by the job's keys."""
    return _new_job(document, Job, values)


def new_lathe_job(document: Any, **values: Any) -> Any:
    """Return a new CNCStepper_LatheJob in `document`, with a preview of its program; `values` by the job's keys.

    Keys of a table have its name before them: "stock_diameter_mm".
    """
    return _new_job(document, LatheJob, values)


def _new_job(document: Any, kind: type[Feature], values: dict[str, Any]) -> Any:
    job = _add(document, "App::FeaturePython", kind, values)
    importlib.import_module("Path")  # FreeCAD learns the type of its Path objects from it

    _add(document, "Path::FeaturePython", Preview, {"job": job})
    return job


def add_tool(job: Any, **values: Any) -> Any:
    """Return a new tool of the job, of the kind that it has; its number is the next free one unless given."""
    numbers = [tool.Number for tool in job.Tools]
    kind = next(kind for kind in (Tool, TurningTool) if kind.Type == job.Proxy.TOOL)
    tool = _add(job.Document, "App::FeaturePython", kind, {"number": max(numbers, default=0) + 1, **values})
    job.Tools = [*job.Tools, tool]
    return tool


def chart_tool(job: Any) -> Any:
    """Return the job's tool that its cut chart describes, made where it has none."""
    present = (tool for tool in job.Tools if tool.FromChart)
    return next(present, None) or add_tool(job, from_chart=True)


def import_tools(job: Any, path: str | Path, unit_mm: float = 1.0) -> tuple[list[Any], list[str]]:
    """Return the tools of a file as new tools of the job, and what of the file was not understood or not taken.

    The file is FreeCAD's `.fctb` or `.fctl`, or LinuxCNC's `.tbl` with lengths in units of `unit_mm`. A number that
    the job has already becomes the next free one. Raises JobError for a file that cannot be read, and adds nothing.
    """
    packages.require()
    from CNCStepper.machine.tools.tool_files import read_tools

    stored = read_tools(Path(path), unit_mm)
    notes: list[str] = [
        Text("{tool}: {note}", tool=each.name or each.number, note=note) for each in stored for note in each.notes
    ]
    return [add_stored_tool(job, each) for each in stored if each.tool is not None], notes


def add_stored_tool(job: Any, stored: StoredTool) -> Any:
    """Return a tool of a file or of the user's library as a new tool of the job.

    A number that the job has already becomes the next free one. Raises JobError for one that is none of our shapes.
    """
    from CNCStepper.machine.tools.stored_tool import given_keys

    taken = {tool.Number for tool in job.Tools}
    free = stored.number if stored.number not in taken else max(taken) + 1
    tool = add_tool(job, **{**UNKNOWN, **given_keys(stored.required(stored.name)), "number": free})
    tool.Label = stored.name or tool.Label
    return tool


def add_elliptical_pocket(job: Any, drawing: Any = None, **values: Any) -> Any:
    """Return a new CNCStepper_EllipticalPocket at the end of the job, from a drawing of one ellipse or from numbers."""
    return add_operation(job, "elliptical_pocket", drawing, **values)


def add_engrave(job: Any, drawing: Any, **values: Any) -> Any:
    """Return a new CNCStepper_Engrave of a sketch, wire, B-spline or freehand line at the end of the job."""
    return add_operation(job, "engrave", drawing, **values)


def add_operation(job: Any, cycle: str, drawing: Any = None, picked: Sequence[str] = (), **values: Any) -> Any:
    """Return a new operation at the end of the job, from a drawing (picked: its faces and edges) or from numbers.

    drawings, among the values: several, each an object or a pair of it and the names of its faces and edges.
    cycle: its name in job files, such as "pocket", "contour" or "drill"; it is cut with the job's last tool, or the
    one that its cut chart describes, unless `tool` says which.
    """
    kind = operation_class(cycle)
    charted = [process for process in kind.BY if process in PROCESSES and PROCESSES[process].uses_chart]
    if "tool" not in values and job.Process in charted:
        values["tool"] = chart_tool(job)
    tool = {"tool": job.Tools[-1]} if job.Tools else {}
    drawn = {} if drawing is None else {"drawings": [(drawing, tuple(picked))]}
    operation = _add(job.Document, "App::FeaturePython", kind, {**tool, **drawn, **values})
    job.Operations = [*job.Operations, operation]
    return operation


def edit_program(job: Any, text: str = "") -> Any:
    """Return a new CNCStepper_Program with an edited text for a job, its own program unless given."""
    own = program_text(job)
    obj = _add(job.Document, "App::FeaturePython", Program, {"job": job})
    obj.Label = f"{job.Label} (edited)"
    obj.MadeFrom = fingerprint(own)
    program_file.store(obj, text or own)
    job.Message = job.Message  # an output: nothing is out of date by that, but FreeCAD's tree looks at the job again
    return obj


def load_program(job: Any, path: str | Path) -> Any:
    """Return the CNCStepper_Program with the text of a G-code file, for the machine, stock, tools and clamps of a job.

    One that was read from the same file before takes its text. Raises JobError for a file that cannot be read.
    """
    return program_of_file(job, Path(path))


def add_profile(document: Any, points: Iterable[str], x_is: str = "diameter") -> Any:
    """Return a new CNCStepper_TurningProfile; points: a line of text each, as `job/turning/profile_rows.py` says."""
    values = {"points": tuple(points), "x_is": x_is}
    return _add(document, "Part::FeaturePython", TurningProfile, values)


def add_freehand(
    document: Any,
    points_mm: Iterable[Sequence[float]],
    tolerance_mm: float = 0.0,
    closed: bool = False,
    smooth_mm: float = 0.0,
) -> Any:
    """Return a new CNCStepper_Freehand through points (X, Y or X, Y, Z) in drawing order."""
    values = {"points_mm": list(points_mm), "tolerance_mm": tolerance_mm, "smooth_mm": smooth_mm, "closed": closed}
    return _add(document, "Part::FeaturePython", Freehand, values)


def add_drawing(document: Any, path: str | Path, **values: Any) -> Any:
    """Return a new CNCStepper_Drawing of a file, an empty group until it is read; `values` by its keys."""
    return _add(document, "App::DocumentObjectGroupPython", Drawing, {"file": str(Path(path).absolute()), **values})


def import_drawing(document: Any, path: str | Path, **values: Any) -> Any:
    """Return a new CNCStepper_Drawing with the objects that its file holds.

    Raises JobError for a file that cannot be read or a bad value, and adds nothing.
    """
    packages.require()
    from CNCStepper.workbench.document.drawing_files import read_now

    obj = add_drawing(document, path, **values)
    try:
        read_now(obj)
    except CNCStepperError:
        document.removeObject(obj.Name)
        raise
    obj.Label = Path(path).stem
    return obj


def reload_drawing(obj: Any) -> None:
    """Read the file of a CNCStepper_Drawing again; its objects keep their names. Raises JobError, changing nothing."""
    packages.require()
    from CNCStepper.workbench.document.drawing_files import read_now

    read_now(obj)


def add_shape(document: Any, kind: str, **values: Any) -> Any:
    """Return a new CNCStepper_Shape of a kind of the library; `values` are dimensions by the keys of job files.

    Raises JobError for an unknown kind or key and a bad value, and adds nothing.
    """
    packages.require()
    obj = document.addObject("Part::FeaturePython", Shape.Type)
    try:
        Shape(obj).become(obj, kind)
        edit(obj, **values)
    except CNCStepperError:
        document.removeObject(obj.Name)
        raise
    obj.Label = kind
    return obj


def add_slices(document: Any, solid: Any, **values: Any) -> Any:
    """Return a new CNCStepper_Slices of a body or a mesh, an empty group until it is sliced; `values` by its keys."""
    return _add(document, "App::DocumentObjectGroupPython", Slices, {"solid": solid, **values})


def slice_solid(slices: Any) -> None:
    """Cut the solid of a CNCStepper_Slices into sheets, nest their pieces, and read the drawings of that.

    Raises CNCStepperError for a solid that cannot be sliced or a bad value, and then changes nothing.
    """
    packages.require()
    from CNCStepper.workbench.document.slice_files import slice_now

    slice_now(slices)


def add_nest(document: Any, parts: Iterable[Any], **values: Any) -> Any:
    """Return a new CNCStepper_Nest of drawings, sketches, shapes or operations, an empty group until it is nested.

    `values` by its keys; counts, rotations, grain and priority of the parts by `set_nest_parts`.
    """
    return _add(document, "App::DocumentObjectGroupPython", Nest, {"parts": list(parts), **values})


def set_nest_parts(nest: Any, parts: Iterable[tuple[Any, dict[str, Any]]]) -> None:
    """Let a nest have these parts, each with its count, turn, grain and priority."""
    pairs = list(parts)
    set_parts(nest, [part for part, _ in pairs], [PartValues(**wanted) for _, wanted in pairs])


def nest_parts(nest: Any) -> None:
    """Place the parts of a CNCStepper_Nest on its sheets, write their drawings, and read these.

    Parts that are locked stay where they are. Raises CNCStepperError for a part or a value that is no good, and then
    changes nothing.
    """
    packages.require()
    from CNCStepper.workbench.document.nest_files import nest_now

    nest_now(nest, "search")


def add_arrangement(job: Any, programs: Iterable[Any], **values: Any) -> Any:
    """Return a new CNCStepper_Arrangement of jobs, programs and paths of G-code files, for the machine of a job."""
    obj = _add(job.Document, "App::FeaturePython", Arrangement, {"job": job, **values})
    found = [Path(each) if isinstance(each, str) else each for each in programs]
    set_sources(obj, found, [1] * len(found))
    return obj


def arrange_programs(arrangement: Any, placements: Iterable[tuple[int, float, float, float]] | None = None) -> None:
    """Place the programs of a CNCStepper_Arrangement, write the one checked program of them, and load it.

    placements: number of the program, x_mm, y_mm, rotation_deg of each copy; None: they are placed by a search. Raises
    CNCStepperError, and then changes nothing.
    """
    packages.require()
    from CNCStepper.workbench.document.arrange_files import arrange_now

    arrange_now(arrangement, placements)


def add_text(document: Any, text: str, **values: Any) -> Any:
    """Return a new CNCStepper_Text; `values` by the keys of a text in job files, and `along` with its line or arc."""
    return _add(document, "Part::FeaturePython", TextObject, {"text": text, **values})


def require_valid(job: Any) -> None:
    """Raise JobError when the job or an object it depends on has an error, or has changed since its recompute."""
    require_parts([*job.OutListRecursive, job])
    stale = [obj.Label for obj in [job, *job.OutListRecursive] if "Touched" in obj.State]
    if stale:
        raise JobError(
            "program-stale",
            Text("{stale} has changed since the program was made", stale=stale[0]),
            advice="recompute the document",
        )


def program_text(job: Any) -> str:
    """Return the program of a job or of an edited program.

    Raises JobError when there is none, or one that the drawing has left behind.
    """
    require_valid(job)
    text = program_file.load(job)
    if not text:
        why = getattr(job, "Message", "") or "it is empty"
        raise JobError(
            "program-missing",
            Text("{job} has no program: {why}", job=job.Label, why=why),
            advice="recompute the document",
        )
    return text


def save_program(job: Any, path: str | Path, overwrite: bool = False) -> list[Path]:
    """Write the job's program to a file, byte for byte, and return the file.

    A job that is split into a program a tool is written into several beside it: `part.nc` becomes `part-1-T1.nc`,
    `part-2-T3.nc`. The file that is named is replaced; others only with `overwrite`. Raises JobError as `program_text`
    does, or for a file, OutputError for another file that is there already.
    """
    text, path = program_text(job), Path(path)
    if job.ProgramParts == 1:
        return [_write(path, text)]
    names = [(name.removeprefix("program").removesuffix(".nc"), each) for name, each in job.Proxy.programs(job)]
    files = [(path.with_name(f"{path.stem}{name}{path.suffix}"), each) for name, each in names]
    there = [file for file, _ in files if os.path.lexists(file)]
    if there and not overwrite:
        what = "programs of these names are there already"
        named = ", ".join(file.name for file in there)
        raise OutputError("output-exists", what, value=named, advice="choose another name", place=Place(str(there[0])))
    return [_write(file, each) for file, each in files]


def _write(path: Path, text: str) -> Path:
    try:
        write_whole(path, text.encode("ascii"))
    except OSError as error:
        what = Text("the program cannot be written: {error}", error=error.strerror or error)
        advice = "choose a folder that exists and that you may write to"
        raise JobError("program-unwritable", what, advice=advice, place=Place(str(path))) from error
    return path


def job_model(job: Any) -> Model:
    """Return the job as the core's own checked model, for reports and checks; raises what the core raises."""
    packages.require()
    from CNCStepper.workbench.document.core_job import job_of

    return job_of(job)


def _add(document: Any, freecad_type: str, kind: type[Feature], values: dict[str, Any]) -> Any:
    obj = document.addObject(freecad_type, kind.Type)
    obj.Label = kind.Type.removeprefix("CNCStepper_")
    try:
        kind(obj)
        edit(obj, **values)
        obj.Proxy.check(obj)
    except CNCStepperError:
        document.removeObject(obj.Name)
        raise
    return obj
