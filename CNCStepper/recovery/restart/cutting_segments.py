# SPDX-License-Identifier: LGPL-2.1-or-later
"""The stretches in which a program cuts, and the ways into them.

rapids      .........                            ............
                    :  descent                   :
                     \\   lead-in                 : (lift)
                      \\__,  contour ___________,-'
            |        |                          |
            |        +------ a stretch ---------+       from one rapid to the next, at one state of the spindle
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from CNCStepper.recovery.restart.program import Program

LEVEL_MM = 1e-6  # a move that falls by less is level
SAME_PLACE_MM = 0.002  # of the begin and the end of a contour
LEAD_ROWS = 3  # a lead-in is a line, an arc, or both


class Stretch(NamedTuple):
    """Rows [first, last)."""

    first: int
    last: int


def stretches(program: Program) -> list[Stretch]:
    """Return all runs of rows that are no rapids, parted where the spindle or the beam is switched."""
    feeds, on = program.feeds, program.spindle_on
    breaks = np.flatnonzero((feeds[1:] != feeds[:-1]) | (on[1:] != on[:-1])) + 1
    firsts, lasts = np.r_[0, breaks], np.r_[breaks, len(feeds)]
    return [Stretch(first, last) for first, last in zip(firsts.tolist(), lasts.tolist(), strict=True) if feeds[first]]


def cutting(program: Program) -> list[Stretch]:
    """Return the stretches that cut: all, or those with the spindle or the beam on where a program switches one."""
    on = program.spindle_on
    return [stretch for stretch in stretches(program) if on[stretch.first] or not on.any()]


def stretch_of(program: Program, row: int) -> Stretch:
    """Return the stretch of a row that is no rapid."""
    return next(stretch for stretch in stretches(program) if stretch.first <= row < stretch.last)


def descents(program: Program, stretch: Stretch) -> list[Stretch]:
    """Return the ways down within a stretch: its first fall, plunges, and ramps from one level to another.

    A fall on a surface that rises and falls all the way is none.
    """
    rows = slice(stretch.first, stretch.last)
    way = program.table.end[rows, :3] - program.begins[rows]
    falls = way[:, 2] < -LEVEL_MM
    level = np.abs(way[:, 2]) <= LEVEL_MM
    upright = falls & (np.hypot(way[:, 0], way[:, 1]) <= LEVEL_MM) & (program.ways.sweep_rad[rows] == 0)
    edges = np.flatnonzero(np.diff(np.r_[False, falls, False].astype(np.int8)))
    found = []
    for first, last in zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True):
        before, after = first == 0 or level[first - 1], last == len(falls) or level[last]
        if first == 0 or upright[first:last].all() or (before and after):
            found.append(Stretch(stretch.first + first, stretch.first + last))
    return found


def entry_of(program: Program, stretch: Stretch, row: int) -> Stretch:
    """Return the last way into the cut that begins at or before a row of a stretch: a descent and its lead-in.

    Where there is none it is empty, and stands at the stretch's begin.
    """
    before = [one for one in descents(program, stretch) if one.first <= row]
    descent = before[-1] if before else Stretch(stretch.first, stretch.first)
    return Stretch(descent.first, _lead_end(program, stretch, descent.last))


def _lead_end(program: Program, stretch: Stretch, first: int) -> int:
    """Return where a lead-in from `first` on ends: the first place to which the way comes back; `first` for none."""
    ends = program.table.end[first : stretch.last, :3]
    for row in range(first, min(first + LEAD_ROWS, stretch.last - 1)):
        back = np.abs(ends[row - first :] - program.begins[row]).max(axis=1) <= SAME_PLACE_MM
        if back.any():
            return row
    return first
