# SPDX-License-Identifier: LGPL-2.1-or-later
"""The player on a clock of its own: whatever is held, shared and taken back, the pulses written are the planned ones.

Writes are decoded by tests/helpers/control/virtual_player.py, which knows the pins and nothing of the encoder.
"""

from __future__ import annotations

import random
from itertools import pairwise
from math import sqrt
from typing import Any

import numpy as np
import pytest

from CNCStepper.control.pulses import pulse_player_client
from CNCStepper.errors import LinkError
from CNCStepper.motion.planner.buffers import TICKS_PER_S, UNLIMITED
from helpers.control.virtual_player import (
    ACCELERATION,
    STEPS_PER_MM,
    Plan,
    Pulse,
    VirtualPlayer,
    decoded,
    machine,
    random_plan,
)

STEP_MM = sqrt(3.0) / STEPS_PER_MM
STEP_SQR = 2 * ACCELERATION * STEP_MM  # by which u² may change on the way of a step of all axes
LAST_STEP_S = sqrt(2 * STEP_MM / ACCELERATION)


def even_plan(pulses: int, speed: float = 10.0, acceleration: float = ACCELERATION, rapid_to: int = 0) -> Plan:
    """Return pulses of x at one speed, which neither begins nor ends at rest."""
    wait = round(TICKS_PER_S / STEPS_PER_MM / speed)
    ones = np.ones(pulses)
    columns = ones.astype(np.uint8), np.zeros(pulses, np.uint8), (speed * ones).astype(np.float32)
    ticks = np.arange(1, pulses + 1, dtype=np.int64) * wait
    is_rapid = np.arange(pulses) < rapid_to
    return Plan(ticks, *columns, (acceleration * ones).astype(np.float32), is_rapid, ones / STEPS_PER_MM)


@pytest.fixture
def player(monkeypatch: pytest.MonkeyPatch) -> VirtualPlayer:
    return VirtualPlayer(monkeypatch, machine())


def walked(plan: Plan, pulses: list[Pulse]) -> list[int]:
    """Return the row behind which each pulse ends; asserts that each is the next one, or the last one taken back."""
    place, places = 0, []
    for pulse in pulses:
        row = place if pulse.sense > 0 else place - 1
        back = plan.back[row] if pulse.sense > 0 else plan.step[row] & ~plan.back[row]
        assert (pulse.step, pulse.back) == (plan.step[row], back), f"row {row}"
        place += pulse.sense
        places.append(place)
    return places


def speeds(plan: Plan, pulses: list[Pulse], places: list[int]) -> list[tuple[float, bool]]:
    """Return the mean path speed between each pulse and the next, and whether the axes may have stood between them."""
    found = []
    for (one, next_), place in zip(pairwise(pulses), places, strict=False):
        if one.sense != next_.sense:
            found.append((0.0, True))
            continue
        rests = plan.speed[place] == 0.0  # the row whose time lies between them, on the way back too
        found.append((0.0 if rests else float(plan.way_mm[place]) / ((next_.ns - one.ns) / 1e9), bool(rests)))
    return found


def test_on_the_plan_every_pulse_has_its_planned_time(player: VirtualPlayer) -> None:
    plan = random_plan(random.Random(5), 30)
    player.output.append(*plan.columns)
    assert player.output.state == "run" and player.output.queued_s == pytest.approx(
        (plan.ticks[-1] - plan.ticks[0]) / TICKS_PER_S
    )
    player.run_until("idle")
    pulses = decoded(player.port.rows)
    assert walked(plan, pulses)[-1] == len(plan.ticks) == len(pulses) == player.output.sent
    planned_ns = (plan.ticks - plan.ticks[0]) * (1e9 / TICKS_PER_S)
    late = np.array([pulse.ns - pulses[0].ns for pulse in pulses]) - planned_ns
    assert abs(late).max() < 10_000  # signals take 2 us, the clock goes by 0.1 us
    steps = [sum((p.step >> n & 1) - 2 * (p.back >> n & 1) for p in pulses) for n in range(3)]
    assert player.output.position_steps == tuple(steps)


