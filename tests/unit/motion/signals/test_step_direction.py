# SPDX-License-Identifier: LGPL-2.1-or-later
"""The edges of step, direction and enable lines: widths, gaps, set-up, and the pulses that they carry."""

from itertools import pairwise

import numpy as np
import pytest

from CNCStepper.errors import MachineRefusal
from CNCStepper.machine.wiring import Signals
from CNCStepper.motion.planner.buffers import TICKS_PER_S
from CNCStepper.motion.signals.pulse_stream import PulseChunk, PulseStream, Switch
from CNCStepper.motion.signals.step_direction import MOST_LATE_S, Timeline


def random_chunks(rng, count, pieces=5, least_tick=60):
    """Return chunks of random pulses with reversals, the clock in µs."""
    ticks = np.cumsum(rng.integers(least_tick, 400, count))
    step = rng.integers(1, 8, count).astype(np.uint8)
    back = (step & rng.integers(0, 8, count)).astype(np.uint8)
    cuts = [0, *sorted(rng.integers(0, count, pieces - 1)), count]
    return [PulseChunk(ticks[a:b], step[a:b], back[a:b]) for a, b in pairwise(cuts)]


def edges_of(chunks, signals):
    timeline = Timeline(PulseStream(chunks, 3, 1_000_000), signals)
    edges = list(timeline)
    return timeline, np.concatenate([e.ticks for e in edges]), np.concatenate([e.levels for e in edges])


def line(timeline, levels, name):
    return (levels >> timeline.lines.index(name)) & 1


def counted(timeline, levels, motor):
    """Return the position that a drive counts: at each rising edge of its step line, as its direction line stands."""
    step, direction = line(timeline, levels, f"{motor}_step"), line(timeline, levels, f"{motor}_direction")
    rising = np.flatnonzero(np.diff(step.astype(int), prepend=0) == 1)
    return int(np.sum(1 - 2 * direction[rising].astype(int)))


@pytest.mark.parametrize("seed", range(20))
def test_widths_gaps_and_set_up_hold_and_the_drives_count_the_target(seed):
    rng = np.random.default_rng(seed)
    pulse, gap, setup = rng.integers(1, 15, 3).tolist()
    print("seed", seed, "pulse", pulse, "gap", gap, "setup", setup)
    signals = Signals(pulse_us=pulse, gap_us=gap, direction_setup_us=setup, motors=("x", "-y", "z", "-x"))
    chunks = random_chunks(rng, 400)
    timeline, ticks, levels = edges_of(chunks, signals)
    assert (np.diff(ticks) >= gap).all()
    assert (np.diff(levels.astype(np.int64)) != 0).all()
    for motor in signals.motor_names:
        step, direction = line(timeline, levels, f"{motor}_step"), line(timeline, levels, f"{motor}_direction")
        changes = np.flatnonzero(np.diff(step.astype(int), prepend=0))
        rises, falls = changes[::2], changes[1::2]
        assert (ticks[falls] - ticks[rises] >= pulse).all()
        assert (ticks[rises[1:]] - ticks[falls[:-1]] >= gap).all()
        for turn in np.flatnonzero(np.diff(direction.astype(int), prepend=0)):
            assert not step[turn]
            after = rises[rises > turn]
            assert not len(after) or ticks[after[0]] - ticks[turn] >= setup
    target = {
        axis: sum(int(((c.step >> n) & 1).sum()) - 2 * int(((c.back >> n) & 1).sum()) for c in chunks)
        for n, axis in enumerate("xyz")
    }
    for motor, turning in zip(signals.motor_names, signals.motors, strict=True):
        sense = -1 if turning.startswith("-") else 1
        assert counted(timeline, levels, motor) == sense * target[turning[-1]]


def test_a_pulse_comes_at_its_moment_where_nothing_turns():
    chunk = PulseChunk(np.array([100, 200, 300]), np.array([1, 3, 1], np.uint8), np.zeros(3, np.uint8))
    timeline, ticks, levels = edges_of([chunk], Signals())
    step = line(timeline, levels, "x_step")
    rising = ticks[np.diff(step.astype(int), prepend=0) == 1]
    np.testing.assert_array_equal(rising - timeline.lead, [100, 200, 300])
    assert timeline.late_ticks == 0


def test_the_drives_are_on_before_the_first_edge_and_off_after_the_last():
    chunk = PulseChunk(np.array([0, 50]), np.array([1, 1], np.uint8), np.array([1, 0], np.uint8))
    timeline, ticks, levels = edges_of([chunk], Signals(enable_lead_us=700))
    assert line(timeline, levels, "enable").tolist() == [1] * (len(levels) - 1) + [0]
    assert ticks[0] == 0 and ticks[1] >= 700 and levels[-1] & 1 == 0


def test_devices_switch_between_the_pulses_that_they_stand_between():
    switches = (Switch(1, 90, "flood", True), Switch(2, 201, "spindle_cw", False), Switch(2, 201, "flood", False))
    chunk = PulseChunk(np.array([50, 200]), np.array([1, 1], np.uint8), np.zeros(2, np.uint8), switches)
    timeline, ticks, levels = edges_of([chunk], Signals())
    flood, step = line(timeline, levels, "flood"), line(timeline, levels, "x_step")
    on, off = np.flatnonzero(np.diff(flood.astype(int), prepend=0))
    assert ticks[on] == 90 + timeline.lead
    assert step[:on].sum() == 1 and step[on:off].sum() == 1 and not step[off:].any()


@pytest.mark.parametrize("interval", [5, 15])
def test_pulses_that_the_lines_cannot_carry_are_refused(interval):
    count = 10_000
    step = np.ones(count, np.uint8)
    chunk = PulseChunk(np.arange(count) * interval, step, np.zeros(count, np.uint8))
    with pytest.raises(MachineRefusal, match="pulse-rate") as refusal:
        edges_of([chunk], Signals())
    assert refusal.value.limit == "50000 pulses/s"


def test_the_delay_of_a_reversal_does_not_grow():
    count = 20_000
    back = (np.arange(count) % 10 == 0).astype(np.uint8)
    chunk = PulseChunk(np.arange(count) * 33, np.ones(count, np.uint8), back)
    timeline, _, _ = edges_of([chunk], Signals())
    assert 0 <= timeline.late_ticks <= 10 < MOST_LATE_S * TICKS_PER_S


def test_a_stream_without_a_clock_is_refused():
    with pytest.raises(MachineRefusal, match="no-clock"):
        Timeline(PulseStream([], ticks_per_s=None), Signals())
