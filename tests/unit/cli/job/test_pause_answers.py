# SPDX-License-Identifier: LGPL-2.1-or-later
"""What may be answered while a job stands."""

from __future__ import annotations

import pytest

from CNCStepper.cli.job.pause_answers import GO_ON, STOP, is_end, read_answer
from CNCStepper.cli.job.pause_question import question
from CNCStepper.control.session.command import JOB_COMMANDS, read_command
from CNCStepper.control.session.status import SenderStatus
from CNCStepper.control.stream.overrides import override_byte


@pytest.mark.parametrize(
    ("text", "wishes"),
    [
        ("", GO_ON),
        ("  ", GO_ON),
        ("S", STOP),
        ("no", STOP),
        ("all", [("by_line", {"on": False}), ("resume", {})]),
        ("zero z", [("set_zero", {"axes": "Z"})]),
        ("Zero XYZ", [("set_zero", {"axes": "XYZ"})]),
        ("z-0.1", [("jog", {"x_mm": 0.0, "y_mm": 0.0, "z_mm": -0.1, "feed_mm_min": 500.0})]),
        ("X10 y-.5f100", [("jog", {"x_mm": 10.0, "y_mm": -0.5, "z_mm": 0.0, "feed_mm_min": 100.0})]),
    ],
)
def test_answer_is_read(text, wishes):
    assert read_answer(text) == wishes
    for name, values in wishes:
        read_command({"command": name, **values}, JOB_COMMANDS)


@pytest.mark.parametrize(
    "text", ["y", "yes", "x", "f100", "x1 x2", "x5000", "x1f0", "x1f-5", "zero", "zero a", "go", "1", "x--1"]
)
def test_anything_else_moves_nothing(text):
    with pytest.raises(ValueError, match="is no"):
        read_answer(text)


def test_only_going_on_and_stopping_end_a_stand():
    assert is_end(read_answer("")) and is_end(read_answer("s")) and is_end(read_answer("all"))
    assert not is_end(read_answer("x1")) and not is_end(read_answer("zero z"))


@pytest.mark.parametrize(
    ("phase", "state", "jogs", "touches", "goes_back"),
    [
        ("held", "Hold:0", False, False, True),
        ("paused", "Hold:0", False, False, True),
        ("paused", "Idle", True, True, True),
        ("paused", "Tool", True, True, False),
        ("retreated", "Idle", True, False, True),
        ("door", "Door:0", False, False, False),
    ],
)
def test_question_names_what_can_be_done_at_a_stand(phase, state, jogs, touches, goes_back):
    asked = question(SenderStatus(phase=phase, machine_state=state))
    assert "Enter goes on, s stops" in asked
    assert ("z-0.1 jogs" in asked) == jogs and ("zero z" in asked and jogs) == touches
    assert ("`cncstepper back` goes back" in asked) == goes_back


@pytest.mark.parametrize(
    ("text", "kind", "step"),
    [
        ("feed +10", "feed", "10"),
        ("FEED  -1", "feed", "-1"),
        ("feed 100", "feed", "reset"),
        ("rapid 50", "rapid", "50"),
        ("spindle -10", "spindle", "-10"),
        ("spindle stop", "spindle", "stop"),
        ("flood", "coolant", "flood"),
        ("mist", "coolant", "mist"),
    ],
)
def test_override_is_read_and_is_one_that_there_is(text, kind, step):
    assert read_answer(text) == [("override", {"kind": kind, "step": step})]
    read_command({"command": "override", "kind": kind, "step": step}, JOB_COMMANDS)
    assert override_byte(kind, step)


@pytest.mark.parametrize("text", ["feed", "feed 10", "feed 90", "rapid +10", "rapid stop", "feed stop", "spindle 0"])
def test_override_that_there_is_not_is_refused_with_those_that_there_are(text):
    with pytest.raises(ValueError, match=r"there is no override .* feed \+10 -10"):
        read_answer(text)


def test_question_mark_is_answered_with_all_words():
    with pytest.raises(ValueError, match=r"zero z touches off.*spindle \+10.*flood"):
        read_answer("?")
