# SPDX-License-Identifier: LGPL-2.1-or-later
"""The line that is told as done is cut, not only taken by the controller, which plans many lines ahead."""

from __future__ import annotations

from math import floor

import pytest

from CNCStepper.virtual.grbl.firmware import FIRMWARES
from helpers.control.service_bench import Visit

STEP_MM = 0.03
LINES = ("G21G90G94F1200", *(f"G1X-{number}" for number in range(1, 61)))


def lines_passed(x_mm: float) -> set[int]:
    """Return how many of LINES lie behind a place, both numbers where it is at the end of one."""
    return {1 + floor(-x_mm + near_mm) for near_mm in (-STEP_MM, STEP_MM)}


@pytest.mark.parametrize("firmware", FIRMWARES.values(), ids=lambda firmware: firmware.name)
def test_line_done_is_the_one_behind_the_tool(tmp_path, firmware):
    visit = Visit(tmp_path, firmware=firmware)
    seen = []

    def person():
        visit.job(*LINES)
        yield lambda: visit.table.x_mm() < -20.4
        visit.ask("hold")
        yield visit.at("held")
        yield 0.5
        seen.append((visit.table.x_mm(), visit.service.status()))
        visit.ask("resume")
        yield visit.ended()

    visit.receive(person)
    x_mm, held = seen[0]
    assert held.file_line in lines_passed(x_mm) and held.file_line + 5 < held.acknowledged <= held.file_line_sent
    end = visit.outcomes[0].status
    assert visit.outcomes[0].done and end.file_line == end.acknowledged == len(LINES) and end.done == 1.0


def test_all_before_a_pause_is_done(tmp_path):
    visit = Visit(tmp_path)
    seen = []

    def person():
        visit.job(*LINES[:9], "M0", *LINES[9:12])
        yield visit.at("paused")
        yield 0.5
        seen.append(visit.service.status().file_line)
        visit.ask("resume")
        yield visit.ended()

    visit.receive(person)
    assert seen == [9] and visit.outcomes[0].done


def test_where_the_path_is_not_known_only_lines_that_left_the_planner_are_done(tmp_path):
    visit = Visit(tmp_path)
    passed = []

    def look(data: bytes) -> None:
        status = visit.service.status()
        passed.append((max(lines_passed(visit.table.x_mm())), status.file_line, status.acknowledged))

    def person():
        visit.job(LINES[0], "$G", *LINES[1:])
        yield visit.at("running")
        visit.table.on_write = look
        yield visit.ended()

    visit.receive(person)
    assert any("not compared" in text for _, text in visit.told) and visit.outcomes[0].done
    assert all(line <= behind + 1 for behind, line, _ in passed), passed
    assert any(0 < line < taken for _, line, taken in passed), passed
    assert visit.outcomes[0].status.file_line == len(LINES) + 1


def test_remaining_time_goes_by_what_is_cut(tmp_path):
    visit = Visit(tmp_path)
    seen = []

    def person():
        visit.job(*LINES, plan=[[number, 0.05 * number] for number in range(1, len(LINES) + 1)])
        yield lambda: visit.table.x_mm() < -30.4
        seen.append((visit.table.x_mm(), visit.service.status()))
        yield visit.ended()

    visit.receive(person)
    x_mm, status = seen[0]
    assert status.done == pytest.approx(-x_mm / 60, abs=0.1)
    assert status.remaining_s == pytest.approx((60 + x_mm) * 0.05, rel=0.4)
