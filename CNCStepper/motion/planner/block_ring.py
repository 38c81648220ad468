# SPDX-License-Identifier: LGPL-2.1-or-later
"""The ring of queued blocks: places that follow one another, the last by the first.

. . T b b P b b H . .      T tail: being cut   P planned: up to here final   H head: the next free place
"""

from __future__ import annotations

from CNCStepper.kernels import njit_inline


@njit_inline
def next_place(planner, place):
    """Return the ring's place after `place`."""
    after = place + 1
    return after if after < len(planner.blocks) else 0


@njit_inline
def place_before(planner, place):
    """Return the ring's place before `place`."""
    return place - 1 if place > 0 else len(planner.blocks) - 1


@njit_inline
def places_from(planner, first, last):
    """Return how many places lie from place `first` to place `last`."""
    count = last - first
    return count if count >= 0 else count + len(planner.blocks)


@njit_inline
def is_full(planner):
    """Return whether no further block can be queued."""
    queue = planner.queue[0]
    return next_place(planner, queue.head) == queue.tail


@njit_inline
def count_blocks(planner):
    """Return how many blocks are queued, the one being cut included."""
    queue = planner.queue[0]
    return places_from(planner, queue.tail, queue.head)


@njit_inline
def discard_block(planner):
    """Free the place of the block that has been cut up."""
    queue = planner.queue[0]
    after = next_place(planner, queue.tail)
    if queue.planned == queue.tail:
        queue.planned = after
    if queue.fresh == queue.tail:
        queue.fresh = after
    queue.tail = after
