# SPDX-License-Identifier: LGPL-2.1-or-later
"""A reversed program is read again: its passes must be the old ones from end to begin, and all else as it was.

old    travel ──► A   plunge   A -> B -> C   lift        rows of a pass: AB BC
new    travel ──► C   plunge   C -> B -> A   lift                        CB BA
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from CNCStepper.gcode.edit.cutting_passes import SAME_MM, Pass, Rows
from CNCStepper.gcode.edit.edit_result import Edited
from CNCStepper.gcode.edit.executed_lines import Source
from CNCStepper.gcode.edit.preserved_modes import same_modes
from CNCStepper.gcode.edit.verification import same_events
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.gcode.interpreter.motion.arc_lengths import ways_of
from CNCStepper.toolpath import ARC_CW, Toolpath

CENTRE_MM = 0.005  # by which rounding may move the centre of an arc
COMMENTS = ("comment", "message")  # stay with their lines
SAME_ANGLE = 0.02  # radians, of arcs that are not too small to have one


def require_reversed(source: Source, rows: Rows, passes: Sequence[Pass], edited: Edited) -> None:
    """Raise ProgramError where the new text is not the old one with its passes turned round."""
    new = interpret(edited.text, source.start, source.dialect, source.file)
    good = len(new) == len(source.toolpath) and same_events(source.toolpath, new, COMMENTS)
    if not (good and _same_rows(source.toolpath, new, rows, passes)):
        raise source.refusal(1, "edit-differs", "the changed program would make other moves")


def _same_rows(old: Toolpath, new: Toolpath, rows: Rows, passes: Sequence[Pass]) -> bool:
    """Return whether every row is the one that it must be: `was` names the old row that each is the way of."""
    table, before = new.table(), rows.table
    was = np.arange(len(before))
    turned = np.zeros(len(before), bool)
    for one in passes:
        was[one.first : one.last] = np.arange(one.first, one.last)[::-1]
        turned[one.first : one.last] = True
    arcs = before.kind[was] >= ARC_CW
    kinds = np.where(turned & arcs, 5 - before.kind[was].astype(int), before.kind[was])
    feeds, wanted = table.feed, before.feed[was]
    if not ((table.kind == kinds) & (np.abs(feeds - wanted) <= 1e-9 * wanted) & same_modes(old, new)).all():
        return False
    begins, ends, centres = (points - new.offsets_mm()[:, :3] for points in _points(new))
    heights = np.isclose(ends[:, 2], rows.end[:, 2], atol=SAME_MM, equal_nan=True)
    to_begin = (np.abs(ends[:, :2] - rows.begin[was, :2]) <= SAME_MM).all(axis=1)
    from_end = (np.abs(begins[:, :2] - rows.end[was, :2]) <= SAME_MM).all(axis=1)
    about = (np.abs(centres - rows.centre[was])[:, :2] <= CENTRE_MM).all(axis=1) | ~arcs
    places = np.where(turned, to_begin & from_end & about & _same_angles(old, new, was), heights)
    return bool(places.all())


def _same_angles(old: Toolpath, new: Toolpath, was: np.ndarray) -> np.ndarray:
    """Return the rows that go through the angle of the old one, the other way round."""
    one, other = (ways_of(path.table(), *_points(path)[:2]) for path in (old, new))
    small = one.radius_mm[was] * SAME_ANGLE < CENTRE_MM
    return small | (np.abs(one.sweep_rad[was] + other.sweep_rad) <= SAME_ANGLE)


def _points(path: Toolpath) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    return path.begins()[:, :3], path.table().end[:, :3], path.table().centre
