# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ramps by a table of waits: published tables tick by tick, reversals in the start/stop region."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings

from CNCStepper.machine.step_wait_tables import counted_down_s, pull_out_s
from CNCStepper.motion.planner.buffers import TICKS_PER_S
from CNCStepper.motion.planner.table_planning import LINE_TICKS
from helpers.motion.ramp_programs import TABLE, all_steps, moves, table_of, targets


def intervals(limits, steps, feed=None):
    """Return the waits between the steps of a move of so many steps of X, in s, and before its first."""
    end = (steps / limits.steps_per_mm[0], 0, 0)
    times, _ = all_steps(table_of([(end, feed or 0, feed is None)]), limits)
    return np.diff(times, prepend=LINE_TICKS / TICKS_PER_S)


LATHE = replace(
    TABLE, steps_per_mm=(80.0,) * 3, max_rate_mm_min=(60 / 4 / 135e-6 / 80,) * 3, waits_s=pull_out_s(), ramp="table"
)


def test_the_published_pull_out_table_comes_tick_by_tick():
    ticks = np.rint(intervals(LATHE, 60) / 135e-6).astype(int).tolist()
    table = [101, 42, 32, 27, 24, 22, 20, 19, 18, 17, 16, 15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4]
    assert ticks == table + [4] * 14 + table[::-1]
    assert np.rint(intervals(LATHE, 7) / 135e-6).astype(int).tolist() == [101, 42, 32, 27, 32, 42, 101]


def test_a_feed_in_the_pull_in_region_has_a_constant_wait():
    slow = intervals(LATHE, 40, feed=0.9 * 60)
    assert np.ptp(slow) < 1e-6 and slow[0] == pytest.approx(1 / (0.9 * 80), rel=1e-4)
    wider = replace(LATHE, pull_in_s=0.004)
    assert np.ptp(intervals(wider, 40, feed=3 * 60)) < 1e-6
    assert np.ptp(intervals(wider, 40, feed=4 * 60)) > 1e-3


def test_the_interval_counts_down_to_the_constant_one_and_up_again():
    limits = replace(LATHE, waits_s=counted_down_s(0.010, 0.002, 0.003))
    assert limits.waits_s == pytest.approx((0.010, 0.008, 0.006, 0.004, 0.003))
    expected = [10, 8, 6, 4, 3, 3, 3, 4, 6, 8, 10]
    assert (intervals(limits, 11) * 1000).tolist() == pytest.approx(expected)


@pytest.mark.slow
@settings(max_examples=10, deadline=None)
@given(rows=moves)
def test_by_table_every_axis_turns_round_in_the_start_stop_region(rows):
    if not np.any(targets(rows, TABLE)):
        return
    times, positions = all_steps(table_of(rows), TABLE)
    for axis in range(3):
        steps = np.diff(positions[:, axis])
        made = np.flatnonzero(steps)
        turns = np.flatnonzero(np.diff(steps[made]))
        waits = np.diff(times[made])[turns]
        assert np.all(waits >= TABLE.waits_s[0] * 0.999)
