# SPDX-License-Identifier: LGPL-2.1-or-later
"""A program as several, one for each stretch with the same tool: its own lines, between a head and an end of their own.

%                                 as the program has it
(program 2 of 3, tool 4)
G21 G17 G90 G91.1 G94 G54 G0      head: all modes in force at the tool change
G0 Z10.  /  G0 X5. Y5.            the place, where the lines after it rely on it
...                               the lines, with the message and the pause before the change
M5  /  M9  /  M2                  end
"""

from __future__ import annotations

from dataclasses import dataclass
from math import isnan

import numpy as np

from CNCStepper.errors import Place, ProgramError, Text
from CNCStepper.gcode.dialects import Dialect, dialect_named
from CNCStepper.gcode.dialects.codes import CODE_OF_PLANE, MOTION_NAMES, UNIT_CODES
from CNCStepper.gcode.edit.edit_result import Lines
from CNCStepper.gcode.edit.line_states import require_straight, work_place
from CNCStepper.gcode.edit.line_tokens import changed, tokens_of
from CNCStepper.gcode.edit.word_values import MOST_DECIMALS, dialect_decimals, number_text
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.gcode.interpreter.line_interpreter import Interpreter
from CNCStepper.gcode.interpreter.state.modal_state_stack import modal_words
from CNCStepper.gcode.syntax.words import is_percent_mark
from CNCStepper.state import Start, State
from CNCStepper.tolerances import SAME_MM
from CNCStepper.toolpath import RAPID, Toolpath
from CNCStepper.units import UNIT_MM

PAUSES = frozenset(("M0", "M1", "T", "N"))
ENDS = frozenset(("M2", "M30"))


@dataclass(frozen=True)
class ProgramOfTool:
    """One of the programs: number from 1, its tool, its text."""

    number: int
    tool: int
    text: str


@dataclass(frozen=True)
class _Change:
    """Where a tool is changed: line (from 0) of the change, first line of its program, what stood before it.

    place: work coordinates. row: the first row after it. more: the path mode, the retract mode of canned cycles and
    the overrides, where the program says them.
    """

    line: int
    first: int
    tool: int
    state: State
    motion: str
    place: tuple[float, ...]
    row: int
    more: tuple[str, ...] = ()


def split(
    text: str, dialect: str | Dialect = "grbl", start: Start | None = None, file: str = ""
) -> list[ProgramOfTool]:
    """Return one program for each stretch with the same tool, in the order of the work.

    Raises ProgramError where there is no tool change, and where a stretch cannot stand alone: the spindle runs or the
    tool is down while it is changed, a G92 or a tool length is in force.
    """
    language, source = dialect_named(dialect), Lines(text)
    require_straight(text, language, file)
    changes, whole, first_tool = _changes(source.lines, language, start, file)
    if not changes:
        raise ProgramError("split-one", "the program changes no tool", advice="it is one program", place=Place(file, 1))
    bounds = [*(change.first for change in changes), len(source.lines)]
    left = [*(change.state for change in changes), State()]
    parts = [_Part(source, language, None, 0, bounds[0], first_tool, left[0])]
    for change, last, after in zip(changes, bounds[1:], left[1:], strict=True):
        _check(change, whole, source.lines[change.line : last], file)
        parts.append(_Part(source, language, change, change.first, last, change.tool, after))
    programs = []
    rows = [0, *(change.row for change in changes), len(whole)]
    for number, part in enumerate(parts, start=1):
        program = part.text(number, len(parts), relies=False)
        if not _same_rows(program, whole, rows[number - 1], rows[number], language, start):
            program = part.text(number, len(parts), relies=True)
            if not _same_rows(program, whole, rows[number - 1], rows[number], language, start):
                what = "the lines after this tool change cannot run on their own"
                advice = "begin them with G90 and a move that names X, Y and Z"
                raise ProgramError("split-alone", what, place=Place(file, part.first + 1), advice=advice)
        programs.append(ProgramOfTool(number, part.tool, program))
    return programs


def _changes(
    lines: list[str], language: Dialect, start: Start | None, file: str
) -> tuple[list[_Change], Toolpath, int]:
    """Return where another tool comes, the table, and the first tool."""
    reader = Interpreter(start, language, file)
    changes: list[_Change] = []
    first_tool, cut = 0, False
    said: set[str] = set()
    for number, line in enumerate(lines):
        model, row = reader.model, reader.table.index
        state, motion = model.state, MOTION_NAMES[model.motion]
        place = work_place(reader)
        reader.line(line)
        tool = reader.model.state.tool
        if tool != state.tool and tool:
            if cut:
                more = modal_words(model, said)
                changes.append(_Change(number, _first_line(lines, number), tool, state, motion, place, row, more))
            first_tool = first_tool or tool
        cut = cut or reader.table.index > row
        said |= {token.name for token in tokens_of(line)}
    return changes, reader.toolpath(), first_tool


def _first_line(lines: list[str], change: int) -> int:
    """Return the first line of what announces a change: comments, pauses, the choice of the tool."""
    first = change
    while first and lines[first - 1].strip() and all(token.name in PAUSES for token in tokens_of(lines[first - 1])):
        first -= 1
    return first


