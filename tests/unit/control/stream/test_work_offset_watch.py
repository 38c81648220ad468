# SPDX-License-Identifier: LGPL-2.1-or-later
"""A work zero that changes while a program runs: what the program itself changes is no fault, all else is one."""

from __future__ import annotations

import pytest

from CNCStepper.control.session.status import DONE
from CNCStepper.control.stream.work_offset_watch import OffsetWatch
from helpers.control.workshop import Workshop

SYSTEMS = ("G54", "G55", "G56", "G57", "G58", "G59")
ENDS = ("M2", "M30", "M02", "G1X-4M30")
ZERO_MM, OTHER_MM = (-1.0, -2.0, 0.0), (0.0, 0.0, 0.0)
# Each leaves an offset behind that the program's end takes away, or a reset before it.
LEFT = {
    "tool length": ("G43.1Z1", "G1X-2F2000"),
    "G92": ("G92X0Y0Z0", "G1X-2F2000"),
    "both, in another system": ("G55", "G43.1Z1", "G92X0Y0Z0", "G1X-2F2000"),
}


@pytest.fixture
def shop(tmp_path) -> Workshop:
    workshop = Workshop(tmp_path)
    workshop.greet_nobody()
    for number, place in workshop.board.memory.places.items():
        if 54 <= number <= 59:
            place[:] = [54.0 - number, 0.0, 0.0]
    return workshop


def cut(shop: Workshop, *lines: str) -> str:
    outcome = shop.send(lines=("G21G90G94", *lines))
    assert outcome.kind == DONE, outcome.text
    return outcome.text


@pytest.mark.parametrize("end", ENDS)
@pytest.mark.parametrize("system", SYSTEMS)
def test_a_program_in_any_work_system_may_end(shop, system, end):
    cut(shop, system, "G1X-3Y-3Z-1F2000", "X-2", "G4P.5", end)
    assert shop.board.axes.position_mm[1] == -3.0


@pytest.mark.parametrize("end", ["M2", "M30"])
@pytest.mark.parametrize("left", LEFT)
def test_an_offset_that_is_left_ends_with_the_program(shop, left, end):
    cut(shop, *LEFT[left], "G4P.5", end)


@pytest.mark.parametrize(
    ("line", "is_own"),
    [("M2", True), ("m030", True), ("M 3 0", True), ("T1M6", True)]
    + [(line, False) for line in ("G1X-2", "M20", "M3S200", "M300", "M62P1", "G1X2M5", "G0X30")],
)
def test_only_a_line_that_may_change_the_zero_excuses_a_change(line, is_own):
    watch = OffsetWatch(["G90", line], ZERO_MM)
    changed = watch.take(OTHER_MM, acknowledged=2, sent=2)
    assert changed == (None if is_own else (ZERO_MM, OTHER_MM))
