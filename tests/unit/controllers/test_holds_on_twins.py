# SPDX-License-Identifier: LGPL-2.1-or-later
"""Holds, corners and reversals at the virtual machines, with the exact times of the player's writes.

Ideal motors give the time of each step; real ones lose steps where pulses do not pass the start/stop region.
"""

from __future__ import annotations

import itertools
from math import sqrt
from random import Random

import numpy as np
import pytest

from CNCStepper.machine.profile import load_machine
from helpers.control.twin_bench import play
from helpers.controllers.twin_player import TwinPlayer, twin_of

PROFILES = {"parport": "thesis-table", "board": "usb-board"}
FEED_MM_MIN = 1200.0
BEGINS_S = 0.005  # after which a hold brakes
STOOD_S = 0.2


def corners(random: Random) -> list[tuple[float, float]]:
    """Return places of a path whose axes turn round often."""
    return [(random.randint(0, 40) / 10, random.randint(0, 40) / 10) for _ in range(9)] + [(0.0, 0.0)]


def step_times(path: np.ndarray, axis: int) -> list[tuple[float, int]]:
    """Return when an axis of ideal motors stepped, and which way."""
    ways = np.diff(path[:, 1 + axis])
    rows = np.flatnonzero(np.abs(ways) > 1e-9)
    return [(float(path[row + 1, 0]), int(np.sign(ways[row]))) for row in rows.tolist()]


@pytest.mark.slow
@pytest.mark.parametrize("family", PROFILES)
def test_holds_end_within_the_braking_time_and_every_reversal_passes_the_start_stop_region(
    family: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    seed = 7
    print(f"seed {seed}")
    random, bench = Random(seed), TwinPlayer(monkeypatch, load_machine(PROFILES[family]))
    places, holds_s = corners(random), []
    for line in ("G21G90G94", f"F{FEED_MM_MIN:g}"):
        bench.send(line)
    for x, y in places:
        bench.send(f"G1X{x}Y{y}")
    for _ in range(4):
        bench.pass_time(random.uniform(0.15, 0.4))
        bench.board.receive(b"!")
        holds_s.append(bench.time_s)
        bench.pass_time(1.0)
        assert bench.board.axes.stopped
        bench.board.receive(b"~")
    bench.run_to_rest()
    assert bench.board.axes.position_steps == (0, 0, 0)

    writes, machine = bench.writes(), bench.machine
    path = play(twin_of(machine), writes)
    acceleration = min(axis.acceleration_mm_s2 for axis in machine.axes[:2])
    step_mm = 1 / machine.axes[0].steps_per_mm
    braking_s = FEED_MM_MIN / 60.0 / acceleration + sqrt(2 * step_mm / acceleration)
    moved_s = np.sort([time_s for axis in (0, 1) for time_s, _ in step_times(path, axis)])
    for hold_s in holds_s:
        last_s = moved_s[moved_s < hold_s + 1.0].max()
        assert last_s <= hold_s + BEGINS_S + braking_s, f"{1000 * (last_s - hold_s):.1f} ms after the hold"
    assert sum((np.diff(moved_s) > STOOD_S).tolist()) >= len(holds_s), "it stood at each"
    first_step_s, reversals = sqrt(2 * step_mm / acceleration), 0
    for axis in (0, 1):
        for (before_s, before), (after_s, after) in itertools.pairwise(step_times(path, axis)):
            if before != after:
                reversals += 1
                assert after_s - before_s > first_step_s / 2.5, "as slow as a first step from rest"
    assert reversals > 4

    real = twin_of(machine, real=True)
    play(real, writes)
    assert real.places_mm[:2] == pytest.approx((0.0, 0.0), abs=step_mm / 4), "no motor has lost a step"
