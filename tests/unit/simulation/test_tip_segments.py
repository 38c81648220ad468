# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np
import pytest

from CNCStepper.simulation.arc_chords import extremes
from CNCStepper.simulation.tip_segments import chains, clipped_below, segments, split_ramps, tips_mm
from CNCStepper.toolpath import ARC_CCW, ARC_CW, YZ, ZX
from helpers.simulation.programs import ZERO_MM, Program, begun


def lengths(path):
    return np.linalg.norm(path.end - path.begin, axis=1)


def lines(count):
    points = np.random.default_rng(7).uniform(-30, 30, (count, 3))
    program = begun()
    for point in points.tolist():
        program = program.feed(*point)
    return program


def test_lines_are_the_same_segments_with_an_arc_in_the_program_and_without():
    alone = segments(lines(50).toolpath(), 0.001)
    beside = segments(lines(50).rapid(10, 0, 0).arc(ARC_CW, (0, -10, 0), (0, 0, 0)).toolpath(), 0.001)[: len(alone)]
    for column in ("begin", "end", "row"):
        assert getattr(alone, column).tobytes() == getattr(beside, column).tobytes()
    assert not alone.are_known and alone.known().are_known
    assert alone.length_mm.tobytes() == lengths(alone).tobytes()


@pytest.mark.parametrize(("kind", "quarter"), [(ARC_CCW, (0, 10)), (ARC_CW, (0, -10))])
def test_an_arc_is_flattened_within_the_tolerance(kind, quarter):
    program = begun().rapid(10, 0, 0).arc(kind, (*quarter, 0), (0, 0, 0))
    path = segments(program.toolpath(), 0.001).known()
    path = path[path.row == 3]
    middles = (path.begin + path.end)[:, :2] / 2
    assert np.hypot(*path.end[:, :2].T) == pytest.approx(10, abs=1e-12)
    assert 0.0009 < 10 - np.hypot(*middles.T).min() <= 0.001 + 1e-9 or len(path) < 4
    assert lengths(path).sum() == pytest.approx(10 * np.pi / 2, rel=1e-3)
    assert path.end[-1].tolist() == pytest.approx([*quarter, 0], abs=1e-12)


def test_equal_ends_are_a_full_circle_and_turns_add_to_it():
    once = begun().rapid(10, 0, 0).arc(ARC_CW, (10, 0, -1), (0, 0, 0)).toolpath()
    thrice = begun().rapid(10, 0, 0).arc(ARC_CW, (10, 0, -3), (0, 0, 0), turns=3).toolpath()
    for toolpath, turns in ((once, 1), (thrice, 3)):
        path = segments(toolpath, 1e-4).known()
        assert lengths(path[path.row == 3]).sum() == pytest.approx(turns * np.hypot(20 * np.pi, 1), rel=1e-4)


@pytest.mark.parametrize(
    ("plane", "begin", "end", "top"),
    [(ZX, (0, 0, 10), (10, 0, 0), (7.07, 0, 7.07)), (YZ, (0, 10, 0), (0, 0, 10), (0, 7.07, 7.07))],
)
def test_arcs_of_the_other_planes_turn_about_their_normals(plane, begin, end, top):
    program = begun().rapid(*begin).arc(ARC_CCW, end, (0, 0, 0), plane)
    path = segments(program.toolpath(), 1e-3).known()
    path = path[path.row == 3]
    assert np.linalg.norm(path.end - np.array(top), axis=1).min() < 0.5


def test_the_extremes_of_an_arc_are_real():
    program = Program(zero_mm=(0, 0, 0)).rapid(10, 0, 0).arc(ARC_CCW, (0, -10, 0), (0, 0, 0)).toolpath()
    low, high = extremes(program.table(), program.begins())
    assert low[1].tolist() == [-10, -10, 0]
    assert high[1].tolist() == [10, 10, 0]
    other = Program(zero_mm=(0, 0, 0)).rapid(10, 0, 0).arc(ARC_CW, (0, -10, 0), (0, 0, 0)).toolpath()
    assert extremes(other.table(), other.begins())[1][1].tolist() == pytest.approx([10, 0, 0])


def test_tips_are_in_the_frame_of_the_first_offset_and_without_tool_length():
    program = Program().rapid(1, 2, 3)
    program.set(offset_mm=(ZERO_MM[0] + 10, ZERO_MM[1], ZERO_MM[2] + 7), tool_length_mm=7).rapid(1, 2, 3)
    assert tips_mm(program.toolpath())[1].tolist() == [[1, 2, 3], [11, 2, 3]]


def test_what_lies_above_a_level_is_clipped():
    path = segments(begun().feed(0, 0, 4).feed(8, 0, -4).feed(8, 0, 4).toolpath(), 0.01).known()
    below = clipped_below(path, 0.0)
    assert below.begin.tolist() == [[4, 0, 0], [8, 0, -4]]
    assert below.end.tolist() == [[8, 0, -4], [8, 0, 0]]
    assert len(chains(below)) == 1


def test_ramps_are_split_and_plunges_are_not():
    path = segments(begun().feed(0, 0, -5).feed(10, 0, -6).toolpath(), 0.01).known()
    parts = split_ramps(path[path.row >= 2], 0.25)
    assert len(parts) == 1 + 4
    assert parts.end[-1].tolist() == [10, 0, -6]
