# SPDX-License-Identifier: LGPL-2.1-or-later
"""The protocol of a worker process: a JSON line per question and per answer, until its input closes."""

from __future__ import annotations

import json
import os
import threading
import traceback
from collections.abc import Callable
from queue import SimpleQueue
from typing import Any

from CNCStepper import text_json
from CNCStepper.errors import CNCStepperError, Text

Questions = SimpleQueue[dict[str, Any]]


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
        what = Text(
            "{doing} failed by a fault of its own: {kind}: {error}", doing=doing, kind=type(error).__name__, error=error
        )
        _refuse(CNCStepperError(code, what, advice="please report it, with the program"), failed)
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


def _refuse(error: CNCStepperError, failed: threading.Event) -> None:
    from CNCStepper.control.session.status import error_to_json

    failed.set()
    tell({"error": error_to_json(error)})
