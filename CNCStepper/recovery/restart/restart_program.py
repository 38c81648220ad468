# SPDX-License-Identifier: LGPL-2.1-or-later
"""A program from a place in its middle on, as a program of its own.

place ─► entrance ─► state there ─► approach ─► entry + the program's own lines ─► read again ─► the same rest?

The moves that are taken as done when a program is restarted: those before the entrance, and a lift.

Wherever the tool stands when the restart begins, its first move leads straight up from there; here it leads up from
the entrance, so that what follows is seen to begin above the work.

The program's own lines from the entry point on, unchanged but for a motion word named before them.

program   G1 X10 F800  /  X20  /  X30           entered at X20, after a plunge or an arc of the entry
rest                      G1 X20  /  X30        the first line that moves names what was modal

Judges a restart program's text: from the entrance on it must have the moves and states of the program itself.

It compares the two tables of moves alone, independently of the writer of the entry.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import isnan
from typing import Any

import numpy as np

from CNCStepper.canned_cycle_expansion import OWN_WORD
from CNCStepper.errors import ProgramError, Text
from CNCStepper.gcode.dialects import Dialect
from CNCStepper.gcode.dialects.codes import ALL_AXES, CYCLES, MOTION_NAMES, NO_MOTION
from CNCStepper.gcode.edit.line_tokens import Token, changed, first_place, tokens_of
from CNCStepper.gcode.edit.word_values import MOST_DECIMALS, number_text
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.gcode.interpreter.state.interpreter_state import Model
from CNCStepper.gcode.interpreter.state.parameters import offset_number, stored_point
from CNCStepper.gcode.syntax.words import is_percent_mark, split_line
from CNCStepper.recovery.restart.approach import Approach, Options, approach_to
from CNCStepper.recovery.restart.entry_point import EntryPoint, entry_point_of
from CNCStepper.recovery.restart.interrupted_program import Program, read_program
from CNCStepper.recovery.restart.preamble import EntryWriter
from CNCStepper.recovery.restart.restart_places import RequestedPlace, place_of
from CNCStepper.state import WORK_SYSTEMS, ZERO3, Start, State
from CNCStepper.tolerances import SAME_ENTRY_MM, SAME_RESTART_FEED
from CNCStepper.toolpath import COLUMNS, RAPID, XY, Chunk, Toolpath


def cut_before(program: Program, entrance: EntryPoint, approach: Approach) -> Toolpath:
    """Return the program's moves up to the entrance, and the lift to the height at which it is crossed."""
    row, table = entrance.row, program.table
    rows = [_rows(table, 0, row)]
    if entrance.share:
        part = _rows(table, row, row + 1)
        rows.append(replace(part, end=np.array([approach.at_mm])))
    if not isnan(approach.safe_mm):
        rows.append(_lift(table, row, approach))
    chunk = Chunk(0, *(np.concatenate([getattr(one, name) for one in rows]) for name in COLUMNS))
    events = [event for event in program.path.events if event.index < row]
    spans = [replace(span, last=min(span.last, row)) for span in program.path.spans if span.first < row]
    return Toolpath(program.path.start, [chunk], program.path.states, events, spans)


def _rows(table: Chunk, first: int, last: int) -> Chunk:
    rows = slice(first, last)
    return Chunk(first, *(getattr(table, name)[rows] for name in COLUMNS))


def _lift(table: Chunk, row: int, approach: Approach) -> Chunk:
    x, y, _ = approach.at_mm
    one = _rows(table, max(row - 1, 0), max(row, 1))
    nothing = np.zeros(1)
    return replace(
        one,
        kind=np.array([RAPID], np.uint8),
        end=np.array([[x, y, approach.safe_mm]]),
        centre=np.zeros((1, 3)),
        plane=np.array([XY], np.uint8),
        turns=np.zeros(1, np.uint16),
        feed=nothing,
    )


_MOVING = frozenset((*ALL_AXES, *"IJKR@^"))


def rest_of(lines: list[str], model: Model, dialect: Dialect) -> list[str]:
    """Return the lines that follow the entry; `model`: what holds before them."""
    found = _first_bare_move(lines, dialect)
    if found is None or model.motion == NO_MOTION:
        return lines
    index, tokens = found
    words = " ".join([MOTION_NAMES[model.motion], *_sticky(model, tokens)])
    place = first_place(lines[index])
    return [*lines[:index], changed(lines[index], [(place, place, f"{words} ")]), *lines[index + 1 :]]


