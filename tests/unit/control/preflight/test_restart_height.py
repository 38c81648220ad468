# SPDX-License-Identifier: LGPL-2.1-or-later
"""A restart goes up first: it is not sent while the tool stands above the height at which it crosses the work."""

from __future__ import annotations

from typing import Any

import pytest

from CNCStepper.control.program.send_job import SendJob
from CNCStepper.control.service.sender import Sender
from CNCStepper.control.session.status import DONE, REFUSED, Outcome
from helpers.control.service_bench import Table

LINES = ("G21G90G54", "G0Z5", "X-10", "G1Z4F600")
LIFT = {"system": "G54", "z_mm": 5.0, "height_mm": 5.0}
ZERO_AT_MM = -60.0  # machine Z of G54


def sent(table: Table, told: list[str], **job: Any) -> Outcome:
    table.board.receive(f"$X\nG10L2P1Z{ZERO_AT_MM}\n".encode("ascii"))
    table.pass_time(0.5)
    table.written.clear()
    sender = Sender(
        SendJob("table", LINES, zero_confirmed=True, **job),
        opener=lambda name, baud: table,
        clock=table.clock,
        tell=lambda kind, text: told.append(text),
    )
    return sender.run()


def moved(table: Table) -> bool:
    return b"G0Z5" in b"".join(data for _, data in table.written)


def test_a_tool_that_stands_higher_is_not_sent_down() -> None:
    table = Table()
    outcome = sent(table, [], lift=LIFT)
    assert outcome.kind == REFUSED and outcome.error and outcome.error.code == "restart-above"
    assert "stands at Z 60.000, and the restart goes straight down to Z 5.000 first" in outcome.text
    assert "the height 60.0" in outcome.text
    assert not moved(table)


@pytest.mark.parametrize(
    "lift",
    [
        {},
        {"system": "G54", "z_mm": 60.0, "height_mm": 60.0},
        {"system": "G54", "z_mm": 90.0, "height_mm": 60.0},  # with a tool of 30 mm
        {"system": "G55", "z_mm": 5.0, "height_mm": 5.0},  # whose zero is higher
    ],
)
def test_one_that_stands_below_goes_up(lift: dict[str, Any]) -> None:
    table = Table()
    assert sent(table, [], lift=lift).kind == DONE
    assert moved(table)


@pytest.mark.slow
def test_a_machine_that_has_just_homed_goes_down_and_says_so() -> None:
    table, told = Table(homing=True), list[str]()
    assert sent(table, told, lift=LIFT, home_first=True).kind == DONE
    assert any("goes straight down first" in text for text in told)
