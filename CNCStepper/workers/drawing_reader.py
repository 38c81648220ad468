# SPDX-License-Identifier: LGPL-2.1-or-later
"""The process that reads drawings, slices, nests and compares programs for the window.

`python -m CNCStepper.workers.drawing_reader` knows nothing of FreeCAD. Each line on standard input is a question in
JSON; a newer one ends the work on the one before. Each line on standard output is about the newest:

    {"mark": 3, "drawing": {"file": PATH, "form": {...}, "limits": {...}}}
    {"mark": 3, "slices": {"solid": PATH, "folder": PATH, "title": TEXT, "form": {...}}}
    {"mark": 3, "template": {"file": PATH, "path": PATH, "content": {...}, "make": false}}
    {"mark": 3, "nest": {...}}                    `job/nesting/nest_question.py`
    {"mark": 3, "arrange": {...}}                 `job/editing/arrange_question.py`
    {"mark": 3, "compare": {...}}                 `job/comparison/comparison_question.py`
    {"stop": 3}                                   ends a search with the best so far

    {"mark": 3, "share": 0.4}                     what share is done
    {"mark": 3, "answer": {...}}                  the end of it
    {"mark": 3, "refused": {...}}                 or the error, as `error_to_json` gives it

When standard input is closed the process ends.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from pathlib import Path
from threading import Event
from typing import Any

from CNCStepper.cancellation import interruptible
from CNCStepper.workers.json_lines import NewestQuestion, Outdated, Questions, Work, serve, tell

SHARE_EVERY_S = 0.2
Share = Callable[[float], None]
READING = Work("drawing", "the reading of the drawing", "simplify it, or divide it")


def main() -> int:
    """Answer what standard input asks; return the exit status."""
    return serve(lambda questions: Answers(questions).run(), "drawing-fault", READING.doing)


class Answers:
    """The newest question."""

    def __init__(self, questions: Questions):
        self._newest = NewestQuestion(questions)
        self._told_s = 0.0
        self._mark = 0

    def run(self) -> None:
        """Answer for ever."""
        while True:
            question = self._newest.wait()
            self._mark = question["mark"]
            try:
                with interruptible(self._newest.look):
                    told = self._answer(question)
            except Outdated:
                continue
            tell({"mark": self._mark, **told})

    def _share(self, share: float) -> None:
        self._newest.look()
        now_s = time.monotonic()
        if now_s >= self._told_s + SHARE_EVERY_S:
            self._told_s = now_s
            tell({"mark": self._mark, "share": share})

    def _answer(self, question: dict[str, Any]) -> dict[str, Any]:
        key = next(key for key in WORK if key in question)
        try:
            return {"answer": WORK[key](question, self._share, self._newest.stopped)}
        except Outdated:
            raise
        except Exception as error:  # a fault of ours still has to reach the person who waits
            return {"refused": READING.refused(error)}


def _drawing(question: dict[str, Any], share: Share, stopped: Event) -> dict[str, Any]:
    from CNCStepper.drawing.repair.problems import RepairLimits
    from CNCStepper.job.drawings.imported_drawing import packed, read_imported
    from CNCStepper.job.shape_forms.drawing_form import DrawingForm

    asked = question["drawing"]
    form, limits = DrawingForm.model_validate(asked["form"]), RepairLimits.model_validate(asked["limits"])
    return packed(read_imported(Path(asked["file"]), form, limits, share))


def _slices(question: dict[str, Any], share: Share, stopped: Event) -> dict[str, Any]:
    from CNCStepper.job.slicing.make_slices import answer_of

    return answer_of(question["slices"], share)


def _template(question: dict[str, Any], share: Share, stopped: Event) -> dict[str, Any]:
    from CNCStepper.job.templates.template_answer import template_answer

    return template_answer(question["template"], share)


def _nest(question: dict[str, Any], share: Share, stopped: Event) -> dict[str, Any]:
    from CNCStepper.job.nesting.nest_question import answer_of

    return answer_of(question["nest"], share, stopped)


def _arrange(question: dict[str, Any], share: Share, stopped: Event) -> dict[str, Any]:
    from CNCStepper.job.editing.arrange_question import answer_of

    return answer_of(question["arrange"], share, stopped)


def _compare(question: dict[str, Any], share: Share, stopped: Event) -> dict[str, Any]:
    from CNCStepper.job.comparison.comparison_question import answer_of

    return answer_of(question["compare"], share)


WORK: dict[str, Callable[[dict[str, Any], Share, Event], dict[str, Any]]] = {
    "drawing": _drawing,
    "slices": _slices,
    "nest": _nest,
    "arrange": _arrange,
    "template": _template,
    "compare": _compare,
}


if __name__ == "__main__":
    sys.exit(main())
