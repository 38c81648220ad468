# SPDX-License-Identifier: LGPL-2.1-or-later
"""The planner against recordings of grbl 1.1 firmware: the same time, the same pulses, the same path."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from recordings import NAMES, limits_of, recording, toolpath_of

from CNCStepper.motion.limits import Limits
from CNCStepper.motion.plan import sample, step_events
from CNCStepper.toolpath import Toolpath

LOOK_AHEAD_BOUND = "ellipse-fine_b"  # braking takes all 15 blocks: here the processor's own pace shows
SAMPLES = "samples_t_s_x_y_z_steps"


@cache
def case(name: str) -> tuple[dict, Toolpath, Limits]:
    recorded = recording(name)
    return recorded, toolpath_of(recorded["program"]), limits_of(recorded["settings"])


@cache
def steps(name: str) -> tuple[np.ndarray, np.ndarray]:
    """Return the times and positions of all step events."""
    _, toolpath, limits = case(name)
    times, positions = zip(*step_events(toolpath, limits), strict=True)
    return np.concatenate(times), np.concatenate(positions)


def duration_s(toolpath: Toolpath, limits: Limits) -> float:
    """Return the time from the first to the last step."""
    times = np.concatenate([times for times, _ in step_events(toolpath, limits)])
    return times[-1] - times[0]


@pytest.mark.parametrize("name", NAMES)
def test_takes_the_same_time_to_the_same_place(name):
    recorded, toolpath, limits = case(name)
    assert duration_s(toolpath, limits) == pytest.approx(recorded["duration_s"], abs=0.005)
    assert steps(name)[1][-1].tolist() == recorded["end_steps"]


@pytest.mark.parametrize("name", [name for name in NAMES if "pulses" in recording(name)])
def test_sends_the_same_pulses(name):
    positions = np.vstack([[[0, 0, 0]], steps(name)[1]])
    assert np.abs(np.diff(positions, axis=0)).sum(axis=0).tolist() == list(case(name)[0]["pulses"].values())


@pytest.mark.parametrize("name", [name for name in NAMES if SAMPLES in recording(name)])
def test_passes_the_sampled_places_in_time(name):
    recorded, toolpath, limits = case(name)
    samples = np.array(recorded[SAMPLES])
    begin_s = samples[:, 0] + steps(name)[0][0]
    early, now, late = (sample(toolpath, limits, begin_s + shift_s) for shift_s in (-0.004, 0.0, 0.004))
    off = np.abs(now - samples[:, 1:])
    assert np.all(off <= np.abs(late - early) + 1)  # reached within some 4 ms; a step for the last digit of the time
    assert np.mean(off <= 1) > (0.3 if name == LOOK_AHEAD_BOUND else 0.99)


@pytest.mark.parametrize(
    "change",
    [
        {"junction_deviation_mm": 0.02},
        {"idle_delay_s": 0.2},
        {"acceleration_mm_s2": (240, 240, 50)},
        {"max_rate_mm_min": (2400, 2400, 800)},
    ],
)
def test_other_settings_are_noticed(change):
    recorded, toolpath, limits = case("corners_a")
    assert abs(duration_s(toolpath, replace(limits, **change)) - recorded["duration_s"]) > 0.02
