# SPDX-License-Identifier: LGPL-2.1-or-later
"""Circular arcs by the digital differential analyser (DDA), as the PC control of stepper tables published it (A3).

    K = 1/R,  limit = sqrt(2 R²)
    each round:  sum_x += K |Y|,  sum_y += K |X|;  a sum that reaches limit loses it, and its axis gets a pulse

          extreme             X and Y are seen from the centre. The arc is run quadrant by quadrant, in each of which
        .-- + --.             both axes go one way; one that has reached the quadrant's end (the rounded extreme, or
      /     |     \\           the programmed point) stops there, and the other goes on at full rate.
     +------+------+
          centre              A sum begins at limit/2, moved by how far the true arc is from the whole step there.

Rounds without a pulse are leapt over, so a pulse costs the same at every radius; a round is 1/(R sqrt(2)) steps of
path. The published registers differ: X and Y absolute, both sums from 0, R cut to a whole number. They leave the arc
by more than a step already about the origin, and by any distance where the centre is far from it.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from CNCStepper.errors import GeometryError
from CNCStepper.kernels import njit
from CNCStepper.motion.interpolation.iteration_stream import iteration_stream
from CNCStepper.motion.signals.pulse_stream import PULSE_ROWS, PulseStream
from CNCStepper.tolerances import SAME_ANGLE_RAD

QUARTER = math.pi / 2.0

_STATE = np.dtype(
    [
        ("x", "i8"),
        ("y", "i8"),
        ("tick", "i8"),
        ("sum_x", "f8"),  # in limits: a pulse at 1
        ("sum_y", "f8"),
        ("quadrant", "i8"),  # row of the ends in hand
        ("begun", "?"),
        ("centre_x", "f8"),  # that the registers are seen from
        ("centre_y", "f8"),
        ("radius", "f8"),
        ("published", "?"),
    ]
)


def circular_dda(
    begin_steps: tuple[int, int],
    end_steps: tuple[int, int],
    centre_steps: tuple[float, float],
    clockwise: bool,
    turns: int = 1,
    published: bool = False,
    radius_steps: float | None = None,
    rows: int = PULSE_ROWS,
) -> PulseStream:
    """Return the pulses of an arc of two axes of equal resolution; begin and end at one place are a whole circle.

    It ends exactly on `end_steps`. centre_steps and radius_steps are the true arc's and need not be whole; the radius
    left out is the mean of those of begin and end. Where begin and end are within half a step of that arc on each
    axis, no position is farther than 1 step from it (worst measured: 0.78 from radius 5 on, 1.00 below). Ticks are
    rounds. published: with the published registers, for which that is not promised.
    Raises GeometryError where begin or end is the centre.
    """
    radius = radius_steps or (math.dist(begin_steps, centre_steps) + math.dist(end_steps, centre_steps)) / 2.0
    if not radius > 0.0:
        raise GeometryError("arc-radius", "an arc needs a radius", value=f"{radius:g}", advice="move the centre")
    true_ends, true_begins = _quadrants(begin_steps, end_steps, centre_steps, radius, clockwise, turns)
    whole_ends = np.rint(true_ends).astype(np.int64)
    state = np.zeros(1, _STATE).view(np.recarray)
    state[0].x, state[0].y = begin_steps
    state[0].radius = int(math.dist(begin_steps, centre_steps)) if published else radius
    state[0].centre_x, state[0].centre_y = (0.0, 0.0) if published else centre_steps
    state[0].published = published
    return iteration_stream(lambda *columns: _write(state, whole_ends, true_begins, *columns), begin_steps, rows)


def _quadrants(
    begin: Sequence[int], end: Sequence[int], centre: Sequence[float], radius: float, clockwise: bool, turns: int
) -> tuple[np.ndarray, np.ndarray]:
    """Return the ends of the parts of the arc within a quadrant each, and where these parts truly begin."""
    turn = -1.0 if clockwise else 1.0
    begin_rad, end_rad = (math.atan2(point[1] - centre[1], point[0] - centre[0]) for point in (begin, end))
    sweep = (turn * (end_rad - begin_rad)) % math.tau
    if tuple(begin) == tuple(end):
        sweep = math.tau
    sweep += math.tau * (turns - 1)
    first = math.floor(turn * begin_rad / QUARTER + SAME_ANGLE_RAD) + 1
    last = math.ceil((turn * begin_rad + sweep) / QUARTER - SAME_ANGLE_RAD)
    quarters = (turn * np.arange(first, last)).astype(np.int64) % 4
    unit = np.array([(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)])
    extremes = np.array(centre) + radius * unit[quarters]
    on_arc = np.array(centre) + radius * np.array([math.cos(begin_rad), math.sin(begin_rad)])
    return np.vstack([extremes, np.array([end], float)]), np.vstack([on_arc[None], extremes])


@njit
def _write(state, ends, begins, ticks, step, back):
    """Write pulses until the columns are full or the last end is reached; returns the rows written."""
    now = state[0]
    written = 0
    while written < len(ticks) and now.quadrant < len(ends):
        end = ends[now.quadrant]
        if now.x == end[0] and now.y == end[1]:
            now.quadrant += 1
            now.begun = False
            continue
        way_x, way_y = np.sign(end[0] - now.x), np.sign(end[1] - now.y)
        if not now.begun:
            _begin(now, begins[now.quadrant], way_x, way_y)
        pulse_x, pulse_y = _leap(now, way_x, way_y)
        if pulse_x or pulse_y:
            ticks[written] = now.tick
            step[written] = pulse_x + 2 * pulse_y
            back[written] = pulse_x * (way_x < 0) + 2 * pulse_y * (way_y < 0)
            written += 1
    return written


@njit
def _begin(now, true, way_x, way_y):
    """Set the sums at the begin of a quadrant; the published ones begin at 0 and are carried on."""
    now.begun = True
    if now.published:
        return
    now.sum_x = min(max(0.5 + way_x * (true[0] - now.x), 0.0), 0.999)
    now.sum_y = min(max(0.5 + way_y * (true[1] - now.y), 0.0), 0.999)


@njit
def _leap(now, way_x, way_y):
    """Run the rounds up to the next pulse; returns for each axis whether it has one."""
    limit = now.radius * math.sqrt(2.0)
    add_x = abs(now.y - now.centre_y) / now.radius / limit if way_x and way_y else abs(way_x) / limit
    add_y = abs(now.x - now.centre_x) / now.radius / limit if way_x and way_y else abs(way_y) / limit
    if add_x == 0.0 and add_y == 0.0:  # only absolute registers can both be 0
        add_x = add_y = 1.0 / limit
    rounds = math.inf
    if add_x > 0.0:
        rounds = math.ceil((1.0 - now.sum_x) / add_x)
    if add_y > 0.0:
        rounds = min(rounds, math.ceil((1.0 - now.sum_y) / add_y))
    rounds = max(rounds, 1)
    now.tick += int(rounds)
    now.sum_x += rounds * add_x
    now.sum_y += rounds * add_y
    pulse_x, pulse_y = int(way_x != 0 and now.sum_x >= 1.0), int(way_y != 0 and now.sum_y >= 1.0)
    now.sum_x -= pulse_x
    now.sum_y -= pulse_y
    now.x += pulse_x * way_x
    now.y += pulse_y * way_y
    return pulse_x, pulse_y
