# SPDX-License-Identifier: LGPL-2.1-or-later
"""A worker process answers line by line, tells the error that ends it, and ends with the one who asks."""

from __future__ import annotations

import json
import subprocess
import sys
from queue import SimpleQueue

import pytest

from CNCStepper.control.processes.python_finder import environment
from CNCStepper.control.session.status import error_from_json
from CNCStepper.workers.json_lines import NewestQuestion, Outdated, Questions

WORKER = """
import atexit, sys, time
from CNCStepper.errors import JobError
from CNCStepper.workers.json_lines import serve, tell

def halve(questions):
    while True:
        number = questions.get()["number"]
        if number < 0:
            raise JobError("negative", "the number is below 0", value=str(number))
        tell({"half": 12 // number})

atexit.register(time.sleep, 0.3)
sys.exit(serve(halve, "half-fault", "the halving"))
"""


def asked(*numbers: int, held_open: bool) -> tuple[int, list[dict]]:
    """Ask about numbers; return how the process ended and what it told. held_open: until it ends by itself."""
    process = subprocess.Popen(
        [sys.executable, "-c", WORKER],
        env=environment(),
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        encoding="utf-8",
    )
    with process:
        assert process.stdin is not None and process.stdout is not None
        for number in numbers:
            process.stdin.write(json.dumps({"number": number}) + "\n")
        process.stdin.flush()
        told = [json.loads(process.stdout.readline()) for _ in numbers]
        if not held_open:
            process.stdin.close()
        return process.wait(60), told


def test_it_answers_in_order_and_ends_when_nobody_asks() -> None:
    assert asked(1, 2, 3, held_open=False) == (0, [{"half": 12}, {"half": 6}, {"half": 4}])


@pytest.mark.parametrize(
    ("number", "code", "what"),
    [
        (-1, "negative", "the number is below 0"),
        (0, "half-fault", "the halving failed by a fault of its own: ZeroDivisionError"),
    ],
)
def test_an_error_is_told_and_ends_it(number: int, code: str, what: str) -> None:
    status, (half, told) = asked(2, number, held_open=True)
    error = error_from_json(told["error"])
    assert (status, half, error.code) == (1, {"half": 6}, code)
    assert error.what.startswith(what)


def test_an_error_is_the_status_though_who_hears_it_hangs_up_at_once() -> None:
    """The process is slow to end, and its own listener sees the end of the questions first."""
    assert asked(-1, held_open=False)[0] == 1


def looked(newest: NewestQuestion) -> None:
    """Look again, though the last look was a moment ago."""
    newest._looked_s = 0.0
    newest.look()


def test_a_stop_is_for_its_own_question_and_a_newer_question_ends_the_work() -> None:
    questions: Questions = SimpleQueue()
    newest = NewestQuestion(questions)
    for told in ({"mark": 1}, {"stop": 1}, {"mark": 2}):
        questions.put(told)
    assert newest.wait() == {"mark": 2} and not newest.stopped.is_set()
    questions.put({"stop": 1})
    looked(newest)
    assert not newest.stopped.is_set()
    questions.put({"stop": 2})
    looked(newest)
    assert newest.stopped.is_set()
    questions.put({"mark": 3})
    with pytest.raises(Outdated):
        looked(newest)
    questions.put({"stop": 3})
    assert newest.wait() == {"mark": 3} and newest.stopped.is_set(), "a stop before it began counts"
