# SPDX-License-Identifier: LGPL-2.1-or-later
"""Look-ahead over any number of blocks: many short lines then run as the one long line that they make."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from CNCStepper.machine.profile import load_machine
from CNCStepper.motion.planner.live_motion import Motion
from CNCStepper.motion.planner.machine_limits import Limits
from CNCStepper.motion.planner.plan import duration_s, sample
from CNCStepper.state import Start
from CNCStepper.toolpath import TableBuilder

LIMITS = Limits.of(load_machine("table-a"))
LENGTH_MM, FEED_MM_MIN = 30.0, 3000.0  # braking from that feed takes 5 mm


def straight(pieces):
    table = TableBuilder(Start.at_zero())
    for place in np.linspace(0, LENGTH_MM, pieces + 1)[1:]:
        table.feed((place, 0, 0), FEED_MM_MIN)
    return table.toolpath()


def looking(blocks):
    return replace(LIMITS, look_ahead_blocks=blocks)


def live_s(blocks, pieces):
    """Return how long the live planner takes when it is fed as fast as it has room, and where it stands then."""
    motion = Motion(looking(blocks))
    for place in np.linspace(0, LENGTH_MM, pieces + 1)[1:]:
        while not motion.room:
            motion.advance(0.001)
        motion.line((place, 0, 0), FEED_MM_MIN)
    while motion.state == "run":
        motion.advance(0.001)
    return motion.time_s, motion.position_steps


@pytest.mark.slow
def test_a_longer_ring_runs_short_lines_faster_up_to_one_long_line():
    taken = [live_s(blocks, 300)[0] for blocks in (2, 4, 15, 60, 150)]
    assert all(more < less - 0.02 for less, more in pairwise(taken[:4]))
    assert taken[4] == pytest.approx(live_s(15, 1)[0], abs=0.03)


@pytest.mark.parametrize("blocks", [2, 3, 16, 17, 1000])
def test_every_ring_ends_on_the_point(blocks):
    assert live_s(blocks, 300)[1] == (2400, 0, 0)
    path = straight(300)
    assert sample(path, looking(blocks), np.array([60.0]))[0].tolist() == [2400, 0, 0]


def test_a_program_is_planned_as_far_ahead_as_the_profile_says():
    taken = [duration_s(straight(100), looking(blocks)) for blocks in (4, 15, 60)]
    assert taken[0] > taken[1] + 0.02 and taken[1] > taken[2] + 0.01
    machine = load_machine("table-a")
    farther = machine.model_copy(update={"planner": machine.planner.model_copy(update={"look_ahead_blocks": 60})})
    assert duration_s(straight(100), farther) == taken[2]