def _check(change: _Change, whole: Toolpath, lines: list[str], file: str) -> None:
    """Refuse a change after which a program of its own would not be safe."""
    place = Place(file, change.line + 1, 1)
    state = change.state
    m6 = any(token.name == "M6" for token in tokens_of(lines[0]))
    if state.spindle_turns and not m6:
        what = "the spindle runs while the tool is changed"
        raise ProgramError("split-spindle", what, value=f"T{change.tool}", advice="write M5 before", place=place)
    if any(state.g92_mm):
        what = "a G92 is in force where the tool is changed: a new program cannot rely on it"
        raise ProgramError("split-offset", what, value="G92", advice="use a work offset (G54) instead", place=place)
    if state.tool_length_mm and not _sets_length(lines):
        what = "the length of the tool before is in force after the change"
        raise ProgramError("split-offset", what, value="G43", advice="write G43 or G49 after the change", place=place)
    heights = (whole.table().end - whole.offsets_mm())[:, 2]
    highest_cut = np.nanmax(heights[whole.table().kind != RAPID], initial=-np.inf)
    if change.place[2] <= highest_cut and change.place[2] < np.nanmax(heights):
        what = "the tool is down while it is changed"
        limit = Text("above {highest_cut:g} mm", highest_cut=highest_cut)
        raise ProgramError(
            "split-height",
            what,
            value=f"Z {change.place[2]:g} mm",
            limit=limit,
            place=place,
            advice=Text("lift the tool above {highest_cut:g} mm before the change", highest_cut=highest_cut),
        )


def _sets_length(lines: list[str]) -> bool:
    for line in lines:
        names = {token.name for token in tokens_of(line)}
        if names & {"G43", "G43.1", "G49"}:
            return True
        if names & set("XYZ"):
            return False
    return False


@dataclass(frozen=True)
class _Part:
    """The lines [first, last) of the program; change: what they begin with, None for the first part; left: the state
    after them."""

    source: Lines
    dialect: Dialect
    change: _Change | None
    first: int
    last: int
    tool: int
    left: State

    def text(self, number: int, count: int, relies: bool) -> str:
        """Return the program; `relies`: it first moves to the position before the change."""
        lines = self.source.lines
        marked = any(is_percent_mark(line) for line in lines[:1])
        own = list(lines[self.first : self.last])
        if self.change is not None:
            own = [*self._head(self.change, relies), *self._with_tool(own, self.change)]
        title = Text("(program {number} of {count}, tool {tool})", number=number, count=count, tool=self.tool)
        own.insert(1 if marked and self.change is None else 0, title)
        if marked and self.change is not None:
            own.insert(0, "%")
        if self.last < len(lines):
            end = next(
                (token.name for line in reversed(lines) for token in tokens_of(line) if token.name in ENDS), "M2"
            )
            state = self.left
            off = ["M5"] * (state.spindle != "off") + ["M9"] * (state.mist or state.flood)
            own += [*off, end] + ["%"] * marked
        return self.source.edited(own, [1] * len(own)).text

    def _head(self, change: _Change, relies: bool) -> list[str]:
        state, known = change.state, self.dialect.codes
        words = [
            UNIT_CODES[state.units],
            CODE_OF_PLANE[state.plane],
            {"absolute": "G90", "incremental": "G91"}[state.distance],
            {"incremental": "G91.1", "absolute": "G90.1"}[state.arc_centres],
            {"inverse_time": "G93"}.get(state.feed_mode, "G94"),
            state.work_system,
        ]
        head = [" ".join(word for word in words if word in known and known[word].group != "motion")]
        head += change.more
        if relies:
            head += self._approach(change)
        motion = change.motion if change.motion in ("G0", "G1", "G2", "G3", "G80") else "G80"
        feed = state.feed_mm_min > 0 and state.feed_mode == "per_minute"
        number = number_text(state.feed_mm_min / UNIT_MM[state.units], MOST_DECIMALS)
        head.append(" ".join([motion] + [f"F{number}"] * feed))
        head += ["M7"] * state.mist + ["M8"] * state.flood
        return [line for line in head if line]

    def _approach(self, change: _Change) -> list[str]:
        """Return rapids to the tool's last position: up first, then over the place."""
        unit_mm = UNIT_MM[change.state.units]
        decimals = dialect_decimals(self.dialect, change.state.units) + 3
        x, y, z = ("" if isnan(v) else number_text(v / unit_mm, decimals) for v in change.place[:3])
        flat = " ".join(f"{letter}{text}" for letter, text in (("X", x), ("Y", y)) if text)
        back = ["G91"] * (change.state.distance != "absolute")
        lines = ([f"G0 Z{z}"] if z else []) + ([f"G0 {flat}"] if flat else [])
        return ["G90", *lines, *back] if back else lines

    def _with_tool(self, own: list[str], change: _Change) -> list[str]:
        """Return the lines with a T word where an M6 relied on one long before."""
        at = change.line - change.first
        said = any(token.letter == "T" for line in own[: at + 1] for token in tokens_of(line))
        if not said:
            m6 = next((token for token in tokens_of(own[at]) if token.name == "M6"), None)
            if m6 is not None:
                own[at] = changed(own[at], [(m6.begin, m6.begin, f"T{change.tool} ")])
        return own


def _same_rows(program: str, whole: Toolpath, first: int, last: int, language: Dialect, start: Start | None) -> bool:
    """Whether a program makes the rows [first, last) of the whole, perhaps after rapids of its own."""
    try:
        part = interpret(program, start, language)
    except ProgramError:
        return False
    new, old = part.table(), whole.table()
    rows, more = slice(first, last), len(part) - (last - first)
    if more < 0 or (new.kind[:more] != RAPID).any():
        return False
    same = (new.kind[more:] == old.kind[rows]).all() and np.allclose(new.feed[more:], old.feed[rows])
    ends = np.isclose(new.end[more:], old.end[rows], rtol=0.0, atol=SAME_MM, equal_nan=True).all()
    states = all(
        _running(part.states[a]) == _running(whole.states[b])
        for a, b in set(zip(new.state[more:].tolist(), old.state[rows].tolist(), strict=True))
    )
    return bool(same and ends and states)


def _running(state: State) -> tuple:
    return state.spindle, state.spindle_rpm if state.spindle != "off" else 0.0, state.mist, state.flood, state.tool
