# SPDX-License-Identifier: LGPL-2.1-or-later
"""Play that is taken up in the wire text, and the proof of it: the tool goes where the program says."""

from __future__ import annotations

import random
import re
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.dialects import dialect, dialect_names
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.gcode.wire.backlash_compensation import backlash_of
from CNCStepper.gcode.wire.encoder import prepare
from CNCStepper.gcode.wire.read_back import read_back
from CNCStepper.machine.backlash import Backlash
from CNCStepper.machine.profile import load_machine
from CNCStepper.motion.planner.backlash_moves import tool_moves
from CNCStepper.simulation.tip_segments import segments
from CNCStepper.state import Start
from helpers.gcode.backlash_programs import random_program

PLAY = Backlash((0.05, 0.1, 0.02), (-1, 1, -1), (80.0, 80.0, 400.0))
AT_ZERO = Start.at_zero()
MODES = "G21 G90 G17\nG1 F300\n"


def sent(text: str, start: Start | None = AT_ZERO, play: Backlash = PLAY) -> list[str]:
    return list(prepare(MODES + text, "grbl", "", start, play).lines)[2:]


def test_a_motor_crosses_the_gap_alone_at_the_feed_of_the_move() -> None:
    assert sent("X10\nX4\nX3 F200\nX5") == ["G1X0.05", "X10.05", "G1X10", "X4", "X3F200", "G1X3.05", "X5.05"]


def test_the_feed_of_a_line_holds_for_the_gap_before_it() -> None:
    assert sent("X10 F50\nG93 X4 F3\nG94 X5 F60") == [
        "G1X0.05F50",
        "X10.05F50",
        "G1X10F18",
        "G93X4F3",
        "G1X4.05F1200",  # a minute over 1200: 0.05 mm at 60 mm/min
        "G94X5.05F60",
    ]
    assert sent("X-5\nG20 X0.1 F2")[1:] == ["G1X-4.95F50.8", "G20X0.101969F2"]


def test_a_rapid_crosses_the_gap_as_a_rapid() -> None:
    assert sent("G0 X10\nG1 X4\nG0 X5") == ["G0X0.05", "G0X10.05", "G1X10", "G1X4", "G0X4.05", "G0X5.05"]


def test_a_laser_crosses_the_gap_as_a_rapid_in_which_its_beam_is_off() -> None:
    laser = load_machine("table-a")
    laser = laser.model_copy(update={"spindle": laser.spindle.model_copy(update={"laser": True})})
    play = Backlash((0.05, 0.1, 0.02), (-1, 1, -1), (80.0, 80.0, 400.0), Backlash.of(laser).beam)
    assert sent("X10\nX4", play=play) == ["G0X0.05", "G1X10.05", "G0X10", "G1X4"]


def test_an_axis_is_true_away_from_its_switch() -> None:
    assert sent("Y10\nY4") == ["Y10", "G1Y9.9", "Y3.9"]


def test_moves_smaller_than_a_step_turn_nothing_back() -> None:
    assert sent("X-5\nX-4.999\nX-5.001\nX-6") == ["X-5", "X-4.999", "X-5.001", "X-6"]


def test_a_circle_is_cut_at_its_extremes() -> None:
    assert sent("G2 X0 Y0 I5 J0") == [
        "G1X0.05",
        "G2X5.05Y5I5J0",
        "G1Y4.9",
        "G2X10.05Y-0.1I0J-5",
        "G1X10",
        "G2X5Y-5.1I-5J0",
        "G1Y-5",
        "G2X0Y0I0J5",
    ]


def test_incremental_moves_keep_their_words() -> None:
    assert sent("G91 X5\nX2\nX-3") == ["G1X0.05", "G91X5", "X2", "G1X-0.05", "X-3"]


