# SPDX-License-Identifier: LGPL-2.1-or-later
"""The look-ahead of S-curves: at which speed, without acceleration, every queued block may be begun.

    tail   a   b   c   d   e   new     An entry follows from the later ones that it looks to, at most up to the end:
            └───┴──►└──►└───┴───►|      as soon as one change of speed reaches what it may be, it looks no farther.
                    ^ no further back   A new block changes the entries that look to it, and those that look to these.

A pass looks from each of the k blocks within the way to a stop to some k others, so a long queue is not planned at
each block: fresh ones wait, with an entry at rest, until they are a sixteenth of it. So a look-ahead beyond the
firmware's is shorter by up to a sixteenth.

Invariant: the pass goes back to where no entry before looks to one that has changed, so that all entries are those
that planning all of them anew would give. `farthest` of a block is the farthest place to which it or any before looks.

Changes of speed whose acceleration rises and falls at a limited rate, the jerk.

    acceleration │    ┌────────┐              speed │            ____
                 │   /          \\                   │         /
                 │  /            \\                  │      /
                 └─/──────────────\\──► time         └____/──────────► time
                    A/J   hold   A/J     the greatest A is not reached where the change is below A²/J

A whole change begins and ends without acceleration and is symmetric about its middle, so that its mean speed
is that of its two ends, also where one of them lies below zero. mm, mm/s, mm/s², mm/s³.
"""

from __future__ import annotations

import math

from CNCStepper.kernels import njit_in_place
from CNCStepper.motion.planner.buffers import UNLIMITED, count_blocks, next_place, place_before, places_from


@njit_in_place
def change_time(change, acceleration, jerk):
    """Return how long a whole change of speed by `change` (any sign) takes, in s."""
    size = abs(change)
    if size * jerk <= acceleration**2:
        return 2.0 * math.sqrt(size / jerk)
    return size / acceleration + acceleration / jerk


@njit_in_place
def change_length(before, after, acceleration, jerk):
    """Return the distance of a whole change from one speed to another, in mm."""
    return 0.5 * (before + after) * change_time(after - before, acceleration, jerk)


@njit_in_place
def reachable_speed(speed, length, acceleration, jerk):
    """Return the greatest speed that a whole change from `speed` reaches within `length`; the same backwards."""
    half = 0.5 * (speed / acceleration + 0.5 * acceleration / jerk)  # of the linear term of change²/2A + ... = 0
    rest = length - speed * acceleration / jerk
    if rest > 0.0:
        change = 2.0 * acceleration * (math.sqrt(half**2 + 0.5 * rest / acceleration) - half)
        if change * jerk >= acceleration**2:
            return speed + change
    return speed + _small_change(speed, length * math.sqrt(jerk))


@njit_in_place
def _small_change(speed, scaled):
    """Return x² of the positive root of x³ + 2 speed x = scaled: a change that does not reach the acceleration."""
    if speed * speed * speed <= 1e-12 * scaled * scaled:
        return scaled ** (2.0 / 3.0)
    third = math.sqrt(2.0 * speed / 3.0)
    root = 2.0 * third * math.sinh(math.asinh(0.5 * scaled / third**3) / 3.0)
    return root**2


DUE = 16  # fresh blocks that many times are as many as all: the firmware's 15 are planned at each


@njit_in_place
def plan_when_due(planner):
    """Plan the entries once a sixteenth of the queue is fresh: at every block where the queue is short."""
    queue = planner.queue[0]
    if DUE * places_from(planner, queue.fresh, queue.head) >= count_blocks(planner):
        plan_entries(planner)


@njit_in_place
def plan_entries(planner):
    """Plan the entries that the fresh blocks change, or all where none counts as planned, backwards.

    The running block makes what it can of its exit: what it cannot reach, no entry need be lowered for.
    """
    queue = planner.queue[0]
    first = changed = queue.fresh
    place = place_before(planner, queue.head)
    while place != queue.tail:
        block = planner.blocks[place]
        before = block.entry_sqr
        block.entry_sqr = _smooth_entry(planner, place) ** 2
        old = _ahead(planner, place) < _ahead(planner, first)
        if old and block.entry_sqr != before:
            changed = place
        place = place_before(planner, place)
        old = _ahead(planner, place) < _ahead(planner, first)
        if old and _ahead(planner, planner.blocks[place].farthest) < _ahead(planner, changed):
            break
    _note_farthest(planner, place)
    queue.fresh = queue.head


