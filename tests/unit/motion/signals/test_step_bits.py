# SPDX-License-Identifier: LGPL-2.1-or-later
"""The steps of single ticks against the closed form of where the axes stand, for one to eight axes."""

import numpy as np
import pytest

from CNCStepper.motion.planner.buffers import EIGHTHS, new_segments
from CNCStepper.motion.planner.step_timeline import place_in
from CNCStepper.motion.signals.step_bits import keep_steps, write_bits

SEED = 20261122


def random_segment(rng, axes):
    """Return a segment somewhere within a block of any size."""
    segment = new_segments(1, axes)[0]
    most = int(rng.choice([3, 40, 5000, 2**30]))
    segment.steps[:] = rng.integers(-most, most + 1, axes)
    segment.steps[rng.integers(axes)] = most
    segment.begin[:] = rng.integers(-(10**9), 10**9, axes)
    segment.events = most
    segment.unit = rng.choice([1, 2, 4, 8])
    done = int(rng.integers(0, most))
    segment.eighths = EIGHTHS * done
    segment.ticks = min((most - done) * EIGHTHS // segment.unit, int(rng.integers(1, 300)))
    segment.start, segment.cycles = rng.integers(0, 10**12), rng.integers(400, 65_535)
    return segment


def positions(segment, first, last):
    places = np.empty((last - first + 1, len(segment.steps)), np.int64)
    for row in range(len(places)):
        place_in(segment, first + row, places[row])
    return places


@pytest.mark.slow
@pytest.mark.parametrize("axes", range(1, 9))
def test_every_tick_steps_as_the_closed_form_says(axes):
    rng = np.random.default_rng(SEED + axes)
    for _ in range(60):
        segment = random_segment(rng, axes)
        last = int(segment.ticks)
        first = int(rng.integers(0, last))
        bits = np.empty(last - first, np.uint8)
        write_bits(segment, first, last, bits)
        moved = np.diff(positions(segment, first, last), axis=0)
        assert (bits[:, None] >> np.arange(axes) & 1).tolist() == np.abs(moved).tolist()
        rows = (np.empty(last - first, np.int64), np.empty_like(bits), np.empty_like(bits))
        count = keep_steps(segment, first, last, bits, *rows, 0)
        ticks, step, back = (column[:count] for column in rows)
        on = np.flatnonzero(bits)
        assert ticks.tolist() == (segment.start + (first + 1 + on) * segment.cycles).tolist()
        assert step.tolist() == bits[on].tolist()
        assert (back[:, None] >> np.arange(axes) & 1).tolist() == (moved[on] < 0).tolist()