@pytest.mark.parametrize("seed", range(20))
def test_held_shared_and_taken_back_the_pulses_are_the_planned_ones(monkeypatch: pytest.MonkeyPatch, seed: int) -> None:
    """Net the same pulses; speeds rise and fall within the acceleration; every reversal passes a stop."""
    print("seed", seed)
    dice = random.Random(seed)
    player, done = VirtualPlayer(monkeypatch, machine()), []
    plan = random_plan(dice, 20)
    output = player.output
    given = 0
    while output.state != "idle" or given < len(plan.ticks):
        if given < len(plan.ticks):
            more = len(plan.ticks) if dice.random() < 0.2 else dice.randint(200, 600)
            output.append(*(column[given : given + more] for column in plan.columns))
            given = min(given + more, len(plan.ticks))
        if len(done) < 40:
            done.append(_meddle(player, dice))
        else:
            output.share(1.0, 1.0)
            player.run_until("idle")
    pulses = decoded(player.port.rows)
    places = walked(plan, pulses)
    assert places[-1] == len(plan.ticks) == output.sent
    for name in ("hold", "hold again", "share", "back", "back and resumed on the way"):
        assert name in done, f"the case {name} does not occur"
    assert sum(one.sense != two.sense for one, two in pairwise(pulses)) > 2
    _check_speeds(plan, pulses, places)


def _meddle(player: VirtualPlayer, dice: random.Random) -> str:
    """Do one thing to a player that has something to play."""
    output = player.output
    player.run_for(dice.choice((0.0, 0.004, 0.05, 0.4, 0.4)))
    what = dice.choice(("hold", "hold again", "share", "back", "back and resumed on the way", "nothing"))
    if what == "share":
        output.share(dice.choice((0.1, 0.5, 1.0, 2.0)), dice.choice((0.25, 0.5, 1.0)))
    elif what == "hold again":
        output.hold()
        player.run_for(dice.choice((0.001, 0.02)))
        output.resume()
    elif what != "nothing":
        output.hold()
        player.run_until("held")
        if what != "hold":
            output.back(dice.choice((1, 20, 150)))
            player.run_for(dice.choice((0.01, 0.2))) if what != "back" else player.run_until("held")
        player.run_for(dice.choice((0.0, 0.01)))
        output.resume()
    return what


def _check_speeds(plan: Plan, pulses: list[Pulse], places: list[int]) -> None:
    """Assert that u² changes no faster than by 2 A ds, with a step as the tolerance, and is small at each rest."""
    run = speeds(plan, pulses, places)
    assert max(speed for speed, _ in run) > 5.0
    for number, ((u, rests), (then, rests_then)) in enumerate(pairwise(run)):
        allowed = 2 * STEP_SQR + 0.05 * max(u, then) ** 2
        if rests and not rests_then:  # a stop is passed: what comes first is as slow as a start
            assert then**2 <= 2 * STEP_SQR, f"pulse {number}: {then} mm/s from a rest"
        elif rests_then and not rests:
            assert u**2 <= 2 * STEP_SQR + 0.05 * u * u, f"pulse {number}: {u} mm/s into a rest"
        elif not rests:
            assert abs(then**2 - u**2) <= allowed, f"pulse {number}: {u} mm/s and then {then} mm/s"


def test_speeds_that_jump_are_seen() -> None:
    plan = even_plan(4)
    pulses = [Pulse(ns, 1, 0, 1) for ns in (0, 20_000_000, 40_000_000, 41_000_000)]
    with pytest.raises(AssertionError, match="mm/s and then"):
        _check_speeds(plan, pulses, walked(plan, pulses))


@pytest.mark.parametrize("seed", range(8))
def test_a_hold_brakes_within_5_ms_and_ends_within_the_braking_time(monkeypatch: pytest.MonkeyPatch, seed: int) -> None:
    print("seed", seed)
    dice = random.Random(seed)
    player, plan = VirtualPlayer(monkeypatch, machine()), even_plan(3000, speed=dice.choice((5.0, 20.0, 60.0)))
    player.output.append(*plan.columns)
    player.run_for(0.5 + dice.random() / 100)
    held_ns, speed = player.clock.ns, player.output.rate_mm_min / 60.0
    assert speed == pytest.approx(plan.speed[0])
    player.output.hold()
    assert player.output.state == "hold"
    player.run_until("held")
    pulses = [pulse.ns - held_ns for pulse in decoded(player.port.rows)]
    behind = [ns for ns in pulses if ns > 0]
    braking_s = speed / ACCELERATION
    assert behind[-1] / 1e9 <= 0.005 + braking_s + LAST_STEP_S
    way_mm = speed * 0.005 + speed**2 / 2 / ACCELERATION
    assert len(behind) <= way_mm * STEPS_PER_MM + 1
    waits = np.diff([ns for ns in pulses if ns > 5_000_000])
    assert len(waits) < 2 or (np.diff(waits) > 0).all()  # 5 ms after it every pulse is slower than the one before


