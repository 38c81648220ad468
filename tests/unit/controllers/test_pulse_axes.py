# SPDX-License-Identifier: LGPL-2.1-or-later
"""Moves on a board of ours: the way and its speeds, holds, resumes, overrides and resets, by the pulses played."""

from __future__ import annotations

import itertools
import math
import random
from bisect import bisect_right

import numpy as np
import pytest

from CNCStepper.controllers.pulse_axes import AHEAD_S
from CNCStepper.machine.profile import Machine, load_machine
from helpers.controllers.talk import Talk

LONG = ("G21G90G94", "G1X100F1800")
BRAKE_S = 30.0 / 100.0  # from 1800 mm/min at 100 mm/s²
START_STEP_S = math.sqrt(2 / 40 / 100.0)  # of one axis from rest; the planner makes a whole segment of it and a bit


@pytest.fixture(params=["planner", "dda"])
def machine(request: pytest.FixtureRequest) -> Machine:
    return load_machine("thesis-table").model_copy(update={"interpolation": request.param})


@pytest.fixture
def talk(machine: Machine) -> Talk:
    return Talk(machine)


def begin(talk: Talk, seconds: float = 1.0) -> None:
    """Begin a long move and let some time of it pass."""
    for line in LONG:
        assert talk.line(line) == "ok"
    talk.pass_time(seconds)
    assert talk.status()[""] == "Run"


def times_of(talk: Talk) -> np.ndarray:
    return np.array([time_s for time_s, *_ in talk.output.played])


def test_a_program_ends_where_it_should_and_is_reported(talk: Talk) -> None:
    talk.send("G21G90G94F900", "G1X10Y-5", "G3X0Y5I-5J5", "G0X3.5Y0")
    assert talk.output.position_steps == (140, 0, 0)
    assert talk.status()["MPos"] == "3.500,0.000,0.000"
    assert talk.status()[""] == "Idle"


def test_no_more_is_queued_than_the_time_ahead(talk: Talk) -> None:
    begin(talk)
    queued_s = []
    for _ in range(300):
        talk.pass_time(0.005)
        queued_s.append(talk.output.queued_s)
    assert max(queued_s) < AHEAD_S + 0.05
    assert min(queued_s) > AHEAD_S - 0.1


def test_a_hold_acts_within_5_ms_and_ends_with_the_ramp(talk: Talk) -> None:
    begin(talk)
    asked_s, before = talk.output.time_s, len(talk.output.played)
    talk.say("!", 0.001)
    assert [what for time_s, what in talk.output.commands if time_s <= asked_s + 0.005] == ["hold"]
    talk.pass_time(1.0)
    times_s = times_of(talk)
    assert len(times_s) > before
    assert times_s[-1] <= asked_s + 0.005 + BRAKE_S
    assert talk.status()[""] == "Hold:0"
    waits_s = np.diff(times_s[before - 1 :])
    assert (np.diff(waits_s) > -1e-6).all(), "it only gets slower"


def test_a_resume_goes_on_with_the_same_pulses(machine: Machine) -> None:
    held, unheld = Talk(machine), Talk(machine)
    for talk in (held, unheld):
        begin(talk)
    held.say("!", 1.0)
    assert held.status()[""] == "Hold:0"
    held.say("~")
    for talk in (held, unheld):
        talk.until_idle()
    assert [pulse[1:] for pulse in held.output.played] == [pulse[1:] for pulse in unheld.output.played]
    assert held.output.time_s > unheld.output.time_s + 0.9


def test_a_hold_near_the_end_of_a_move_is_released(talk: Talk) -> None:
    talk.line("G21G91G1X1F900")
    talk.pass_time(0.1)
    talk.say("!", 1.0)
    assert talk.status()[""] == "Hold:0"
    talk.say("~")
    talk.until_idle()
    assert talk.output.position_steps == (40, 0, 0)


def test_an_override_below_100_percent_slows_down_at_once(talk: Talk) -> None:
    begin(talk)
    talk.say(b"\x92" * 5, 0.5)
    waits_s = np.diff(times_of(talk)[-20:])
    assert waits_s.mean() * 40 == pytest.approx(2 / 30.0, rel=0.01)
    assert talk.status()["FS"].startswith("900,")


def test_an_override_above_100_percent_is_felt_behind_what_is_queued(machine: Machine) -> None:
    talk = Talk(machine)
    talk.line("G21G90G94")
    for number in range(1, 13):
        talk.line(f"G1X{5 * number}F600")
    talk.say(b"\x91" * 5, 0.0)
    talk.until_idle()
    gaps_s = np.diff(times_of(talk))
    assert gaps_s.min() * 40 == pytest.approx(1 / 15.0, rel=0.02)


def test_a_rapid_override_acts_on_rapids_alone(talk: Talk) -> None:
    talk.say(b"\x97")
    talk.send("G21G90G94", "G0X20")
    rapid_s = np.diff(times_of(talk)).min() * 40
    assert rapid_s == pytest.approx(4 / 30.0, rel=0.02)
    first = len(talk.output.played)
    talk.send("G1X0F1200")
    assert np.diff(times_of(talk)[first:]).min() * 40 == pytest.approx(1 / 20.0, rel=0.02)