def test_inverse_time_is_shared_out_over_the_pieces() -> None:
    lines = sent("G93 G3 X-5 Y5 I-5 J0 F6")
    assert lines == ["G93G3X-5Y5I-5J0F6"]
    lines = sent("G93 G3 X-10 Y0 I-5 J0 F6")
    assert lines == ["G93G3X-5Y5I-5J0F12", "G1Y4.9F942.4778", "G3X-10Y-0.1I0J-5F12"]


def test_stops_of_a_line_come_after_its_last_piece_and_its_message_with_them() -> None:
    wire = prepare(MODES + "G2 X0 Y0 I5 J0 M0 (MSG, turn it over)\nM2\n", "grbl", "", AT_ZERO, PLAY)
    assert [line for line in wire.lines if "M0" in line] == ["G2X0Y0I0J5M0"]
    assert {wire.lines[index]: text for index, text in wire.messages.items()} == {"G2X0Y0I0J5M0": "turn it over"}


def test_a_place_is_stored_with_the_motors_where_the_tool_stands() -> None:
    assert sent("X5\nG92 X0\nX2") == ["G1X0.05", "X5.05", "G0X5", "G92X0", "G1X0.05", "X2.05"]


def test_places_of_the_machine_stay_as_written() -> None:
    assert sent("X5\nG53 G0 X-3\nG1 X-4\nX0")[2:] == ["G53G0X-3", "G1X-4", "G1X-3.95", "X0.05"]


def test_from_an_unknown_place_an_axis_arrives_in_its_true_sense() -> None:
    assert sent("G0 Z5\nX1 Y2\nZ4", Start()) == ["G0Z5.02", "G0Z5", "X1.05Y1.9", "G0X1Y2", "Z4"]


@pytest.mark.parametrize("seed", range(16))
def test_the_tool_goes_where_the_program_says(seed: int) -> None:
    print("seed", seed)
    text = random_program(random.Random(seed), 25)
    wire = prepare(text, "grbl", "", AT_ZERO, PLAY)
    motors = read_back(wire, text, AT_ZERO)
    tool, wanted = tool_moves(motors, PLAY), interpret(text, AT_ZERO)
    assert _farthest_mm(wanted, tool) < 0.02  # no more than a step beside the way, here or there
    assert _farthest_mm(tool, wanted) < 0.02
    assert tool.table().end[-1] == pytest.approx(wanted.table().end[-1], abs=2e-5)
    assert set(tool.table().line) == set(wanted.table().line)


@pytest.mark.slow
@pytest.mark.parametrize(("unit", "arm"), [("G21", "0.123204"), ("G20", "0.1237044")])
def test_the_pieces_of_incremental_circles_add_up_to_nothing(unit: str, arm: str) -> None:
    """An arm of more digits than are written, in mm and in inches."""
    text = f"{unit} G91 G17\nG1 F30\n" + f"G2 X0 Y0 I{arm} J0.457\n" * 1000
    lines = list(prepare(text, "grbl", "", AT_ZERO, PLAY).lines)
    for letter in "XY":
        words = [float(number) for number in re.findall(rf"{letter}(-?[0-9.]+)", "".join(lines))]
        assert len(words) > 3000 and abs(sum(words)) < 2e-6, letter


@pytest.mark.parametrize("seed", range(16))
def test_no_motor_turns_back_unless_it_takes_up_play(seed: int) -> None:
    print("seed", seed)
    text = random_program(random.Random(seed), 25)
    motors = read_back(prepare(text, "grbl", "", AT_ZERO, PLAY), text, AT_ZERO)
    tool, begins = tool_moves(motors, PLAY), motors.begins()
    still = np.abs(np.diff(np.vstack([tool.begins()[:1], tool.table().end]), axis=0)).max(axis=1) < 0.0126  # a step
    for axis, gap in enumerate(PLAY.backlash_mm):
        way = motors.table().end[:, axis] - begins[:, axis]
        senses = [(row, np.sign(step)) for row, step in enumerate(way) if abs(step) > 0.013]
        turned = [row for (_, one), (row, other) in pairwise(senses) if one != other]
        assert all(still[row] and abs(way[row]) <= gap + 0.0126 for row in turned), axis


