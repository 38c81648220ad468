# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the motors do and when, read from segments: positions at times, and every single step.

Bresenham in n axes: per step event of the longest axis every axis adds its own count, and steps when the
sum passes the event count; all sums begin at half. Slow segments do this in halves, quarters or eighths
of an event, so that the shorter axes step more evenly. With E events and s steps in the block, after m
eighths an axis has made

    floor((4 E + m s - 1) / (8 E))    steps, for m = 0 .. 8 E
"""

from __future__ import annotations

import numpy as np

from CNCStepper.kernels import njit, njit_inline
from CNCStepper.motion.planner.buffers import EIGHTHS


@njit_inline
def steps_made(steps, whole, parts):
    """Return how many of its steps an axis has made after so many of the `whole` parts of a block."""
    return (whole // 2 + parts * steps - 1) // whole


@njit_inline
def place_in(segment, ticks, position):
    """Write to `position` the axes' position after `ticks` of the segment's ticks."""
    eighths = segment.eighths + ticks * segment.unit
    for axis in range(len(position)):
        steps = segment.steps[axis]
        made = steps_made(abs(steps), EIGHTHS * segment.events, eighths)
        position[axis] = segment.begin[axis] + (made if steps > 0 else -made)


@njit
def ends(segments):
    """Return the position at the end of every segment, int64[n, axes]."""
    positions = np.empty((len(segments), len(segments[0].steps)), np.int64)
    for row in range(len(segments)):
        place_in(segments[row], segments[row].ticks, positions[row])
    return positions


@njit
def positions_at(segments, clocks, positions):
    """Write the axes' positions at `clocks` (int64, rising, ticks of the controller's clock).

    Every clock must lie at or after the first segment's start; between two segments, and after the
    last, the axes stand where the earlier one ended.
    """
    row = 0
    for query in range(len(clocks)):
        while row + 1 < len(segments) and segments[row + 1].start <= clocks[query]:
            row += 1
        segment = segments[row]
        ticks = (clocks[query] - segment.start) // segment.cycles
        place_in(segment, min(ticks, segment.ticks), positions[query])


@njit
def _write_step_events(segments, clocks, positions):
    """Write the clock of every tick on which an axis steps, and the position after it; returns their number."""
    count = 0
    position = np.empty_like(positions[0])
    for row in range(len(segments)):
        segment = segments[row]
        place_in(segment, 0, position)
        for tick in range(1, segment.ticks + 1):
            place_in(segment, tick, positions[count])
            if np.any(positions[count] != position):
                position[:] = positions[count]
                clocks[count] = segment.start + tick * segment.cycles
                count += 1
    return count


def step_table(segments: np.recarray) -> tuple[np.ndarray, np.ndarray]:
    """Return every step event of the segments: clocks int64[k] and positions int64[k, axes] after each."""
    room = int(segments.ticks.sum()) + 1
    clocks = np.empty(room, np.int64)
    positions = np.empty((room, segments.steps.shape[1]), np.int64)
    count = _write_step_events(segments, clocks, positions)
    return clocks[:count], positions[:count]
