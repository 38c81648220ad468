# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whole programs through the planner: limits kept on the emitted steps, chunks, stops, unknown places."""

import math
import os
import subprocess
import sys
import time
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from CNCStepper.machine.profile import load_machine
from CNCStepper.motion.planner.machine_limits import Limits
from CNCStepper.motion.planner.plan import duration_s, sample, step_events, times_s
from CNCStepper.state import UNKNOWN, Start, State
from CNCStepper.toolpath import ARC_CCW, TableBuilder
from helpers.motion.chunks import in_chunks

MACHINE = load_machine("table-a")
LIMITS = Limits.of(MACHINE)
coordinate = st.floats(-20, 20)
moves = st.lists(
    st.tuples(st.tuples(coordinate, coordinate, st.floats(-4, 4)), st.floats(30, 6000), st.booleans()),
    min_size=1,
    max_size=25,
)


def table_of(rows, start=None):
    table = TableBuilder(start or Start.at_zero())
    for end, feed, rapid in rows:
        table.rapid(end) if rapid else table.feed(end, feed)
    return table.toolpath()


def random_table(count, seed=7, spread=0.3):
    steps = np.random.default_rng(seed).normal(0, spread, (count, 3)) * (1, 1, 0.05)
    return table_of([(end, 1500, False) for end in np.cumsum(steps, axis=0)])


def all_steps(toolpath, limits=LIMITS):
    pieces = list(step_events(toolpath, limits))
    return np.concatenate([times for times, _ in pieces]), np.concatenate([positions for _, positions in pieces])


def axis_speeds(toolpath, limits, axis):
    """Return times and speeds of one axis in mm/s over windows of 40 ms, from its emitted steps."""
    times, positions = all_steps(toolpath, limits)
    grid = np.arange(times[0] - 0.1, times[-1] + 0.1, 0.04)
    at = np.searchsorted(times, grid, side="right") - 1
    places = np.where(at < 0, 0, positions[np.maximum(at, 0), axis]) / limits.steps_per_mm[axis]
    return np.diff(places) / 0.04


@settings(max_examples=25, deadline=None)
@given(moves)
def test_no_axis_is_faster_or_accelerates_more_than_it_may(rows):
    toolpath = table_of(rows)
    for axis in range(3):
        if not np.any(np.rint(toolpath.table().end[:, axis] * LIMITS.steps_per_mm[axis])):
            continue
        speeds = axis_speeds(toolpath, LIMITS, axis)
        step_mm_s = 2.0 / LIMITS.steps_per_mm[axis] / 0.04
        assert np.abs(speeds).max() <= LIMITS.max_speed_mm_s[axis] * 1.001 + step_mm_s
        corner = 2 * math.sqrt(LIMITS.acceleration_mm_s2[axis] * LIMITS.junction_deviation_mm * 10)
        change = LIMITS.acceleration_mm_s2[axis] * 0.08
        assert np.abs(np.diff(speeds)).max() <= change + corner + 2 * step_mm_s


def test_a_straight_move_keeps_to_its_acceleration_and_speed():
    times, positions = all_steps(table_of([((60, 0, 0), 3000, False)]))
    mm = positions[:, 0] / 80
    ramp_s = 50 / 250
    expected = 2 * ramp_s + (60 - 50 * ramp_s) / 50
    assert times[-1] - times[0] == pytest.approx(expected, abs=0.02)
    speeds = np.diff(mm) / np.diff(times)
    assert speeds.max() == pytest.approx(50, rel=0.002)
    inside = (times[1:] > times[0] + 0.02) & (times[1:] < times[-1] - 0.02)
    smooth = np.interp(np.arange(times[0] + 0.03, times[-1] - 0.03, 0.02), times[1:][inside], speeds[inside])
    assert np.abs(np.diff(smooth) / 0.02).max() <= 250 * 1.35


def test_too_high_limits_would_be_noticed():
    fast = replace(LIMITS, acceleration_mm_s2=(500, 500, 50))
    with pytest.raises(AssertionError):
        speeds = axis_speeds(table_of([((60, 0, 0), 3000, False)]), fast, 0)
        assert np.abs(np.diff(speeds)).max() <= 250 * 0.04 * 1.2


@settings(max_examples=15, deadline=None)
@given(moves, st.integers(1, 9))
def test_split_chunks_give_the_same_times(rows, size):
    toolpath = table_of(rows)
    assert times_s(in_chunks(toolpath, size), MACHINE).tolist() == times_s(toolpath, MACHINE).tolist()


def test_many_segments_and_arcs_over_chunk_bounds_change_nothing():
    table = TableBuilder(Start.at_zero())
    for turn in range(40):
        table.rapid((10, 0, turn * 0.1))
        table.arc(ARC_CCW, (10, 0, turn * 0.1 + 0.1), (0, 0, 0), 1200)
        table.event("dwell", 0.1)
    toolpath = table.toolpath()
    assert times_s(in_chunks(toolpath, 3), MACHINE).tolist() == times_s(toolpath, MACHINE).tolist()
    assert duration_s(toolpath, MACHINE) == pytest.approx(times_s(toolpath, MACHINE)[-1] + 0.1 + 0.025, abs=1e-9)


