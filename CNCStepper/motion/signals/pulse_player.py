# SPDX-License-Identifier: LGPL-2.1-or-later
r"""Selects the planned pulses of the next time slice and their times: on the plan, slower, to a stop, or backwards.

    planned speed   /‾‾‾‾‾‾‾‾‾‾‾\         u² rises and falls by 2 A ds from pulse to pulse, between 0 and the plan's;
    hold            /‾‾‾\____/‾‾\         the time to the next pulse is the planned one, stretched by plan / u
                        ^   ^ resume      (the mean of both ends), so that on the plan it is exactly the plan's

No pulse is left out or comes twice. A hold ends before the pulse at which u² would be 0. A rest (a dwell, the begin of
a move) keeps its planned time; on the way back it takes REST_BACK_NS. Backwards the same pulses come in the opposite
order and directions; the time between two of them is stretched as forwards.

Rows lie in a ring, row n in place n modulo its length. The sums `time_ns` and `energy` run over all rows, so that what
lies between two rows is a difference: planned time, and how much u² can change on the way.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from CNCStepper.kernels import njit

IS_RAPID, IS_REST = 1, 2  # flags of a row
REST_BACK_NS = 20_000_000.0
PLAYED_AXES = 3
DYING_SHARE = 4.0  # of what a step's way takes from u²: below that a path may end as it is

# words, int64: the appender writes the first ones, the player the others
HEAD, OLDEST, ENDS_AT_REST = range(3)
PLACE, SENSE, BRAKES, STANDS, TARGET, BOUNDARY, IS_STALE, STARVES, SENT = range(16, 25)
POSITION = 25  # and the two behind it
WORDS = 64
# reals, float64
FEED_SHARE, RAPID_SHARE = range(2)
SCALE, PLANNED, DUE_NS = range(16, 19)  # u by the plan's speed; that speed, mm/s; when the last pulse was due
REALS = 64


@dataclass(frozen=True)
class PulseRows:
    """The columns of a ring of rows.

    time_ns float64: planned time up to the row. energy float64: sum of 2 A ds up to the row, mm²/s². speed float32:
    planned path speed over the time that ends with the row, mm/s. step, back uint8: masks of axes. flags uint8.
    """

    time_ns: np.ndarray
    energy: np.ndarray
    speed: np.ndarray
    step: np.ndarray
    back: np.ndarray
    flags: np.ndarray

    @property
    def columns(self) -> tuple[np.ndarray, ...]:
        """The columns as `play` takes them."""
        return self.time_ns, self.energy, self.speed, self.step, self.back, self.flags


def new_state() -> tuple[np.ndarray, np.ndarray]:
    """Return words and reals of a player at rest before row 0."""
    words, reals = np.zeros(WORDS, np.int64), np.zeros(REALS, np.float64)
    begin(words, reals)
    return words, reals


def begin(words: np.ndarray, reals: np.ndarray) -> None:
    """Set the player's own words and reals for standing before row 0."""
    words[SENSE], words[ENDS_AT_REST] = 1, 1
    reals[FEED_SHARE] = reals[RAPID_SHARE] = reals[SCALE] = 1.0


@njit
def play(time_ns, energy, speed, step, back, flags, words, reals, earliest_ns, until_ns, due_ns, steps, backs):
    """Write the pulses that are due before `until_ns`, none before `earliest_ns`; return their number.

    due_ns int64[k], steps, backs uint8[k]: at most k are written. Commands are in `words` and `reals`; where the way
    ends, in words[STANDS].
    """
    size, count = len(time_ns), 0
    while count < len(due_ns):
        place, sense = words[PLACE], words[SENSE]
        row = place if sense > 0 else place - 1
        if (sense > 0 and place >= words[HEAD]) or (sense < 0 and place <= words[TARGET]):
            _end_of_way(energy, size, words, reals)
            break
        between = row if sense > 0 or words[STANDS] else row + 1  # whose time and way lie before this pulse
        at = between % size
        scale, wait_ns = _scale_and_wait(time_ns, energy, speed, flags, words, reals, row, between)
        if scale < 0.0:
            words[STANDS] = 1
            break
        due = max(reals[DUE_NS] + wait_ns, earliest_ns)
        if due >= until_ns:
            break
        words[STANDS] = words[STARVES] = 0
        reals[SCALE], reals[PLANNED], reals[DUE_NS] = scale, speed[at], due
        on, turned = np.int64(step[row % size]), np.int64(back[row % size])
        if sense < 0:
            turned = on & ~turned
        due_ns[count], steps[count], backs[count] = np.int64(due), on, turned
        for axis in range(PLAYED_AXES):
            words[POSITION + axis] += ((on >> axis) & 1) - 2 * ((turned >> axis) & 1)
        words[PLACE] += sense
        words[SENT] += sense
        count += 1
    return count