def test_a_reset_in_motion_loses_the_position_and_one_when_held_keeps_it(talk: Talk) -> None:
    begin(talk)
    assert "ALARM:3" in talk.say(b"\x18")
    assert "stop_at_once" in [what for _, what in talk.output.commands]
    here = talk.output.position_steps
    talk.pass_time(1.0)
    assert talk.output.position_steps == here
    assert talk.line("$X") == "ok"
    talk.send("G21G90G94", "G1X0F900")
    assert talk.output.position_steps == (0, 0, 0)


def test_pulses_still_played_at_a_reset_move_no_axis_later(talk: Talk, monkeypatch: pytest.MonkeyPatch) -> None:
    """The player hears of a stop some pulses later; a move of another axis does not take them back."""
    begin(talk)
    monkeypatch.setattr(talk.output, "stop_at_once", talk.output.hold)
    here = talk.output.position_steps
    assert "ALARM:3" in talk.say(b"\x18")
    talk.pass_time(1.0)
    stopped = talk.output.position_steps
    assert stopped[0] > here[0]
    assert talk.line("$X") == "ok"
    talk.send("G21G90G94", "G1Y1F900")
    assert talk.output.position_steps == (stopped[0], stopped[1] + 40, 0)


def test_a_reset_when_held_keeps_the_position(talk: Talk) -> None:
    begin(talk)
    talk.say("!", 1.0)
    here = talk.output.position_steps
    said = talk.say(b"\x18", 0.5)
    assert said == ["Grbl 1.1h ['$' for help]"]
    assert talk.status()[""] == "Idle" and talk.output.position_steps == here
    assert "stop_at_once" not in [what for _, what in talk.output.commands]
    talk.send("G21G90G94", "G1X0F900")
    assert talk.output.position_steps == (0, 0, 0)


def test_a_jog_is_cancelled_with_a_ramp(talk: Talk) -> None:
    assert talk.line("$J=G91G21X50F1800") == "ok"
    talk.pass_time(0.8)
    assert talk.status()[""] == "Jog"
    asked_s = talk.output.time_s
    talk.say(b"\x85", 1.0)
    assert talk.status()[""] == "Idle"
    assert asked_s + 0.1 < times_of(talk)[-1] <= asked_s + 0.005 + BRAKE_S
    here = talk.output.position_steps
    talk.send("G21G91G94", "G1X1F900")
    assert talk.output.position_steps == (here[0] + 40, 0, 0)


def test_a_slow_move_is_not_planned_for_ever() -> None:
    """A pulse in 15 s: it is played in its time, and a hold finds no more than that one."""
    talk = Talk(load_machine("thesis-table").model_copy(update={"interpolation": "dda"}))
    assert talk.line("G21G90G94G1X1F0.1") == "ok"
    talk.pass_time(0.2)
    talk.say("!", 0.1)
    talk.say(b"\x18")
    assert len(talk.output.played) <= 2


def test_a_sender_can_count_every_move_that_is_not_cut(talk: Talk) -> None:
    """Of many short moves the status counts all that are under way."""
    most = int(next(line for line in talk.say("$I\n") if line.startswith("[OPT:")).split(",")[1])
    talk.line("G21G90G94F1500")
    ends = [4 * number for number in range(1, 200)]
    for taken, end in enumerate(ends, 1):
        answer = talk.say(f"G1X{end / 40}\n", 0.001)
        while "ok" not in answer:
            answer += talk.say(b"", 0.001)
        under_way = most - int(talk.status()["Bf"].split(",")[0])
        cut = bisect_right(ends, talk.output.position_steps[0])
        assert taken - under_way <= cut, "none is taken for cut that is not"
    talk.until_idle()
    assert talk.output.position_steps == (ends[-1], 0, 0)
    assert talk.status()["Bf"] == f"{most},128"


def test_many_short_moves_in_line_keep_their_speed() -> None:
    """The planner looks ahead over what is not made, however much is: 15 of them are 1.5 mm."""
    took_s = []
    for ends_mm in ([number / 10 for number in range(1, 300)], [29.9]):
        talk = Talk(load_machine("thesis-table"))
        talk.send("G21G90G94F600", *(f"G1X{end}" for end in ends_mm))
        took_s.append(talk.output.played[-1][0] - talk.output.played[0][0])
    assert took_s[0] < 1.1 * took_s[1]


def corners(seed: int) -> list[str]:
    """Return moves with reversals and turns, short and long."""
    dice = random.Random(seed)
    place, lines = [0, 0], []
    for _ in range(25):
        axis = dice.choice((0, 1, 2))
        for each in (0, 1):
            if axis in (each, 2):
                place[each] = min(max(place[each] + dice.choice((-40, -3, -1, 1, 3, 40)), -200), 200)
        lines.append(f"G1X{place[0] / 10}Y{place[1] / 10}")
    return lines


@pytest.mark.parametrize("seed", range(4))
def test_every_reversal_and_stop_passes_through_the_start_stop_region(machine: Machine, seed: int) -> None:
    print(f"seed {seed}")
    talk = Talk(machine)
    talk.send("G21G90G94F1800", *corners(seed))
    reversals = 0
    for axis in (0, 1):
        own = [(time_s, bool(back >> axis & 1)) for time_s, step, back, _ in talk.output.played if step >> axis & 1]
        for (before_s, before), (after_s, after) in itertools.pairwise(own):
            if before != after:
                reversals += 1
                assert after_s - before_s > START_STEP_S / 2.5, "as slow as a first step from rest"
    assert reversals > 5