def test_times_rise_and_belong_to_the_rows():
    toolpath = random_table(400)
    ends = times_s(toolpath, MACHINE)
    assert np.all(np.diff(ends) >= 0)
    targets = np.rint(toolpath.table().end * LIMITS.steps_per_mm)
    assert np.abs(sample(toolpath, MACHINE, ends) - targets).max() <= 1


def test_samples_may_come_in_any_order_and_lie_outside():
    toolpath = table_of([((10, 0, 0), 1200, False), ((10, 5, 0), 1200, False)])
    at = sample(toolpath, MACHINE, np.array([99.0, 0.3, -1.0, 0.6]))
    assert at[0].tolist() == [800, 400, 0] and at[2].tolist() == [0, 0, 0]
    assert 0 < at[1][0] < at[3][0] <= 800
    assert sample(toolpath, MACHINE, np.array([])).shape == (0, 3)


def test_nothing_takes_no_time():
    empty = table_of([])
    assert duration_s(empty, MACHINE) == 0.0 and times_s(empty, MACHINE).tolist() == []
    still = table_of([((0, 0, 0), 100, False), ((0.001, 0, 0), 100, False)])
    assert duration_s(still, MACHINE) == 0.0 and times_s(still, MACHINE).tolist() == [0.0, 0.0]


@pytest.mark.parametrize(("asked_s", "waited_s"), [(0.25, 0.25), (0.26, 0.3), (0.1, 0.1), (0.0, 0.0)])
def test_dwells_come_in_steps_of_50_ms_and_after_the_idle_delay(asked_s, waited_s):
    table = TableBuilder(Start.at_zero())
    table.feed((10, 0, 0), 1200)
    table.event("dwell", asked_s)
    table.feed((20, 0, 0), 1200)
    ends = times_s(table.toolpath(), MACHINE)
    assert ends[1] - 2 * ends[0] == pytest.approx(waited_s + 0.025, abs=1e-3)


@pytest.mark.parametrize(
    ("change", "laser", "stops"),
    [
        ({"spindle": "cw"}, False, True),
        ({"spindle": "cw"}, True, True),
        ({"flood": True}, False, True),
        ({"spindle_rpm": 500.0}, False, False),
        ({"offset_mm": (1.0, 0.0, 0.0)}, False, True),
        ({"feed_mm_min": 300.0}, False, False),
    ],
)
def test_what_changes_between_two_moves_may_stop_them(change, laser, stops):
    assert stopped(State(), replace(State(), **change), laser) == stops


def test_spindle_speed_stops_a_spindle_but_not_a_laser():
    slow, fast = State(spindle="cw", spindle_rpm=100), State(spindle="cw", spindle_rpm=200)
    assert stopped(slow, fast, laser=False) and not stopped(slow, fast, laser=True)


def stopped(before, after, laser):
    table = TableBuilder(Start.at_zero(), before)
    table.feed((10, 0, 0), 1200)
    table.set_state(after)
    table.feed((20, 0, 0), 1200)
    plain = duration_s(table_of([((10, 0, 0), 1200, False), ((20, 0, 0), 1200, False)]), MACHINE)
    return duration_s(table.toolpath(), replace(LIMITS, laser=laser)) > plain + 0.02


def test_the_way_along_an_unknown_axis_counts_as_nothing():
    rows = [((UNKNOWN, UNKNOWN, 5.0), 800, True), ((10.0, 20.0, 5.0), 800, True), ((10.0, 20.0, 0.0), 800, True)]
    ends = times_s(table_of(rows, Start()), MACHINE)
    assert ends[0] == ends[1] == 0.0 and ends[2] > 0.3


@pytest.mark.slow
def test_a_chunk_of_100_000_short_blocks_is_planned_within_a_second():
    toolpath = random_table(100_000)
    duration_s(random_table(50), MACHINE)
    begin = time.process_time()
    assert duration_s(toolpath, MACHINE) > 1000
    assert time.process_time() - begin < 1.0


SMALL = """
from CNCStepper.machine.profile import load_machine
from CNCStepper.motion.planner.live_motion import Motion
from CNCStepper.motion.planner.machine_limits import Limits
from CNCStepper.motion.planner.plan import sample, times_s
from CNCStepper.toolpath import ARC_CW, TableBuilder
from CNCStepper.state import Start
import numpy as np
table = TableBuilder(Start.at_zero())
table.rapid((3, 1, 0.4))
table.arc(ARC_CW, (1, 3, 0), (1, 1, 0), 900)
table.event("dwell", 0.1)
table.feed((0, 0, 0), 1500)
machine = load_machine("table-b")
path = table.toolpath()
motion = Motion(Limits.of(machine), record=True)
motion.line((1, 1, 0), 900, tag=4)
motion.line((2, 0, 0), 900)
motion.advance(0.1); motion.hold(); motion.advance(1); motion.resume(); motion.override(0.5, 1); motion.advance(2)
print(times_s(path, machine).tolist(), sample(path, machine, np.linspace(0, 1, 20)).tolist())
print(motion.path().tolist(), motion.step_path().tolist())
"""


@pytest.mark.slow
def test_compiled_and_plain_python_agree():
    compiled, plain = (said_by_small({**os.environ, "NUMBA_DISABLE_JIT": disable}) for disable in "01")
    assert compiled == plain and len(plain) > 500


def said_by_small(environment):
    command = [sys.executable, "-c", SMALL]
    return subprocess.run(command, capture_output=True, text=True, check=True, env=environment).stdout
