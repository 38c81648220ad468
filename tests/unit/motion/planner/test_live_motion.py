# SPDX-License-Identifier: LGPL-2.1-or-later
"""The live motion: holds, overrides, resets and starvation at any moment, and the path it reports."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from CNCStepper.errors import MachineRefusal
from CNCStepper.machine.profile import load_machine
from CNCStepper.motion.planner.live_motion import Motion
from CNCStepper.motion.planner.machine_limits import Limits
from CNCStepper.motion.planner.plan import duration_s
from CNCStepper.state import Start
from CNCStepper.toolpath import TableBuilder
from helpers.motion.meddling import held_on_a_line

LIMITS = Limits.of(load_machine("table-a"))
TARGETS = np.cumsum(np.random.default_rng(3).normal(0, 0.6, (60, 3)) * (1, 1, 0.1), axis=0)


def run(motion, targets, feed=1800, dt_s=0.002, meddle=None):
    """Feed lines as there is room and let time pass until all is done; returns the time it took."""
    waiting = [tuple(target) for target in targets]
    begin_s = motion.time_s
    while waiting or not motion.idle:
        while waiting and motion.room:
            motion.line(waiting.pop(0), feed, tag=len(targets) - len(waiting))
        motion.advance(dt_s)
        if meddle:
            meddle(motion)
        assert motion.time_s - begin_s < 600
    return motion.time_s - begin_s


def steps_of(target):
    return np.rint(np.array(target, np.float32) * np.array(LIMITS.steps_per_mm, np.float32)).astype(int).tolist()


def pulses(motion):
    positions = np.vstack([np.zeros(3), motion.step_path()[:, 1:]])
    return np.abs(np.diff(positions, axis=0)).sum(axis=0).tolist()


@pytest.mark.slow
def test_it_takes_the_time_that_the_planner_states():
    table = TableBuilder(Start.at_zero())
    for target in TARGETS:
        table.feed(target, 1800)
    assert run(Motion(LIMITS), TARGETS) == pytest.approx(duration_s(table.toolpath(), LIMITS) + 0.025, abs=0.05)


@pytest.mark.parametrize("dt_s", [*(pytest.param(dt_s, marks=pytest.mark.slow) for dt_s in (0.0007, 0.0173)), 30.0])
def test_the_length_of_the_time_steps_does_not_matter(dt_s):
    motions = [Motion(LIMITS, record=True) for _ in range(2)]
    for motion, step_s in zip(motions, (0.003, dt_s), strict=True):
        for target in TARGETS[:15]:
            motion.line(target, 1800)
        for _ in range(round(30 / step_s)):
            motion.advance(step_s)
    assert np.array_equal(motions[0].step_path(), motions[1].step_path())
    assert motions[0].idle and motions[0].position_steps == motions[1].position_steps


@settings(max_examples=20, deadline=None)
@given(
    st.lists(
        st.tuples(
            st.integers(1, 400),
            st.sampled_from(["hold", "resume", "feed", "rapid", "starve"]),
            st.floats(0.1, 2.0),
        ),
        max_size=12,
    )
)
@pytest.mark.slow
def test_meddling_never_costs_a_pulse(acts):
    plain = Motion(LIMITS, record=True)
    run(plain, TARGETS)
    motion = Motion(LIMITS, record=True)
    queue, clock = list(acts), [0]

    def meddle(motion):
        clock[0] += 1
        if queue and clock[0] >= queue[0][0]:
            clock[0] = 0
            _, act, factor = queue.pop(0)
            if act == "hold":
                motion.hold()
            elif act == "resume":
                motion.resume()
            elif act == "starve":
                motion.advance(1.0)
            else:
                motion.override(*((factor, 1.0) if act == "feed" else (1.0, min(factor, 1.0))))
        if motion.held and not queue:
            motion.resume()

    run(motion, TARGETS, meddle=meddle)
    assert list(motion.position_steps) == steps_of(TARGETS[-1])
    assert pulses(motion) == pulses(plain)


@pytest.mark.slow
@settings(max_examples=20, deadline=None)
@given(st.integers(0, 300), st.floats(0.1, 2.0))
def test_holds_and_overrides_keep_to_the_acceleration(after, factor):
    motion, accelerations = held_on_a_line(LIMITS, after, factor, 80)
    assert accelerations.max() * 0.05 <= 250 * 0.05 + 2 / 80 / 0.05 + 1
    assert motion.position_steps == (6400, 0, 0)


def test_hold_brakes_on_the_path_and_resume_goes_on():
    motion = Motion(LIMITS, record=True)
    motion.line((30, 15, 0), 3000, tag=7)
    motion.advance(0.5)
    assert motion.state == "run" and motion.tag == 7 and motion.rate_mm_min == pytest.approx(3000)
    motion.hold()
    assert motion.holding and not motion.resume()
    motion.advance(0.4)
    assert motion.state == "held" and motion.rate_mm_min == 0 and motion.tag is None and not motion.idle
    x, y, _ = motion.position_mm
    assert 10 < x < 29 and y == pytest.approx(x / 2, abs=0.02)
    motion.advance(5)
    assert motion.position_mm[:2] == (x, y)
    assert motion.resume() and not motion.held
    motion.advance(5)
    assert motion.idle and motion.position_steps == (2400, 1200, 0)


def test_a_hold_at_rest_is_complete_at_once():
    motion = Motion(LIMITS)
    motion.hold()
    assert motion.held and not motion.idle
    motion.line((1, 0, 0), 600)
    motion.advance(1)
    assert motion.position_steps == (0, 0, 0)
    motion.resume()
    motion.advance(1)
    assert motion.position_steps == (80, 0, 0) and motion.idle


@pytest.mark.slow
def test_reset_in_motion_says_so_and_reset_when_held_does_not():
    motion = Motion(LIMITS, record=True)
    motion.line((30, 0, 0), 3000)
    motion.advance(0.5)
    assert motion.reset() and motion.idle is False
    stopped_at = motion.position_steps
    motion.advance(1)
    assert motion.idle and motion.position_steps == stopped_at and motion.room == 15
    assert motion.step_path()[-1, 1:].tolist() == list(stopped_at)
    motion.line((30, 0, 0), 3000)
    motion.advance(0.3)
    motion.hold()
    motion.advance(1)
    assert motion.held and not motion.reset()
    motion.line((0, 0, 0), 3000)
    motion.advance(5)
    assert motion.position_steps == (0, 0, 0)


def test_a_full_planner_and_unknown_places_are_refused():
    motion = Motion(LIMITS)
    for x in range(15):
        assert motion.room == 15 - x == 15 - motion.blocks
        motion.line((x + 1, 0, 0), 600)
    with pytest.raises(MachineRefusal, match="planner-full"):
        motion.line((99, 0, 0), 600)
    with pytest.raises(MachineRefusal, match="not-finite"):
        Motion(LIMITS).line((math.nan, 0, 0), 600)


def test_a_move_shorter_than_a_step_takes_no_place():
    motion = Motion(LIMITS)
    assert not motion.line((0.001, 0, 0), 600)
    assert motion.room == 15 and motion.idle


def test_starved_motion_stops_between_the_lines():
    motion = Motion(LIMITS)
    for x in (1, 2, 3):
        motion.line((x, 0, 0), 1200)
        motion.advance(1)
        assert motion.idle and motion.position_steps == (80 * x, 0, 0)


def test_overrides_change_the_speed_under_way():
    motion = Motion(LIMITS)
    motion.line((200, 0, 0), 1000)
    motion.line((400, 0, 0), 0, rapid=True)
    motion.advance(1)
    motion.override(1.5, 0.25)
    motion.advance(1)
    assert motion.rate_mm_min == pytest.approx(1500)
    motion.advance(8)
    assert motion.rate_mm_min == pytest.approx(1250)


def test_the_path_has_the_ends_of_the_segments_and_is_drained():
    motion = Motion(LIMITS, record=True)
    motion.line((10, 5, 0), 1200)
    motion.advance(10)
    path = motion.path()
    assert path[-1, 1:].tolist() == [800, 400, 0] and np.diff(path[:, 0]).max() < 0.03
    assert np.abs(path[:, 1] - 2 * path[:, 2]).max() <= 2
    assert len(motion.path()) == 0
    assert len(Motion(LIMITS).path()) == 0


def test_it_begins_where_it_is_told():
    motion = Motion(LIMITS, (800, -80, 4))
    assert motion.position_mm == (10.0, -1.0, 0.01)
    motion.line((10, -1, 0), 600)
    motion.advance(1)
    assert motion.position_steps == (800, -80, 0)
