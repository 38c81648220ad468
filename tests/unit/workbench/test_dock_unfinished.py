# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the dock says of a job that did not end, and which program of the document it was."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from CNCStepper.control.certificate import digest_of_text
from CNCStepper.control.journal.first_program import FirstProgram
from CNCStepper.control.journal.group import Group
from CNCStepper.control.journal.sent_text import text_sent
from CNCStepper.control.journal.story import KILLED, Story
from CNCStepper.control.outcome import STOPPED
from CNCStepper.errors import JobError
from CNCStepper.workbench.dock.state import Moment
from CNCStepper.workbench.dock.unfinished import (
    NAMES,
    Reading,
    line_of,
    name_of,
    program_of,
    reached_by,
    told,
    why_not_now,
)

HEADER = {
    "lines": 300, "last_line": 301, "homing": True, "goes_back": False, "port": "COM3", "file": "Plate",
    "machine": "table-a", "firmware": "1.1h", "begin": "2026-11-22 08:00:00",
}  # fmt: skip
GROUP = Group(1.8e9, 97, 60, 41, 43, 98, "Run", (-90.0, -40.0, -10.0), (10.0, 10.0, 10.0))
WAIT_S = 30


def story(group: Group = GROUP, **header: Any) -> Story:
    return Story(Path("1.journal"), {**HEADER, "program_sha256": digest_of_text("G21\n"), **header}, group, KILLED)


def wait_for(reading: Reading, happened: Callable[[], Any]) -> None:
    until_s = time.monotonic() + WAIT_S
    while not happened():
        reading.poll()
        assert time.monotonic() < until_s
        time.sleep(0.001)


def test_the_line_is_the_first_that_is_not_certainly_cut() -> None:
    assert line_of(story()) == 43
    names = [name for name, _ in told(story())]
    wanted = ("program", "machine", KILLED, "certain", "not certain", "not sent", "last seen", "position")
    assert names == [NAMES[name] for name in wanted]


def test_the_interval_is_told_as_places_where_the_program_is_there_as_it_was_sent() -> None:
    text = "G21 G90\nG1 X10 F600\nG1 X20\n"
    zero = {"modes": "G0 G54 G17 G21 G90 G94", "offsets_mm": {"G54": [0.0, 0.0, 0.0]}, "mpos_mm": [0.0, 0.0, 0.0]}
    group = Group(1.8e9, 3, 2, 1, 2, 3, "Run", (5.0, 0.0, 0.0), (5.0, 0.0, 0.0))
    sent = story(group, lines=3, dialect="grbl", program_sha256=digest_of_text(text), **zero)
    told_then = dict(told(sent, reached_by(sent, ["G21\n", text])))
    assert told_then[NAMES["on the path"]].startswith("from X0.000 Y0.000 Z0.000 at line 2, to X20.000")
    assert told_then[NAMES["last seen"]].endswith("on the path at line 2")
    assert reached_by(sent, ["G21\n"]) is None
    assert reached_by(replace(sent, group=replace(group, finished=3, first_line=0)), [text]) is None


def test_the_program_in_its_file_counts_too_while_it_is_the_same(tmp_path: Path) -> None:
    file = tmp_path / "peça 1.nc"
    file.write_text("G21\n", "utf-8")
    assert text_sent(story(file=str(file))) == "G21\n"
    file.write_text("G20\n", "utf-8")
    assert text_sent(story(file=str(file))) is None and text_sent(story(file=str(file)), ["G21\n"]) == "G21\n"
    assert text_sent(story()) is None


def test_how_it_ended_is_a_word_of_ours_and_why_a_sentence_of_the_core() -> None:
    stopped = replace(story(), end=STOPPED, why="stopped as asked after 60 lines")
    assert (NAMES[STOPPED], "stopped as asked after 60 lines") in told(stopped)


def test_a_zero_that_was_set_within_the_job_is_told() -> None:
    set_again = replace(story(offsets_mm={}), zero={"line": 12, "offsets_mm": {"G54": [1.0, 2.0, 3.0]}})
    assert "line 12" in dict(told(set_again))[NAMES["work zero"]]


@pytest.mark.parametrize(
    "unclear", [story(goes_back=True), story(Group(1.0, 300, 300, 300, 0, 301))], ids=["loops", "all cut"]
)
def test_where_a_line_would_be_wrong_none_is_proposed_and_it_is_said(unclear: Story) -> None:
    assert line_of(unclear) == 0
    assert NAMES["restart"] in dict(told(unclear))


def test_the_program_is_known_by_its_text_alone() -> None:
    programs = [("edited", "G21 (edited)\n"), ("job", "G21\n")]
    assert program_of(story(), programs) == "job"
    assert program_of(story(), programs[:1]) is None


def test_a_restart_that_did_not_end_itself_leads_to_the_first_program_and_its_line() -> None:
    first = FirstProgram("Plate", digest_of_text("G21\n"), [[40, 812]])
    again = story(program_sha256=digest_of_text("the restart"), restart_of=first.to_content(), file="Plate-restart")
    assert (name_of(again), line_of(again)) == ("Plate", 815)
    assert program_of(again, [("restart", "the restart"), ("plate", "G21\n")]) == "plate"
    assert "the program's 815" in dict(told(again))[NAMES["restart"]]


def test_nothing_is_restarted_while_something_is_cut() -> None:
    assert why_not_now(Moment("running", job=True)).endswith(".")
    assert not why_not_now(Moment("idle")) and not why_not_now(Moment())


def test_whoever_asks_does_not_wait() -> None:
    may_answer, found = threading.Event(), []
    reading = Reading()
    reading.ask(lambda: may_answer.wait(WAIT_S) and story(), found.append)
    reading.poll()
    assert not found
    may_answer.set()
    wait_for(reading, lambda: found)
    reading.poll()
    assert found == [story()]


def test_of_two_questions_the_newer_counts() -> None:
    first, second = [], []
    reading = Reading()
    reading.ask(story, first.append)
    reading.ask(lambda: None, second.append)
    wait_for(reading, lambda: second)
    assert (first, second) == ([], [None])


def test_what_the_finding_raises_is_raised_to_whoever_looks() -> None:
    def fail() -> Story:
        raise JobError("journal-unreadable", "the journal cannot be read", advice="look at the machine")

    reading = Reading()
    reading.ask(fail, lambda _: None)
    with pytest.raises(JobError, match="cannot be read"):
        wait_for(reading, lambda: False)
