# SPDX-License-Identifier: LGPL-2.1-or-later
"""A program that lets the machine cut its corners is told so, with how far; one that does not, is not."""

from __future__ import annotations

import pytest

from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.machine.profile import load_machine
from CNCStepper.simulation.checks.check_program import check
from CNCStepper.simulation.finding import Finding
from CNCStepper.state import Start

MACHINE = load_machine("table-a")


def corners(text: str) -> list[Finding]:
    path = interpret(f"G21 G90 G17 G94\nM3 S100\nG4 P3\n{text}\nM2\n", Start.at_zero(), "linuxcnc", "job.ngc")
    return [finding for finding in check(path, MACHINE, file="job.ngc") if finding.code == "corners-cut"]


def test_the_widest_tolerance_is_named_at_its_first_corner() -> None:
    (found,) = corners("G64 P0.02\nG1 X-1 F500\nY-1\nG64 P0.3\nX-2\nY-2\nX-3\nG61\nY-3")
    assert (found.severity, found.place.line, found.value, found.unit, found.count) == ("warning", 8, 0.3, "mm", 4)
    assert "0.3 mm" in str(found) and "programmed path" in str(found)


def test_inches_are_told_in_mm() -> None:
    (found,) = corners("G20\nG64 P0.01\nG1 X-0.1 F20\nY-0.1")
    assert found.value == pytest.approx(0.254)


def test_a_tolerance_that_nobody_has_named_is_told_too() -> None:
    (found,) = corners("G64\nG1 X-1 F500\nY-1")
    assert found.value is None and "does not say how far" in found.text and found.place.line == 5


@pytest.mark.parametrize(
    "text",
    [
        "G61\nG1 X-1 F500\nY-1",
        "G61.1\nG1 X-1 F500\nY-1",
        "G64 P1\nG0 X-1\nY-1",
        "G64 P1\nG1 X-1 F500\nG0 Y-1",
        "G64 P1",
    ],
)
def test_where_no_corner_may_be_cut_nothing_is_told(text: str) -> None:
    assert corners(text) == []
