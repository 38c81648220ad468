# SPDX-License-Identifier: LGPL-2.1-or-later
"""Job files in and out: a job object as the text of a job file, and the objects of a job that a file holds.

job object ──► job_of ──► save_job_file          its curves are within the file
file ──► Job ──► opened: job, tools, operations, a Part object with the curves of each, where no other holds them
            └──► differences: what of the file the objects do not hold
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np

from CNCStepper.errors import CNCStepperError, JobError, Place, Text
from CNCStepper.machine.processes import PROCESSES
from CNCStepper.workbench import packages
from CNCStepper.workbench.document.turning.turning_files import export_turning_job, turning_objects_of
from CNCStepper.workbench.drawings.exact_curves import ROUNDING_MM
from CNCStepper.workbench.features.base import LATHE_JOB, edit, proxy_type
from CNCStepper.workbench.features.catalogue import operation_class
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.translation import tr

if TYPE_CHECKING:
    from CNCStepper.geometry.curve import Curve
    from CNCStepper.job.model import Job
    from CNCStepper.job.turning.turning_job import TurningJob

Made = TypeVar("Made")
JOB_KEYS = ("units", "work_offset", "process", "clearance_mm", "retract_mm", "coolant", "material", "consumable")
CURVES = ("outlines", "islands", "curves")  # of an operation, that its drawings give
MARKS, CIRCLES = "marks", "circles"
ObjectsWith = Callable[[Sequence[Any]], list[Any]]
OWN, NONE, COUNT, SPACING = "own", "none", "count", "spacing"


def export_job(obj: Any, path: str | Path) -> None:
    """Write a job object as a job file, TOML or JSON by its name, its curves within it; raises what the core raises."""
    packages.require()
    from CNCStepper.job.files.job_text import save_job_file
    from CNCStepper.workbench import api

    api.require_valid(obj)
    if proxy_type(obj) == LATHE_JOB:
        export_turning_job(obj, Path(path))
    else:
        save_job_file(exported(obj), Path(path))


def open_job(document: Any, path: str | Path) -> tuple[Any, list[str]]:
    """Return a new job object with what a job file holds, and what of it FreeCAD's objects do not hold.

    Raises JobError for a file that is no job.
    """
    packages.require()
    return exhausted(objects_of(document, read_job(Path(path)), Path(path)))


def read_job(path: Path) -> Job | TurningJob:
    """Return the job of a file, in whatever thread; raises JobError for a file that is no job."""
    from CNCStepper.job.model import Job
    from CNCStepper.job.turning.turning_job import load_turning_job
    from CNCStepper.machine.files.toml_reader import read_toml
    from CNCStepper.machine.processes import is_turning

    if path.suffix.casefold() == ".toml" and is_turning(read_toml(path)):
        return load_turning_job(path)[0]
    return Job.load(path)


def objects_of(document: Any, job: Job | TurningJob, path: Path) -> Generator[None, None, tuple[Any, list[str]]]:
    """Return the new job object of a file's job, and what of it FreeCAD's objects do not hold.

    Yields after each object, so that a window can see to its events. Raises JobError for what FreeCAD has none of.
    """
    from CNCStepper.job.model import Job

    if not isinstance(job, Job):
        return (yield from turning_objects_of(document, job, path))
    obj = begun(document, job, path.stem)
    yield
    yield from filled(obj, job)
    return obj, [*job.notes, *differences(obj, job)]


def exhausted(making: Generator[None, None, Made]) -> Made:
    """Return what a generator returns, without a pause."""
    while True:
        try:
            next(making)
        except StopIteration as end:
            return end.value


def exported(obj: Any) -> Job:
    """Return a job object as the model that its file holds; a machine's file is named by its whole path."""
    from CNCStepper.workbench.document.core_job import job_of

    return with_whole_path(obj, job_of(obj))


def with_whole_path(obj: Any, job: Job) -> Job:
    """Return the model of a job object with its machine's file by its whole path."""
    from CNCStepper.machine.profile import profile_names

    named = job.machine in profile_names() or Path(job.machine).is_absolute() or not obj.Document.FileName
    machine = job.machine if named else str(Path(obj.Document.FileName).parent / job.machine)
    return job.model_copy(update={"machine": machine})


def begun(document: Any, job: Job, label: str) -> Any:
    """Return a new job object with the values of a job, without its tools and operations; raises as `objects_of`."""
    from CNCStepper.workbench import api

    obj = api.new_job(document, **job_values(job, label))
    obj.Label = label
    return obj


def replaced(obj: Any, job: Job) -> None:
    """Give a job object the values of a job, without the tools and operations that it had; raises JobError."""
    edit(obj, **job_values(job, obj.Label))
    gone = [*obj.Operations, *obj.Tools]
    obj.Operations, obj.Tools, obj.Clamps = [], [], []
    for each in gone:
        obj.Document.removeObject(each.Name)