@njit
def _end_of_way(energy, size, words, reals):
    """Note whether the path ended at rest, or pulses are wanting while it moves."""
    if words[SENSE] < 0:
        words[STANDS] = 1
        return
    last = words[HEAD] - 1
    dying = DYING_SHARE * (energy[last % size] - energy[(last - 1) % size])
    at_rest = words[ENDS_AT_REST] or words[STANDS] or (reals[SCALE] * reals[PLANNED]) ** 2 <= dying
    words[STARVES] = 0 if at_rest else 1
    if words[BRAKES]:
        words[STANDS] = 1


@njit
def _scale_and_wait(time_ns, energy, speed, flags, words, reals, row, between):
    """Return u by the planned speed at a pulse, and the time before it; -1 where the axes stop before it."""
    size = len(time_ns)
    at, before = between % size, (between - 1) % size
    wait_ns, planned = time_ns[at] - time_ns[before], float(speed[at])
    share = _share(flags[row % size], reals, words[SENSE])
    if flags[at] & IS_REST:
        if words[BRAKES]:
            return -1.0, 0.0
        return share, wait_ns if words[SENSE] > 0 else REST_BACK_NS
    old = 0.0 if words[STANDS] else reals[SCALE]
    old_sqr, change = (old * reals[PLANNED]) ** 2, energy[at] - energy[before]
    low_sqr = old_sqr - change
    if words[BRAKES] and low_sqr <= 0.0:
        return -1.0, 0.0
    low, high = math.sqrt(max(low_sqr, 0.0)), math.sqrt(old_sqr + change)
    if words[BRAKES]:
        wanted = low
    else:  # it stays on the plan at every planned speed: the planner has the limits of the axes
        low, high = min(low, old * planned), max(high, old * planned)
        wanted = max(min(share * planned, high, _limit(energy, speed, flags, words, reals, row, between)), low)
    scale = min(wanted / planned, 1.0)
    if scale <= 0.0:
        return -1.0, 0.0
    return scale, wait_ns if old == 1.0 and scale == 1.0 else 2.0 * wait_ns / (old + scale)


@njit
def _share(flag, reals, sense):
    """Return which share of its planned speed a row may have; backwards the lesser one, whatever it is."""
    feed, rapid = reals[FEED_SHARE], reals[RAPID_SHARE]
    if sense < 0:
        return min(feed, rapid)
    return rapid if flag & IS_RAPID else feed


@njit
def _limit(energy, speed, flags, words, reals, row, between):
    """Return the speed from which the path can still brake for what comes: its end, or a lower share."""
    size = len(energy)
    if words[SENSE] < 0:
        target = words[TARGET]
        step = energy[(target + 1) % size] - energy[target % size]
        return math.sqrt(max(energy[row % size] - energy[target % size], 0.0) + step)
    limit = np.inf
    here = energy[between % size]
    if words[IS_STALE] and not words[ENDS_AT_REST]:
        last = words[HEAD] - 1
        step = energy[last % size] - energy[(last - 1) % size]
        limit = math.sqrt(max(energy[last % size] - here, 0.0) + step)
    if reals[FEED_SHARE] != reals[RAPID_SHARE]:
        then = _next_kind(flags, words, row)
        if then < words[HEAD] and not flags[then % size] & IS_REST:
            share = _share(flags[then % size], reals, 1)
            if share < _share(flags[row % size], reals, 1):
                end = share * float(speed[then % size])
                limit = min(limit, math.sqrt(end * end + energy[then % size] - here))
    return limit


@njit
def _next_kind(flags, words, row):
    """Return the next row that is a rapid where this one is none, or the other way round; HEAD where there is none."""
    size = len(flags)
    then, kind = words[BOUNDARY], flags[row % size] & IS_RAPID
    if then <= row or then > words[HEAD]:
        then = row + 1
    while then < words[HEAD] and flags[then % size] & IS_RAPID == kind:
        then += 1
    words[BOUNDARY] = then
    return then
