# SPDX-License-Identifier: LGPL-2.1-or-later
"""The kernel that executes runs of plain lines, from bytes straight into columns of the table of moves.

    bytes --read_words--> shape, values --verdicts[motion, shape]--> kind of move --> end, arc --> a row

It knows no grammar, no modes and no errors: which shapes of line may be executed stands in `verdicts`, all else in
`Facts`. Before a line that it does not know, or that it would have to refuse, it stops and has changed nothing.
"""

from __future__ import annotations

import math

import numpy as np

from CNCStepper.gcode.interpreter.motion import arc_geometry
from CNCStepper.gcode.syntax.word_kernels import LEFT, LETTERS, SHAPES, N, after_line_end, read_words
from CNCStepper.kernels import njit_in_place
from CNCStepper.toolpath import ARC_CW, LINE, RAPID

MOTIONS = 4  # G0 ... G3 as they may be modal
ALL_SHAPES = (MOTIONS + 1) * SHAPES
UNKNOWN, REFUSED, MOVELESS, FIRST_MOTION = 0, 1, 2, 3  # verdicts; FIRST_MOTION + n makes a move of kind n
FEED, RADIUS, CENTRE = LETTERS.index("F"), LETTERS.index("R"), LETTERS.index("I")

length, centre_by_radius = njit_in_place(arc_geometry.length), njit_in_place(arc_geometry.centre_by_radius)
radii_agree, sweep_rad = njit_in_place(arc_geometry.radii_agree), njit_in_place(arc_geometry.sweep_rad)

FACTS = np.dtype(  # what the lines of a run cannot change
    [
        ("scale", "f8"),  # mm per unit of the text
        ("absolute", "i8"),  # G90
        ("centres_absolute", "i8"),  # G90.1
        ("plane", "i8"),
        ("first", "i8"),  # the plane's axes
        ("second", "i8"),
        ("normal", "i8"),
        ("slack", "f8"),  # `ArcRule`, in mm
        ("gap", "f8"),
        ("relative", "f8"),
        ("smallest_radius", "f8"),
        ("smallest_angle_rad", "f8"),
        ("radius_slack", "f8"),
        ("largest_number", "f8"),  # of an N word
        ("longest_line", "i8"),
    ]
)
NOW = np.dtype(  # where the run is
    [
        ("at", "i8"),  # byte
        ("line", "i8"),  # lines read
        ("rows", "i8"),  # rows made
        ("room", "i8"),  # rows at most
        ("changes", "i8"),  # feeds set
        ("state", "i8"),  # index of the state in force
        ("motion", "i8"),  # modal
        ("feed", "f8"),  # in force, mm/min
        ("told", "i8"),  # whether an F was read, 0 or 1
        ("words", "i8"),  # shape of the line before which it stopped, -1 where that cannot be said
    ]
)


def _fields(kind: np.dtype) -> np.ndarray:
    return np.zeros(1, kind).view(np.recarray)


def new_facts():
    """Return the memory of the facts, a record."""
    return _fields(FACTS)[0]


def new_now():
    """Return the memory of where a run is, a record."""
    return _fields(NOW)[0]


@njit_in_place
def end_of_move(facts, offset, position, shape, values, target):
    """Write where the axis words lead into `target`; return whether that is known."""
    for axis in range(len(position)):
        target[axis] = position[axis]
    for axis in range(3):
        if shape & (1 << axis):
            if facts.absolute:
                target[axis] = values[axis] * facts.scale + offset[axis]
            else:
                target[axis] += values[axis] * facts.scale
                if math.isnan(target[axis]):
                    return False
    return True


