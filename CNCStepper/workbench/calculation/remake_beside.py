# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes the changed objects of a document beside the window: many at once, as a template adds them.

begin ──► look_at: what is not known ──► the cut process ──► look_at … ──► all known ──► objects made a little at a time
                                                                                           └──► pictures later, done
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from typing import Any

from PySide import QtCore

from CNCStepper.workbench.calculation import deferred_drawing
from CNCStepper.workbench.calculation.cut_process import CutRequest, process
from CNCStepper.workbench.calculation.precalculation import look_at
from CNCStepper.workbench.calculation.recompute import steps
from CNCStepper.workbench.features.base import proxy_type
from CNCStepper.workbench.services.messages import guarded

STEP_S = 0.005  # so long are objects made before the window sees to its events
DONE = object()


class RemakeBeside:
    """One remake of a document. stage: called with the process's English words. done: called when all are made."""

    def __init__(self, document: Any, stage: Callable[[str], None], done: Callable[[], None]):
        self._name, self._stage, self._done = document.Name, stage, done
        self._asked: frozenset[str] = frozenset()
        self._steps: Iterator[None] | None = None
        self._goes_on = True

    def begin(self) -> None:
        """Start, and return at once."""
        self._soon(self._look)

    def end(self) -> None:
        """Make no more; what is made stays."""
        self._goes_on = False
        process().forget(self)

    def _soon(self, act: Callable[[], None]) -> None:
        QtCore.QTimer.singleShot(0, guarded(lambda: act() if self._goes_on else None))

    def _document(self) -> Any:
        import FreeCAD

        return FreeCAD.listDocuments().get(self._name)

    def _look(self) -> None:
        """Ask for what is not known yet; a question that was not answered is not asked again."""
        document = self._document()
        if document is None:
            return
        unknown = look_at(document).unknown
        if unknown.keys() - self._asked:
            self._asked |= unknown.keys()
            process().ask(self, CutRequest(unknown, self._stage, lambda: self._soon(self._look)))
            return
        self._steps = steps(document, deferred_drawing.leave)
        self._step()

    def _step(self) -> None:
        """Make some objects, and more when the window has seen to its events."""
        document, until_s = self._document(), time.perf_counter() + STEP_S
        if document is None or self._steps is None:
            return
        while time.perf_counter() < until_s:
            if next(self._steps, DONE) is DONE:
                _settle(document)
                deferred_drawing.draw_soon(document)
                self._done()
                return
        self._soon(self._step)


def _settle(document: Any) -> None:
    """Make the new objects that are FreeCAD's own; pictures stay as they are until they are drawn."""
    for obj in document.Objects:
        if "Touched" in obj.State and not proxy_type(obj):
            obj.recompute()
            obj.purgeTouched()
