# SPDX-License-Identifier: LGPL-2.1-or-later
"""The look-ahead of S-curves plans only what a new block can change, and what it leaves is what it would plan."""

from dataclasses import replace

import numpy as np
import pytest

from CNCStepper.machine.profile import load_machine
from CNCStepper.motion.planner.buffers import count_blocks, new_planner, places_from
from CNCStepper.motion.planner.look_ahead import plan_again, push_line
from CNCStepper.motion.planner.machine_limits import Limits
from CNCStepper.motion.planner.s_curve_look_ahead import plan_entries, reachable_speed

LIMITS = replace(
    Limits.of(load_machine("table-a")), ramp="s_curve", jerk_mm_s3=(4000.0, 4000.0, 1000.0), look_ahead_blocks=400
)
SPEED_MM_S = 50.0  # to stop from it takes some 8 mm


def planner_of(points):
    planner = new_planner(LIMITS, (0.0, 0.0, 0.0))
    for point in points:
        push_line(planner, np.array(point, float), SPEED_MM_S, False, 0)
    return planner


@pytest.mark.parametrize("seed", range(8))
def test_it_leaves_the_entries_that_planning_all_of_them_anew_gives(seed):
    print("seed", seed)
    random = np.random.default_rng(seed)
    straight_on = np.cumsum(random.normal(0, 0.05, 150))  # the direction turns little by little, and at times at once
    turns = straight_on + np.where(random.random(150) < 0.06, random.uniform(-2, 2, 150), 0.0).cumsum()
    ways = random.uniform(0.05, 3, 150)[:, None] * np.column_stack([np.cos(turns), np.sin(turns), 0.02 * turns])
    planner = planner_of(np.cumsum(ways, axis=0))
    plan_entries(planner)
    kept = planner.blocks.entry_sqr.copy()
    plan_again(planner)
    assert np.array_equal(kept, planner.blocks.entry_sqr)
    assert np.ptp(kept) > 100
    expected = [best_entry_mm_s(planner.blocks, first) ** 2 for first in range(15, 150, 15)]
    assert kept[15:150:15].tolist() == expected


def best_entry_mm_s(blocks, first):
    """Return the greatest entry speed of a block, over all places at which a change of speed may end."""
    entries = np.sqrt([*blocks.entry_sqr[first + 1 : 150], 0.0])
    lengths = np.cumsum(blocks.length[first:150])
    least = (np.minimum.accumulate(column[first:150]) for column in (blocks.acceleration, blocks.jerk))
    reachable = map(reachable_speed, entries, lengths, *least)
    limits = np.sqrt(np.minimum.accumulate(blocks.max_entry_sqr[first:150]))
    return max(map(min, limits, reachable))


def test_what_no_later_block_can_change_is_not_planned_again():
    planner = planner_of([(0.1 * (number + 1), 0.0, 0.0) for number in range(300)])
    plan_entries(planner)
    planner.blocks.entry_sqr[:150] = -1.0  # all that is planned anew is overwritten
    push_line(planner, np.array([40.0, 0.0, 0.0]), SPEED_MM_S, False, 0)
    plan_entries(planner)
    assert (planner.blocks.entry_sqr[:150] == -1.0).all()


def fresh_blocks(planner):
    return places_from(planner, planner.queue[0].fresh, planner.queue[0].head)


def test_a_short_queue_is_planned_at_each_block_and_a_long_one_when_a_sixteenth_of_it_is_new():
    planner, waiting = new_planner(LIMITS, (0.0, 0.0, 0.0)), []
    for number in range(320):
        push_line(planner, np.array([0.1 * (number + 1), 0.0, 0.0]), SPEED_MM_S, False, 0)
        assert 16 * fresh_blocks(planner) < count_blocks(planner)
        waiting.append(fresh_blocks(planner))
    assert max(waiting[:16]) == 0 and 10 < max(waiting) < 20
    assert waiting.count(0) < 100