@njit_in_place
def centre_of_arc(facts, offset, position, target, shape, values, clockwise):
    """Return whether the interpreter is sure to take the arc, and its centre along the plane's axes."""
    x0, y0, x1, y1 = position[facts.first], position[facts.second], target[facts.first], target[facts.second]
    if math.isnan(x0 + y0 + x1 + y1 + position[facts.normal] + target[facts.normal]):
        return False, 0.0, 0.0
    if shape & (1 << RADIUS):
        radius, chord = values[RADIUS] * facts.scale, length(x1 - x0, y1 - y0)
        if chord == 0 or chord / 2 - abs(radius) > facts.radius_slack:
            return False, 0.0, 0.0
        x, y = centre_by_radius(x0, y0, x1, y1, radius, clockwise)
    else:
        x, y = x0, y0
        if shape & (1 << (CENTRE + facts.first)):
            x = values[CENTRE + facts.first] * facts.scale + (offset[facts.first] if facts.centres_absolute else x0)
        if shape & (1 << (CENTRE + facts.second)):
            y = values[CENTRE + facts.second] * facts.scale + (offset[facts.second] if facts.centres_absolute else y0)
    return is_good_arc(facts, x0 - x, y0 - y, x1 - x, y1 - y, x0 == x1 and y0 == y1, clockwise), x, y


@njit_in_place
def is_good_arc(facts, x0, y0, x1, y1, whole, clockwise):
    """Whether the radius vectors of an arc's ends pass the dialect's rule; what hangs by a hair is left."""
    radius, at_end = length(x0, y0), length(x1, y1)
    if min(radius, at_end) < facts.smallest_radius:
        return False
    if not radii_agree(radius, at_end, facts.slack, facts.gap, facts.relative):
        return False
    if whole or facts.smallest_angle_rad == 0:
        return True
    swept = sweep_rad(x0, y0, x1, y1, clockwise)
    return min(swept, arc_geometry.FULL_TURN - swept) > 1.001 * facts.smallest_angle_rad


@njit_in_place
def run_lines(data, now, facts, offset, position, target, roles, verdicts, values, feeds, columns):
    """Execute lines from `now.at` on until one must be left, or `now.room` rows are made or `feeds` is full.

    data: uint8, whole lines. position: float64[axes], mm, changed. target, values: memory, float64[axes] and [G].
    feeds: each new feed, mm/min. columns: kind, end, centre, plane, turns, feed, state and line as in
    `toolpath.Chunk`; the rows of `centre`, `plane` and `turns` are 0.
    """
    kind, ends, centres, planes, turns, row_feed, row_state, row_line = columns
    end, now.words = len(data), -1
    while now.at < end and now.rows < now.room and now.changes < len(feeds):
        shape, at = read_words(data, now.at, end, roles, values)
        if at == LEFT or at - now.at >= facts.longest_line:
            return
        verdict = verdicts[now.motion, shape]
        if verdict < MOVELESS:
            now.words = shape
            return
        feed = now.feed
        if shape & (1 << FEED):
            feed = values[FEED] * facts.scale
            if math.copysign(1.0, feed) < 0:
                return
        if shape & (1 << N) and not 0 <= values[N] <= facts.largest_number:
            return
        if verdict >= FIRST_MOTION:
            motion, row = verdict - FIRST_MOTION, now.rows
            if not end_of_move(facts, offset, position, shape, values, target) or (motion != RAPID and feed <= 0):
                return
            if motion > LINE:
                good, x, y = centre_of_arc(facts, offset, position, target, shape, values, motion == ARC_CW)
                if not good:
                    return
                centres[row, facts.first], centres[row, facts.second] = x, y
                centres[row, facts.normal] = position[facts.normal]
                planes[row], turns[row] = facts.plane, 1
            kind[row], row_feed[row] = motion, 0.0 if motion == RAPID else feed
            row_state[row] = now.state + (feed != now.feed)
            row_line[row] = now.line + 1
            for axis in range(len(position)):
                ends[row, axis] = position[axis] = target[axis]
            now.rows, now.motion = row + 1, motion
        if feed != now.feed:
            feeds[now.changes] = now.feed = feed
            now.changes += 1
            now.state += 1
        if shape & (1 << FEED):
            now.told = 1
        now.line += 1
        now.at = after_line_end(data, at, end)
