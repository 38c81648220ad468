# SPDX-License-Identifier: LGPL-2.1-or-later
"""A person at the terminal of `send`, asked about stands that end and begin while the question is open.

What may be answered while a job stands.
"""

from __future__ import annotations

import io
import time
from typing import Any

import click
import pytest

from CNCStepper.cli.job.pause_prompt import (
    GO_ON,
    OVER,
    STOP,
    PausePrompt,
    SessionListener,
    is_end,
    question,
    read_answer,
)
from CNCStepper.cli.job.session_watch import Moving, _Watch
from CNCStepper.control.session.command import JOB_COMMANDS, read_command
from CNCStepper.control.session.status import Outcome, SenderStatus
from CNCStepper.control.stream.overrides import override_byte

HELD = SenderStatus("held", stand=1)
CHANGE = SenderStatus("paused", machine_state="Idle", stand=3, message="change to tool 2")
RUNNING = SenderStatus("running", stand=1)
LIMIT_S = 20.0


class Session:
    """A session that stands as it is told, and notes what it is asked."""

    session_file = None

    def __init__(self, status: SenderStatus):
        self.asked: list[tuple[str, dict[str, Any]]] = []
        self.outcome: Outcome | None = None
        self._events: list[dict[str, Any]] = []
        self.become(status)

    def become(self, status: SenderStatus) -> None:
        self.status = status
        self.say(event="status", status=status.to_json())

    def say(self, **event: Any) -> None:
        self._events.append(event)

    def ask(self, command: str, **values: Any) -> None:
        if command == "status":
            self.become(self.status)
            return
        self.asked.append((command, values))
        if command in ("resume", "stop"):
            self.become(SenderStatus("running", stand=self.status.stand))

    def hold(self) -> None:
        self.ask("hold")

    def stop(self) -> None:
        self.ask("stop")

    def poll(self, wait_s: float) -> list[dict[str, Any]]:
        events, self._events = self._events, []
        return events


class Person:
    """Types answers at prompts; each is a text, or what to do first."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch, *answers: Any):
        self.questions: list[str] = []
        self._answers = list(answers)
        monkeypatch.setattr("click.prompt", self._prompt)

    def _prompt(self, question: str, *, type: click.ParamType, **given: Any) -> Any:
        self.questions.append(question)
        answer = self._answers.pop(0)
        return type.convert(answer() if callable(answer) else answer, None, None)


def asked(session: Session, told: list[str]) -> PausePrompt:
    return PausePrompt(session, lambda event: told.append(event["text"]), told.append)


def test_enter_at_a_question_that_is_over_asks_anew_and_only_then_goes_on(monkeypatch):
    session, told = Session(HELD), []
    person = Person(monkeypatch, lambda: session.become(CHANGE) or "", "")
    assert asked(session, told).ask(HELD) == 3
    assert "The machine holds" in person.questions[0] and "change to tool 2" in person.questions[1]
    assert session.asked == [("resume", {"stand": 3})]


@pytest.mark.parametrize("answer", ["x5", "zero z", "feed +10", "all"])
def test_what_was_typed_at_a_question_that_is_over_is_not_done(monkeypatch, answer):
    session, told = Session(HELD), []
    Person(monkeypatch, lambda: session.become(CHANGE) or answer, "s")
    asked(session, told).ask(HELD)
    assert OVER in told and session.asked == [("stop", {})]


def test_nothing_is_asked_of_a_job_that_has_gone_on_and_nothing_is_done(monkeypatch):
    session, told = Session(HELD), []
    person = Person(monkeypatch, lambda: session.become(RUNNING) or "")
    asked(session, told).ask(HELD)
    assert len(person.questions) == 1 and session.asked == []


def test_stop_counts_at_every_moment(monkeypatch):
    session = Session(HELD)
    Person(monkeypatch, lambda: session.become(RUNNING) or "s")
    asked(session, []).ask(HELD)
    assert session.asked == [("stop", {})]


def test_override_is_told_and_the_stand_stays(monkeypatch):
    session, told = Session(HELD), []
    faster = SenderStatus("held", stand=1, overrides=(110, 100, 100))
    person = Person(monkeypatch, lambda: session.become(HELD) or "feed +10", "")
    monkeypatch.setattr(session, "ask", _becoming(session, faster))
    asked(session, told).ask(HELD)
    assert "110/100/100 %" in told and len(person.questions) == 2


def _becoming(session: Session, status: SenderStatus):
    ask = session.ask

    def asking(command: str, **values: Any) -> None:
        ask(command, **values)
        if command == "override":
            session.become(status)

    return asking


def test_what_is_told_behind_a_status_is_told(monkeypatch):
    session, told = Session(HELD), []
    ask = session.ask
    monkeypatch.setattr(session, "ask", lambda *words, **values: (ask(*words, **values), told_of(session)))
    Person(monkeypatch, "s")
    asked(session, told).ask(HELD)
    assert "zero of Z set" in told


def told_of(session: Session) -> None:
    session.say(event="message", text="zero of Z set")


def test_new_stand_is_told_while_the_old_question_is_open():
    session, told = Session(HELD), []
    end_s = time.monotonic() + LIMIT_S
    with SessionListener(session, HELD, lambda event: told.append(event["text"]), told.append):
        session.become(RUNNING)
        session.say(event="message", text="look")
        while len(told) < 2 and time.monotonic() < end_s:
            time.sleep(0.01)
        session.become(CHANGE)
        while len(told) < 3 and time.monotonic() < end_s:
            time.sleep(0.01)
    assert "gone on" in told[0] and told[1] == "look" and "change to tool 2" in told[2]


class Ended(io.StringIO):
    """Standard input at its end, of a terminal or of none."""

    def __init__(self, is_terminal: bool):
        super().__init__("")
        self._is_terminal = is_terminal

    def isatty(self) -> bool:
        return self._is_terminal


def test_without_a_terminal_the_machine_waits_and_says_how_it_goes_on(monkeypatch):
    monkeypatch.setattr("sys.stdin", Ended(False))
    session, told = Session(HELD), []
    asker = asked(session, told)
    assert asker.ask(HELD) == 1 and asker.ask(CHANGE) == 3
    assert session.asked == [] and not asker.is_there
    assert "`cncstepper go` goes on" in told[0] and "`cncstepper go --pause` goes on" in told[1]


def test_end_of_input_at_a_terminal_stops(monkeypatch):
    monkeypatch.setattr("sys.stdin", Ended(True))
    session = Session(HELD)
    asked(session, []).ask(HELD)
    assert session.asked == [("stop", {})]


def test_without_a_terminal_the_second_interrupt_stops(monkeypatch):
    monkeypatch.setattr("sys.stdin", Ended(False))
    monkeypatch.setattr("CNCStepper.cli.job.session_watch._Watch._follow_buttons", lambda watch: None)
    session = Session(RUNNING)
    watch = _Watch(session, Moving(), False, False)
    watch._look()
    watch._interrupted()
    assert session.asked == [("hold", {})]
    session.become(HELD)
    watch._look()
    watch._interrupted()
    assert session.asked == [("hold", {}), ("stop", {})]


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
