# SPDX-License-Identifier: LGPL-2.1-or-later
"""Programs become tables of moves: modes, offsets, arcs, events, spans, ends."""

from __future__ import annotations

from math import isnan, nan, pi

import numpy as np
import pytest

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.gcode.interpreter.line_interpreter import Interpreter
from CNCStepper.gcode.syntax.words import program_lines
from CNCStepper.state import Start
from CNCStepper.toolpath import ARC_CCW, ARC_CW, LINE, RAPID, XY, YZ, ZX

ZERO = Start.at_zero()


def ends(text: str, start: Start = ZERO, dialect: str = "grbl") -> list[list[float]]:
    return interpret(text, start, dialect).table().end.round(6).tolist()


def test_a_plain_program():
    path = interpret("G21 G90\nG0 X1 Y2\nG1 Z-1 F100\nX5 F200\nG2 X7 I1\n", ZERO)
    table = path.table()
    assert table.kind.tolist() == [RAPID, LINE, LINE, ARC_CW]
    assert table.end.tolist() == [[1, 2, 0], [1, 2, -1], [5, 2, -1], [7, 2, -1]]
    assert table.feed.tolist() == [0, 100, 200, 200]
    assert table.line.tolist() == [2, 3, 4, 5]
    assert table.centre[3].tolist() == [6, 2, -1]
    assert table.turns.tolist() == [0, 0, 0, 1]
    assert path.states[table.state[2]].feed_mm_min == 200


def test_inches_and_incremental_words():
    assert ends("G20\nG0 X1\nG91\nX1 Y-.5\nG21\nX1") == [[25.4, 0, 0], [50.8, -12.7, 0], [51.8, -12.7, 0]]
    table = interpret("G20 G1 X1 F10", ZERO).table()
    assert table.feed.tolist() == [254]


def test_absent_words_keep_their_axes_and_unknown_stays_unknown():
    table = interpret("G0 X1\nZ5").table()
    assert table.end[0, 0] == 1 and np.isnan(table.end[0, 1:]).all()
    assert table.end[1, 2] == 5 and isnan(table.end[1, 1])


@pytest.mark.parametrize(
    "plane, words, expected, centre",
    [
        ("G17", "X0 Y10 I-10", (XY, [0, 10, 0]), [0, 0, 0]),
        ("G18", "X0 Z10 I-10", (ZX, [0, 0, 10]), [0, 0, 0]),
        ("G19", "Y5 Z5 J5", (YZ, [10, 5, 5]), [10, 5, 0]),
    ],
)
def test_arcs_in_every_plane(plane, words, expected, centre):
    table = interpret(f"G0 X10 Y0 Z0\n{plane} G3 {words} F100", ZERO).table()
    assert (table.plane[1], table.end[1].tolist()) == expected
    assert table.centre[1].tolist() == centre


def test_helix_full_circle_and_turns():
    table = interpret("G0 X10\nG3 X10 Z-1 I-10 F100\nG2 X10 I-10 P3\nM2", ZERO, "linuxcnc").table()
    assert table.kind.tolist() == [RAPID, ARC_CCW, ARC_CW]
    assert table.end[1].tolist() == [10, 0, -1]
    assert table.turns.tolist() == [0, 1, 3]


@pytest.mark.parametrize("word, centre", [("R10", [10, 0]), ("R-10", [0, 10])])
def test_arcs_by_radius(word, centre):
    table = interpret(f"G0 X0 Y0\nG2 X10 Y10 {word} F100", ZERO).table()
    assert np.allclose(table.centre[1, :2], centre)


def test_absolute_arc_centres():
    table = interpret("G90.1\nG0 X10\nG3 X0 Y10 I0 J0 F100\nM2", ZERO, "linuxcnc").table()
    assert table.centre[1].tolist() == [0, 0, 0]


def test_inverse_time_feed_is_the_length_times_f():
    table = interpret("G0 X0 Y0 Z0\nG93\nG1 X10 F2\nG3 X0 I-5 F1", ZERO).table()
    assert np.allclose(table.feed, [0, 20, 5 * pi])


def test_two_start_states_give_two_results():
    text = "G0 X1 Y2 Z3\nG55\nG0 X1 Y2 Z3"
    plain = Start.at_zero()
    other = Start(
        position_mm=(0, 0, 0),
        work_offsets_mm={"G54": (10, 20, 30), "G55": (-1, 0, 0)},
        g92_mm=(0.5, 0, 0),
        zero_known=True,
    )
    assert ends(text, plain) == [[1, 2, 3], [1, 2, 3]]
    assert ends(text, other) == [[11.5, 22, 33], [0.5, 2, 3]]