@njit_in_place
def _ahead(planner, place):
    """Return how far behind the running block a place lies."""
    return places_from(planner, planner.queue[0].tail, place)


@njit_in_place
def _note_farthest(planner, place):
    """Note of all blocks behind a place how far they and those before them look."""
    queue = planner.queue[0]
    farthest = place if place == queue.tail else planner.blocks[place].farthest
    planner.blocks[place].farthest = farthest
    place = next_place(planner, place)
    while place != queue.head:
        block = planner.blocks[place]
        if _ahead(planner, block.looks_to) > _ahead(planner, farthest):
            farthest = block.looks_to
        block.farthest = farthest
        place = next_place(planner, place)


@njit_in_place
def _smooth_entry(planner, first):
    """Return the greatest entry speed from which one change of speed, over some blocks, ends at a later entry.

    The changes fall, so that none is above the entries that it passes when its begin is not. Each place counts with
    what is reachable from its entry, and at most with the least of the entries passed: so the places can be looked at
    in any order, and the one that counted most for the block behind first. Most others need no reachable speed then.
    """
    queue = planner.queue[0]
    place = next_place(planner, first)
    known, known_at = 0.0, first  # the place whose speed is known
    limit = math.sqrt(planner.blocks[first].max_entry_sqr)
    if place != queue.head and math.sqrt(planner.blocks[place].entry_sqr) < limit:
        known_at = planner.blocks[place].best_from
        known = _speed_from(planner, first, known_at)
    length, acceleration, jerk = 0.0, UNLIMITED, UNLIMITED
    best, best_from = 0.0, place
    place = first
    while best < limit and place != queue.head:
        block = planner.blocks[place]
        length += block.length
        acceleration, jerk = min(acceleration, block.acceleration), min(jerk, block.jerk)
        place = next_place(planner, place)
        entry = 0.0 if place == queue.head else math.sqrt(planner.blocks[place].entry_sqr)
        speed = 0.0
        if place == known_at:
            speed = known
        elif entry >= limit:
            speed = limit
        elif not _is_out_of_reach(max(best, known), entry, length, acceleration, jerk):
            speed = min(limit, reachable_speed(entry, length, acceleration, jerk))
        if speed > best:
            best, best_from = speed, place
        if place != queue.head:
            limit = min(limit, math.sqrt(planner.blocks[place].max_entry_sqr))
    block = planner.blocks[first]
    block.looks_to, block.best_from = place, best_from
    return best


@njit_in_place
def _speed_from(planner, first, last):
    """Return the greatest entry speed of block `first` for a change of speed that ends at the entry of block `last`."""
    limit, length, acceleration, jerk = UNLIMITED, 0.0, UNLIMITED, UNLIMITED
    place = first
    while place != last:
        block = planner.blocks[place]
        limit = min(limit, block.max_entry_sqr)
        length += block.length
        acceleration, jerk = min(acceleration, block.acceleration), min(jerk, block.jerk)
        place = next_place(planner, place)
    entry = 0.0 if last == planner.queue[0].head else math.sqrt(planner.blocks[last].entry_sqr)
    return min(math.sqrt(limit), reachable_speed(entry, length, acceleration, jerk))


MARGIN = 1.000001  # above all rounding


@njit_in_place
def _is_out_of_reach(speed, entry, length, acceleration, jerk):
    """Return whether a change between two speeds surely takes more than `length`: by `change_length`, undivided."""
    change = speed - entry
    if change <= 0.0:
        return False
    both = speed + entry
    if both**2 * change > MARGIN * jerk * length**2:  # no change is quicker than without a limit of acceleration
        return True
    return change * jerk > acceleration**2 and both * (change * jerk + acceleration**2) > MARGIN * 2.0 * (
        length * acceleration * jerk
    )
