# SPDX-License-Identifier: LGPL-2.1-or-later
"""The planner against recordings of grbl 1.1 firmware: the same time, the same pulses, the same path."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from CNCStepper.motion.planner.buffers import TICKS_PER_S
from CNCStepper.motion.planner.machine_limits import Limits
from CNCStepper.motion.planner.plan import sample, step_events
from CNCStepper.motion.planner.table_planning import CHORD_TICKS, LINE_TICKS
from CNCStepper.state import Start, State
from CNCStepper.toolpath import TableBuilder, Toolpath
from helpers.motion.firmware_recordings import NAMES, end_steps, limits_of, recording, toolpath_of

LOOK_AHEAD_BOUND = "ellipse-fine_b"  # braking takes all 15 blocks: here the processor's own pace shows
SAMPLES = "samples_t_s_x_y_z_steps"
CHANGES = {"spindle": {"spindle": "cw"}, "flood": {"flood": True}, "offset_mm": {"offset_mm": (0.0, 0.0, 1.0)}}


@cache
def case(name: str) -> tuple[dict, Toolpath, Limits]:
    recorded = recording(name)
    return recorded, toolpath_of(recorded["program"]), limits_of(recorded["settings"])


@cache
def steps(name: str) -> tuple[np.ndarray, np.ndarray]:
    """Return the times and positions of all step events."""
    _, toolpath, limits = case(name)
    return steps_of(toolpath, limits)


def steps_of(toolpath: Toolpath, limits: Limits) -> tuple[np.ndarray, np.ndarray]:
    """Return the times and positions of all step events."""
    times, positions = zip(*step_events(toolpath, limits), strict=True)
    return np.concatenate(times), np.concatenate(positions)


def duration_s(toolpath: Toolpath, limits: Limits, of: Toolpath | None = None) -> float:
    """Return the time from the first to the last step, of the table or of its end that makes the steps of `of`."""
    times, _ = steps_of(toolpath, limits)
    count = len(steps_of(of, limits)[0]) if of else len(times)
    return times[-1] - times[-count]


@pytest.mark.parametrize("name", NAMES)
def test_takes_the_same_time_to_the_same_place(name):
    recorded, toolpath, limits = case(name)
    assert duration_s(toolpath, limits) == pytest.approx(recorded["duration_s"], abs=0.005)
    assert steps(name)[1][-1].tolist() == end_steps(recorded)


@pytest.mark.parametrize("stop", ["dwell", "pause", "output", "spindle", "flood", "offset_mm"])
def test_arcs_from_a_standstill_take_what_they_took_at_the_program_begin(stop):
    recorded, arcs, limits = case("arcs_c")
    assert duration_s(after_a_stop(arcs, stop), limits, of=arcs) == pytest.approx(recorded["duration_s"], abs=0.0005)
    run_through = duration_s(after_a_stop(arcs, ""), limits, of=arcs)
    assert run_through < recorded["duration_s"] - 0.005  # the arcs begin as the axes pass by


def test_an_arc_from_a_standstill_is_queued_whole_before_its_first_step():
    _, arcs, limits = case("arcs_c")
    first_s = {blocks: steps_of(arcs, replace(limits, look_ahead_blocks=blocks))[0][0] for blocks in (4, 15, 400)}
    line_s, chord_s = LINE_TICKS / TICKS_PER_S, CHORD_TICKS / TICKS_PER_S
    assert first_s[15] > line_s + 8 * chord_s  # the first arc has 9 chords
    assert first_s[15] - first_s[4] > 5 * chord_s  # a buffer of 4 is full before
    assert first_s[400] <= first_s[15]  # a faster processor does not wait for what the firmware's buffer does not hold


def after_a_stop(arcs: Toolpath, stop: str) -> Toolpath:
    """Return the arcs behind a way that ends where they begin, with a stop of one kind, or none, between the two."""
    before = 2
    states = [State(), replace(State(), **CHANGES.get(stop, {}))]
    builder = TableBuilder(Start.at_zero())
    builder.feed((-20.0, 0.0, 0.0), 2000.0, 1)
    builder.feed((0.0, 0.0, 0.0), 2000.0, 2)
    if stop and stop not in CHANGES:
        builder.event(stop, 0.1)
    head = builder.toolpath()
    (rows,) = arcs.chunks
    behind = replace(rows, first=before, state=np.full(len(rows), 1 if stop in CHANGES else 0, rows.state.dtype))
    return replace(head, chunks=[*head.chunks, behind], states=states)


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
