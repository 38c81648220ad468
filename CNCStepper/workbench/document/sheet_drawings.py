# SPDX-License-Identifier: LGPL-2.1-or-later
"""A group of drawings, one for each sheet that the process has written; they are read one after the other.

SheetWork(obj, …).begin() ──► process ──► sheet-1.dxf, sheet-2.dxf ──► Reading of each ──► done
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from CNCStepper.errors import CNCStepperError, Place
from CNCStepper.workbench.document.drawing_files import Reading, read_now
from CNCStepper.workbench.document.drawing_work import DrawingWork
from CNCStepper.workbench.features.base import edit, proxy_type
from CNCStepper.workbench.features.drawings.drawing import Drawing, path_of


class SheetWork(DrawingWork):
    """A work that ends with the drawings of sheets; those that were read before a refusal stay."""

    def __init__(
        self,
        obj: Any,
        done: Callable[[], None],
        failed: Callable[[CNCStepperError], None],
        share: Callable[[float], None] = lambda share: None,
    ):
        super().__init__(obj, done, failed, share)
        self._to_read: list[Any] = []
        self._reading: Reading | None = None
        self._made_of = ""

    def end(self) -> None:
        """Make nothing any more."""
        if self._reading is not None:
            self._reading.end()
        super().end()

    def question(self) -> dict[str, Any]:
        """Return what the process is asked, and note of which sources and values it is."""
        asked = self.asked()
        self._made_of = self.obj.Proxy.key_of(self.obj)
        return asked

    def asked(self) -> dict[str, Any]:
        """Return what the process is asked; raises CNCStepperError for a source or a value that is no good."""
        raise NotImplementedError

    def take(self, answer: dict[str, Any]) -> None:
        """Keep what was made, and read the files of the sheets into the group."""
        self.obj.Proxy.keep(self.obj, answer, self._made_of)
        self._to_read = drawings_of(self.obj, [Path(path) for path in answer["sheets"]])
        self._read_next()

    def _read_next(self) -> None:
        if not self.goes_on:
            return
        if not self._to_read:
            self.obj.Proxy.execute(self.obj)
            self.finish()
            return
        self._reading = Reading(self._to_read.pop(0), self._read_next, self.refuse)
        try:
            self._reading.begin()
        except CNCStepperError as error:
            self.refuse(error)


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


def make_now(obj: Any, answer_now: Callable[[], dict[str, Any]]) -> dict[str, Any]:
    """Take what `answer_now` makes, read the drawings, and return it; raises CNCStepperError, and then changes nothing.

    For scripts: the window waits for a process instead (`SheetWork`).
    """
    try:
        answer = answer_now()
    except CNCStepperError as error:
        raise error.at(Place(obj.Label)) from error
    for drawing in drawings_of(obj, [Path(path) for path in answer["sheets"]]):
        read_now(drawing)
    obj.Proxy.keep(obj, answer, obj.Proxy.key_of(obj))
    return answer
