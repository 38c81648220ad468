# SPDX-License-Identifier: LGPL-2.1-or-later
"""Arcs and helices as chains of straight moves, split as the firmware splits them.

The number of chords follows from the arc tolerance (the sagitta of a chord); the radius is turned from
chord to chord by a third-order approximation, put right with exact sine and cosine every twelfth time.
An arc whose angle is at most 5e-7 rad is taken as a whole circle.
"""

from __future__ import annotations

import math

import numpy as np

from CNCStepper.kernels import njit_inline
from CNCStepper.motion.planner.buffers import copy_axes
from CNCStepper.tolerances import FULL_CIRCLE_RAD
from CNCStepper.toolpath import ARC_CW, PLANE_AXES

CORRECT_EVERY = 12

ARC = np.dtype(
    [
        ("axis_0", "i8"),
        ("axis_1", "i8"),
        ("chords", "i8"),
        ("done", "i8"),
        ("centre_0", "f8"),
        ("centre_1", "f8"),
        ("begin_0", "f8"),  # radius vector of the arc's begin
        ("begin_1", "f8"),
        ("now_0", "f8"),  # radius vector of the last point
        ("now_1", "f8"),
        ("angle", "f8"),  # of one chord, positive counter-clockwise
        ("since_exact", "i8"),
    ]
)


def new_arc() -> np.ndarray:
    """Return the memory of one arc in the making."""
    return np.zeros(1, ARC).view(np.recarray)


def arc_points(
    begin_mm: np.ndarray,
    end_mm: np.ndarray,
    centre_mm: np.ndarray,
    kind: int,
    plane: int,
    turns: int,
    arc_tolerance_mm: float,
) -> np.ndarray:
    """Return the points that the firmware drives to, float64[n, axes], without the begin and with the end.

    All in mm; `kind`, `plane` and `turns` as in the table of moves.
    """
    arc = new_arc()
    begin, end, centre = (np.asarray(point, float) for point in (begin_mm, end_mm, centre_mm))
    points = np.empty((start_arc(arc[0], begin, end, centre, kind, plane, turns, arc_tolerance_mm), len(begin)))
    _fill(arc[0], begin, end, points)
    return points


@njit_inline
def start_arc(arc, begin, end, centre, kind, plane, turns, tolerance):
    """Prepare the splitting of an arc; returns its number of chords, at least 1."""
    axis_0, axis_1, _ = PLANE_AXES[plane]
    arc.axis_0, arc.axis_1 = axis_0, axis_1
    arc.centre_0, arc.centre_1 = centre[axis_0], centre[axis_1]
    arc.begin_0, arc.begin_1 = begin[axis_0] - arc.centre_0, begin[axis_1] - arc.centre_1
    arc.now_0, arc.now_1 = arc.begin_0, arc.begin_1
    angle = _sweep(arc, end, kind == ARC_CW, turns)
    radius = math.hypot(arc.begin_0, arc.begin_1)
    room = tolerance * (2.0 * radius - tolerance)
    arc.chords = 1
    if room > 0.0 and not math.isnan(angle):
        arc.chords = max(1, math.floor(abs(0.5 * angle * radius) / math.sqrt(room)))
    arc.angle = angle / arc.chords
    arc.done = 0
    arc.since_exact = 0
    return arc.chords


@njit_inline
def _sweep(arc, end, clockwise, turns):
    """Return the signed angle of the arc, in the firmware's 32-bit precision."""
    begin_0, begin_1 = np.float32(arc.begin_0), np.float32(arc.begin_1)
    end_0 = np.float32(end[arc.axis_0]) - np.float32(arc.centre_0)
    end_1 = np.float32(end[arc.axis_1]) - np.float32(arc.centre_1)
    sine = begin_0 * end_1 - begin_1 * end_0
    cosine = begin_0 * end_0 + begin_1 * end_1
    angle = math.atan2(float(sine), float(cosine))
    extra = 2.0 * math.pi * max(0, turns - 1)
    if clockwise:
        return (angle if angle < -FULL_CIRCLE_RAD else angle - 2.0 * math.pi) - extra
    return (angle if angle > FULL_CIRCLE_RAD else angle + 2.0 * math.pi) + extra


@njit_inline
def next_point(arc, begin, end, point):
    """Write the end of the next chord to `point`; the axes outside the plane move in proportion."""
    arc.done += 1
    if arc.done == arc.chords:
        copy_axes(end, point)
        return
    _turn(arc)
    for axis in range(len(point)):
        point[axis] = begin[axis] + (end[axis] - begin[axis]) * (arc.done / arc.chords)
    point[arc.axis_0] = arc.centre_0 + arc.now_0
    point[arc.axis_1] = arc.centre_1 + arc.now_1


@njit_inline
def _turn(arc):
    """Turn the radius vector by one chord."""
    from_0, from_1 = arc.now_0, arc.now_1
    if arc.since_exact < CORRECT_EVERY:
        arc.since_exact += 1
        cosine = 1.0 - 0.5 * arc.angle**2
        sine = arc.angle - arc.angle**3 / 6.0
    else:
        arc.since_exact = 0
        from_0, from_1 = arc.begin_0, arc.begin_1
        cosine = math.cos(arc.done * arc.angle)
        sine = math.sin(arc.done * arc.angle)
    arc.now_0 = from_0 * cosine - from_1 * sine
    arc.now_1 = from_0 * sine + from_1 * cosine


@njit_inline
def _fill(arc, begin, end, points):
    for row in range(len(points)):
        next_point(arc, begin, end, points[row])
