# SPDX-License-Identifier: LGPL-2.1-or-later
"""An arrangement's program: a process places and writes beside the window, then the program is loaded."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

from CNCStepper.errors import CNCStepperError, Place
from CNCStepper.workbench.document.drawing_work import DrawingWork
from CNCStepper.workbench.features.programs.arrangement import asked_of, take_answer


class Arranging(DrawingWork):
    """One question about an arrangement; answer: of the process."""

    def __init__(
        self,
        obj: Any,
        verb: str,
        done: Callable[[], None],
        failed: Callable[[CNCStepperError], None],
        share: Callable[[float], None] = lambda share: None,
        **more: Any,
    ):
        """more: what else is asked, as the copies that are placed (`job/editing/arrange_question.py`)."""
        super().__init__(obj, done, failed, share)
        self.answer: dict[str, Any] = {}
        self._verb, self._more = verb, more

    def question(self) -> dict[str, Any]:
        """Return what the process is asked; raises CNCStepperError for a program or a value that is no good."""
        return {"arrange": asked_of(self.obj, self._verb, **self._more)}

    def take(self, answer: dict[str, Any]) -> None:
        """Load the program where one was written; all else is only told."""
        self.answer = answer
        if answer["written"]:
            try:
                take_answer(self.obj, answer)
                self.obj.Proxy.execute(self.obj)
            except CNCStepperError as error:
                self.refuse(error)
                return
        self.finish()


def arrange_now(obj: Any, placements: Iterable[tuple[int, float, float, float]] | None) -> None:
    """Place and write at once, for scripts; raises CNCStepperError, and then changes nothing."""
    from CNCStepper.job.editing.arrange_question import answer_of

    try:
        if placements is None:
            parts = answer_of(asked_of(obj, "search"))["parts"]
        else:
            parts = [[0, *place, False] for place in placements]
        answer = answer_of(asked_of(obj, "write", parts=parts))
    except CNCStepperError as error:
        raise error.at(Place(obj.Label)) from error
    take_answer(obj, answer)
    obj.Proxy.execute(obj)