def job_values(job: Job, label: str) -> dict[str, Any]:
    """Return the values of a job object by their keys; raises JobError for a stock that FreeCAD has none of."""
    if job.stock.heights_mm is not None:
        what, advice = "FreeCAD has no stock of a height field", "run this job with cncstepper run"
        raise JobError("job-stock", what, advice=advice, place=Place(label))
    keys = {key: getattr(job, key) for key in JOB_KEYS}
    stock = {"stock_size_mm": job.stock.size_mm, "stock_form": job.stock.form, "stock_origin": job.stock.origin}
    return {"machine": job.machine, "chart": job.chart, **keys, **stock, "edge_mm": job.stock.edge_mm or 0.0}


def filled(obj: Any, job: Job, objects_with: ObjectsWith = lambda curves: []) -> Iterator[None]:
    """Give a job object the tools, operations and clamps of a job, whose curves lie where the document has them.

    objects_with: returns the objects of the document that hold just some curves, none where there are no such ones.
    Yields after each object, so that a window can see to its events.
    """
    tools = {}
    for tool in job.tool:
        tools[tool.number] = add_tool_of_file(obj, tool)
        yield
    for cycle in job.operation:
        _operation(obj, cycle, tools[cycle.tool], objects_with)
        yield
    obj.Clamps = [_clamp(obj.Document, clamp) for clamp in job.clamp]


def add_tool_of_file(obj: Any, tool: Any) -> Any:
    """Return a new tool of a job: the one that the cut chart describes, where it is that, else by its own values."""
    from CNCStepper.machine.tools.stored_tool import given_keys
    from CNCStepper.workbench import api

    made = api.add_tool(obj, **{**api.UNKNOWN, **given_keys(tool)})
    if PROCESSES[obj.Process].uses_chart and obj.Material:
        edit(made, from_chart=True)
    return made


def _operation(obj: Any, cycle: Any, tool: Any, objects_with: ObjectsWith) -> None:
    """Add an operation with the keys and the curves of a cycle."""
    from CNCStepper.workbench import api

    kind = operation_class(cycle.cycle)
    values = dict(_flat(cycle, kind))
    if _has_places(cycle):
        values |= _pattern_values(cycle.pattern)
    drawn, marks = _drawn(cycle), [mark.moved(*cycle.offset_mm) for mark in getattr(cycle, MARKS, ())]
    found, marked = objects_with(drawn), objects_with(marks)
    if found or marked:
        linked = {"drawings": found} | ({"mark_drawings": marked} if marked else {})
        operation = api.add_operation(obj, cycle.cycle, tool=tool, **values, **linked)
        if _cuts_where(operation, cycle, tuple(obj.WorkOrigin)):
            return
        obj.Operations = [each for each in obj.Operations if each != operation]
        obj.Document.removeObject(operation.Name)
    if drawn:
        values["drawings"] = [_curves_object(obj.Document, kind.CYCLE, drawn)]
    if marks:
        values["mark_drawings"] = [_curves_object(obj.Document, MARKS, marks)]
    api.add_operation(obj, cycle.cycle, tool=tool, **values)


def _cuts_where(operation: Any, cycle: Any, origin_mm: tuple[float, ...]) -> bool:
    """Return whether an operation cuts just the curves of a cycle, which lie where the document has them."""
    try:
        made = operation.Proxy.cycle(operation, origin_mm)
    except CNCStepperError:
        return False
    x_mm, y_mm = origin_mm[:2]
    if _has_places(cycle):
        wanted = np.array([each[:2] for each in cycle.pattern.holes()]) + cycle.offset_mm - (x_mm, y_mm)
        found = np.array([each[:2] for each in made.pattern.holes()])
        return wanted.shape == found.shape and bool(np.allclose(found, wanted, rtol=0.0, atol=ROUNDING_MM))
    (dx_mm, dy_mm), keys = getattr(cycle, "offset_mm", (0.0, 0.0)), (*CURVES, MARKS)
    wanted = {key: [each.moved(dx_mm, dy_mm).moved(-x_mm, -y_mm) for each in getattr(cycle, key, ())] for key in keys}
    return all(list(getattr(made, key, ())) == wanted[key] for key in keys)


def _has_places(cycle: Any) -> bool:
    """Return whether a cycle has a pattern of places; the pattern of an area is a word."""
    return not isinstance(getattr(cycle, "pattern", ""), str)


def _drawn(cycle: Any) -> list[Curve]:
    """Return the curves of a cycle where it cuts them: `offset_mm` is in them."""
    curves = [curve for key in CURVES for curve in getattr(cycle, key, ())]
    circles = getattr(cycle.pattern, CIRCLES, ()) if _has_places(cycle) else ()
    return [curve.moved(*getattr(cycle, "offset_mm", (0.0, 0.0))) for curve in (*curves, *circles)]


