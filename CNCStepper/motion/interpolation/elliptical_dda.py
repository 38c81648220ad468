# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whole ellipses by the digital differential analyser (DDA) of the fixed-cycle method (C), as pulses.

The published points (`geometry/shapes/ellipse_dda.py`) are rounded to steps, each from its true place so that nothing
adds up, and
joined by the events of Bresenham's algorithm. They run counter-clockwise from the +Y vertex, or back.
"""

from __future__ import annotations

import numpy as np

from CNCStepper.geometry.shapes.ellipse_dda import ellipse_by_dda
from CNCStepper.kernels import njit
from CNCStepper.motion.interpolation.iteration_stream import iteration_stream
from CNCStepper.motion.planner.step_timeline import steps_made
from CNCStepper.motion.signals.pulse_stream import PULSE_ROWS, PulseStream

FINER = 2.0  # than a step: the published points are as far off as their resolution is large


def elliptical_dda(
    radius_x_mm: float,
    radius_y_mm: float,
    steps_per_mm: tuple[float, float],
    clockwise: bool = False,
    resolution_mm: float | None = None,
    rows: int = PULSE_ROWS,
) -> PulseStream:
    """Return the pulses of a whole ellipse about (0, 0) from its +Y vertex; it ends exactly where it began.

    resolution_mm: of the published points; left out, so fine that no position is farther from the true ellipse than
    1.25 of the larger step of the two axes. Given, that and resolution · max(1, Rx/Ry) together. Ticks are events.
    Raises GeometryError as `ellipse_by_dda` does.
    """
    finest_mm = min(1.0 / per_mm for per_mm in steps_per_mm) / FINER / max(1.0, radius_x_mm / radius_y_mm)
    curve = ellipse_by_dda(radius_x_mm, radius_y_mm, finest_mm if resolution_mm is None else resolution_mm)
    points = np.rint(curve.xy * np.array(steps_per_mm)).astype(np.int64)
    points = points[::-1].copy() if clockwise else points
    state = np.zeros(3, np.int64)  # chord in hand, its events that are done, all events
    begin = (int(points[0, 0]), int(points[0, 1]))
    return iteration_stream(lambda *columns: _write(points, state, *columns), begin, rows)


@njit
def _write(points, state, ticks, step, back):
    """Write the events of chords from `state` on until the columns are full; returns the rows written."""
    written = 0
    while written < len(ticks) and state[0] + 1 < len(points):
        way_x, way_y = points[state[0] + 1] - points[state[0]]
        events = max(abs(way_x), abs(way_y))
        if state[1] == events:
            state[0] += 1
            state[1] = 0
            continue
        pulse_x = _has_step(abs(way_x), events, state[1])
        pulse_y = _has_step(abs(way_y), events, state[1])
        state[1] += 1
        state[2] += 1
        ticks[written] = state[2]
        step[written] = pulse_x + 2 * pulse_y
        back[written] = pulse_x * (way_x < 0) + 2 * pulse_y * (way_y < 0)
        written += 1
    return written


@njit
def _has_step(steps, events, done):
    """Return 1 where an axis steps at the event behind so many that are done, as in `bresenham`; else 0."""
    return steps_made(steps, 2 * events, 2 * done + 2) - steps_made(steps, 2 * events, 2 * done)
