# SPDX-License-Identifier: LGPL-2.1-or-later
"""Work beside the window: it is not waited for, and its result or its error comes back."""

from __future__ import annotations

import threading

from CNCStepper.control.processes.background_thread import in_background
from CNCStepper.errors import JobError


def test_the_answer_comes_when_the_work_is_done_and_not_before() -> None:
    let_on = threading.Event()

    def work() -> int:
        assert let_on.wait(30)
        return threading.get_ident()

    answer = in_background(work)
    assert not answer.done()
    let_on.set()
    assert answer.result(30) != threading.get_ident()


def test_an_error_is_handed_on_as_it_was_raised() -> None:
    error = JobError("no-such", "there is none")

    def work() -> None:
        raise error

    assert in_background(work).exception(30) is error


def test_the_thread_does_not_keep_a_program_from_ending() -> None:
    let_on = threading.Event()
    answer = in_background(lambda: let_on.wait(30))
    (thread,) = [thread for thread in threading.enumerate() if thread.name == "in-background"]
    assert thread.daemon
    let_on.set()
    assert answer.result(30)