def test_the_tool_length_of_the_start_is_used():
    text = "T2 M6\nG43\nG0 Z0\nG49\nG0 Z0\nM2"
    for length in (12.5, 40.0):
        start = Start(position_mm=(0, 0, 0), tool_lengths_mm={2: length})
        assert ends(text, start, "linuxcnc") == [[0, 0, length], [0, 0, 0]]


def test_offsets_of_g10_g92_and_g43_1():
    assert ends("G10 L2 P1 X5\nG0 X1") == [[6, 0, 0]]
    assert ends("G0 X3\nG10 L20 P1 X0\nG0 X1") == [[3, 0, 0], [4, 0, 0]]
    assert ends("G0 X3\nG92 X0\nG0 X1\nG92.1\nG0 X1") == [[3, 0, 0], [4, 0, 0], [1, 0, 0]]
    assert ends("G43.1 Z2\nG0 Z1\nG53 G0 Z0") == [[0, 0, 3], [0, 0, 0]]


def test_an_offset_in_the_state_maps_machine_to_work():
    path = interpret("G10 L2 P1 X5 Z1\nG43.1 Z2\nG92 Y1\nG0 X1 Y1 Z1", ZERO)
    work = path.table().end - path.offsets_mm()
    assert work.tolist() == [[1, 1, 1]]


def test_stored_positions():
    start = Start(position_mm=(0, 0, 0), zero_known=True, parameters={5161: 1, 5162: 2, 5163: 3})
    assert ends("G28", start) == [[1, 2, 3]]
    assert ends("G28 Z10", start) == [[0, 0, 10], [0, 0, 3]]
    assert ends("G0 X7\nG30.1\nG0 X9\nG30") == [[7, 0, 0], [9, 0, 0], [7, 0, 0]]
    with pytest.raises(ProgramError, match="not known"):
        interpret("G28", ZERO)


def test_a_machine_position_is_unknown_where_the_work_zero_is():
    table = interpret("G0 X1 Y1 Z5\nG53 G0 Z0\nG0 Z2").table()
    assert table.end[1, :2].tolist() == [1, 1] and isnan(table.end[1, 2])
    assert table.end[2].tolist() == [1, 1, 2]


def test_states_follow_the_words():
    path = interpret("M3 S5000\nM8\nG0 X1\nG4 P2\nM5\nM9\nG0 X2\n", ZERO)
    first, second = (path.states[index] for index in path.table().state)
    assert (first.spindle, first.spindle_rpm, first.flood, first.mist) == ("cw", 5000, True, False)
    assert (second.spindle, second.flood) == ("off", False)
    (dwell,) = [event for event in path.events if event.kind == "dwell"]
    assert (dwell.index, dwell.value, dwell.line) == (1, 2.0, 4)
    assert path.states[dwell.state].spindle == "cw"


def test_events_and_spans():
    text = (
        "(part one)\n(begin operation: pocket)\nG0 X1\n(finish operation: pocket)\n(MSG, turn it)\nM0\nT3\nG0 X2\nM2\n"
    )
    path = interpret(text, ZERO)
    assert [(event.index, event.kind, event.text) for event in path.events] == [
        (0, "comment", "part one"),
        (1, "message", "turn it"),
        (1, "pause", ""),
        (1, "tool_select", ""),
        (2, "end", ""),
    ]
    assert [(span.kind, span.name, span.first, span.last) for span in path.spans] == [("operation", "pocket", 0, 1)]
    assert path.states[path.table().state[1]].tool == 3


def test_a_message_on_the_line_of_a_pause_is_the_pause_s_text():
    path = interpret("M0 (MSG, clamp it)", ZERO)
    assert [(event.kind, event.text) for event in path.events] == [("pause", "clamp it")]


def test_the_end_switches_off_and_restores_modes():
    path = interpret("G91 G18 G55 G20\nM3 S100 M8\nM2\nX1 F10\n", ZERO)
    state = path.states[path.table().state[0]]
    assert (state.distance, state.plane, state.work_system) == ("absolute", "XY", "G54")
    assert (state.spindle, state.flood, state.units) == ("off", False, "inch")
    assert path.table().kind.tolist() == [LINE]  # grbl reads on, in G1


def test_text_after_the_end_is_not_read_where_the_controller_stops_there():
    assert ends("G0 X1\nM2\nG0 X2\nnonsense", ZERO, "linuxcnc") == [[1, 0, 0]]


def test_percent_signs_frame_a_program():
    assert ends("%\nG0 X1\n%\nnonsense") == [[1, 0, 0]]


def test_block_delete_is_the_dialect_s():
    assert ends("/G0 X1\nG0 X2") == [[2, 0, 0]]
    assert ends("/G0 X1\nG0 X2\nM2", ZERO, "linuxcnc") == [[1, 0, 0], [2, 0, 0]]


