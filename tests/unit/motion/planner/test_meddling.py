# SPDX-License-Identifier: LGPL-2.1-or-later
"""Holds, resumes and overrides at any moment of every ramp: no pulse is lost, the acceleration is kept."""

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from helpers.motion.meddling import WAY, held_on_a_line, meddled
from helpers.motion.ramp_programs import RAMPS

acts = st.lists(
    st.tuples(st.integers(1, 60), st.sampled_from(["hold", "resume", "feed", "rapid", "starve"]), st.floats(0.1, 2.0)),
    max_size=14,
)


def pulses(motion):
    positions = np.vstack([np.zeros(3), motion.step_path()[:, 1:]])
    return np.abs(np.diff(positions, axis=0)).sum(axis=0).tolist()


@pytest.mark.slow
@pytest.mark.parametrize("limits", RAMPS)
@settings(max_examples=30, deadline=None)
@given(acts=acts)
def test_holds_resumes_and_overrides_never_cost_a_pulse(limits, acts):
    motion = meddled(limits, acts)
    assert list(motion.position_steps) == np.rint(np.float32(WAY[-1]) * np.float32(800)).astype(int).tolist()
    assert pulses(motion) == pulses(meddled(limits, ()))


@pytest.mark.slow
@pytest.mark.parametrize("limits", RAMPS)
def test_meddling_at_every_moment_of_a_ramp_costs_no_pulse(limits):
    plain = pulses(meddled(limits, ()))
    for clock in range(1, 60, 7):
        acts = [(clock, "hold", 0), (clock + 3, "resume", 0), (clock, "feed", 0.3), (clock + 5, "feed", 1.7)]
        assert pulses(meddled(limits, acts * 2)) == plain


@pytest.mark.parametrize("limits", RAMPS)
@settings(max_examples=12, deadline=None)
@given(after=st.integers(0, 300), factor=st.floats(0.1, 2.0))
def test_holds_and_overrides_keep_to_the_acceleration(limits, after, factor):
    motion, accelerations = held_on_a_line(limits, after, factor, 800)
    assert accelerations.max() * 0.05 <= 250 * 0.05 * 1.15 + 1
    assert motion.position_steps == (64000, 0, 0)


SMALL = """
from dataclasses import replace
from helpers.motion.meddling import meddled
from helpers.motion.ramp_programs import RAMPS, table_of
from CNCStepper.motion.planner.plan import times_s
from CNCStepper.state import State
blend = State(path_mode="blend", blend_mm=0.2)
rows = [((3, 0, 0), 1500, False), ((3, 1, 0.4), 1500, False), ((0, 0, 0), 900, True)]
for limits in (parameter.values[0] for parameter in RAMPS):
    coarse = replace(limits, steps_per_mm=(40.0,) * 3)
    print(times_s(table_of(rows, blend), coarse).tolist())
    print(meddled(coarse, [(9, "hold", 0), (30, "resume", 0), (9, "feed", 0.5)]).path().tolist())
"""


@pytest.mark.slow
def test_compiled_and_plain_python_agree():
    compiled, plain = (said_by_small(disable) for disable in "01")
    assert compiled == plain and len(plain) > 500


def said_by_small(disable):
    environment = {
        **os.environ,
        "NUMBA_DISABLE_JIT": disable,
        "PYTHONPATH": str(Path(__file__).parents[3]),
    }
    command = [sys.executable, "-c", SMALL]
    return subprocess.run(command, capture_output=True, text=True, check=True, env=environment).stdout
