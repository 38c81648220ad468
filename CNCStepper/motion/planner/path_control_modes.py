# SPDX-License-Identifier: LGPL-2.1-or-later
"""Path modes: exact stop at every corner (G61.1), and corners between straight feeds cut by arcs (G64 P).

    before ────────────┐ reach ┌─ corner        r: radius; the turn is the change of direction
                        ` .    |                deviation of the arc from the corner = r (1 / cos(turn / 2) - 1)
                            `. |  reach         reach = r tan(turn / 2), at most half of either line
                              \\|
                               └── after        a chord's sagitta comes to the deviation: both within P

Invariants: no point of the new path is farther than P from the programmed one; both lines' middles are passed;
an arc is run no faster than its acceleration v²/r allows every axis. A corner that P lets nobody cut better than
the junction deviation does is left as it is, and so is one at which the motion stops. G61 and G64 without P follow
the exact path.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from CNCStepper.kernels import njit_in_place
from CNCStepper.motion.planner.machine_limits import Limits
from CNCStepper.state import State
from CNCStepper.toolpath import LINE, Chunk, begins_of

LEAST_TURN_RAD = 1e-3  # below it a corner is passed as fast
MOST_TURN_RAD = math.pi - 0.05  # above it the path reverses


def path_modes(states: Sequence[State], column: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return for a column of states whether each is exact stop, bool[n], and how far its corners may be cut, in mm."""
    firsts = np.flatnonzero(np.diff(column, prepend=-1))
    used = [states[int(column[first])] for first in firsts]
    counts = np.diff(firsts, append=len(column))
    exact = np.array([state.path_mode == "exact_stop" for state in used], bool)
    allowed_mm = np.array([state.blend_mm if state.path_mode == "blend" else 0.0 for state in used], float)
    return np.repeat(exact, counts), np.repeat(allowed_mm, counts)


def reaches(
    chunk: Chunk, begin: np.ndarray, after: np.ndarray, allowed_mm: np.ndarray, free: np.ndarray, limits: Limits
) -> np.ndarray:
    """Return how much of each row's end its corner's arc takes, float64[n] in mm, 0 where the corner stays.

    begin: where the first row begins. after: float64[n, axes], where the row behind each ends. free: bool[n],
    a straight feed follows and nothing stops the motion before it.
    """
    with np.errstate(invalid="ignore", divide="ignore"):
        one, other = chunk.end - begins_of(chunk, begin), after - chunk.end
        lengths = np.linalg.norm(one, axis=1), np.linalg.norm(other, axis=1)
        cosine = np.clip((one * other).sum(axis=1) / (lengths[0] * lengths[1]), -1.0, 1.0)
        turn = np.arccos(cosine)
        per_radius = 1.0 / np.cos(0.5 * turn) - 1.0
        sagitta = np.minimum(limits.junction_deviation_mm, 0.25 * allowed_mm)
        radius = (allowed_mm - sagitta) / per_radius
        reach = np.minimum(radius * np.tan(0.5 * turn), 0.5 * np.minimum(*lengths))
        better = reach / np.tan(0.5 * turn) * per_radius > limits.junction_deviation_mm
        cut = free & (chunk.kind == LINE) & (turn > LEAST_TURN_RAD) & (turn < MOST_TURN_RAD) & better
    return np.where(cut, reach, 0.0)


@njit_in_place
def start_corner(course, rows, row):
    """Prepare the pieces of a row whose corner is cut: what is left of the line, and the chords of the arc."""
    arc = course.arc[0]
    turn = _turn(course, rows, row)
    radius = rows.reach[row] / math.tan(0.5 * turn)
    deviation = radius * (1.0 / math.cos(0.5 * turn) - 1.0)
    sagitta = min(course.planner.settings[0].junction_deviation, deviation / 3.0)
    chords = max(1, math.ceil(turn / (2.0 * math.acos(1.0 - sagitta / radius))))
    arc.angle = turn / chords
    arc.chords = chords + 1
    arc.done = 0


@njit_in_place
def next_corner_point(course, rows, row):
    """Write the end of the row's next piece to `course.point`; returns how fast that may be run, in mm/s."""
    arc = course.arc[0]
    place, corner, after = course.place, rows.end[row], rows.after[row]
    turn = _turn(course, rows, row)
    before_mm, after_mm = _length(place, corner), _length(corner, after)
    reach = rows.reach[row]
    radius = reach / math.tan(0.5 * turn)
    angle = arc.done * arc.angle
    along = radius * (math.sin(angle) - (1.0 - math.cos(angle)) / math.tan(turn)) - reach
    across = radius * (1.0 - math.cos(angle)) / math.sin(turn)
    least = np.inf
    for axis in range(len(place)):
        one, other = (corner[axis] - place[axis]) / before_mm, (after[axis] - corner[axis]) / after_mm
        course.point[axis] = corner[axis] + along * one + across * other
        if one != 0.0 or other != 0.0:
            least = min(least, course.planner.max_acceleration[axis])
    arc.done += 1
    return rows.speed[row] if arc.done == 1 else min(rows.speed[row], math.sqrt(least * radius))


@njit_in_place
def _turn(course, rows, row):
    """Return the change of direction at the end of the row, in rad."""
    place, corner, after = course.place, rows.end[row], rows.after[row]
    dot = 0.0
    for axis in range(len(place)):
        dot += (corner[axis] - place[axis]) * (after[axis] - corner[axis])
    return math.acos(max(-1.0, min(1.0, dot / (_length(place, corner) * _length(corner, after)))))


@njit_in_place
def _length(begin, end):
    square = 0.0
    for axis in range(len(begin)):
        square += (end[axis] - begin[axis]) ** 2
    return math.sqrt(square)
