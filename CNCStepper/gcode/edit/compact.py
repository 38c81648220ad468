# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shorter programs: runs of small straight moves become few longer lines, arcs and helices within a tolerance.

    G1 X1. F800      kept: it sets the feed
    X1.05            \\
    X1.1 Y.05         |  a run: nothing but straight moves at one feed, in one state
    ...               |  -> G3 X4. Y2. I.. J..
    X4. Y2.          /
    (here we are)    kept: every line with a comment, event, output, other motion or change of state

What is no run stays as it is written. The ends of the new moves are ends of old ones, so only the centres of arcs are
rounded; how far an arc as it is written leaves the old way is measured, and where that is too far lines take its place.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from math import isnan

import numpy as np

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.dialects import Dialect, dialect_named
from CNCStepper.gcode.dialects.codes import MOTION_NAMES, NO_MOTION
from CNCStepper.gcode.edit.edit_result import Edited, Lines
from CNCStepper.gcode.edit.executed_lines import is_compensated, require_straight, work_place
from CNCStepper.gcode.edit.line_and_arc_writer import Run, written
from CNCStepper.gcode.edit.line_tokens import changed, first_place, is_plain, tokens_of
from CNCStepper.gcode.interpreter.line_interpreter import Interpreter
from CNCStepper.gcode.syntax.words import NUMBER
from CNCStepper.state import Start
from CNCStepper.toolpath import LINE

LEAST_MOVES = 2  # fewer are no run
_SMALL = re.compile(rf"(?:N[0-9.]+)?(?:G0*1(?![0-9.]))?(?:[XYZF]{NUMBER})+")
_MOTIONS = frozenset(MOTION_NAMES)


@dataclass
class _Gathered:
    """A run while it is read: its line numbers (from 0) and the places that it goes through, work mm."""

    lines: list[int]
    points: list[tuple[float, ...]]
    run: Run


def compact(
    text: str, tolerance_mm: float, dialect: str | Dialect = "grbl", start: Start | None = None, file: str = ""
) -> Edited:
    """Return the program with its runs of straight moves rewritten, never farther than `tolerance_mm` from the old way.

    The distance is measured both ways, curve to curve, in space. Raises ProgramError for a text that cannot be read,
    that has subroutines or loops, or a tolerance that is not above 0.
    """
    if not tolerance_mm > 0:
        raise ProgramError("tolerance", "the tolerance must be above 0", value=f"{tolerance_mm:g} mm")
    language, source = dialect_named(dialect), Lines(text)
    require_straight(text, language, file)
    lines: list[str] = []
    origins: list[int] = []
    owed = ""  # the motion word that the next straight move needs
    for item in _items(source.lines, language, start, file):
        if isinstance(item, _Gathered):
            item.run.motion = NO_MOTION if owed else item.run.motion
            new = written(np.array(item.points), item.run, tolerance_mm)
            if new is not None and len(new.lines) < len(item.lines):
                lines += new.lines
                origins += [item.lines[place] + 1 for place in new.places]
                owed = new.owed
                continue
            kept = [(number, True) for number in item.lines]
        else:
            kept = [item]
        for number, straight in kept:
            line = source.lines[number]
            if owed:
                line, owed = _with_motion(line, owed, straight)
            lines.append(line)
            origins.append(number + 1)
    return source.edited(lines, origins)


def _items(
    lines: list[str], language: Dialect, start: Start | None, file: str
) -> Iterator[_Gathered | tuple[int, bool]]:
    """Yield runs, and between them (number of a line, whether it makes a straight move)."""
    reader = Interpreter(start, language, file)
    run: _Gathered | None = None
    for number, line in enumerate(lines):
        before = _look(reader)
        reader.line(line)
        straight = reader.table.index == before.index + 1 and reader.model.motion == LINE
        if straight and _may_join(reader, before, line, language):
            if run is None:
                run = _Gathered([], [before.work], _run_of(reader, before, language))
            run.lines.append(number)
            run.points.append(work_place(reader))
            run.run.tell(line)
            continue
        if run is not None:
            yield from _ended(run)
            run = None
        yield number, straight
    if run is not None:
        yield from _ended(run)
    reader.toolpath()


@dataclass(frozen=True)
class _Look:
    """What the reader holds before a line."""

    index: int
    states: int
    events: int
    motion: int
    work: tuple[float, ...]


def _look(reader: Interpreter) -> _Look:
    table = reader.table
    return _Look(table.index, len(table.states), len(table.events), reader.model.motion, work_place(reader))


def _may_join(reader: Interpreter, before: _Look, line: str, language: Dialect) -> bool:
    """Whether a line is nothing but a straight move in the state of the lines before it."""
    table, state = reader.table, reader.model.state
    same = len(table.states) == before.states and len(table.events) == before.events
    steady = same and reader.model.plain and state.path_mode != "exact_stop"
    if not steady or is_compensated(reader) or reader.model.turn is not None or len(before.work) != 3:
        return False
    if state.distance != "absolute" and language.motion_code(LINE) != language.codes.get("G1"):
        return False
    known = not any(isnan(value) for value in before.work[:2])
    moved = before.work != work_place(reader)
    return known and moved and _SMALL.fullmatch("".join(line.split()).upper()) is not None


def _run_of(reader: Interpreter, before: _Look, language: Dialect) -> Run:
    state = reader.model.state
    return Run(
        dialect=language,
        units=state.units,
        scale_mm=reader.model.scale,
        absolute=state.distance == "absolute",
        absolute_centres=state.arc_centres == "absolute",
        plane=state.plane,
        motion=before.motion,
    )


def _ended(run: _Gathered) -> Iterator[_Gathered | tuple[int, bool]]:
    if len(run.lines) >= LEAST_MOVES:
        yield run
    else:
        yield from ((number, True) for number in run.lines)


def _with_motion(line: str, word: str, straight: bool) -> tuple[str, str]:
    """Return a kept line with the motion word where it needs it, and what is still owed after it."""
    if any(token.name in _MOTIONS for token in tokens_of(line)) or not is_plain(line):
        return line, ""
    if not straight:
        return line, word
    at = first_place(line)
    return changed(line, [(at, at, f"{word} ")]), ""
