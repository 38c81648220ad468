# SPDX-License-Identifier: LGPL-2.1-or-later
"""What LinuxCNC's codes leave in the table of moves: the trace is compared with `rs274` elsewhere."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.interpreter.functions.tools import read_tool_table
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.gcode.interpreter.motion.nurbs import Nurbs, nurbs_points
from CNCStepper.gcode.interpreter.motion.splines import TOLERANCE_MM
from CNCStepper.state import Start
from CNCStepper.toolpath import ARC_CCW, ARC_CW, LINE, RAPID, Toolpath, require_straight_axes

START = Start.at_zero()


def read(text: str, start: Start = START) -> Toolpath:
    return interpret(text + "\nM2\n", start, "linuxcnc")


def ends(path: Toolpath) -> np.ndarray:
    return path.table().end


def points_of(path: Toolpath, count: int = 50) -> np.ndarray:
    """Return points along all feed rows, X and Y."""
    table, points = path.table(), []
    for begin, end, centre, kind in zip(path.begins(), table.end, table.centre, table.kind, strict=True):
        share = np.linspace(0.0, 1.0, count)
        if kind in (RAPID, LINE):
            points.append(begin[:2] + share[:, None] * (end - begin)[:2])
            continue
        a, b = complex(*(begin - centre)[:2]), complex(*(end - centre)[:2])
        angle = np.angle(b / a) % math.tau
        angle = angle - math.tau if kind == ARC_CW else angle
        along = a * np.exp(1j * angle * share) + complex(*centre[:2])
        points.append(np.column_stack([along.real, along.imag]))
    return np.vstack(points)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("text", "nurbs"),
    [
        ("F100 G5 X30 Y10 I5 J20 P-8 Q15", Nurbs(((0, 0), (5, 20), (22, 25), (30, 10)), (1, 1, 1, 1), 4)),
        ("F100 G5.1 X20 Y0 I10 J15", Nurbs(((0, 0), (10, 15), (20, 0)), (1, 1, 1), 3)),
        (
            "F100 G5.2 X5 Y10 P1\nX15 Y10 P3\nX20 Y0 P1\nG5.3",
            Nurbs(((0, 0), (5, 10), (15, 10), (20, 0)), (1, 1, 3, 1), 3),
        ),
    ],
)
def test_the_arcs_of_a_spline_lie_within_the_tolerance(text, nurbs):
    path = read(text)
    assert (path.table().kind >= ARC_CW).any()
    last = len(nurbs.points) - nurbs.order + 1
    curve = nurbs_points(nurbs, np.linspace(0.0, last, 20_001))
    apart = np.abs(points_of(path)[:, None, :] @ np.array([1, 1j]) - (curve @ np.array([1, 1j]))[None, :]).min(axis=1)
    assert apart.max() < TOLERANCE_MM + 2e-3  # the curve's own points lie that far apart
    assert np.allclose(ends(path)[-1, :2], nurbs.points[-1])


def test_rows_have_nine_columns_once_a_further_axis_moves():
    path = read("G0 X1\nG1 X2 F100\nG0 A90\nX3")
    assert ends(path).shape == (4, 9)
    assert ends(path)[1].tolist() == [2, 0, 0, 0, 0, 0, 0, 0, 0]
    assert ends(path)[3].tolist() == [3, 0, 0, 90, 0, 0, 0, 0, 0]
    assert path.begins().shape == (4, 9)


def test_a_machine_of_nine_axes_moves_u_v_w_too():
    path = read("G20 G0 U1 C90\nG10 L2 P1 W2\nG0 W1", Start.at_zero(9))
    assert ends(path)[-1].tolist() == pytest.approx([0, 0, 0, 0, 0, 90, 25.4, 0, 76.2])
    with pytest.raises(ProgramError, match="no word U"):
        read("G0 U1")


def test_a_program_of_x_y_z_keeps_three_columns():
    assert ends(read("G0 X1\nG1 Y2 F100")).shape == (2, 3)


def test_offsets_of_further_axes_count():
    path = read("G10 L2 P1 A30\nG0 A60\nG92 A0\nG0 A10\nG53 G0 A5")
    assert ends(path)[:, 3].tolist() == [90, 100, 5]


def test_a_turned_work_system_turns_the_moves():
    path = read("G10 L2 P1 X10 R90\nG0 X5 Y0\nG91 X0 Y2")
    assert np.allclose(ends(path)[:, :2], [[10, 5], [8, 5]])
    assert path.states[-1].rotation_deg == 90


def test_an_arc_out_of_the_turned_plane_becomes_chords_of_it():
    path = read("G10 L2 P1 R90\nG18 G3 X10 Z0 I5 K0 F100")
    table = path.table()
    assert set(table.kind) == {LINE}
    assert np.allclose(table.end[-1], [0, 10, 0])
    assert np.abs(np.hypot(table.end[:, 1] - 5, table.end[:, 2]) - 5).max() < 1e-9
    steps = np.linalg.norm(np.diff(np.vstack([path.begins()[:1], table.end]), axis=0), axis=1)
    assert (5 - np.sqrt(25 - (steps / 2) ** 2)).max() < 0.0021


def test_compensated_moves_are_the_rows():
    path = read("G1 F100 Y-10\nG41.1 D4\nX10 Y0\nX30\nY-20\nG40\nG0 Z5")
    table = path.table()
    assert (table.kind == ARC_CW).sum() == 2  # about the two convex corners
    corner = table.kind == ARC_CW
    assert np.allclose(np.linalg.norm((table.end - table.centre)[corner][:, :2], axis=1), 2.0)
    assert table.end[-1].tolist() == [30, -20, 5]
    assert table.line.tolist() == sorted(table.line.tolist())


def test_what_is_said_between_held_moves_happens_between_them():
    path = read("G41.1 D2\nG1 F100 X10\nM8\nG4 P1\nY10\nG40\nG0 X0")
    dwell = next(event for event in path.events if event.kind == "dwell")
    assert dwell.index == 1
    assert [state.flood for state in path.states][path.table().state[1]]


def test_an_unknown_diameter_is_refused_and_a_known_one_used():
    with pytest.raises(ProgramError, match="diameter"):
        read("G41 G1 X10 F100")
    tools = read_tool_table("T3 P3 D4 Z10 ; a mill\n")
    path = read("G41 D3\nG1 X10 F100", replace(START, tools=tools))
    assert ends(path)[-1].tolist() == [10, 2, 0]


def test_a_tool_of_the_table_lengthens_with_g43_and_g10():
    start = replace(START, tools=read_tool_table("T1 P1 D3 Z10\nT2 P2 Z20 X1\n"))
    path = read("T1 M6 G43\nG0 Z0\nG43 H2\nG0 X0 Z0\nG10 L1 P2 Z25\nG43 H2\nG0 Z0", start)
    assert ends(path)[:, 2].tolist() == [10, 20, 25]
    assert ends(path)[1, 0] == 1


def test_after_a_tool_change_the_tool_is_where_plain_moves_have_led():
    """G88 leaves the place to whoever ended its pause; moves that were read before are read the short way then."""
    path = read("G0 X1\nG0 Z5\nM3 S100 F9\nG88 X3 Z-1 R2 P1\nG80\nG0 X1\nG0 Z5\nT1 M6\nG91 G0 Z1")
    assert ends(path)[-1].tolist() == [1, 0, 6]


def test_a_change_of_the_unit_leaves_the_tools_length():
    """The table follows the machine, the trace the stand-alone interpreter, which keeps the number instead."""
    start = replace(START, tools=read_tool_table("T1 P1 Z13\n"))
    path = read("T1 M6 G43\nG20\nG53 G0 Z-1\nG0 Z0", start)
    assert ends(path)[:, 2].tolist() == pytest.approx([-25.4, 13])
    assert path.states[-1].tool_length_mm == 13


@pytest.mark.parametrize("code", ["G17.1", "G18.1", "G19.1"])
def test_lines_are_read_in_the_planes_of_u_v_w_and_arcs_after_them(code):
    path = read(f"{code}\nG0 X1\nG1 Y2 F100\nG17\nG2 X3 I1")
    assert ends(path)[:, :2].tolist() == [[1, 0], [1, 2], [3, 2]]
    with pytest.raises(ProgramError, match=f"G81 is not read in {code}"):
        read(f"F100\n{code}\nG0 X1\nG81 Z-1 R1")


def test_the_feed_that_comes_back_has_the_number_that_was_kept():
    """M72 compares numbers, as LinuxCNC does: the same one in inches is not brought back."""
    path = read("F100\nM70\nG20\nF100\nM72\nG1 X1\nG20 M70\nF30\nM72\nG1 X2")
    assert path.table().feed.tolist() == [2540, 100]


def test_a_table_that_names_a_tool_twice_is_refused():
    with pytest.raises(ProgramError) as caught:
        read_tool_table("T1 P1 Z1\nT1 P2 Z2\n", file="tool.tbl")
    assert (caught.value.place.file, caught.value.place.line) == ("tool.tbl", 2)


def test_where_a_probe_has_led_is_not_known_afterwards():
    path = read("G0 X5 Y5 Z5\nG38.2 Z-10 F100\nG0 X6\nG0 Z5")
    assert [event.text for event in path.events if event.kind == "probe"] == ["G38.2"]
    assert ends(path)[1].tolist() == [5, 5, -10]
    assert np.isnan(ends(path)[2, 2]) and ends(path)[3].tolist() == [6, 5, 5]
    with pytest.raises(ProgramError):
        read("G0 X0 Y0 Z5\nG38.2 Z-10 F100\nG91 G0 Z1")


def test_the_spindle_drives_the_feed_of_threads():
    path = read("M3 S200\nG33 Z-10 K1.5\nG33.1 Z-20 K0.5")
    table = path.table()
    assert table.feed.tolist() == [300, 100, 100]
    assert table.end[:, 2].tolist() == [-10, -20, -10]
    assert [path.states[state].spindle for state in table.state] == ["cw", "cw", "ccw"]
    with pytest.raises(ProgramError, match="speed"):
        read("M3\nG33 Z-10 K1.5")


def test_feeds_per_turn_and_surface_speeds_become_feeds_a_minute():
    path = read("G95 M3 S500 F0.2 G1 X10\nG96 S100 D2000\nG1 X20\nG97 S300 G1 X30")
    on_the_way = 0.2 * 100_000 / (math.tau * 15)  # takes as long as the speeds from X10 to X20
    assert path.table().feed.tolist() == pytest.approx([100, on_the_way, 60])
    assert path.states[path.table().state[1]].spindle_rpm == pytest.approx(100_000 / (math.tau * 20))


def test_a_thread_cuts_deeper_pass_by_pass():
    path = read("M3 S100\nG0 X20 Z5\nG18 G76 Z-10 P1.5 I-.5 J.3 K1 R1")
    table = path.table()
    deepest = table.end[(table.kind == LINE), 0]
    assert deepest.tolist() == pytest.approx([19.2, 18.9, 18.6, 18.5])
    assert set(table.feed[table.kind == LINE]) == {150.0}


def test_outputs_and_inputs_are_events():
    path = read("M62 P1\nM65 P2\nM68 E1 Q2.5\nM66 P3 L3 Q4\nM19 R90\nM49\nM60")
    told = [(event.kind, event.value, event.text) for event in path.events if event.kind != "end"]
    assert told[:4] == [
        ("output", 1, "M62 P1"),
        ("output", 0, "M65 P2"),
        ("output", 2.5, "M68 E1 Q2.5"),
        ("input", 4, "M66 P3"),
    ]
    assert [kind for kind, _, _ in told[4:]] == ["orient", "override", "pause"]


def test_a_profile_is_cut_in_passes_and_finished():
    path = read(
        "G18\no1 sub\nG0 X5 Z0\nG1 Z-5\nG3 X8 Z-8 K-3 I0\nG1 X12\no1 endsub\nF100 G0 X14 Z2\nG71 Q1 I1 D.5\nG70 Q1"
    )
    table = path.table()
    assert (table.kind == ARC_CCW).any()
    cut = table.end[table.kind == LINE]
    assert cut[:, 0].min() == pytest.approx(5.0) and cut[:, 2].min() == pytest.approx(-8.0)


def test_bores_orient_the_spindle_and_come_back_up():
    path = read("M3 S100 F100 G0 Z5\nG87 X2 Z-1 R1 I1 J0 K-.5\nG86 X5 Z-2 R1 P1")
    assert [event.kind for event in path.events].count("orient") == 2
    assert ends(path)[-1].tolist() == [5, 0, 1]
    assert path.states[-2].spindle == "cw"


def test_kept_modes_come_back():
    path = read("G21 F100\nM70\nG91 G18 F50 M8\nM72\nG1 X1")
    state = path.states[path.table().state[-1]]
    assert (state.distance, state.plane, state.feed_mode, state.feed_mm_min, state.flood) == (
        *("absolute", "XY", "per_minute", 100),
        False,
    )


@pytest.mark.parametrize("text", ["G0 X1\nG1 A5 F100", "G10 L2 P1 R10\nG0 X1\nG0 X2"])
def test_what_cannot_be_judged_is_refused_with_its_line(text):
    with pytest.raises(ProgramError) as caught:
        require_straight_axes(read(text), "part.ngc")
    assert (caught.value.code, caught.value.place.file, caught.value.place.line) == ("axes", "part.ngc", 2)


def test_what_a_probe_will_find_cannot_be_calculated_with():
    with pytest.raises(ProgramError, match="5063"):
        read("G0 X0 Y0 Z5\nG38.2 Z-10 F100\nG0 X[#5063]")
