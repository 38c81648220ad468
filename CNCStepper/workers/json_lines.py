# SPDX-License-Identifier: LGPL-2.1-or-later
"""The protocol of a worker process: a JSON line per question and per answer, until its input closes."""

from __future__ import annotations

import json
import os
import threading
import time
import traceback
from collections.abc import Callable
from dataclasses import dataclass
from queue import Empty, SimpleQueue
from typing import Any

from CNCStepper import text_json
from CNCStepper.errors import CNCStepperError, Text

Questions = SimpleQueue[dict[str, Any]]
LOOK_EVERY_S = 0.02  # whether a newer question has come
STOP = "stop"  # the key of a message that ends a search with the best so far


class Outdated(Exception):
    """Raised where a newer question has come."""


class NewestQuestion:
    """The newest of a worker's questions: who works on one looks now and then whether there is a newer one.

    {"stop": MARK} is no question: it sets `stopped` while the question of that mark is worked on, which then ends
    with the best so far.
    """

    def __init__(self, questions: Questions):
        self.stopped = threading.Event()
        self._questions = questions
        self._newer: dict[str, Any] | None = None
        self._mark: Any = None
        self._looked_s = 0.0

    def wait(self) -> dict[str, Any]:
        """Return the newest question; wait where there is none."""
        question, self._newer = self._newer, None
        self.stopped.clear()
        while question is None or not self._questions.empty():
            told = self._questions.get()
            if STOP not in told:
                question = told
                self.stopped.clear()
            elif question is not None and told[STOP] == question.get("mark"):
                self.stopped.set()
        self._mark = question.get("mark")
        return question

    def look(self) -> None:
        """Raise Outdated where a newer question has come."""
        now_s = time.monotonic()
        if now_s < self._looked_s + LOOK_EVERY_S:
            return
        self._looked_s = now_s
        try:
            told = self._questions.get_nowait()
        except Empty:
            return
        if STOP not in told:
            self._newer = told
            raise Outdated
        if told[STOP] == self._mark:
            self.stopped.set()


@dataclass(frozen=True)
class Work:
    """How a worker's errors name what it does: "cut", "the cut", and how it takes less memory."""

    code: str
    doing: str
    less_memory: str

    def refused(self, error: Exception) -> dict[str, Any]:
        """Return an error for the person who waits, as JSON; call it where `error` is caught."""
        from CNCStepper.control.session.status import error_to_json

        if isinstance(error, CNCStepperError):
            return error_to_json(error)
        if isinstance(error, MemoryError):
            what = Text("{doing} takes more memory than there is", doing=self.doing)
            return error_to_json(CNCStepperError(f"{self.code}-memory", what, advice=self.less_memory))
        traceback.print_exc()
        return error_to_json(_fault(error, f"{self.code}-fault", self.doing))


def serve(answer: Callable[[Questions], None], code: str, doing: str) -> int:
    """Let `answer` take the questions of standard input until an error; report that error, and return 1.

    code, doing: of a fault of ours, as in "timeline-fault" and "the timeline".
    """
    questions: Questions = SimpleQueue()
    failed = threading.Event()
    threading.Thread(target=_listen, args=(questions.put, failed), daemon=True).start()
    try:
        answer(questions)
    except CNCStepperError as error:
        _refuse(error, failed)
    except Exception as error:  # a fault of ours still has to reach the person who waits
        traceback.print_exc()
        _refuse(_fault(error, code, doing), failed)
    return 1


def tell(answer: dict[str, Any]) -> None:
    """Write an answer to standard output."""
    print(text_json.dumps(answer), flush=True)


def _listen(put: Callable[[dict[str, Any]], None], failed: threading.Event) -> None:
    """Hand on every question; end this process when nobody holds the other end of standard input any more.

    Who closes it on hearing of an error may be quicker than this process ends by itself: the status is the same.
    """
    with open(0, "rb", closefd=False) as questions:  # not sys.stdin: its lock would be held when the interpreter ends
        for line in questions:
            put(json.loads(line))
    os._exit(int(failed.is_set()))


def _fault(error: Exception, code: str, doing: str) -> CNCStepperError:
    what = Text(
        "{doing} failed by a fault of its own: {kind}: {error}", doing=doing, kind=type(error).__name__, error=error
    )
    return CNCStepperError(code, what, advice="please report it, with the program")


def _refuse(error: CNCStepperError, failed: threading.Event) -> None:
    from CNCStepper.control.session.status import error_to_json

    failed.set()
    tell({"error": error_to_json(error)})
