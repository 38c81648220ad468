# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pulses that are held, let go and slowed down while they are made: braking on the path, and every pulse of it."""

from __future__ import annotations

import numpy as np
import pytest
from ramp_programs import RAMPS, table_of

from CNCStepper.errors import MachineRefusal
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.machine.profile import load_machine
from CNCStepper.motion.planner.buffers import TICKS_PER_S
from CNCStepper.motion.planner.feed_hold import REST_S, REST_TICKS, FeedHold
from CNCStepper.motion.signals.parallel_port import pin_levels, port_chunks
from CNCStepper.motion.signals.pulse_stream import moves_of, pulse_stream
from CNCStepper.state import Start

MACHINE = load_machine("table-a")
ZIGZAG = [((4.0 * (number % 3), 2.0 * number, 0.0), 3000, number % 4 == 0) for number in range(1, 20)]
SPINDLE_PIN = 14


def steps_of(stream):
    """Return ticks, positions and how long it stood in holds (s), of a stream that is being asked by `act`."""
    ticks, moves, rests = [], [], 0
    for chunk in stream:
        rests += chunk.held_until is not None
        ticks.append(chunk.ticks.copy())
        moves.append(moves_of(chunk, 3))
    return np.concatenate(ticks), np.cumsum(np.concatenate(moves), axis=0), rests * REST_S


def meddled(stream, reins, seed):
    """Yield the chunks of a stream, and hold, let go or slow down behind some of them."""
    rng = np.random.default_rng(seed)
    for chunk in stream:
        yield chunk
        if reins.held:
            reins.held = rng.random() < 0.7
        elif rng.random() < 0.1:
            reins.hold()
        elif rng.random() < 0.1:
            reins.slow(rng.uniform(0.2, 1.0))


@pytest.mark.parametrize("limits", RAMPS)
def test_without_a_word_the_pulses_are_those_of_the_whole_pass(limits):
    whole, held = (steps_of(pulse_stream(table_of(ZIGZAG), limits, reins=reins)) for reins in (None, FeedHold()))
    assert (whole[0] == held[0]).all() and (whole[1] == held[1]).all()


@pytest.mark.parametrize("limits", RAMPS)
@pytest.mark.parametrize("seed", range(4))
def test_meddling_changes_no_pulse_but_its_time(limits, seed):
    """Each axis makes the same pulses in the same order, and none faster than it may."""
    _, places, _ = steps_of(pulse_stream(table_of(ZIGZAG), limits))
    reins = FeedHold()
    ticks, seen, rest_s = steps_of(meddled(pulse_stream(table_of(ZIGZAG), limits, reins=reins), reins, seed))
    assert rest_s > 0 and (np.diff(ticks) > 0).all()
    for axis in range(2):
        own, as_programmed = (np.diff(column, prepend=0) for column in (seen[:, axis], places[:, axis]))
        assert (own[own != 0] == as_programmed[as_programmed != 0]).all()
        times = ticks[np.flatnonzero(own)]
        fastest = limits.max_rate_mm_min[axis] / 60 * limits.steps_per_mm[axis]
        assert (TICKS_PER_S * 8 / (times[8:] - times[:-8])).max() <= fastest * 1.02


def speed_mm_s(ticks, at):
    """Return the speed along X over the eight steps behind a row."""
    return 8 / 80 / ((ticks[at + 8] - ticks[at]) / TICKS_PER_S)


def test_a_hold_brakes_as_hard_as_the_axis_may_and_comes_back_so():
    """At 50 mm/s and 250 mm/s² braking takes 5 mm and 0.2 s, and so does coming back."""
    reins, path = FeedHold(), table_of([((-100.0, 0.0, 0.0), 3000, False)])
    ticks, rests = [], []
    for number, chunk in enumerate(pulse_stream(path, MACHINE, reins=reins)):
        ticks += chunk.ticks.tolist()
        if chunk.held_until is not None:
            rests.append((len(ticks), chunk.held_until))
        if number == 20:  # 0.8 s: it cruises
            reins.hold()
            asked = len(ticks)
        if len(rests) == 10:
            reins.resume()
    ticks = np.array(ticks)
    held, since = rests[0]
    assert [row for row, _ in rests] == [held] * 10
    assert (held - asked) / 80 == pytest.approx(5.0, abs=0.7)
    assert (since - ticks[asked]) / TICKS_PER_S == pytest.approx(0.2, abs=0.03)
    assert np.diff([tick for _, tick in rests[1:]]).tolist() == [REST_TICKS] * 8
    assert ticks[held] >= rests[-1][1] + REST_TICKS and len(ticks) == 8000
    assert speed_mm_s(ticks, held + 400 - 8) == pytest.approx(50, rel=0.05)


def test_a_share_slows_feeds_and_rapids_and_is_never_above_what_was_tried():
    path = table_of([((-50.0, 0.0, 0.0), 1200, False), ((0.0, 0.0, 0.0), 0, True)])
    as_programmed = steps_of(pulse_stream(path, MACHINE))[0]
    reins = FeedHold()
    reins.slow(0.5)
    slowed = steps_of(pulse_stream(path, MACHINE, reins=reins))[0]
    middle = (2000, 6000)  # the feed's and the rapid's
    for row in middle:
        assert speed_mm_s(slowed, row) == pytest.approx(speed_mm_s(as_programmed, row) / 2, rel=0.01)
    for share in (0.0, 1.01, float("nan")):
        with pytest.raises(MachineRefusal, match="share of the programmed speed"):
            reins.slow(share)


@pytest.mark.parametrize(("laser", "lit"), [(True, False), (False, True)])
def test_a_beam_goes_out_in_a_hold_and_comes_back_with_the_pulses_a_spindle_turns_on(laser, lit):
    """What is written while it is held says so again and again, for who waits for writes."""
    spindle = MACHINE.spindle.model_copy(update={"laser": laser})
    machine = MACHINE.model_copy(update={"spindle": spindle})
    path = interpret("G21 G90 G17 G94\nM3 S100\nG1 X-20 F3000\nM5\nG0 X0\nM2\n", Start.at_zero(), "grbl", "job.nc")
    reins, writes = FeedHold(), []
    for number, chunk in enumerate(port_chunks(pulse_stream(path, machine, reins=reins), machine.signals)):
        writes += zip(chunk.data.tolist(), chunk.control.tolist(), strict=True)
        reins.held = 8 <= number < 20
    shines = [pin_levels(*write)[SPINDLE_PIN] for write in writes]
    rests = [shines[row] for row in range(1, len(writes)) if writes[row] == writes[row - 1]]
    assert len(rests) >= 5 and set(rests) == {lit}
    changes = np.diff(np.array(shines, int), prepend=0).tolist()
    assert [changes.count(change) for change in (1, -1)] == ([2, 2] if laser else [1, 1])
