# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sheets of a stack: a process slices and nests beside the window, then each sheet's drawing is read.

Slicing(obj, …).begin() ──► process ──► sheet-1.dxf, sheet-2.dxf ──► Reading of each, one after the other ──► done
"""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

from CNCStepper.errors import CNCStepperError, Place
from CNCStepper.workbench.document.drawing_files import Reading
from CNCStepper.workbench.features.base import edit, proxy_type
from CNCStepper.workbench.features.drawings.drawing import Drawing, path_of
from CNCStepper.workbench.features.drawings.slices import asked_of, key_of, take_answer

TEMPORARY = "cncstepper-slices-"  # how folders begin that hold the solid for the process


class Slicing:
    """One slicing of a solid beside the window; the transaction is the caller's.

    done: called when the drawings of all sheets are read. failed: with the error; the drawings that were read until
    then stay. share: with what is done, 0 to 1.
    """

    def __init__(
        self,
        obj: Any,
        done: Callable[[], None],
        failed: Callable[[CNCStepperError], None],
        share: Callable[[float], None] = lambda share: None,
    ):
        self._obj, self._done, self._failed, self._share = obj, done, failed, share
        self._place = obj.Document.Name, obj.Name
        self._temporary = tempfile.TemporaryDirectory(prefix=TEMPORARY)
        self._made_of = ""
        self._to_read: list[Any] = []
        self._reading: Reading | None = None
        self._ended = False

    def begin(self) -> None:
        """Ask the process; raises JobError where there is no solid, no folder, or a bad value."""
        from CNCStepper.workbench.calculation.drawing_process import DrawingRequest, process

        question = {"slices": asked_of(self._obj, Path(self._temporary.name))}
        self._made_of = key_of(self._obj)
        process().ask(self, DrawingRequest(question, self._take, self._refuse, self._share))

    def end(self) -> None:
        """Make nothing any more."""
        from CNCStepper.workbench.calculation.drawing_process import process

        process().forget(self)
        if self._reading is not None:
            self._reading.end()
        self._close()

    @property
    def _is_there(self) -> bool:
        """Whether the object is still in its document."""
        import FreeCAD

        document, name = self._place
        return document in FreeCAD.listDocuments() and FreeCAD.getDocument(document).getObject(name) is not None

    def _take(self, answer: dict[str, Any]) -> None:
        if self._ended or not self._is_there:
            return
        self._to_read = drawings_of(self._obj, [Path(path) for path in answer["sheets"]])
        take_answer(self._obj, answer, self._made_of)
        self._read_next()

    def _read_next(self) -> None:
        if self._ended or not self._is_there:
            return
        if not self._to_read:
            self._close()
            self._obj.Proxy.execute(self._obj)
            self._done()
            return
        self._reading = Reading(self._to_read.pop(0), self._read_next, self._refuse)
        try:
            self._reading.begin()
        except CNCStepperError as error:
            self._refuse(error)

    def _refuse(self, error: CNCStepperError) -> None:
        if not self._ended and self._is_there:
            self._close()
            self._failed(error)

    def _close(self) -> None:
        self._ended = True
        self._temporary.cleanup()


def drawings_of(obj: Any, sheets: list[Path]) -> list[Any]:
    """Return a drawing for each sheet's file: those of before where they follow it, the others new.

    Drawings of sheets that are no longer made are deleted with their objects.
    """
    before = {path_of(each): each for each in obj.Group if proxy_type(each) == Drawing.Type}
    found = []
    for path in sheets:
        drawing = before.pop(path, None)
        if drawing is None:
            drawing = obj.Document.addObject("App::DocumentObjectGroupPython", Drawing.Type)
            Drawing(drawing)
            edit(drawing, file=str(path), split="chain")
            drawing.Label = f"{obj.Label} {path.stem}"
            obj.addObject(drawing)
        found.append(drawing)
    for gone in before.values():
        for each in gone.Group:
            obj.Document.removeObject(each.Name)
        obj.Document.removeObject(gone.Name)
    return found


def slice_now(obj: Any) -> None:
    """Slice and nest at once and read the drawings, for scripts; raises CNCStepperError, and then changes nothing."""
    from CNCStepper.job.slicing.make_slices import answer_of
    from CNCStepper.workbench.document.drawing_files import read_now

    try:
        with tempfile.TemporaryDirectory(prefix=TEMPORARY) as folder:
            answer = answer_of(asked_of(obj, Path(folder)))
    except CNCStepperError as error:
        raise error.at(Place(obj.Label)) from error
    for drawing in drawings_of(obj, [Path(path) for path in answer["sheets"]]):
        read_now(drawing)
    take_answer(obj, answer, key_of(obj))
    obj.Proxy.execute(obj)