def test_a_lower_share_of_feeds_is_reached_where_the_feed_begins(player: VirtualPlayer) -> None:
    plan = even_plan(2000, speed=20.0, rapid_to=1000)
    player.output.share(0.5, 1.0)
    player.output.append(*plan.columns)
    player.run_for(1000 / STEPS_PER_MM / 20.0 - 0.2)
    assert player.output.rate_mm_min == pytest.approx(1200.0)
    player.run_until("idle")
    pulses = decoded(player.port.rows)
    waits_ms = np.diff([pulse.ns for pulse in pulses]) / 1e6
    assert waits_ms[1000] == pytest.approx(5.0, rel=0.01) and waits_ms[900] == pytest.approx(2.5, rel=0.01)
    _check_speeds(plan, pulses[:1900], walked(plan, pulses)[:1900])


def test_pulses_are_taken_back_to_the_oldest_and_played_again(player: VirtualPlayer) -> None:
    plan = even_plan(400)
    player.output.append(*plan.columns)
    player.run_for(1.0)
    player.output.hold()
    player.run_until("held")
    reached = player.output.sent
    assert player.output.kept == reached
    player.output.back(10_000)
    assert player.output.state == "run"
    player.run_until("held")
    assert player.output.sent == 0 and player.output.position_steps == (0, 0, 0)
    player.output.resume()
    player.run_until("idle")
    pulses = decoded(player.port.rows)
    assert [pulse.sense for pulse in pulses] == [1] * reached + [-1] * reached + [1] * 400
    turned = 2 * reached  # behind it the plan begins at full speed
    _check_speeds(plan, pulses[:turned], walked(plan, pulses)[:turned])


def test_what_is_dropped_never_comes_and_what_follows_comes_at_once(player: VirtualPlayer) -> None:
    plan = even_plan(1000)
    player.output.append(*plan.columns)
    player.run_for(0.5)
    with pytest.raises(ValueError, match="at rest only"):
        player.output.drop()
    player.output.hold()
    player.run_until("held")
    reached = player.output.sent
    player.output.drop()
    assert player.output.queued_s == 0.0
    player.output.resume()
    player.run_until("idle")
    rest_ns = player.clock.ns
    later = player.output
    more = even_plan(10)
    later.append(more.ticks + 10 * int(plan.ticks[-1]), *more.columns[1:])
    player.run_until("idle")
    pulses = decoded(player.port.rows)
    assert len(pulses) == reached + 10 and pulses[reached].ns - rest_ns < 5_000_000


def test_a_dwell_keeps_its_time_at_every_share(player: VirtualPlayer) -> None:
    """The second half comes 3 s later: by its marked speed 0, and where only the time tells it."""
    for marked in (True, False):
        plan = even_plan(10, speed=1.0)
        ticks = plan.ticks + (plan.ticks[-1] * 9 if not marked else 0)
        ticks[5:] += 3 * TICKS_PER_S
        if marked:
            plan.speed[5] = 0.0
        player.output.share(0.5, 0.5)
        begun = len(decoded(player.port.rows))
        player.output.append(ticks, *plan.columns[1:])
        player.run_until("idle")
        times = [pulse.ns / 1e9 for pulse in decoded(player.port.rows)[begun:]]
        assert times[5] - times[4] == pytest.approx(3.0 + 0.05, abs=0.001)
        assert times[2] - times[1] == pytest.approx(0.1, abs=0.001)


def test_motors_that_may_start_at_once_do(player: VirtualPlayer) -> None:
    plan = even_plan(200, speed=50.0, acceleration=UNLIMITED)
    player.output.append(*plan.columns)
    player.run_for(0.1)
    player.output.hold()
    player.run_until("held")
    held_ns = player.clock.ns
    player.output.resume()
    player.run_until("idle")
    times = [pulse.ns for pulse in decoded(player.port.rows)]
    after = [ns for ns in times if ns > held_ns]
    assert len(times) == 200 and np.diff(after).max() < 1_010_000


def test_where_no_more_comes_it_brakes_to_the_end_of_what_is_queued(player: VirtualPlayer) -> None:
    plan = even_plan(3000, speed=40.0)
    player.output.append(*(column[:1000] for column in plan.columns))
    player.run_until("idle")
    player.output.append(*(column[1000:] for column in plan.columns))
    player.run_until("idle")
    pulses = decoded(player.port.rows)
    assert len(pulses) == 3000
    plan.speed[1000] = 0.0  # it has stood there
    _check_speeds(plan, pulses, walked(plan, pulses))


