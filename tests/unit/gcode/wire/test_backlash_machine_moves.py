# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines that go to a place of the machine, sent as written on axes that have play: where the tool is then."""

from __future__ import annotations

import random
from dataclasses import replace

import numpy as np
import pytest

from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.gcode.wire.encoder import prepare
from CNCStepper.gcode.wire.read_back import read_back
from CNCStepper.machine.backlash import Backlash
from CNCStepper.recovery.retract.places_on_path import RetractPath
from CNCStepper.state import Start
from helpers.gcode.backlash_programs import program_of_places, pushed

PLAY = Backlash((0.05, 0.1, 0.02), (-1, 1, -1), (80.0, 80.0, 400.0))
STEP_MM = 0.018  # of X, Y and Z at once
HOMES_MM = {5161: (3.0, 4.0, 9.0), 5181: (-6.0, 7.0, 2.0)}
AT_ZERO = replace(
    Start.at_zero(), parameters={first + axis: place[axis] for first, place in HOMES_MM.items() for axis in range(3)}
)
MODES = "G21 G90 G17\nG1 F300\n"


def sent(text: str, start: Start = AT_ZERO) -> list[str]:
    return list(prepare(MODES + text, "grbl", "", start, PLAY).lines)[2:]


def test_tool_that_was_left_short_comes_to_its_place_before_the_next_feed_move() -> None:
    assert sent("X-5\nG53 G0 X3\nG1 Y5") == ["X-5", "G53G0X3", "G1X3.05", "G1Y5"]
    assert sent("X5\nG53 G0 X5.02\nG1 Y3")[2:] == ["G53G0X5.02", "G1X5.07", "G1Y3"]


def test_axis_that_goes_on_alone_needs_no_travel_beyond_its_place() -> None:
    assert sent("Z-5\nG53 G0 Z0\nG0 X-5\nG1 Z-3") == ["Z-5", "G53G0Z0", "G0X-5", "G1Z-3"]


def test_gaps_are_crossed_before_several_axes_set_out() -> None:
    assert sent("X-5\nG53 G0 X3 Y4\nG1 X2 Y6") == ["X-5", "G0X-4.95", "G53G0X3Y4", "G1X3.05", "G1X3", "G1X2Y6"]
    assert sent("X-5\nG53 G0 X-4.98 Y4")[1:] == ["G0X-4.98", "G53G0X-4.98Y4"]


def test_arrival_in_the_true_sense_leaves_nothing_to_take_up() -> None:
    assert sent("X5\nG53 G0 X-3\nG1 Y5")[2:] == ["G53G0X-3", "G1Y5"]


def test_home_is_gone_to_by_way_of_the_point_between() -> None:
    assert sent("X-5\nG28 X4\nG1 Y5") == ["X-5", "G28X4", "G1Y5"]
    assert sent("X5\nG91 G30 X13\nG90 G1 Y5")[2:] == ["G91G30X13", "G90G1Y5"]
    assert sent("X-5\nG28 X-5\nG1 Y5") == ["X-5", "G28X-5", "G1X3.05", "G1Y5"]


def test_place_that_nobody_knows_leaves_an_axis_to_be_approached() -> None:
    unknown = replace(Start(), work_offsets_mm={})
    lines = sent("G0 X5 Y5 Z5\nG53 G0 X-3\nG1 Y7\nX1 Y8", unknown)
    assert lines[2:] == ["G53G0X-3", "G1Y7", "X1.05Y8", "G1X1Y8"]


def test_place_that_is_named_is_where_the_motor_stands() -> None:
    assert sent("X-5\nG53 G0 X3\nG92 X0\nG1 Y5") == ["X-5", "G53G0X3", "G92X0", "G1X0.05", "G1Y5"]


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(8))
def test_every_feed_move_begins_and_ends_with_the_tool_where_the_text_says(seed: int) -> None:
    print("seed", seed)
    text = program_of_places(random.Random(seed), 20, ("G0", "G1", "G1", "G53G0", "G53G1", "G28", "G30"))
    motors, wanted = read_back(prepare(text, "grbl", "", AT_ZERO, PLAY), text, AT_ZERO), interpret(text, AT_ZERO)
    way, own, tool_mm, judged = RetractPath(motors), RetractPath(wanted), np.zeros(3), 0
    for number, line in enumerate(text.splitlines(), 1):
        rows = way.rows_of(number)
        for row in rows:
            begin_mm, points = tool_mm, pushed(PLAY, tool_mm, [way.move(row)])
            tool_mm = points[-1]
            if row != rows[-1] or not line.startswith(("G1", "G53")):
                continue
            length, off = np.linalg.norm(tool_mm - begin_mm), np.cross(points - begin_mm, tool_mm - begin_mm)
            assert length < STEP_MM or np.linalg.norm(off, axis=1).max() / length < STEP_MM, "no straight way"
            if line.startswith("G1"):
                move = own.move(own.rows_of(number)[-1])
                assert tool_mm == pytest.approx(move.end, abs=STEP_MM)
                moved = np.abs(np.subtract(move.end, move.begin)) > STEP_MM
                at_place = np.abs(np.subtract(begin_mm, move.begin)) < STEP_MM
                assert at_place.all() or ((at_place | moved).all() and moved.sum() == 1)
                judged += 1
    assert judged > 0
