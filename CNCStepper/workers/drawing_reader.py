# SPDX-License-Identifier: LGPL-2.1-or-later
"""The process that reads drawings for the window: `python -m CNCStepper.workers.drawing_reader`.

It knows nothing of FreeCAD. Each line on standard input is a question in JSON; a newer one ends the work on the one
before. Each line on standard output is about the newest:

    {"mark": 3, "drawing": {"file": PATH, "form": {...}, "limits": {...}}}

    {"mark": 3, "share": 0.4}                     what share is done
    {"mark": 3, "answer": {...}}                  the end of it
    {"mark": 3, "refused": {...}}                 or the error, as `error_to_json` gives it

When standard input is closed the process ends.
"""

from __future__ import annotations

import sys
import time
import traceback
from collections.abc import Callable
from pathlib import Path
from typing import Any

from CNCStepper.cancellation import interruptible
from CNCStepper.errors import CNCStepperError, Text
from CNCStepper.workers.json_lines import Questions, serve, tell

SHARE_EVERY_S = 0.2


class Outdated(Exception):
    """Raised where a newer question has come."""


def main() -> int:
    """Answer what standard input asks; return the exit status."""
    return serve(lambda questions: Answers(questions).run(), "drawing-fault", "the reading of the drawing")


class Answers:
    """The newest question."""

    def __init__(self, questions: Questions):
        self._questions = questions
        self._told_s = 0.0
        self._mark = 0

    def run(self) -> None:
        """Answer for ever."""
        while True:
            question = self._questions.get()
            if not self._questions.empty():
                continue
            self._mark = question["mark"]
            try:
                with interruptible(self._look):
                    told = self._answer(question)
            except Outdated:
                continue
            tell({"mark": self._mark, **told})

    def _look(self) -> None:
        """Raise Outdated where a newer question has come."""
        if not self._questions.empty():
            raise Outdated

    def _share(self, share: float) -> None:
        self._look()
        now_s = time.monotonic()
        if now_s >= self._told_s + SHARE_EVERY_S:
            self._told_s = now_s
            tell({"mark": self._mark, "share": share})

    def _answer(self, question: dict[str, Any]) -> dict[str, Any]:
        from CNCStepper.control.session.status import error_to_json

        key = next(key for key in WORK if key in question)
        try:
            return {"answer": WORK[key](question, self._share)}
        except CNCStepperError as refusal:
            error = refusal
        except MemoryError:
            what = "the drawing takes more memory than there is"
            error = CNCStepperError("drawing-memory", what, advice="simplify it, or divide it")
        except Outdated:
            raise
        except Exception as fault:  # a fault of ours still has to reach the person who waits
            traceback.print_exc()
            what = Text(
                "the drawing failed by a fault of ours: {kind}: {fault}", kind=type(fault).__name__, fault=fault
            )
            error = CNCStepperError("drawing-fault", what, advice="please report it, with the drawing")
        return {"refused": error_to_json(error)}


def _drawing(question: dict[str, Any], share: Callable[[float], None]) -> dict[str, Any]:
    from CNCStepper.drawing.repair.problems import RepairLimits
    from CNCStepper.job.drawings.imported_drawing import packed, read_imported
    from CNCStepper.job.shape_forms.drawing_form import DrawingForm

    asked = question["drawing"]
    form, limits = DrawingForm.model_validate(asked["form"]), RepairLimits.model_validate(asked["limits"])
    return packed(read_imported(Path(asked["file"]), form, limits, share))


WORK: dict[str, Callable[[dict[str, Any], Callable[[float], None]], dict[str, Any]]] = {"drawing": _drawing}


if __name__ == "__main__":
    sys.exit(main())
