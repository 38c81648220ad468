# SPDX-License-Identifier: LGPL-2.1-or-later
"""Opens a job file in the window, which sees to its events meanwhile: one undo step.

file ──► thread: the core's job ──► objects, one in each event ──► their cuts beside the window ──► into view, notes
"""

from __future__ import annotations

from collections.abc import Generator
from concurrent.futures import Future
from functools import partial
from pathlib import Path
from typing import Any

from PySide import QtCore

from CNCStepper.control.processes.background_thread import in_background
from CNCStepper.workbench import packages
from CNCStepper.workbench.calculation.preloading import LOOK_EVERY_MS
from CNCStepper.workbench.calculation.remake_beside import RemakeBeside
from CNCStepper.workbench.document import undo_steps
from CNCStepper.workbench.document.job_files import objects_of, read_job
from CNCStepper.workbench.services.message_translation import translated
from CNCStepper.workbench.services.messages import guarded, note, notice
from CNCStepper.workbench.services.translation import tr
from CNCStepper.workbench.services.view_fit import show_all


class JobOpening:
    """One file that becomes the objects of a document, as an undo step with that text; `begin` returns at once."""

    def __init__(self, document: Any, path: Path, text: str):
        self._name, self._path, self._text = document.Name, path, text
        self._making: Generator[None, None, tuple[Any, list[str]]] | None = None
        self._remaking: RemakeBeside | None = None
        self._notes: list[str] = []

    def begin(self) -> None:
        """Read the file; raises MissingPackage."""
        packages.require()
        note(tr("Making the job…"))
        self._soon(partial(self._look, in_background(partial(read_job, self._path))), LOOK_EVERY_MS)

    def _soon(self, act: Any, after_ms: int = 0) -> None:
        """Do something in an event of its own; a document that was closed meanwhile ends all."""
        QtCore.QTimer.singleShot(after_ms, guarded(lambda: act() if self._document() is not None else None))

    def _document(self) -> Any:
        import FreeCAD

        return FreeCAD.listDocuments().get(self._name)

    def _look(self, reading: Future[Any]) -> None:
        """Begin the objects when the file is read; raises what reading has raised."""
        if not reading.done():
            self._soon(partial(self._look, reading), LOOK_EVERY_MS)
            return
        self._making = objects_of(self._document(), reading.result(), self._path)
        undo_steps.begin(self._document(), self._text)
        self._step()

    def _step(self) -> None:
        """Make an object, and the next in another event; then what they cut."""
        assert self._making is not None
        try:
            next(self._making)
        except StopIteration as end:
            self._notes = end.value[1]
            self._remaking = RemakeBeside(
                self._document(), lambda words: note(tr(words)), lambda: self._soon(self._made)
            )
            self._remaking.begin()
        except Exception:
            self._document().abortTransaction()
            raise
        else:
            self._soon(self._step)

    def _made(self) -> None:
        """End the undo step, bring all into view, and say what the objects do not hold."""
        self._document().commitTransaction()
        self._soon(show_all)
        if self._notes:
            self._soon(self._tell)

    def _tell(self) -> None:
        notice(tr("{0} was opened").format(self._path.name), "\n".join(map(translated, self._notes)))
