# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a program in one dialect to the same moves in another, with notes of what had to be expanded.

text --interpreter of the one--> table --writer of the other--> text --interpreter of the other--> table
                                   '---- the same work: ways, feeds, switches (program_equivalence.py) -----'
"""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from math import isnan
from typing import Any

import numpy as np

from CNCStepper.errors import Place, ProgramError, Text
from CNCStepper.gcode.conversion.program_equivalence import require_same_work
from CNCStepper.gcode.dialects import Dialect, dialect_named
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.gcode.syntax.words import program_lines, scanned_codes, scanned_words, split_line
from CNCStepper.gcode.writer.write import written
from CNCStepper.gcode.writer.write_options import Note, WriteOptions
from CNCStepper.state import Start, State, ToolEntry
from CNCStepper.toolpath import Toolpath

_STATES: tuple[tuple[Callable[[State], bool], str, str], ...] = (
    (lambda state: state.distance == "incremental", "G91", "incremental coordinates became absolute"),
    (lambda state: state.feed_mode == "inverse_time", "G93", "feeds of inverse time became feeds a minute"),
    (
        lambda state: state.feed_mode == "per_turn",
        "G95",
        "feeds a turn became feeds a minute, at the speed that S asks for",
    ),
    (lambda state: state.rotation_deg != 0, "G10", "the turn of the work system went into the coordinates"),
    (lambda state: state.surface_m_min > 0, "G96", "constant surface speed became a speed a move"),
    (
        lambda state: state.path_mode == "blend",
        "G64",
        "left out: G64, the exact path is followed as far as the machine does",
    ),
    (lambda state: state.path_mode == "exact_stop", "G61.1", "left out: G61.1, the machine may round the corners"),
)
_SAID = (
    ({"G41", "G42", "G41.1", "G42.1"}, "the path contains the tool's radius and is right for this tool only"),
    ({"G28", "G30", "G53"}, "places of the machine became those of the work, right for this work zero only"),
    ({"G74", "G84"}, "tapping became plain moves: the feed may be overridden, and nothing keeps it to the spindle"),
)
_STOPS = ("pause", "optional_pause", "tool_change")
_AFTER_STOPS = (
    "after a stop the first move names all its axes, on one straight way: let the machine stand above the work"
)
_BEGIN = "the program begins with the tool at the work zero: bring it there before this one is sent"
_ROTARY = re.compile(r"(?<![#<A-Z_])([ABC])(?=[-+.\d])", re.IGNORECASE)
STAGES = ("read", "write", "compare")  # the stages that `tell` is called with, in this order


@dataclass(frozen=True)
class Converted:
    """text: the program in the other dialect. notes: what was expanded or left out. toolpath: the moves of both."""

    text: str
    notes: tuple[Note, ...]
    toolpath: Toolpath


def convert(
    text: str,
    source: str | Dialect,
    target: str | Dialect,
    start: Start | None = None,
    file: str = "",
    tell: Callable[[str], None] = lambda stage: None,
    share: Callable[[float], None] = lambda share: None,
    **choices: Any,
) -> Converted:
    """Return a program of the dialect `source` in the dialect `target`.

    The program keeps its units, its work offsets and its moves, and tools are changed by M6 where the target has it.
    choices: fields of `WriteOptions` that are to be otherwise; with tool_length "touch_off" the lengths of tools need
    not be known. tell: called with the stage that begins, one of STAGES;
    share: with the share of it that is done. Raises ProgramError for what the target cannot express.
    """
    language, unknown = dialect_named(target), set[int]()
    if choices.get("tool_length") == "touch_off":  # lengths are left out, so that nobody need know them
        unknown = _tools_named(text) - set((start or Start()).tools)
        start = replace(start or Start(), tools=(start or Start()).tools | {tool: ToolEntry(tool) for tool in unknown})
    tell("read")
    path = interpret(text, start, source, file, share)
    options = replace(default_options(path, language), **choices)
    tell("write")
    try:
        made = written(path, language, options, share)
    except ProgramError as error:
        raise error.at(Place(file, error.place.line if error.place else 0)) from error
    tell("compare")
    again = interpret(made.text, path.start, language, progress=share)  # from where the source takes itself to begin
    require_same_work(path, again, options, language, file)
    codes, read = _lines_of_codes(text), dialect_named(source)
    notes = (
        *_begin(read, start),
        *_notes(path, codes, language),
        *_said(codes, read),
        *_touched_off(codes, unknown),
        *_axes_left_out(text, codes, language),
        *made.notes,
    )
    return Converted(made.text, notes, path)


def default_options(path: Toolpath, target: Dialect) -> WriteOptions:
    """Return the options that keep a program as it is, as far as the target can."""
    writing = target.writing
    if writing is None:
        return WriteOptions()
    units = path.states[int(path.table().state[-1])].units if len(path) else "mm"
    change = next((way for way in ("m6", "pause") if way in writing.tool_change), "split")
    kept = units if units in writing.units else next(iter(writing.units))
    return WriteOptions(units=kept, work_offset="", tool_change=change, retract=False)  # type: ignore[arg-type]


def _begin(source: Dialect, start: Start | None) -> Iterator[Note]:
    """Yield places where the source assumes a tool position that no line has set."""
    if source.starts_at_work_zero and isnan((start or Start()).position_mm[0]):
        yield Note(_BEGIN, 1, 1)


def _notes(path: Toolpath, codes: dict[str, list[int]], target: Dialect) -> Iterator[Note]:
    """Yield notes on expansions by the interpreter, and its warnings."""
    lines, canned = path.table().line, target.writing.canned if target.writing else ()
    cycles = [
        span for span in path.spans if span.kind == "cycle" and span.name not in canned and span.last > span.first
    ]
    for name in dict.fromkeys(span.name for span in cycles):
        own = [span for span in cycles if span.name == name]
        yield Note(Text("{name} became plain moves", name=name), len(own), int(lines[own[0].first]))
    if (lines[1:] < lines[:-1]).any():
        yield Note("subroutines and loops were written out", 1)
    for event in path.events:
        if event.kind == "warning":
            yield Note(event.text, 1, event.line)
    stops = [event.line for event in path.events if event.kind in _STOPS and event.index < len(path)]
    if stops:
        yield Note(_AFTER_STOPS, len(stops), stops[0])
    yield from _notes_of_states(path, codes)


def _tools_named(text: str) -> set[int]:
    """Return the numbers of the tools and lengths (T, H) that a program names."""
    words = (word for line in program_lines(text) for word in scanned_words(split_line(line).code))
    return {int(number) for letter, number in words if letter in "TH" and number.isdigit()}


def _touched_off(codes: dict[str, list[int]], unknown: set[int]) -> Iterator[Note]:
    """Yield that lengths which nobody has said are the operator's."""
    if lines := codes.get("G43") if unknown else None:
        yield Note("left out: the lengths of tools; set the Z zero with each tool", len(lines), lines[0])