PROGRAM = """%
(begin operation: a)
G21 G90 G17
N10 T1
M3 S1000
g0 x1 y1 z5
G1 Z-1 F100
X2 Y3
G2 X4 Y3 I1
G91 G1 X1
(MSG, hello)
M0
G18 G3 X1 Z1 R1
G4 P1
(finish operation: a)
G20 G90 G1 X.5 F5
G93 X1 F3
M2
"""


def test_whole_and_line_by_line_give_the_same_table():
    whole = interpret(PROGRAM, ZERO)
    reader = Interpreter(ZERO, "grbl")
    chunks = []
    for line in program_lines(PROGRAM):
        reader.line(line)
        chunks += reader.table.take()
    rest = reader.toolpath()
    for name in ("kind", "end", "centre", "plane", "turns", "feed", "state", "line"):
        piecewise = np.concatenate([getattr(chunk, name) for chunk in [*chunks, *rest.chunks]])
        assert np.array_equal(piecewise, getattr(whole.table(), name)), name
    assert (rest.states, rest.events, rest.spans) == (whole.states, whole.events, whole.spans)


def test_the_fast_way_and_the_general_way_give_the_same_table():
    """A comment on a line keeps it off the fast way."""
    plain = "G21 G90 F100\nG0 X1 Y1 Z1\nN5 G1 X2.5\nY3 F100\nY4 F200\nG2 X4.5 I1\nG0 Z9\n"
    general = "\n".join(f"{line} ()" for line in plain.splitlines())
    fast, slow = interpret(plain, ZERO), interpret(general, ZERO)
    for name in ("kind", "end", "centre", "feed", "state", "line"):
        assert np.array_equal(getattr(fast.table(), name), getattr(slow.table(), name)), name
    assert fast.states == slow.states


def test_two_axes_are_refused():
    with pytest.raises(ProgramError, match="three axes"):
        interpret("G0 X1", Start(position_mm=(0.0, 0.0)))


def test_unknown_dialect():
    with pytest.raises(ProgramError, match="no dialect 'fanuc'"):
        interpret("G0 X1", dialect="fanuc")


FIGURE_11 = [[15, 10], [35, 10], [25, 17], [15, 10]]
PART_1 = [
    "g90\ny-80\nG2 x-80 y0 i0 j0\nG90\nx-160 y0\nG2 x0 y160 i0 j0\nG90\ny80\nG2 x80 y0 i0 j0\nG90\nx160\n"
    "G2 x0 y-160 i0 j0\ng90\ny-80",
    "g90\ny-160\nG3 x160 y0 i0 j0\nG90\nx80\nG3 x0 y80 i0 j0\nG90\ny160\nG3 x-160 y0 i0 j0\nG90\nx-80\n"
    "G3 x0 y-80 i0 j0",
    "g90\ny-160\nG2 x-160 y0 i0 j0\nG90\nx-80\nG2 x0 y80 i0 j0\nG90\ny160\nG2 x160 y0 i0 j0\nG90\nx80\n"
    "G2 x0 y-80 i0 j0",
    "g90\ny-80\nG3 x80 y0 i0 j0\nG90\nx160\nG3 x0 y160 i0 j0\nG90\ny80\nG3 x-80 y0 i0 j0\nG90\nx-160\n"
    "G3 x0 y-160 i0 j0\ng90\ny-80",
]


@pytest.mark.parametrize(
    "text", ["G0\nX15 Y10\nG90\nX35\nX25 Y17\nX15 Y10", "G0\nX15 Y10\nG91\nX20\nX-10 Y7\nX-10 Y-7"]
)
def test_figure_11_of_thesis_a(text):
    table = interpret(text, ZERO, "thesis-a").table()
    assert table.end[:, :2].tolist() == FIGURE_11
    assert table.kind.tolist() == [RAPID, LINE, LINE, LINE]


@pytest.mark.parametrize("text", ["G0 X2 Y11\nG2 X11 Y2 I1 J1", "G0 X11 Y2\nG3 X2 Y11 I1 J1"])
def test_figure_13_of_thesis_a(text):
    table = interpret(text, ZERO, "thesis-a").table()
    assert table.centre[1, :2].tolist() == [1, 1]


@pytest.mark.parametrize("text", PART_1)
def test_the_parts_of_thesis_a_start_at_the_work_zero(text):
    path = interpret(text, Start(), "thesis-a")
    table = path.table()
    arcs = table.kind >= ARC_CW
    assert arcs.sum() == 4
    assert (table.centre[arcs] == 0).all()
    radii = np.hypot(table.end[:, 0], table.end[:, 1])
    assert set(radii.tolist()) == {80.0, 160.0}
    assert path.start.position_mm == (0, 0, 0)


def test_nan_is_not_lost_on_the_way():
    start = Start(position_mm=(nan, 0.0, 0.0))
    assert isnan(interpret("G0 Y1", start).table().end[0, 0])
