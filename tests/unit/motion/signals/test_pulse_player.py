# SPDX-License-Identifier: LGPL-2.1-or-later
"""The player's kernel by itself: the same compiled, with checked bounds and as plain Python; and how it stops.

What whole runs give is in tests/unit/control/pulses/test_pulse_loop.py.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from CNCStepper.motion.signals.pulse_player import (
    BRAKES,
    DUE_NS,
    HEAD,
    IS_REST,
    PLACE,
    POSITION,
    SENSE,
    SENT,
    STANDS,
    TARGET,
    PulseRows,
    new_state,
    play,
)

WAYS = """
import random
import numpy as np
from CNCStepper.motion.signals.pulse_player import *

dice, size = random.Random(3), 97  # rows lie in a ring that goes round often
words, reals = new_state()
kinds = (np.float64, np.float64, np.float32, np.uint8, np.uint8, np.uint8)
rows = PulseRows(*(np.zeros(size, kind) for kind in kinds))
due, steps, backs = np.empty(64, np.int64), np.empty(64, np.uint8), np.empty(64, np.uint8)
now = 0
for turn in range(400):
    while words[HEAD] < words[PLACE] + 40:
        at, before = int(words[HEAD]) % size, (int(words[HEAD]) - 1) % size
        speed = dice.choice((5.0, 6.0, 7.0))
        rows.time_ns[at] = rows.time_ns[before] + 1e6 * dice.randint(1, 9)
        rows.energy[at] = rows.energy[before] + dice.choice((1.0, 9.0))
        rows.speed[at], rows.step[at] = speed, dice.randint(1, 7)
        rows.back[at], rows.flags[at] = rows.step[at] & dice.randint(0, 7), dice.choice((0, 0, 0, 0, 1, 1, 2))
        words[HEAD] += 1
    what = dice.randint(0, 9)
    if what == 0:
        words[BRAKES] = 1
    elif what == 1 and words[STANDS]:
        words[SENSE], words[TARGET], words[BRAKES] = -1, max(0, words[PLACE] - 20), 0
    elif what < 5 and (words[STANDS] or words[SENSE] > 0):
        words[SENSE], words[BRAKES] = 1, 0
    elif what == 5:
        reals[FEED_SHARE], reals[RAPID_SHARE] = dice.choice((0.2, 1.0)), dice.choice((0.5, 1.0))
    words[ENDS_AT_REST], words[IS_STALE] = dice.randint(0, 1), dice.randint(0, 1)
    count = play(*rows.columns, words, reals, now, now + 8_000_000, due, steps, backs)
    now += 8_000_000
    print(words.tolist(), [float(f"{x:.12g}") for x in reals[:20]])
    print(due[:count].tolist(), steps[:count].tolist(), backs[:count].tolist())
"""


def even_rows(count: int, change: float = 1.0) -> PulseRows:
    """Return rows of x at 5 mm/s, one a millisecond; from row to row u² may change so much."""
    rows = PulseRows(*(np.zeros(count, kind) for kind in ("f8", "f8", "f4", "u1", "u1", "u1")))
    rows.time_ns[:] = np.arange(count) * 1e6
    rows.energy[:] = np.arange(count) * change
    rows.speed[:], rows.step[:] = 5.0, 1
    rows.flags[0] = IS_REST  # as the first row of an output has it: nothing lies before it
    return rows


class Played:
    """A player of such rows."""

    def __init__(self, rows: PulseRows):
        self.rows, (self.words, self.reals) = rows, new_state()
        self.words[HEAD] = len(rows.step)
        self._room = np.empty(500, np.int64), np.empty(500, np.uint8), np.empty(500, np.uint8)

    def until(self, ms: float) -> list[int]:
        """Return when pulses were due, in µs."""
        count = play(*self.rows.columns, self.words, self.reals, 0, round(ms * 1e6), *self._room)
        return [round(ns / 1000) for ns in self._room[0][:count].tolist()]


@pytest.mark.slow
def test_the_kernel_does_the_same_in_all_ways(printed_three_ways: Callable[[str], list[str]]) -> None:
    compiled, checked, plain = printed_three_ways(WAYS)
    assert compiled.count("\n") == 800 and compiled == checked == plain


def test_what_is_due_comes_and_the_rest_waits() -> None:
    played = Played(even_rows(100))
    assert played.until(3.5) == [0, 1000, 2000, 3000]
    assert played.until(3.5) == []
    assert played.until(5.5) == [4000, 5000]
    assert (played.words[PLACE], played.words[SENT], played.words[POSITION]) == (6, 6, 6)


def test_a_hold_takes_as_much_from_u_squared_as_the_way_allows() -> None:
    """25 less 1 a row: 25 rows later it would be 0, so that 24 come, each later than the one before."""
    played = Played(even_rows(100))
    begun = len(played.until(10.5))
    played.words[BRAKES] = 1
    times = played.until(1e6)
    assert begun == 11 and len(times) == 24 and played.words[STANDS]
    assert (np.diff(times, n=2) > 0).all()
    assert played.until(1e6) == []


def test_the_way_back_ends_at_its_target_and_turns_the_masks() -> None:
    played = Played(even_rows(100))
    played.until(40.5)
    played.words[BRAKES] = 1
    played.until(1e6)
    reached = int(played.words[PLACE])
    played.words[BRAKES], played.words[SENSE], played.words[TARGET] = 0, -1, reached - 30
    played.reals[DUE_NS] = 2e12
    times = played.until(1e9)
    assert len(times) == 30 and played.words[STANDS] and played.words[POSITION] == reached - 30
    waits = np.diff(times)
    assert waits.argmin() in range(12, 18)  # fastest half way: it has braked in time
    assert waits[-1] > 2 * waits.min()
