# SPDX-License-Identifier: LGPL-2.1-or-later
"""The targets of a command: the open document, the active job, the selected drawing or solid.

All of it is asked several times a second, so nothing here computes or loads.
"""

from __future__ import annotations

from collections.abc import Container, Iterator
from itertools import islice
from typing import Any

from CNCStepper.workbench.document.selection import members
from CNCStepper.workbench.features.base import is_job, is_tool, named, problem_of, proxy_type
from CNCStepper.workbench.services.choice_labels import words_of
from CNCStepper.workbench.services.message_translation import translated
from CNCStepper.workbench.services.translation import tr

PREVIEW = "CNCStepper_Preview"
DRAWING = "CNCStepper_Drawing"
PROGRAM = "CNCStepper_Program"


def document() -> Any:
    """Return the active document, or None."""
    import FreeCAD

    return FreeCAD.ActiveDocument


def selected() -> list[Any]:
    """Return the objects that are selected in the active document, each once, in the order of selection."""
    import FreeCADGui

    return FreeCADGui.Selection.getSelection() if document() is not None else []


def jobs() -> list[Any]:
    """Return all jobs of the active document."""
    return list(_each_job())


def _each_job() -> Iterator[Any]:
    if document() is not None:
        yield from filter(is_job, document().findObjects("App::FeaturePython"))


def job() -> Any:
    """Return the job that is meant, or None: the selected one, the one of a selected object, or the only one."""
    found = _meant_jobs()
    return found[0] if len(found) == 1 else None


def _meant_jobs() -> list[Any]:
    """Return the jobs of what is selected, or two of the document: a second one leaves open which is meant."""
    meant = {owner.Name: owner for obj in selected() for owner in _owners(obj)}
    return list(meant.values()) or list(islice(_each_job(), 2))


def imported_drawing() -> Any:
    """Return the imported drawing that is meant: the selected one, that of a selected contour, or the last."""
    if document() is None:
        return None
    groups = document().findObjects("App::DocumentObjectGroupPython")
    drawings = [obj for obj in groups if proxy_type(obj) == DRAWING and obj.ReadWith]
    chosen = {owner.Name for obj in selected() for owner in (obj, *obj.InList)}
    meant = [drawing for drawing in drawings if drawing.Name in chosen]
    return next(iter(meant or reversed(drawings)), None)


def program() -> Any:
    """Return the edited program that is selected, None where it is not exactly one."""
    found = [obj for obj in selected() if proxy_type(obj) == PROGRAM]
    return found[0] if len(found) == 1 else None


def why_no_job() -> str:
    """Return why it is not known which job is meant, "" when it is."""
    found = _meant_jobs()
    if found:
        return tr("Select the job in the tree: this document has several") if len(found) > 1 else ""
    return tr("Make a job first, with New job")


def why_not_by_process(by: tuple[str, ...]) -> str:
    """Return why the meant job has none of some operations: those processes cut them, "" where its own does."""
    present = job()
    if present is None or present.Process in by:
        return ""
    return tr("This is cut by: {0}. The job's process is: {1}").format(
        ", ".join(words_of(each, "process") for each in by), words_of(present.Process, "process")
    )


def why_no_program(job: Any) -> str:
    """Return why a job cannot have a program, "" when it has one or gets one by a recompute."""
    operations = [operation for operation in job.Operations if operation.Active]
    if not operations:
        return tr("{0} has nothing to cut: add an operation").format(job.Label)
    parts = [*(operation.Tool for operation in operations if operation.Tool is not None), *operations, job]
    if any("Touched" in part.State for part in parts):
        return ""
    return next((named(part, translated(problem_of(part))) for part in parts if problem_of(part)), "")


def why_no_view() -> str:
    """Return why nothing can be drawn with the mouse now, "" when the active view shows a document in 3D."""
    import FreeCADGui

    shown = FreeCADGui.activeDocument()
    if shown is None:
        return tr("Open or make a document first")
    return "" if hasattr(shown.activeView(), "getSceneGraph") else tr("Open the 3D view of the document first")


def why_no_panel() -> str:
    """Return why no task panel can be opened now, "" when one can."""
    import FreeCADGui

    return tr("Close the open task panel first") if FreeCADGui.Control.activeDialog() else ""


def tool(of_job: Any, shapes: Container[str]) -> Any:
    """Return the job's tool of one of some shapes that is selected, else its last such one, None when it has none."""
    suited = [each for each in of_job.Tools if each.ToolShape in shapes]
    return next((obj for obj in selected() if obj in suited), suited[-1] if suited else None)


def drawing() -> Any:
    """Return the first selected sketch, wire, ellipse, face or freehand line, or the solid whose faces or edges are."""
    held = (member for obj in selected() for member in members(obj))
    return next((obj for obj in held if _is_drawing(obj) or picked(obj)), None)


def drawings(of_drawings: bool = False) -> list[tuple[Any, tuple[str, ...]]]:
    """Return all that is selected and none of ours, what groups hold, each with its picked faces and edges.

    of_drawings: whether a click on a line of a drawing means that line alone.
    """
    found = dict.fromkeys(member for obj in selected() for member in members(obj))
    return [(obj, picked(obj, of_drawings)) for obj in found]


def picked(obj: Any, of_drawings: bool = False) -> tuple[str, ...]:
    """Return the names of the faces and edges of a solid that are selected.

    of_drawings: also those of other objects, a click on which else means all of them.
    """
    import FreeCADGui

    if obj is None or not (of_drawings or _holds(obj, "Solid")):
        return ()
    parts = [part for part in FreeCADGui.Selection.getSelectionEx() if part.Object == obj]
    return tuple(name for part in parts for name in part.SubElementNames if name.startswith(("Face", "Edge")))


def solid() -> Any:
    """Return the selected solid, or None."""
    return next((obj for obj in selected() if _holds(obj, "Solid")), None)


def _owners(obj: Any) -> list[Any]:
    """Return the jobs to which an object of ours belongs; a drawing belongs to none."""
    if is_job(obj):
        return [obj]
    if proxy_type(obj) == PREVIEW:
        return [obj.Job] if obj.Job is not None else []
    belongs = is_tool(obj) or bool(getattr(getattr(obj, "Proxy", None), "CYCLE", ""))
    return [other for other in obj.InList if is_job(other)] if belongs else []


def _is_drawing(obj: Any) -> bool:
    return obj.isDerivedFrom("Sketcher::SketchObject") or (_holds(obj, "Vertex") and not _holds(obj, "Solid"))


def _holds(obj: Any, element: str) -> bool:
    return obj.isDerivedFrom("Part::Feature") and not obj.Shape.isNull() and obj.Shape.countElement(element) > 0
