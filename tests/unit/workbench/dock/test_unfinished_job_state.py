# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the dock says of a job that did not end, and which program of the document it was."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from typing import Any

import pytest

from CNCStepper.control.journal.replay import KILLED
from CNCStepper.control.program.certificate import digest_of_text
from CNCStepper.control.session.status import DONE, FAILED, STOPPED
from CNCStepper.errors import JobError
from CNCStepper.workbench.dock.model.button_states import ControllerSnapshot
from CNCStepper.workbench.dock.model.unfinished_job import NAMES, Reading, program_of, why_not_now

WAIT_S = 30


def wait_for(reading: Reading, happened: Callable[[], Any]) -> None:
    until_s = time.monotonic() + WAIT_S
    while not happened():
        reading.poll()
        assert time.monotonic() < until_s
        time.sleep(0.001)


def test_the_program_is_known_by_its_text_alone() -> None:
    programs = [("edited", "G21 (edited)\n"), ("job", "G21\n")]
    assert program_of(digest_of_text("G21\n"), programs) == "job"
    assert program_of(digest_of_text("G21\n"), programs[:1]) is None


def test_however_a_job_ended_it_has_a_word() -> None:
    assert {KILLED, STOPPED, FAILED, DONE} <= set(NAMES)


def test_nothing_is_restarted_while_something_is_cut() -> None:
    assert why_not_now(ControllerSnapshot("running", job=True)).endswith(".")
    assert not why_not_now(ControllerSnapshot("idle")) and not why_not_now(ControllerSnapshot())


def test_whoever_asks_does_not_wait() -> None:
    may_answer, found = threading.Event(), []
    reading = Reading()
    reading.ask(lambda: may_answer.wait(WAIT_S) and "a story", found.append)
    reading.poll()
    assert not found
    may_answer.set()
    wait_for(reading, lambda: found)
    reading.poll()
    assert found == ["a story"]


def test_of_two_questions_the_newer_counts() -> None:
    first, second = [], []
    reading = Reading()
    reading.ask(lambda: "a story", first.append)
    reading.ask(lambda: None, second.append)
    wait_for(reading, lambda: second)
    assert (first, second) == ([], [None])


def test_what_the_finding_raises_is_raised_to_whoever_looks() -> None:
    def fail() -> None:
        raise JobError("journal-unreadable", "the journal cannot be read", advice="look at the machine")

    reading = Reading()
    reading.ask(fail, lambda _: None)
    with pytest.raises(JobError, match="cannot be read"):
        wait_for(reading, lambda: False)
