# SPDX-License-Identifier: LGPL-2.1-or-later
"""The wire text of a stretch: read back after a reset it is the stretch, in the state that a reset has taken away."""

from __future__ import annotations

import random
from dataclasses import replace
from math import dist

import numpy as np
import pytest

from CNCStepper.control.stream.return_after_jog import over
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.gcode.wire.wire_text import check_wire_line
from CNCStepper.recovery.retract.places_on_path import Place, RetractPath, stretch_moves
from CNCStepper.recovery.retract.wire_writer import head_lines, modes_line, output_lines, over_lines, way_lines
from CNCStepper.state import Start

START = replace(Start.at_zero(), work_offsets_mm={"G55": (-100.0, -50.0, -20.0)})
PROGRAM = """G21 G90 G55
G92 X1 Y2 Z3
G43.1 Z1.5
M3 S8000 M8
G0 X10 Y0 Z5
G1 Z-1 F300
G2 X10 Y0 I-2 F900
G18 G3 X6 Z-1 I-2 K0
G19 G2 Y-4 Z-1 J-2 K0
G17 G2 X6 Y-4 I1.5 Z-3
G1 X5.9995
G3 X5.9985 Y-4 I-.0005
G1 X2
"""
SEEDS = range(20)


@pytest.fixture(scope="module")
def way() -> RetractPath:
    return RetractPath(interpret(PROGRAM, START))


def some_place(way: RetractPath, rng: random.Random) -> Place:
    return Place(rng.randrange(1, len(way)), rng.choice((0.0, 1.0, 1e-7, rng.random())))


@pytest.mark.parametrize("seed", SEEDS)
def test_text_read_back_is_the_stretch(way: RetractPath, seed: int) -> None:
    rng = random.Random(seed)
    begin, end = some_place(way, rng), some_place(way, rng)
    state = way.toolpath.states[int(way.toolpath.table().state[begin.row])]
    at = way.move(begin.row).at(begin.share)
    lines, parts = way_lines(stretch_moves(way, begin, end), state)
    head = head_lines(state, at) + output_lines(state, 3.0)
    for line in [*head, *lines]:
        check_wire_line(line)
    read = RetractPath(interpret("\n".join([*head, *lines]), replace(START, position_mm=at, work_system="G54")))
    for number, (row, first, last) in enumerate(parts):
        own = read.move(int(read.rows_of(len(head) + number + 1)[0]))
        for share in (0.0, 0.3, 1.0):
            wanted = way.move(row).at(first + (last - first) * share)
            assert dist(own.at(share), wanted) < 0.001


def test_head_brings_back_what_a_reset_takes(way: RetractPath) -> None:
    state = way.toolpath.states[-1]
    head = head_lines(state, (-90.0, -48.0, -10.0)) + output_lines(state, 3.0)
    read = interpret("\n".join(head), replace(START, position_mm=(-90.0, -48.0, -10.0))).states[-1]
    assert read.offset_mm == pytest.approx(state.offset_mm) and read.g92_mm == pytest.approx(state.g92_mm)
    assert (read.spindle, read.spindle_rpm, read.flood) == ("cw", 8000.0, True)
    assert read.tool_length_mm == 1.5 and read.work_system == "G55"
    assert "G4P3" in head
    off = head_lines(state, (0.0, 0.0, 0.0))
    assert not any("M3" in line or "M8" in line or "G4P" in line for line in off)


def test_modes_are_those_of_the_program() -> None:
    path = interpret("G20G91G18G94\nG1X1F10\nM3S500\nM5\nG1X1\n", Start.at_zero())
    state = path.states[-1]
    assert modes_line(state, state.feed_mm_min) == "G20G91G18G94F10S500"
    read = interpret(modes_line(state, state.feed_mm_min), Start.at_zero()).states[-1]
    assert (read.units, read.distance, read.plane, read.feed_mm_min) == ("inch", "incremental", "ZX", 254.0)


def test_way_over_is_in_work_coordinates_and_higher_than_both_ends(way: RetractPath) -> None:
    state = way.toolpath.states[-1]
    here, there = (-90.0, -48.0, -10.0), (-80.0, -48.0, -12.0)
    text = "\n".join([*head_lines(state, here), *over_lines(over(here, there, -5.0), state)])
    ends = interpret(text, replace(START, position_mm=here)).table().end[:, :3]
    assert ends == pytest.approx(np.array([(-90.0, -48.0, -5.0), (-80.0, -48.0, -5.0), there]), abs=0.001)
