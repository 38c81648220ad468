# SPDX-License-Identifier: LGPL-2.1-or-later
"""A job whose machine homes itself first, on a virtual board that is locked until it has."""

from __future__ import annotations

import pytest

from CNCStepper.control.operator.homing import HOME
from CNCStepper.control.program.send_job import SendJob
from CNCStepper.control.protocol.grbl.driver import RESET
from CNCStepper.control.service.sender import Sender
from CNCStepper.control.session.status import DONE, REFUSED, STOPPED, Outcome
from helpers.control.service_bench import Person, Table

LINES = ("G21G90G54", "G1X-40Y-30F1000", "G1X-42")


class Bench:
    def __init__(self, home_first: bool, **table):
        self.table = Table(**table)
        self.sender = Sender(
            SendJob("table", LINES, zero_confirmed=True, home_first=home_first),
            opener=lambda name, baud: self.table,
            clock=self.table.clock,
        )

    def run(self) -> Outcome:
        return self.sender.run()

    @property
    def lines(self) -> list[bytes]:
        return b"".join(data for _, data in self.table.written).split(b"\n")


@pytest.mark.slow
def test_locked_machine_homes_itself_and_cuts() -> None:
    bench = Bench(True, homing=True)
    outcome = bench.run()
    assert outcome.kind == DONE, outcome.text
    assert b"$H" in b"".join(bench.lines[: bench.lines.index(LINES[0].encode())])
    assert abs(bench.table.x_mm() + 42) < 0.02


def test_locked_machine_is_refused_without() -> None:
    outcome = Bench(False, homing=True).run()
    assert outcome.kind == REFUSED and "machine-alarm" in outcome.text


def test_machine_that_cannot_home_is_refused_in_words() -> None:
    outcome = Bench(True).run()
    assert outcome.kind == REFUSED and "homing is not enabled" in outcome.text


def test_stop_while_it_homes_stops_the_axes_and_the_place_is_unknown() -> None:
    bench = Bench(True, homing=True)

    def person() -> Person:
        yield lambda: bench.table.board.state.value == "Home"
        yield 0.5
        bench.sender.stop()

    bench.table.person = person()
    outcome = bench.run()
    assert outcome.kind == STOPPED and not outcome.position_known
    assert bench.table.sent(RESET)


class Changes(Bench):
    """A bench on whose wire one line of the sender becomes another one."""

    def __init__(self, line: bytes, other: bytes):
        super().__init__(True, homing=True)
        to_board = self.table._wire.send
        self.table._wire.send = lambda data: to_board(data.replace(line, other))


@pytest.mark.parametrize("other", [b"$X\n", b"$I\n", b"$\n", b"\n"])
def test_homing_that_reached_the_machine_as_another_line_is_not_believed(other: bytes) -> None:
    bench = Changes(HOME.encode() + b"\n", other)
    outcome = bench.run()
    assert outcome.kind == REFUSED and not outcome.position_known
    assert outcome.error and outcome.error.code == "homing-not-made"
    assert bench.table.sent(RESET) and LINES[0].encode() not in bench.lines


def test_answer_too_many_before_the_homing_does_not_end_it() -> None:
    outcome = Changes(b"$\n", b"$\n\n").run()
    assert outcome.kind == REFUSED and not outcome.position_known


def test_machine_that_moves_is_not_reset_but_refused() -> None:
    bench = Bench(True, homing=True)
    bench.table.board.receive(b"$X\nG1X-5F300\n")
    for _ in range(10):
        bench.table.pass_time(0.01)
    outcome = bench.run()
    assert outcome.kind == REFUSED and outcome.error and outcome.error.code == "machine-run"
    assert not bench.table.sent(RESET)
