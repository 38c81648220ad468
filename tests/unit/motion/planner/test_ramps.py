# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every ramp on the planner's interface: limits kept on the emitted steps, continuous speed, no pulse lost."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from CNCStepper.motion.planner import plan
from CNCStepper.state import Start, State
from CNCStepper.toolpath import ARC_CCW, TableBuilder
from helpers.motion.ramp_programs import (
    GRID_S,
    RAMPS,
    S_CURVE,
    TRAPEZOID,
    WINDOW_S,
    all_steps,
    moves,
    speeds_mm_s,
    table_of,
    targets,
)


def shrunk(rows, scale):
    return [(tuple(scale * place for place in end), feed, rapid) for end, feed, rapid in rows]


@pytest.mark.slow
@pytest.mark.parametrize("limits", RAMPS)
@settings(max_examples=25, deadline=None)
@given(rows=moves, scale=st.sampled_from([1.0, 0.2, 0.02]))
@example(rows=[((-1.078125, 0.0, 1.078125), 60.0, False)], scale=1.0)  # half a step
def test_no_axis_exceeds_its_rate_and_all_reach_their_targets(limits, rows, scale):
    rows = shrunk(rows, scale)
    if not np.any(targets(rows, limits)):
        return
    toolpath = table_of(rows)
    _, positions = all_steps(toolpath, limits)
    assert positions[-1].tolist() == targets(rows, limits)[-1].tolist()
    fastest = np.abs(speeds_mm_s(toolpath, limits)).max(axis=0)
    assert (fastest <= np.array(limits.max_speed_mm_s) * 1.001 + 2.0 / 800 / GRID_S).all()


@pytest.mark.slow
@pytest.mark.parametrize("limits", RAMPS[:2])
@settings(max_examples=40, deadline=None)
@given(rows=moves, scale=st.sampled_from([1.0, 0.2, 0.02]))
def test_no_axis_exceeds_its_acceleration_and_its_speed_never_jumps(limits, rows, scale):
    """Of moves with exact stops, over any 30 ms of fine steps: at corners the junction deviation allows a jump.

    A table of waits knows no acceleration of the axes: its steps are held to the table itself, below.
    """
    fine = replace(limits, steps_per_mm=(8000.0,) * 3)
    rows = shrunk(rows, scale)
    if not np.any(targets(rows, fine)):
        return
    speeds = speeds_mm_s(table_of(rows, State(path_mode="exact_stop")), fine, WINDOW_S)
    changed = np.abs(np.diff(speeds, axis=0)).max(axis=0)
    assert (changed <= np.array(fine.acceleration_mm_s2) * WINDOW_S * 1.05 + 4.0 / 8000 / WINDOW_S).all()


@pytest.mark.parametrize("limits", RAMPS[1:])
def test_the_pulses_are_those_of_the_trapezoid(limits):
    rows = [((8, 0, 0), 3000, False), ((8, 4, 1), 1200, False), ((2, 1, 0.3), 3000, True), ((0, 9, 0), 600, False)]
    counts = [np.abs(np.diff(all_steps(table_of(rows), one)[1], axis=0)).sum(axis=0) for one in (TRAPEZOID, limits)]
    assert counts[0].tolist() == counts[1].tolist()


def test_an_s_curve_takes_the_time_of_its_seven_phases():
    times, _ = all_steps(table_of([((60, 0, 0), 3000, False)]), S_CURVE)
    change_s = 50 / 250 + 250 / 4000
    assert times[-1] - times[0] == pytest.approx(2 * change_s + (60 - 50 * change_s) / 50, abs=0.025)


def test_a_short_s_curve_never_reaches_its_acceleration():
    times, _ = all_steps(table_of([((0.4, 0, 0), 3000, False)]), S_CURVE)
    assert times[-1] - times[0] == pytest.approx(4 * (0.2 / 4000) ** (1 / 3), abs=0.025)


def test_the_jerk_of_an_s_curve_is_limited_and_that_of_a_trapezoid_is_not():
    slow = replace(S_CURVE, jerk_mm_s3=(1000.0,) * 3)
    assert greatest_jerk(slow) <= 1000 * 1.4
    assert greatest_jerk(TRAPEZOID) > 1000 * 3


def greatest_jerk(limits):
    """Return the greatest change of acceleration in a second, over windows of 50 ms of the steps of a long move."""
    fine = replace(limits, steps_per_mm=(8000.0,) * 3)
    speeds = speeds_mm_s(table_of([((60, 0, 0), 3000, False)]), fine, 0.05)[:, 0]
    return np.abs(np.diff(speeds, 2)).max() / 0.05**2


def test_an_s_curve_keeps_its_acceleration_over_the_chords_of_an_arc():
    table = TableBuilder(Start.at_zero())
    table.rapid((10, 0, 0))
    table.arc(ARC_CCW, (10, 0, 0), (0, 0, 0), 3000)
    toolpath = table.toolpath()
    times = [all_steps(toolpath, limits)[0][-1] for limits in (TRAPEZOID, S_CURVE)]
    assert times[0] < times[1] < 1.2 * times[0]
    speeds = speeds_mm_s(toolpath, S_CURVE)
    assert np.abs(np.diff(speeds, axis=0)).max() <= 250 * 2 * GRID_S + 4 / 800 / GRID_S


@pytest.mark.parametrize("limits", RAMPS)
def test_the_vector_speed_stays_constant_when_axes_combine(limits):
    limits = replace(limits, max_rate_mm_min=(6000.0,) * 3, acceleration_mm_s2=(250.0,) * 3)
    for end in ((40, 0, 0), (28, 28, 0), (12, 30, 9), (-30, 3, -18)):
        speeds = np.linalg.norm(speeds_mm_s(table_of([(end, 1200, False)]), limits), axis=1)
        cruise = speeds[len(speeds) // 2 - 10 : len(speeds) // 2 + 10]
        assert np.abs(cruise - 20).max() < 0.3


@pytest.mark.parametrize("limits", RAMPS)
def test_a_reversal_stands_still_in_between(limits):
    """In the 5 ms on either side of the turn the axis is no faster than 15 ms of its acceleration make it."""
    speeds = speeds_mm_s(table_of([((10, 0, 0), 3000, False), ((0, 0, 0), 3000, False)]), limits, 0.005)[:, 0]
    turn = int(np.flatnonzero(speeds < 0)[0])
    assert np.abs(speeds[turn - 1 : turn + 1]).max() <= 250 * 0.015 + 1 / 800 / 0.005
    assert np.abs(speeds).max() > 40


@pytest.mark.parametrize("limits", RAMPS)
def test_a_pass_goes_on_from_a_mark(limits, monkeypatch):
    monkeypatch.setattr(plan, "SEGMENT_ROWS", 9)
    state = State(path_mode="blend", blend_mm=0.3)
    run = plan.Run(
        table_of([((8, 0, 0), 3000, False), ((8, 4, 1), 1200, False), ((2, 1, 0.3), 3000, False)], state), limits
    )
    pieces, marks = [], []
    while True:
        marks.append(run.mark())
        pieces.append(run.piece().copy())
        if not len(pieces[-1]):
            break
    assert len(marks) > 5
    for mark, piece in list(zip(marks, pieces, strict=True))[::-1]:
        run.back_to(mark)
        assert np.array_equal(run.piece(), piece)