def _first_bare_move(lines: list[str], dialect: Dialect) -> tuple[int, list[Token]] | None:
    """Return the first line that moves and its words, where no line up to it names a motion; else None."""
    for index, line in enumerate(lines):
        if is_percent_mark(line) or (dialect.skips_deleted and split_line(line).deleted):
            continue
        try:
            tokens = tokens_of(line)
        except ProgramError:  # the interpreter has read it, so it is no move but a sign of the dialect's own
            continue
        codes = [dialect.codes[token.name] for token in tokens if token.name in dialect.codes]
        if any(code.motion is not None for code in codes):
            return None
        if _MOVING.intersection(token.letter for token in tokens) and not any(code.axes for code in codes):
            return index, tokens
    return None


def _sticky(model: Model, tokens: list[Token]) -> list[str]:
    """Return the sticky words of a modal canned cycle that the line itself does not have."""
    if model.motion not in CYCLES or model.run is None:
        return []
    own = OWN_WORD.get(MOTION_NAMES[model.motion], "")
    stuck = {"Z": model.run.z, "R": model.run.r} | ({own: model.run.own} if own else {})
    said = {token.letter for token in tokens}
    return [f"{letter}{number_text(value, MOST_DECIMALS)}" for letter, value in stuck.items() if letter not in said]


def require_same_rest(program: Program, entrance: EntryPoint, restart: Toolpath, entry_lines: int) -> None:
    """Raise ProgramError, naming the first line that would differ, unless the rest is run as in the undisturbed run.

    restart: the moves of the restart program, whose first lines, so many, are the entry.
    """
    old, new = program.table, restart.table()
    first = entrance.row + (1 if entrance.share else 0)
    own = int(np.searchsorted(new.line, entry_lines + 1))
    count = len(old) - first
    if len(new) - own != count:
        raise _differs(program, min(first, len(old) - 1), "moves")
    begin = restart.table().end[own - 1, :3] if own else np.full(3, np.nan)
    wanted = old.end[entrance.row, :3] if entrance.share else program.begins[entrance.row]
    if not np.allclose(begin, wanted, rtol=0.0, atol=SAME_ENTRY_MM, equal_nan=True):
        raise _differs(program, entrance.row, "begin")
    for name in ("kind", "plane", "turns"):
        _require(program, first, getattr(new, name)[own:] == getattr(old, name)[first:], name)
    for name in ("end", "centre"):
        one, other = getattr(new, name)[own:], getattr(old, name)[first:]
        _require(program, first, np.isclose(one, other, 0.0, SAME_ENTRY_MM, equal_nan=True).all(axis=1), name)
    _require(program, first, np.isclose(new.feed[own:], old.feed[first:], SAME_RESTART_FEED, SAME_RESTART_FEED), "feed")
    _require_states(program, first, restart, own)
    _require_events(program, first, restart, own, entrance)


def _require_states(program: Program, first: int, restart: Toolpath, own: int) -> None:
    pairs = np.stack([program.table.state[first:], restart.table().state[own:]], axis=1)
    kinds, rows = np.unique(pairs, axis=0, return_index=True)
    for (one, other), row in sorted(zip(kinds.tolist(), rows.tolist(), strict=True), key=lambda pair: pair[1]):
        before, after = program.path.states[one], restart.states[other]
        if not _same(before, after):
            raise _differs(program, first + row, _difference(before, after))


def _require_events(program: Program, first: int, restart: Toolpath, own: int, entrance: EntryPoint) -> None:
    """Compare what happens between the moves of the program's own lines."""
    old = [
        (event.index - first, event.kind, event.value, event.text)
        for event in program.path.events
        if event.line >= entrance.first_line
    ]
    shift = int(restart.table().line[own]) - int(program.table.line[first]) if own < len(restart) else 0
    new = [
        (event.index - own, event.kind, event.value, event.text)
        for event in restart.events
        if event.line >= entrance.first_line + shift
    ]
    if old != new:
        raise _differs(program, min(first, len(program.table) - 1), "events")


def _same(old: State, new: State) -> bool:
    """Whether two states are equal but for the entry's rounding of offsets and feeds."""
    if old == new:
        return True
    one, other = (
        [*state.offset_mm, *state.g92_mm, state.tool_length_mm, state.feed_mm_min, state.feed_mm_turn]
        for state in (old, new)
    )
    blank: dict[str, Any] = {
        "offset_mm": ZERO3,
        "g92_mm": ZERO3,
        "tool_length_mm": 0.0,
        "feed_mm_min": 0.0,
        "feed_mm_turn": 0.0,
    }
    near = bool(np.allclose(one, other, rtol=SAME_RESTART_FEED, atol=SAME_ENTRY_MM))
    return near and replace(old, **blank) == replace(new, **blank)


