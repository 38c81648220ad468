# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sheets of a stack: a process slices and nests beside the window, then each sheet's drawing is read."""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

from CNCStepper.errors import CNCStepperError, Place
from CNCStepper.workbench.document.sheet_drawings import SheetWork, drawings_of
from CNCStepper.workbench.features.drawings.slices import asked_of, key_of, take_answer

TEMPORARY = "cncstepper-slices-"  # how folders begin that hold the solid for the process


class Slicing(SheetWork):
    """One slicing of a solid beside the window."""

    def __init__(
        self,
        obj: Any,
        done: Callable[[], None],
        failed: Callable[[CNCStepperError], None],
        share: Callable[[float], None] = lambda share: None,
    ):
        super().__init__(obj, done, failed, share)
        self._temporary = tempfile.TemporaryDirectory(prefix=TEMPORARY)
        self._made_of = ""

    def question(self) -> dict[str, Any]:
        """Return what the process is asked; raises JobError where there is no solid, no folder, or a bad value."""
        question = {"slices": asked_of(self.obj, Path(self._temporary.name))}
        self._made_of = key_of(self.obj)
        return question

    def take(self, answer: dict[str, Any]) -> None:
        """Keep what was made, and read the sheets."""
        take_answer(self.obj, answer, self._made_of)
        self.read(answer["sheets"])

    def close(self) -> None:
        """Take no answer any more, and take the solid away."""
        super().close()
        self._temporary.cleanup()


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