def _flat(cycle: Any, kind: Any) -> Iterator[tuple[str, Any]]:
    """Yield the values of a cycle by the keys of its object, tables with the names of their choosers."""
    keys = {entry.key for entry in kind.PROPERTIES if not entry.output}
    content = cycle.model_dump()
    for key, value in content.items():
        if key in ("cycle", "tool", MARKS, *CURVES) or (key == "pattern" and isinstance(value, dict)):
            continue
        if key in kind.TABLES:
            yield from _table(key, value, keys)
        elif key in keys and value is not None:
            yield key, value


def _table(name: str, value: Mapping[str, Any] | None, keys: set[str]) -> Iterator[tuple[str, Any]]:
    if name == "tabs":
        given = value or {}
        yield "tabs_by", COUNT if given.get("count") else SPACING if given.get("spacing_mm") else NONE
    elif value is not None and f"{name}_by" in keys:
        yield f"{name}_by", OWN
    for key, one in (value or {}).items():
        if f"{name}_{key}" in keys and one is not None:
            yield f"{name}_{key}", one


def _pattern_values(pattern: Any) -> dict[str, Any]:
    """Return the values of a pattern of holes; circles are a drawing's."""
    content = pattern.model_dump()
    kind = content.pop("kind")
    if kind == CIRCLES:
        return {"pattern_kind": "drawing"}
    if kind == "grid":
        content["columns"], content["rows"] = content.pop("count")
    return {"pattern_kind": kind, **{f"pattern_{key}": value for key, value in content.items() if value is not None}}


def _curves_object(document: Any, label: str, curves: Sequence[Curve]) -> Any:
    """Return a Part object with the wires of curves, lines and arcs exact."""
    import Part

    from CNCStepper.workbench.drawings.exact_curves import keep_curves
    from CNCStepper.workbench.drawings.wires import wire_of

    obj = document.addObject("Part::Feature", "Contour")
    obj.Label = label
    obj.Shape = Part.makeCompound([wire_of(curve, 0.0) for curve in curves])
    keep_curves(obj, curves)
    return obj


def _clamp(document: Any, clamp: Any) -> Any:
    """Return a solid in place of a clamp: its outline, from far below to its top."""
    import FreeCAD
    import Part

    corners = list(clamp.corners_mm)
    if len(corners) == 2:
        (left, front), (right, back) = corners
        corners = [(left, front), (right, front), (right, back), (left, back)]
    height_mm = max(clamp.top_mm, 1.0)
    ring = [FreeCAD.Vector(x, y, clamp.top_mm - height_mm) for x, y in (*corners, corners[0])]
    obj = document.addObject("Part::Feature", "Clamp")
    obj.Shape = Part.Face(Part.makePolygon(ring)).extrude(FreeCAD.Vector(0, 0, height_mm))
    return obj


def differences(obj: Any, job: Job) -> list[str]:
    """Return what of a file's job its objects do not hold, as sentences."""
    from CNCStepper.workbench.document.core_job import job_of

    try:
        made = job_of(obj)
    except CNCStepperError as error:  # the operation that cannot be made says it too
        return [error.sentence]
    found: list[str] = []
    for number, (ours, theirs) in enumerate(zip(made.operation, job.operation, strict=True), start=1):
        by_curves = {*CURVES, MARKS, "closed", *(("offset_mm",) if _drawn(theirs) else ())}
        by_curves |= {"pattern"} if _has_places(theirs) else set()
        for key in type(theirs).model_fields:
            if key not in by_curves and getattr(ours, key) != getattr(theirs, key):
                found.append(Text("operation {number} has another {key} than its file", number=number, key=key))
    return found


def ask_to_open(take: Callable[[str], None]) -> None:
    """Ask for a job file and return at once; `take` is called with its path."""
    dialog = _dialog(tr("Open job"))
    dialog.setFileMode(dialog.FileMode.ExistingFile)
    dialog.fileSelected.connect(guarded(take))
    dialog.open()


def ask_to_export(obj: Any, take: Callable[[str], None]) -> None:
    """Ask for the file of a job object and return at once; `take` is called with its path."""
    dialog = _dialog(tr("Export job"))
    dialog.setFileMode(dialog.FileMode.AnyFile)
    dialog.setAcceptMode(dialog.AcceptMode.AcceptSave)
    dialog.setDefaultSuffix("toml")
    dialog.selectFile(f"{obj.Label}.toml")
    dialog.fileSelected.connect(guarded(take))
    dialog.open()


def _dialog(title: str) -> Any:
    import FreeCAD
    import FreeCADGui
    from PySide import QtCore, QtGui

    document = FreeCAD.ActiveDocument
    folder = Path(document.FileName).parent if document is not None and document.FileName else Path.home()
    dialog = QtGui.QFileDialog(FreeCADGui.getMainWindow(), title, str(folder))
    dialog.setObjectName("CNCStepper_Job_file")
    dialog.setNameFilters([tr("Jobs ({0})").format("*.toml *.json"), tr("All files ({0})").format("*")])
    dialog.setAttribute(QtCore.Qt.WidgetAttribute.WA_DeleteOnClose)
    return dialog
