# SPDX-License-Identifier: LGPL-2.1-or-later
"""Back along the cut and on from the table's own buttons: shown, taken up by a client, or refused in the end."""

from __future__ import annotations

from pathlib import Path

import pytest

from CNCStepper.machine.profile import Machine, load_machine
from CNCStepper.machine.wiring import Input
from helpers.control.retract_bench import Cut
from helpers.control.retract_programs import THRICE
from helpers.control.service_bench import Visit

pytestmark = pytest.mark.slow
BUTTONS = Input(pin="P", act="back", back_mm=2.0), Input(pin="X", act="start")
TAP_S = 0.4


@pytest.fixture
def machine() -> Machine:
    return load_machine("table-a").model_copy(update={"input": BUTTONS})


def tap(cut: Cut | Visit, pin: str):
    """Press a button of the table for a while, as a finger does."""
    board = cut.table.board
    board.press(pin)
    yield TAP_S
    board.release(pin)
    yield TAP_S


def found(cut: Cut):
    held = []
    yield from cut.find(held)
    return held[0]


def test_each_press_wants_the_tool_farther_back_and_start_wants_the_rest(machine: Machine, tmp_path: Path) -> None:
    cut, wanted = Cut(tmp_path, THRICE, machine), []
    now = lambda: wanted.append((cut.sender.status().wanted_back_mm, cut.sender.status().wanted_rest))  # noqa: E731

    def person():
        yield 4.0
        for _ in range(2):
            yield from tap(cut, "P")
            yield cut.arrived
            now()
        held = yield from found(cut)
        now()
        yield from cut.go(held.along(held.back_by(4.0)))
        yield cut.arrived
        yield from tap(cut, "X")
        now()
        yield from cut.go((yield from found(cut)).rest())
        now()

    outcome = cut.run(person)
    assert outcome.done and not cut.refused, outcome.text
    assert wanted == [(2.0, False), (4.0, False), (None, False), (None, True), (None, False)]


def test_press_on_the_way_back_holds_there_and_wants_more(machine: Machine, tmp_path: Path) -> None:
    cut, wanted = Cut(tmp_path, THRICE, machine), []

    def person():
        yield 4.0
        yield from tap(cut, "P")
        yield cut.arrived
        held = yield from found(cut)
        yield from cut.go(held.along(held.back_by(20.0)))
        yield 3.5  # the spindle is up, the way begun
        yield from tap(cut, "P")
        yield lambda: cut.phase == "held"
        wanted.append(cut.sender.status().wanted_back_mm)
        yield from cut.go((yield from found(cut)).rest())

    assert cut.run(person).done and not cut.refused
    assert wanted == [2.0]


def test_wish_that_nobody_takes_up_is_refused_and_start_goes_on(machine: Machine, tmp_path: Path) -> None:
    cut = Cut(tmp_path, THRICE, machine)

    def person():
        yield 4.0
        yield from tap(cut, "P")
        yield lambda: bool(cut.refused)
        assert cut.phase == "held" and cut.sender.status().wanted_back_mm is None
        yield from tap(cut, "X")

    assert cut.run(person).done
    assert [error.code for error in cut.refused] == ["retreated"]


def test_start_after_a_press_of_back_forgets_it(machine: Machine, tmp_path: Path) -> None:
    cut = Cut(tmp_path, THRICE, machine)

    def person():
        yield 4.0
        yield from tap(cut, "P")
        yield cut.arrived
        yield from tap(cut, "X")
        assert cut.sender.status().wanted_back_mm is None

    assert cut.run(person).done and not cut.refused


def test_button_back_of_a_table_without_a_job_is_refused(tmp_path: Path) -> None:
    visit = Visit(tmp_path)

    def person():
        visit.job("G21G90G94", "G1X-1F1500", inputs=[entry.model_dump(mode="json") for entry in BUTTONS])
        yield visit.ended()
        yield from tap(visit, "P")

    visit.receive(person)
    assert visit.refusals() == ["not-held"]
