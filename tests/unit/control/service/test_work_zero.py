# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the work zero is, as a service tells it, and when that is a place on the table."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import pytest

from CNCStepper.control.service.work_zero import start_of
from CNCStepper.control.session.status import SenderStatus
from CNCStepper.state import Start
from helpers.control.service_bench import Visit

OFFSETS = {"G54": (-200.0, -150.0, -30.0), "G55": (0.0, 0.0, 0.0), "G28": (1.0, 1.0, 1.0), "G92": (0.0, 0.0, 0.0)}
KNOWN = SenderStatus(phase="idle", homed=True, work_system="G54", work_offsets_mm={**OFFSETS, "TLO": (0.0,)})


@pytest.fixture
def visit(tmp_path: Path) -> Visit:
    return Visit(tmp_path, homing=True)


def home(visit: Visit):
    visit.ask("home")
    yield visit.at("homing")
    yield visit.at("idle")


def test_a_homed_machine_tells_its_start() -> None:
    start = start_of(KNOWN)
    assert start is not None and start.zero_known
    assert start.work_offsets_mm == {"G54": (-200, -150, -30), "G55": (0, 0, 0)} and start.g92_mm == (0, 0, 0)
    assert start == start_of(replace(KNOWN, mpos_mm=(1.0, 2.0, 3.0)))  # a jog changes nothing of it


@pytest.mark.parametrize(
    "change",
    [
        {"homed": False},
        {"work_offsets_mm": None},
        {"work_system": ""},
        {"work_system": "G59"},
        {"work_offsets_mm": {**OFFSETS, "TLO": (2.0,)}},
    ],
)
def test_what_is_not_known_is_no_start(change: dict) -> None:
    assert start_of(replace(KNOWN, **change)) is None
    assert start_of(None) is None


def test_a_status_keeps_its_zero_on_its_way() -> None:
    assert SenderStatus.from_json(json.loads(json.dumps(KNOWN.to_json()))) == KNOWN
    assert SenderStatus.from_json(json.loads(json.dumps(SenderStatus().to_json()))) == SenderStatus()


@pytest.mark.slow
def test_homing_gives_the_place_and_a_new_zero_moves_it(visit: Visit) -> None:
    seen: list[Start | None] = [start_of(visit.service.status())]

    def person():
        seen.append(start_of(visit.service.status()))
        yield from home(visit)
        seen.append(start_of(visit.service.status()))
        visit.ask("jog", x_mm=-20.0)
        yield visit.at("jogging")
        yield visit.at("idle")
        visit.ask("set_zero", axes="XYZ")
        yield lambda: start_of(visit.service.status()) != seen[-1]
        seen.append(start_of(visit.service.status()))

    visit.receive(person)
    assert seen[:2] == [None, None]
    before, after = seen[2:]
    assert before is not None and after is not None and after.work_system == "G54"
    assert before.work_offsets_mm["G54"] == (0, 0, 0)
    assert after.work_offsets_mm["G54"] == pytest.approx(visit.table.board.memory.places[54], abs=0.001)
    assert after.work_offsets_mm["G54"][0] < -19
    assert visit.refused == []


@pytest.mark.slow
def test_a_zero_in_inches_is_told_in_mm(tmp_path: Path) -> None:
    visit = Visit(tmp_path, homing=True, settings={13: 1})
    visit_seen: list[Start | None] = []

    def person():
        yield from home(visit)
        visit.ask("jog", x_mm=-25.4)
        yield visit.at("jogging")
        yield visit.at("idle")
        before = start_of(visit.service.status())
        visit.ask("set_zero", axes="XYZ")
        yield lambda: start_of(visit.service.status()) != before
        visit_seen.append(start_of(visit.service.status()))

    visit.receive(person)
    assert visit_seen[0] is not None
    assert visit_seen[0].work_offsets_mm["G54"] == pytest.approx(visit.table.board.memory.places[54], abs=0.003)


@pytest.mark.slow
def test_a_program_that_sets_the_zero_is_read_back(visit: Visit) -> None:
    seen: list[Start | None] = []

    def person():
        yield from home(visit)
        visit.job("G10L2P1X-33", "G55")
        yield visit.ended()
        yield lambda: (visit.service.status().work_offsets_mm or {})["G54"][0] == -33
        seen.append(start_of(visit.service.status()))

    visit.receive(person)
    assert seen[0] is not None and seen[0].work_system == "G55"


def test_a_machine_without_switches_never_has_a_place(tmp_path: Path) -> None:
    visit = Visit(tmp_path)
    seen: list[SenderStatus] = []

    def person():
        visit.ask("set_zero", axes="XYZ")
        yield lambda: visit.service.status().position_known is True
        seen.append(visit.service.status())

    visit.receive(person)
    assert seen[0].work_offsets_mm and seen[0].homed is False and start_of(seen[0]) is None


def test_an_unlocked_machine_has_no_place(visit: Visit) -> None:
    seen: list[SenderStatus] = []

    def person():
        visit.ask("unlock")
        yield visit.at("idle")
        visit.ask("set_zero", axes="XYZ")
        yield lambda: visit.service.status().position_known is True
        seen.append(visit.service.status())

    visit.receive(person)
    assert start_of(seen[0]) is None


@pytest.mark.slow
def test_a_stopped_job_keeps_the_place_and_a_reset_board_loses_it(visit: Visit) -> None:
    seen: list[bool] = []

    def person():
        yield from home(visit)
        visit.job("G1X-50F500")
        yield visit.at("running")
        yield 0.5
        visit.ask("stop")
        yield visit.ended()
        seen.append(visit.service.status().homed)
        visit.table.board.reset()
        yield lambda: visit.service.status().homed is False
        seen.append(visit.service.status().homed)

    visit.receive(person)
    assert seen == [True, False]