def test_pulses_that_end_at_full_speed_are_an_error_where_motors_follow(monkeypatch: pytest.MonkeyPatch) -> None:
    player = VirtualPlayer(monkeypatch, machine(), patience_ns=0, is_real=True)
    player.output.append(*even_plan(20, speed=40.0).columns)
    with pytest.raises(LinkError, match=r"no more of them came in time.*set it there"):
        player.run_for(1.0)


@pytest.mark.parametrize(("late_ns", "stalls"), [(1_900_000, False), (2_100_000, True)])
def test_a_write_that_is_late_by_a_pulse_of_the_program_ends_it(
    monkeypatch: pytest.MonkeyPatch, late_ns: int, stalls: bool
) -> None:
    """At 500 pulses/s a pulse is 2 ms."""
    player = VirtualPlayer(monkeypatch, machine(), patience_ns=0, is_real=True, takes_ns={100: late_ns})
    player.output.append(*even_plan(500, speed=25.0, acceleration=UNLIMITED).columns)
    if stalls:
        with pytest.raises(LinkError, match="was late with a pulse"):
            player.run_until("idle")
    else:
        player.run_until("idle")
        assert len(decoded(player.port.rows)) == 500
        assert player.output.jitter().worst_us == pytest.approx(late_ns / 1000, abs=50)


def test_stopped_at_once_nothing_follows_and_everything_is_off(player: VirtualPlayer) -> None:
    output = player.output
    output.append(*even_plan(3000, speed=40.0).columns)
    output.switch("flood", True)
    player.run_for(0.3)
    assert player.port.rows[-1][2] & 1 == 0  # pin 1 is turned round by the port
    output.stop_at_once()
    stopped_ns = player.clock.ns
    player.run_until("held")
    pulses = decoded(player.port.rows)
    assert pulses[-1].ns < stopped_ns + 2_100_000
    assert player.port.rows[-1][1:3] == (0, 0b1011)  # pins 1, 14 and 17 are turned round
    output.drop()
    output.resume()
    output.append(*(column[-3:] for column in even_plan(3003, speed=40.0).columns))
    player.run_until("idle")
    assert len(decoded(player.port.rows)) == len(pulses) + 3


def test_a_hold_while_the_device_lags_behind_still_brakes_by_its_ramp(player: VirtualPlayer) -> None:
    player.output.append(*even_plan(2000).columns)
    player.run_for(0.5)
    player.port.waiting = 17
    player.run_for(0.002)
    sent = player.output.sent
    player.output.hold()
    player.run_for(0.01)
    assert player.output.state == "hold" and player.output.sent == sent
    player.port.waiting = 0
    player.run_until("held")
    assert player.output.sent - sent > 3


def test_a_device_that_takes_nothing_any_more_is_lost_and_none_that_rested(player: VirtualPlayer) -> None:
    player.run_for(5.0)
    player.output.append(*even_plan(2000).columns)
    player.port.waiting = 17
    player.run_for(0.9)
    with pytest.raises(LinkError, match="accepted nothing for 1 s") as caught:
        player.run_for(0.2)
    assert caught.value.code == "port-lost"


def test_a_device_is_switched_off_while_a_rate_is_tried(player: VirtualPlayer, monkeypatch: pytest.MonkeyPatch) -> None:
    """A reset on the way of a trial must not leave the spindle on up to its end."""
    output, port = player.output, player.port
    output.switch("spindle_cw", True)
    player.run_for(0.01)
    on = port.rows[-1][1:3]
    begin_ns = player.clock.ns

    def write(data: int, control: int) -> None:
        port.rows.append((player.clock.ns, data, control, 1))
        if player.clock.ns - begin_ns > 100_000_000:
            output.switch("spindle_cw", False)

    monkeypatch.setattr(port, "write", write)
    monkeypatch.setattr(pulse_player_client.time, "sleep", lambda _: player.run_for(0.001))
    output.trial(1000.0, trial_s=1.0)
    last_on = max(ns for ns, *registers, _ in port.rows if tuple(registers) == on)
    assert 100_000_000 < last_on - begin_ns < 110_000_000 and player.clock.ns - begin_ns > 900_000_000