def _difference(old: State, new: State) -> str:
    """Return the name of the first part of the state that differs."""
    return next(name for name in vars(old) if getattr(old, name) != getattr(new, name))


def _require(program: Program, first: int, same: np.ndarray, what: str) -> None:
    if not same.all():
        raise _differs(program, first + int(np.argmin(same)), what)


def _differs(program: Program, row: int, value: str) -> ProgramError:
    """Return the refusal of an entrance after which something is not as it was; value: what."""
    advice = "restart at the begin of its operation, or send the whole program"
    what = "entered here, the program would do something else than when it is run whole"
    return program.refusal("restart-differs", what, row, value=value, advice=advice)


@dataclass(frozen=True)
class Restart:
    """A restart program.

    text: the program. start: from which it is read: the work offsets that hold there, G92 none. file_lines: the line of
    the old file that each of its lines is, 0 for those of the entry. cut: the moves that are taken as done, and the
    lift after them. program, entrance, approach: what it was made from.
    """

    text: str
    start: Start
    file_lines: np.ndarray
    cut: Toolpath
    program: Program
    entrance: EntryPoint
    approach: Approach


def restart(
    text: str,
    where: RequestedPlace,
    dialect: str | Dialect = "grbl",
    start: Start | None = None,
    file: str = "",
    options: Options | None = None,
) -> Restart:
    """Return the restart of a program at a place; raises ProgramError with the reason where it cannot be."""
    return restart_of(read_program(text, dialect, start, file), where, options)


def restart_of(program: Program, where: RequestedPlace, options: Options | None = None) -> Restart:
    """Return the restart of a program that is read already, as `restart` does."""
    options = options or Options()
    wanted = place_of(program, where)
    tool = program.path.states[int(program.table.state[wanted.row])].tool
    overlap_mm = max(options.overlap_mm, options.run_up_mm)
    entrance = entry_point_of(program, wanted, overlap_mm, options.comes_from_edge(tool))
    model = program.model_before(entrance.first_line)
    _check_model(program, entrance, model)
    approach = approach_to(program, entrance, model, options)
    rest = rest_of(program.lines[entrance.first_line - 1 :], model, program.dialect)
    marks = ["%"] * any(map(is_percent_mark, rest))
    lines = marks + EntryWriter(program, entrance, approach, model).lines(len(marks)) + rest
    text, begin = "".join(f"{line}\n" for line in lines), _start(program, model)
    own = len(lines) - len(rest)
    require_same_rest(program, entrance, _read(text, begin, program, entrance), own)
    file_lines = np.r_[np.zeros(own, int), program.file_lines[entrance.first_line - 1 :]]
    return Restart(text, begin, file_lines, cut_before(program, entrance, approach), program, entrance, approach)


def _read(text: str, begin: Start, program: Program, entrance: EntryPoint) -> Toolpath:
    """Return the moves of the restart program; raises ProgramError where it cannot be run alone."""
    try:
        return interpret(text, begin, program.dialect)
    except ProgramError as error:
        what = Text("the program cannot run from here on its own: {error}", error=error.what)
        advice = "restart at another place, or send the whole program"
        raise program.refusal("restart-differs", what, entrance.row, value=error.value, advice=advice) from error


def _start(program: Program, model: Model) -> Start:
    """Return the start of the restart program: work offsets as the program has left them, the place unknown."""
    systems = {name: stored_point(model.parameters, offset_number(name), model.unit_mm)[:3] for name in WORK_SYSTEMS}
    old = program.start
    offsets = {name: offset for name, offset in systems.items() if any(offset) or name in old.work_offsets_mm}
    nowhere = Start().position_mm
    return replace(old, position_mm=nowhere, work_offsets_mm=offsets, g92_mm=ZERO3, tool=0, spindle_rpm=0.0)


def _check_model(program: Program, entrance: EntryPoint, model: Model) -> None:
    """Refuse states that no entry can bring back."""
    if model.diameter or model.state.surface_m_min or model.state.feed_mode == "per_turn":
        what = "turning (G7, G95, G96) is in force here: no entry is written for a lathe"
        raise program.refusal("restart-lathe", what, entrance.row, advice="send the whole program")
    if np.isnan(program.begins[entrance.row, :2]).any():
        what = "the tool's position is unknown here"
        advice = "give the work zero and the position, or choose a place after the next rapid"
        raise program.refusal("restart-place-unknown", what, entrance.row, advice=advice)