def _farthest_mm(one, other) -> float:
    """Return how far the way of a table comes from that of another."""
    ways, points = segments(other, 0.005), segments(one, 0.005).end
    begin, way = ways.begin, ways.end - ways.begin
    length2 = np.maximum((way**2).sum(axis=1), 1e-18)
    farthest = 0.0
    for point in points:
        share = np.clip(((point - begin) * way).sum(axis=1) / length2, 0.0, 1.0)
        farthest = max(farthest, float(np.sqrt(((begin + share[:, None] * way - point) ** 2).sum(axis=1).min())))
    return farthest


def test_two_lines_that_stand_for_one_are_read_back_as_that_line() -> None:
    text = "(begin operation: slot)\nG21 G90 G17\nG1 X5 F300\nX2\n(finish operation: slot)\nM2\n"
    back = read_back(prepare(text, "grbl", "", AT_ZERO, PLAY), text, AT_ZERO)
    assert back.table().line.tolist() == [3, 3, 4, 4]
    assert [(span.name, span.first, span.last) for span in back.spans] == [("slot", 0, 4)]
    assert [event.line for event in back.events if event.kind == "end"] == [6]


def test_a_program_written_out_is_read_back_too() -> None:
    text = "G21 G90 G17 F300\no1 repeat [3]\nG1 X5\nX2\no1 endrepeat\nM2\n"
    wire = prepare(text, "grblhal", "", AT_ZERO, PLAY)
    again = ["G1X2.05", "G1X5.05", "G1X5", "X2"]
    assert list(wire.lines)[1:] == ["G1X0.05", *again[1:], *again, *again, "M2"]
    tool = tool_moves(read_back(wire, text, AT_ZERO, "grblhal"), PLAY)
    assert tool.table().end[-1].tolist() == [2.0, 0.0, 0.0]


def test_an_error_names_the_line_of_the_file() -> None:
    with pytest.raises(ProgramError) as caught:
        prepare("G21 G90\nG1 X5 F300\nG81 X5 Z-1 R2 F100\nM2\n", "grblhal", "a.nc", AT_ZERO, PLAY)
    assert (caught.value.code, caught.value.place and caught.value.place.line) == ("take-up", 3)


@pytest.mark.parametrize("start", [AT_ZERO, Start()])
def test_a_probe_is_never_made_into_two(start: Start) -> None:
    """No language whose play is taken up has probes; one that had would be refused: the second began on contact."""
    grbl, linuxcnc = dialect("grbl"), dialect("linuxcnc")
    assert not any("G38.2" in one.codes for one in map(dialect, dialect_names()) if not one.compensates_backlash)
    probing = replace(grbl, codes={**grbl.codes, "G38.2": linuxcnc.codes["G38.2"]}, refused={})
    with pytest.raises(ProgramError) as caught:
        prepare("G21 G90 G94\nG38.2 Z-10 F50\n", probing, "", start, PLAY)
    assert (caught.value.code, caught.value.place and caught.value.place.line) == ("take-up", 2)


def test_records_of_the_mini_lathe_are_refused() -> None:
    with pytest.raises(ProgramError, match="backlash cannot be compensated"):
        prepare("N30 G00 X-10. # ?", "mini-lathe", "", AT_ZERO, PLAY)


def test_who_takes_up_play_itself_is_left_alone() -> None:
    machine = load_machine("table-a")
    axes = {name: axis.model_copy(update={"backlash_mm": 0.1}) for name, axis in machine.axis.items()}
    loose = machine.model_copy(update={"axis": axes})
    assert backlash_of(machine, "grbl") is None
    assert backlash_of(loose, "grbl") == Backlash((0.1, 0.1, 0.1), (-1, -1, -1), (80.0, 80.0, 400.0))
    assert backlash_of(loose, "linuxcnc") is None
