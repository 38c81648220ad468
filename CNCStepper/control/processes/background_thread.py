# SPDX-License-Identifier: LGPL-2.1-or-later
"""Work beside the thread that asks for it: files to read and write, programs to find, a cluster that may not answer."""

from __future__ import annotations

import threading
from collections.abc import Callable
from concurrent.futures import Future
from typing import TypeVar

Result = TypeVar("Result")


def in_background(work: Callable[[], Result]) -> Future[Result]:
    """Return at once what will be the result of `work`, or its error: a window asks its `done()` from a timer.

    The thread does not keep the program from ending.
    """
    answer: Future[Result] = Future()

    def run() -> None:
        try:
            answer.set_result(work())
        except Exception as error:
            answer.set_exception(error)

    threading.Thread(target=run, name="in-background", daemon=True).start()
    return answer
