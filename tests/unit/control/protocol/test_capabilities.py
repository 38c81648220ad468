# SPDX-License-Identifier: LGPL-2.1-or-later
"""A machine that cannot do all: said before the first line, in every status, and refused in words."""

from __future__ import annotations

import re

import pytest

from CNCStepper.control.program.send_job import SendJob
from CNCStepper.control.protocol.grbl.capabilities import CANNOT_CODE, NEEDS, REASONS, check_can, reason
from CNCStepper.control.service.sender import Sender
from CNCStepper.control.session.command import VALUES, Command
from CNCStepper.control.session.status import DONE, REFUSED, STOPPED, SenderStatus
from CNCStepper.errors import MachineRefusal
from helpers.control.fake_controller import INFO, FakeClock, FakeController, FakeLink

LATHE = (*INFO, "[FIRMWARE:CNCStepper lathe]", "[CANNOT:hold]", "[CANNOT:stop]", "[CANNOT:override]")
PARPORT = (*INFO, "[FIRMWARE:CNCStepper parport]")
ASKED = {"hold": {}, "override": {"kind": "feed", "step": "+10"}}


class Bench:
    """A controller of ours in memory, and what a sender says of it."""

    def __init__(self, info: tuple[str, ...], **job):
        self.clock = FakeClock()
        self.controller = FakeController(self.clock)
        self.controller.info = info
        self.told: list[tuple[str, str]] = []
        self.refused: list[tuple[str, MachineRefusal]] = []
        self.sender = Sender(
            SendJob("fake", [f"G1X{place}F600" for place in range(40)], zero_confirmed=True, **job),
            opener=lambda name, baud: FakeLink(self.controller, self.clock),
            clock=self.clock,
            tell=lambda kind, text: self.told.append((kind, text)),
            refuse=lambda command, error: self.refused.append((command.name, error)),
        )

    def run(self, command: Command | None = None):
        if command:
            self.controller.actions[5] = lambda: self.sender.ask(command)
        return self.sender.run()


@pytest.mark.parametrize("word", REASONS)
def test_each_word_has_a_reason_and_what_to_do(word: str) -> None:
    why, what_to_do = REASONS[word]
    assert len(why.split()) > 4 and len(what_to_do.split()) > 3 and reason(word) == f"{why}: {what_to_do}"


def test_every_command_that_needs_something_is_one() -> None:
    assert set(NEEDS) - {"want_back"} <= set(VALUES) and {word for needs in NEEDS.values() for word in needs} <= set(
        REASONS
    )
    check_can("hold", ())
    with pytest.raises(MachineRefusal) as refusal:
        check_can("hold", ("hold",))
    assert refusal.value.code == CANNOT_CODE and "switch" in refusal.value.advice


def test_what_it_cannot_do_is_said_before_the_first_line_and_is_in_every_status() -> None:
    bench = Bench(LATHE, dialect="mini-lathe")
    seen = []
    bench.controller.actions[0] = lambda: seen.append(list(bench.told))
    assert bench.run().kind == DONE
    before = [text for kind, text in seen[0] if kind == "warning"]
    assert [reason(word) for word in ("hold", "override", "stop")] == before
    status = bench.sender.status()
    assert status.cannot == ("hold", "override", "stop")
    assert SenderStatus.from_json(status.to_json()) == status


@pytest.mark.parametrize("name", ASKED)
def test_command_that_it_cannot_do_is_refused_and_the_job_goes_on(name: str) -> None:
    bench = Bench(LATHE, dialect="mini-lathe")
    assert bench.run(Command(name, ASKED[name])).kind == DONE
    assert [(asked, error.code) for asked, error in bench.refused] == [(name, "cannot")]
    assert "!" not in bench.controller.realtime and len(bench.controller.lines) == 40


def test_stop_that_it_cannot_do_ends_the_sending_and_says_what_runs_on() -> None:
    bench = Bench(LATHE, dialect="mini-lathe")
    outcome = bench.run(Command("stop"))
    assert outcome.kind == STOPPED and "switch" in outcome.text and not outcome.position_known
    assert [error.code for _, error in bench.refused] == ["cannot"] and len(bench.controller.lines) < 40


def test_rate_of_the_program_is_tried_before_its_first_line() -> None:
    bench = Bench(PARPORT, dialect="grbl", pulses_per_s=25_000.4)
    asked: list[str] = []
    system = bench.controller._system

    def answer(line: str) -> None:
        asked.append(line)
        if line.startswith("$T"):
            assert not bench.controller.lines
            bench.controller.say("ok")
        else:
            system(line)

    bench.controller._system = answer
    assert bench.run().kind == DONE
    assert asked.count("$T=25000") == 1
    assert Bench(INFO, pulses_per_s=25_000).run().kind == DONE, "grbl itself is not asked"


def test_rate_that_is_not_kept_is_refused_before_the_first_line() -> None:
    bench = Bench(PARPORT, dialect="grbl", pulses_per_s=90_000)
    system = bench.controller._system
    bench.controller._system = lambda line: bench.controller.say("error:90") if re.match(r"\$T", line) else system(line)
    outcome = bench.run()
    assert outcome.kind == REFUSED and outcome.error.code == "parport-error-90" and bench.controller.lines == []