def test_long_pulses_of_the_thesis_slow_the_program_down_and_lose_none(monkeypatch: pytest.MonkeyPatch) -> None:
    """Pulses are on for 50 ms and off for 10; the program has one every 5 ms."""
    player = VirtualPlayer(monkeypatch, machine(pulse_us=50_000.0, gap_us=10_000.0))
    plan = even_plan(40)
    player.output.append(*plan.columns)
    player.run_until("idle")
    rows = [row for row in player.port.rows if row[2] == player.port.rows[-1][2]]
    rises = [ns for (_, before, _, _), (ns, data, _, _) in pairwise(rows) if data & 1 and not before & 1]
    falls = [ns for (_, before, _, _), (ns, data, _, _) in pairwise(rows) if before & 1 and not data & 1]
    assert len(falls) == 40
    assert min(fall - rise for rise, fall in zip(rises, falls[-len(rises) :], strict=True)) >= 50_000_000
    assert min(rise - fall for fall, rise in zip(falls, rises[1:], strict=False)) >= 10_000_000


def test_devices_are_switched_at_rest_and_while_pulses_run(player: VirtualPlayer) -> None:
    output = player.output
    output.switch("mist", True)
    player.run_for(0.01)
    assert player.port.rows[-1][1] == 1 << 6  # pin 8
    output.append(*even_plan(100).columns)
    player.run_for(0.2)
    output.switch("mist", False)
    player.run_until("idle")
    mist = [bool(data & 1 << 6) for _, data, _, _ in player.port.rows]
    assert mist == sorted(mist, reverse=True) and 30 < mist.count(True) < 150
    assert len(decoded(player.port.rows)) == 100


def test_inputs_are_read_while_it_idles_and_while_it_runs(player: VirtualPlayer) -> None:
    player.port.register = 0b0100_1000  # pins 10 and 15; 11 is turned round
    player.run_for(0.01)
    assert player.output.inputs() == {10, 15, 11}
    player.output.append(*even_plan(100).columns)
    player.port.register = 0b1000_0000
    player.run_for(0.01)
    assert player.output.inputs() == frozenset()


def test_who_is_left_brakes_and_ends_with_everything_off(player: VirtualPlayer) -> None:
    player.output.append(*even_plan(3000, speed=40.0).columns)
    player.output.switch("flood", True)
    player.run_for(0.5)
    reached = player.output.sent
    player.loop.is_left = True
    player.loop.run()
    assert reached + 50 < player.output.sent < reached + 200  # 4 mm of 20 steps, and a moment's more
    assert player.port.rows[-1][1:3] == (0, 0b1011)  # pins 1, 14 and 17 are turned round


def test_a_place_is_declared_and_counted_from(player: VirtualPlayer) -> None:
    player.output.append(*even_plan(10).columns)
    player.run_until("idle")
    player.output.declare(0, -500)
    assert player.output.position_steps == (-500, 0, 0)
    more = even_plan(15)
    player.output.append(*(column[10:] for column in more.columns))
    player.run_until("idle")
    assert player.output.position_steps == (-495, 0, 0)


@pytest.mark.parametrize("what", ["room", "ticks"])
def test_what_does_not_fit_is_refused(player: VirtualPlayer, what: str) -> None:
    plan = even_plan(10)
    player.output.append(*plan.columns)
    refused: Any = plan if what == "ticks" else even_plan(player.output.room + 1)
    with pytest.raises(ValueError, match="do not fit"):
        player.output.append(*refused.columns)


def test_a_ring_that_has_gone_round_takes_back_what_is_kept(monkeypatch: pytest.MonkeyPatch) -> None:
    """Its rows are few here; the memory is the same."""
    from CNCStepper.control.pulses import pulse_player_client, pulse_ring

    for module in (pulse_ring, pulse_player_client):
        monkeypatch.setattr(module, "KEPT", 600, raising=False)
        monkeypatch.setattr(module, "AHEAD", 200)
        monkeypatch.setattr(module, "ROWS", 800)
    player, plan = VirtualPlayer(monkeypatch, machine()), even_plan(3000, speed=40.0)
    given = 0
    while given < 3000:
        more = min(player.output.room, 3000 - given)
        player.output.append(*(column[given : given + more] for column in plan.columns))
        given += more
        player.run_for(0.02)
    player.run_until("idle")
    player.output.hold()
    player.run_until("held")
    player.output.back(2000)
    player.run_until("held")
    assert player.output.sent == 2400
    player.output.resume()
    player.run_until("idle")
    pulses = decoded(player.port.rows)
    assert [pulse.sense for pulse in pulses] == [1] * 3000 + [-1] * 600 + [1] * 600
    walked(plan, pulses)
