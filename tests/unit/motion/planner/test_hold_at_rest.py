# SPDX-License-Identifier: LGPL-2.1-or-later
"""A hold that ends where a block begins cuts nothing of that block, however its length was rounded."""

from dataclasses import replace

import numpy as np
import pytest

from CNCStepper.machine.profile import load_machine
from CNCStepper.motion.planner.buffers import new_planner, new_segments
from CNCStepper.motion.planner.look_ahead import push_line
from CNCStepper.motion.planner.machine_limits import Limits
from CNCStepper.motion.planner.segment_generator import next_segment

FINE = replace(Limits.of(load_machine("table-a")), steps_per_mm=(800.0, 800.0, 800.0))
RAMPS = (FINE, replace(FINE, ramp="s_curve", jerk_mm_s3=(4000.0, 4000.0, 1000.0)))


@pytest.mark.parametrize("limits", RAMPS, ids=lambda limits: limits.ramp)
def test_a_hold_at_the_begin_of_a_block_cuts_no_step(limits):
    longer = 0  # blocks whose length, in steps again, is more than their steps
    for steps in range(2000, 2100):
        planner, segment = new_planner(limits, (0.0, 0.0, 0.0)), new_segments(1, 3)[0]
        push_line(planner, np.array([steps / 800, 333 / 800, 0.0]), 50.0, False, 0)
        block, ramp = planner.blocks[0], planner.ramp[0]
        longer += block.events / block.length * block.length > block.events
        ramp.hold = True
        assert not next_segment(planner, segment)
        assert ramp.ended and ramp.steps_left == steps
    assert longer > 0
