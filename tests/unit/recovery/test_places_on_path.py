# SPDX-License-Identifier: LGPL-2.1-or-later
"""Places on a way: back and forward by lengths, to lines and entries, never over what cannot be undone."""

from __future__ import annotations

import pytest

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.recovery.retract.places_on_path import Place, RetractPath
from CNCStepper.state import Start

PROGRAM = """G21 G90
G0 Z5
G0 X10 Y0
G1 Z0 F100
G1 Z-1
X20
Y10
G2 X20 Y10 I-5 Z-2
G1 X10
G0 Z5
X0
"""
RISES, PLUNGE, HELIX = 0, 3, 6  # rows


@pytest.fixture(scope="module")
def way() -> RetractPath:
    return RetractPath(interpret(PROGRAM, Start.at_zero()))


def test_back_and_forward_by_the_same_length_is_the_same_place(way: RetractPath) -> None:
    last = Place(HELIX + 1, 0.5)
    for length_mm in (0.0, 1.0, 4.99, 20.0, 36.0, 41.0):
        back = way.back_by(last, length_mm)
        assert way.forward_by(back, length_mm, last) == pytest.approx(last)


def test_back_by_more_than_there_is_ends_at_the_begin(way: RetractPath) -> None:
    assert way.back_by(Place(HELIX, 0.5), 1e6) == (0, 0.0)
    assert way.forward_by(Place(0, 0.0), 1e6, Place(HELIX, 0.5)) == (HELIX, 0.5)


def test_entry_is_the_begin_of_the_last_way_down(way: RetractPath) -> None:
    assert way.last_entry(Place(HELIX - 1, 0.5)) == (PLUNGE - 1, 0.0)  # both plunges
    assert way.last_entry(Place(HELIX + 1, 0.5)) == (HELIX, 0.0)
    assert way.last_entry(Place(PLUNGE, 0.5)) == (PLUNGE - 1, 0.0)


def test_stretch_runs_through_every_row_between(way: RetractPath) -> None:
    assert list(way.stretch(Place(3, 0.5), Place(5, 0.25))) == [(3, 0.5, 1.0), (4, 0.0, 1.0), (5, 0.0, 0.25)]
    assert list(way.stretch(Place(5, 0.25), Place(3, 0.5))) == [(5, 0.25, 0.0), (4, 1.0, 0.0), (3, 1.0, 0.5)]
    assert list(way.stretch(Place(5, 0.0), Place(4, 0.5))) == [(4, 1.0, 0.5)]


def test_no_way_leads_back_over_a_change_of_tool_or_from_nowhere() -> None:
    changed = RetractPath(interpret("G21G90\nG0X1\nG1X2F100\nT1M6\nG1X3\nX4\nM2\n", Start.at_zero(), "linuxcnc"))
    assert changed.back_by(Place(3, 0.5), 99.0) == (2, 0.0)
    unknown = RetractPath(interpret("G21G90\nG0Z5\nG0X1Y1\nG1X2F100\n"))
    assert unknown.back_by(Place(2, 0.5), 99.0) == (2, 0.0)
    with pytest.raises(ProgramError, match="retreat-unknown"):
        unknown.back_by(Place(0, 0.5), 1.0)