def _axes_left_out(text: str, codes: dict[str, list[int]], target: Dialect) -> Iterator[Note]:
    """Yield the rotary axes that the target lacks: they never move, or the program would not have been written."""
    found: dict[str, list[int]] = {}
    threads = set(codes.get("G76", ()))  # whose words have other meanings
    for number, line in enumerate(program_lines(text), start=1):
        for letter in _ROTARY.findall("".join(split_line(line).code.split())) if number not in threads else ():
            found.setdefault(letter.upper(), []).append(number)
    for letter, lines in sorted(found.items()):
        if letter not in target.letters:
            yield Note(
                Text("left out: {letter}, which never moves; that axis stands at 0", letter=letter),
                len(lines),
                lines[0],
            )


def _notes_of_states(path: Toolpath, codes: dict[str, list[int]]) -> Iterator[Note]:
    """Yield what each stretch of rows with a mode of `_STATES` became, with the line of its code."""
    told: dict[tuple, list[bool]] = {}
    marks = np.array([told.get(key) or told.setdefault(key, _told(state)) for key, state in _by_modes(path.states)])
    table = path.table()
    for number, (_, code, what) in enumerate(_STATES):
        rows = marks[:, number][table.state]
        begins = np.flatnonzero(rows & ~np.append(False, rows[:-1]))
        if len(begins):
            yield Note(what, len(begins), _last_before(codes.get(code, []), int(table.line[begins[0]])))


def _last_before(lines: list[int], move: int) -> int:
    """Return the last of the lines that is none after a move's, the move's own where there is none."""
    place = bisect_right(lines, move)
    return lines[place - 1] if place else move


def _by_modes(states: Iterable[State]) -> Iterator[tuple[tuple, State]]:
    """Yield every state with its `_STATES` fields: a program of many feeds has as many states."""
    for state in states:
        turned, by_surface = state.rotation_deg != 0, state.surface_m_min > 0
        yield (state.distance, state.feed_mode, turned, by_surface, state.path_mode), state


def _told(state: State) -> list[bool]:
    return [applies(state) for applies, *_ in _STATES]


def _lines_of_codes(text: str) -> dict[str, list[int]]:
    """Return the lines of each G code, and as "/" those that a switch may delete."""
    found: dict[str, list[int]] = {}
    for number, line in enumerate(program_lines(text), start=1):
        split = split_line(line)
        names = {name for name in scanned_codes(split.code) if name.startswith("G")}
        for name in names | {"/"} if split.deleted else names:
            found.setdefault(name, []).append(number)
    return found


def _said(codes: dict[str, list[int]], source: Dialect) -> Iterator[Note]:
    """Yield facts that only the text has: codes that the table has as moves alone, and switches at the machine."""
    deleted = Text(
        "lines with / are {word}: no switch deletes them any more",
        word="left out" if source.skips_deleted else "cut always",
    )
    notes = []
    for names, what in (*_SAID, ({"/"}, deleted)):
        lines = sorted({line for name in names for line in codes.get(name, ())})
        notes += [Note(what, len(lines), lines[0])] if lines else []
    yield from sorted(notes, key=lambda note: note.line)
