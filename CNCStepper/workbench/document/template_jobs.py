# SPDX-License-Identifier: LGPL-2.1-or-later
"""A template and an imported drawing: asked for beside the window, and made into a job of the document.

content of a template ──► the process: chains of each rule, or the job (`job/templates/template_answer.py`)
                                            └──► made: tools and operations, which follow the drawing's objects
                                                 where these give the same curves, else curves of their own
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from CNCStepper.errors import CNCStepperError
from CNCStepper.workbench.document.job_files import begun, exhausted, filled, replaced, with_whole_path
from CNCStepper.workbench.drawings.exact_curves import all_kept
from CNCStepper.workbench.features.base import edit
from CNCStepper.workbench.features.drawings.drawing import form_of, path_of
from CNCStepper.workbench.services.translation import tr

if TYPE_CHECKING:
    from CNCStepper.geometry.curve import Curve

Content = dict[str, Any]
APART = ("shape", "operation", "clamp", "cut_data", "notes")  # of a job's content, that no template has


class TemplateQuestion:
    """One question about a template and a drawing beside the window; a newer one of the same takes its place.

    done: called with the answer. failed: with the error. share: with what is done, 0 to 1.
    """

    def __init__(
        self,
        asked: Content,
        done: Callable[[Content], None],
        failed: Callable[[CNCStepperError], None],
        share: Callable[[float], None] = lambda share: None,
    ):
        self._asked, self._done, self._failed, self._share = asked, done, failed, share

    def begin(self) -> None:
        """Ask the process."""
        from CNCStepper.workbench.calculation.drawing_process import DrawingRequest, process

        process().ask(self, DrawingRequest({"template": self._asked}, self._done, self._failed, self._share))

    def end(self) -> None:
        """Wait for the answer no more."""
        from CNCStepper.workbench.calculation.drawing_process import process

        process().forget(self)


def asked_of(drawing: Any, content: Content, path: Path, make: bool) -> Content:
    """Return what the process is asked of a drawing object and a template's content."""
    return {"file": str(path_of(drawing)), "path": str(path), "content": content, "make": make}


def apply_template(drawing: Any, template: Path, job: Any = None) -> Any:
    """Return the job that a template makes of an imported drawing: a new one, or `job` with other operations and tools.

    Its program is that of `cncstepper job DRAWING --template TEMPLATE`, byte for byte, where both have one title.
    Raises JobError for a template that is none, and for a drawing that it makes no job of.
    """
    from CNCStepper.job.templates.template_answer import template_answer
    from CNCStepper.machine.files.toml_reader import read_toml

    path = template.absolute()
    answer = template_answer(asked_of(drawing, read_toml(path), path, True))
    return exhausted(made(drawing, answer, job))


def new_template(drawing: Any, job: Any) -> Content:
    """Return the content of a template for a drawing: machine, tools and stock of a job, and how the drawing is read.

    Each layer and colour of the drawing has a rule that leaves it out. Raises CNCStepperError for a job that is wrong.
    """
    from CNCStepper.workbench.templates.draft import first_rules

    rules = first_rules((each.Layer, each.Colour) for each in drawing.Group if hasattr(each, "Layer"))
    return {**job_keys(job), "drawing": _reading(drawing), "rule": rules}


def job_keys(job: Any) -> Content:
    """Return the keys of a template that a job gives: machine, tools, stock and all else but shapes and operations.

    Raises CNCStepperError for a job that is wrong.
    """
    from CNCStepper.job.files.job_text import job_content
    from CNCStepper.workbench.document.core_job import without_operations

    keys = job_content(with_whole_path(job, without_operations(job)))
    size_mm, stock = keys["stock"]["size_mm"], keys["stock"]
    kept = {key: stock[key] for key in ("form", "origin", "edge_mm") if key in stock}
    own = {key: value for key, value in keys.items() if key not in APART and value is not None}
    return own | {"stock": {"thickness_mm": size_mm[2], "margin_mm": 5.0, **kept}}


def _reading(drawing: Any) -> Content:
    """Return the `[drawing]` table of how a drawing object is read."""
    form, _ = form_of(drawing)
    told = form.model_dump(mode="json", exclude_defaults=True)
    return {key: told[key] for key in ("tolerance_mm", "unit_mm", "by_colour", "mend", "trace") if key in told}


def made(drawing: Any, answer: Content, job: Any) -> Generator[None, None, Any]:
    """Return the job object of an answer: a job that is there, with other tools and operations, or a new one for None.

    Its work zero lies where the template's job file has it. Yields after each object, so that a window can see to its
    events. Raises JobError for what FreeCAD has no objects for.
    """
    from CNCStepper.job.cut_transfer import job_from_content

    model = job_from_content(answer["job"])
    if job is None:
        job = begun(drawing.Document, model, tr("{0} job").format(path_of(drawing).stem))
    else:
        replaced(job, model)
    x_mm, y_mm = answer["offset_mm"]
    edit(job, work_origin_mm=(-x_mm, -y_mm, 0.0))
    yield
    yield from filled(job, model, Source(drawing).objects_with)
    for operation, title in zip(job.Operations, answer["titles"], strict=True):
        operation.Label = title
    return job


class Source:
    """The objects of an imported drawing by their curves."""

    def __init__(self, drawing: Any):
        self._found: dict[bytes, tuple[Any, int]] = {}
        self._sizes: dict[str, int] = {}
        for obj in drawing.Group:
            curves = all_kept(obj)
            self._sizes[obj.Name] = len(curves)
            self._found |= {_key(curve): (obj, number) for number, curve in enumerate(curves)}

    def objects_with(self, curves: Sequence[Curve]) -> list[Any]:
        """Return the objects that hold just these curves, in their order; none where there are no such objects."""
        found = [self._found.get(_key(curve)) for curve in curves]
        objects = list(dict.fromkeys(each[0] for each in found if each is not None))
        whole = [(obj, number) for obj in objects for number in range(self._sizes[obj.Name])]
        return objects if found == whole else []


def _key(curve: Curve) -> bytes:
    return bytes(curve.xy.tobytes() + curve.bulge.tobytes())
