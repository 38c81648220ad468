# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every pass of a program cut the other way round: what was climb milling is conventional, and the other way.

    before   G0 to A    plunge    A -> B -> C    retract
    after    G0 to C    plunge    C -> B -> A    retract

Order of passes, plunges, spindle, coolant and beam stay where they are; each row keeps its feed. Refused is what would
be unsafe: a ramp (it would enter at full depth), rapids that are not above all cuts with the tool running, passes that
meet one way round only.
"""

from __future__ import annotations

import itertools
from math import isnan

import numpy as np

from CNCStepper.gcode.dialects import Dialect, dialect_named
from CNCStepper.gcode.edit.cutting_passes import SAME_MM, Pass, Rows, passes_of
from CNCStepper.gcode.edit.edit_result import Edited
from CNCStepper.gcode.edit.executed_lines import Source, require_straight
from CNCStepper.gcode.edit.reverse_verification import require_reversed
from CNCStepper.gcode.edit.reverse_writer import Rewriter
from CNCStepper.state import Start


def reverse(text: str, dialect: str | Dialect = "grbl", start: Start | None = None, file: str = "") -> Edited:
    """Return the program with each of its passes cut backwards; raises ProgramError where that would be unsafe."""
    require_straight(text, dialect_named(dialect), file)
    source = Source(text, dialect, start, file)
    rows = Rows(source)
    passes = passes_of(rows)
    if not passes:
        raise source.refusal(1, "reverse-nothing", "the program cuts along no way at one height")
    _check(rows, passes)
    edited = Rewriter(source, rows, passes).edited()
    require_reversed(source, rows, passes, edited)
    return edited


def _check(rows: Rows, passes: list[Pass]) -> None:
    for one in passes:
        if any(meaning.compensated for meaning in _meanings(rows, one)):
            what = "the tool's radius is compensated along this way (G41, G42)"
            raise rows.refusal(one.first, "reverse-compensation", what, "write the way of the tool's centre")
        if np.isnan(rows.begin[one.first : one.last, :2]).any():
            what = "where this way begins is not known"
            raise rows.refusal(one.first, "reverse-unknown", what, "write a rapid to its begin")
    for before, after in itertools.pairwise([None, *passes]):
        _check_meeting(rows, before, after)
    _check_rapids(rows, passes)


def _meanings(rows: Rows, one: Pass):
    found = (rows.source.meanings[rows.line[row] - 1] for row in range(one.first, one.last))
    return (meaning for meaning in found if meaning)


def _check_meeting(rows: Rows, before: Pass | None, after: Pass | None) -> None:
    """Refuse a pass to which no rapid leads and that does not begin where the one before ends, backwards too."""
    if after is None or after.travel is not None:
        return
    begin = rows.end[after.last - 1, :2]
    there = rows.begin[before.first, :2] if before else None
    if there is None or (np.abs(begin - there) > SAME_MM).any():
        what = "no rapid leads to this way, and backwards it does not begin where the one before ends"
        raise rows.refusal(after.first, "reverse-apart", what, "lift the tool between them")


def _check_rapids(rows: Rows, passes: list[Pass]) -> None:
    """Refuse rapids with the tool running that are not above every cut: other places lie under them now."""
    heights = np.concatenate([rows.end[one.first : one.last, 2] for one in passes])
    deepest = float(np.nanmax(heights)) if not np.isnan(heights).all() else float("nan")
    for row in np.flatnonzero(rows.rapid & rows.flat).tolist():
        begin, end = float(rows.begin[row, 2]), float(rows.end[row, 2])
        height = end if isnan(begin) else min(begin, end)
        if rows.state(row).spindle_turns and not height > deepest and not _before(row, passes):
            what = "a rapid with the tool running is not above all cuts"
            raise rows.refusal(row, "reverse-rapid", what, "raise the tool first, or switch it off")


def _before(row: int, passes: list[Pass]) -> bool:
    """Whether a rapid comes before the first pass: nothing has been cut, and its height is not known perhaps."""
    return row < passes[0].first and passes[0].travel != row
