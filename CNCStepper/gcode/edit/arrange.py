# SPDX-License-Identifier: LGPL-2.1-or-later
"""Several programs, each placed and turned on the work surface, as one program; tools are changed as rarely as can be.

    A.nc (T1, T2) ── turned, moved ──► A copy 1: T1 | T2 ─┐
                                       A copy 2: T1 | T2 ─┼─► T1: A1 A2 B1   T2: A1 A2   end
    B.nc (T1)     ── turned, moved ──► B copy 1: T1      ─┘

Each stretch of a copy between two tool changes is a program of its own (split_by_tool.py), moved by transform_verbs.py.
Between two stretches come the modes of a program's start, and the tool goes on at the greatest height of all. The
stretches are operations, so that a restart may begin at each. The whole is read back: its moves are those of the parts.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from CNCStepper.errors import Place, ProgramError, Text
from CNCStepper.gcode.dialects import Dialect, dialect_named
from CNCStepper.gcode.edit import path_transforms
from CNCStepper.gcode.edit.line_states import Source
from CNCStepper.gcode.edit.line_tokens import tokens_of
from CNCStepper.gcode.edit.path_transforms import Map
from CNCStepper.gcode.edit.split_by_tool import ENDS, PAUSES, split
from CNCStepper.gcode.edit.transform_verbs import convert_units, transformed
from CNCStepper.gcode.edit.word_values import number_text
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.gcode.syntax.words import is_percent_mark, program_lines
from CNCStepper.output_files import MADE_BY
from CNCStepper.state import Start
from CNCStepper.tolerances import SAME_ENTRY_MM
from CNCStepper.toolpath import RAPID, Toolpath
from CNCStepper.units import UNIT_MM

OFFSET_CODES = frozenset(("G10", "G52", "G54.1", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3", "G92"))
MACHINE_CODES = frozenset(("G28", "G30", "G53", "G28.1", "G30.1"))
RESET = {"mm": "G21", "inch": "G20"}
MODES = ("G17", "G90", "G91.1", "G94")  # of a program's start, as far as the dialect knows them
SPINDLES = ("off", "cw", "ccw")
PART_TITLE = re.compile(r"\(program \d+ of \d+, tool \d+\)")  # of split_by_tool.py
HEIGHT_DECIMALS = 4
ROUNDED_MM = 0.002  # how far ends written by two ways may be apart: in inches four decimals


@dataclass(frozen=True)
class Copy:
    """A program at a place: turned about its work zero, then moved, mm. name: of its file."""

    name: str
    text: str
    x_mm: float = 0.0
    y_mm: float = 0.0
    rotation_deg: float = 0.0

    @property
    def title(self) -> str:
        """What the operation of the copy is called."""
        turned = f", {self.rotation_deg:g} deg" if self.rotation_deg else ""
        return f"{Path(self.name).name} at X{self.x_mm:g} Y{self.y_mm:g}{turned}"


@dataclass(frozen=True)
class _Stretch:
    """The lines of a copy with one tool, without tool change and end, and what they do when they are read alone."""

    title: str
    tool: int
    change: tuple[str, ...]
    lines: tuple[str, ...]
    path: Toolpath


def arranged(copies: Sequence[Copy], dialect: str | Dialect = "grbl", start: Start | None = None) -> str:
    """Return one program of all copies, in the units of the first one.

    Raises ProgramError for a program that cannot be moved: other work offsets, G92, machine positions, O-words.
    """
    language = dialect_named(dialect)
    if not copies:
        raise ProgramError("arrange-none", "there is no program to arrange", advice="name one")
    units = _units(interpret(copies[0].text, start, language, copies[0].name))
    stretches = [_stretches(copy, language, start, units) for copy in copies]
    ordered = _by_tool(stretches)
    text = _joined(ordered, language, units)
    _verify(text, ordered, language, start)
    return text


def _units(path: Toolpath) -> str:
    """Return the units in force at the first move of a program."""
    return path.states[int(path.table().state[0])].units if len(path) else "mm"


def require_movable(text: str, file: str) -> None:
    """Raise ProgramError for a line that sets or chooses a zero, or names a machine position."""
    for number, line in enumerate(program_lines(text), start=1):
        names = {token.name for token in tokens_of(line, file, number)}
        for codes, what in (
            (OFFSET_CODES, "a program that sets or chooses a work offset cannot be placed beside others"),
            (MACHINE_CODES, "a program that goes to machine positions cannot be placed beside others"),
        ):
            if found := sorted(names & codes):
                advice = "take the line out; the arranged program lies in one work offset"
                place = Place(file, number, 1)
                raise ProgramError("arrange-offset", what, value=found[0], advice=advice, place=place)


def _stretches(copy: Copy, language: Dialect, start: Start | None, units: str) -> list[_Stretch]:
    """Return the stretches of a copy, moved to its place."""
    require_movable(copy.text, copy.name)
    text = convert_units(copy.text, units, language, start, copy.name).text if len(RESET) > 1 else copy.text
    try:
        parts = [part.text for part in split(text, language, start, copy.name)]
    except ProgramError as error:
        if error.code != "split-one":
            raise
        parts = [text]
    where = _map(copy)
    found = []
    for number, part in enumerate(parts):
        moved = transformed(Source(part, language, start, copy.name), where).text
        lines = program_lines(moved)
        change, own = _without_change(
            [line for line in lines if not _is_end(line) and not PART_TITLE.fullmatch(line)], number > 0
        )
        path = interpret(moved, start, language, copy.name)
        tool = path.states[int(path.table().state[-1])].tool if len(path) else 0
        title = copy.title + (f", T{tool}" if tool else "")
        found.append(_Stretch(title, tool, tuple(change), tuple(own), path))
    return found


def _map(copy: Copy) -> Map:
    turned = path_transforms.rotated(copy.rotation_deg)
    return Map(turned.linear, np.array([copy.x_mm, copy.y_mm, 0.0]))


def _is_end(line: str) -> bool:
    """Return whether a line is the percent mark, or ends the program and does nothing else."""
    if is_percent_mark(line):
        return True
    names = {token.name for token in tokens_of(line)}
    return bool(names & ENDS) and names <= ENDS | {"N"}


def _without_change(lines: list[str], later: bool) -> tuple[list[str], list[str]]:
    """Return the lines that change the tool, with the pauses and comments before them, and all others."""
    change = next((n for n, line in enumerate(lines) if any(t.name in ("T", "M6") for t in tokens_of(line))), None)
    if change is None:
        return [], lines
    first = change
    while later and first and lines[first - 1].strip() and {t.name for t in tokens_of(lines[first - 1])} <= PAUSES:
        first -= 1
    last = change
    while last < len(lines) and any(token.name in ("T", "M6") for token in tokens_of(lines[last])):
        if extra := {token.name for token in tokens_of(lines[last])} - PAUSES - {"M6"}:
            what = "a line that changes the tool does more than that"
            raise ProgramError("arrange-tool", what, value=sorted(extra)[0], advice="write it in lines of its own")
        last += 1
    return lines[first:last], lines[:first] + lines[last:]


def _by_tool(copies: Sequence[Sequence[_Stretch]]) -> list[_Stretch]:
    """Return all stretches, those of a copy in their order, with the next tool only when none waits for this one."""
    waiting = [list(stretches) for stretches in copies]
    ordered: list[_Stretch] = []
    while any(waiting):
        tool = next(stretches[0].tool for stretches in waiting if stretches)
        while ready := [stretches for stretches in waiting if stretches and stretches[0].tool == tool]:
            ordered += [stretches.pop(0) for stretches in ready]
    return ordered


def _joined(stretches: Sequence[_Stretch], language: Dialect, units: str) -> str:
    modes = [RESET[units], *(code for code in MODES if code in language.codes)]
    reset = " ".join(code for code in modes if code in language.codes)
    height = _height_line(stretches, units)
    lines, tool = [f"({MADE_BY}: {len(stretches)} stretches arranged)"], -1
    for number, stretch in enumerate(stretches):
        lines.append(f"(begin operation: {_comment(stretch.title)})")
        if number:
            lines += ["M5", reset, *height, *_approach_line(stretch, units)]
        if stretch.tool != tool:
            lines += stretch.change
        lines += stretch.lines
        lines.append(f"(finish operation: {_comment(stretch.title)})")
        tool = stretch.tool
    return "\n".join([*lines, "M5", "M2"]) + "\n"


def _comment(title: str) -> str:
    return title.replace("(", "[").replace(")", "]")


def _height_line(stretches: Sequence[_Stretch], units: str) -> list[str]:
    """Return the rapid to the greatest height of all stretches, [] where none names a height."""
    heights = [_ends(stretch.path)[:, 2] for stretch in stretches]
    known = np.concatenate(heights)
    known = known[np.isfinite(known)]
    if not len(known):
        return []
    return [f"G0 Z{number_text(float(known.max()) / UNIT_MM[units], HEIGHT_DECIMALS)}"]


def _approach_line(stretch: _Stretch, units: str) -> list[str]:
    """Return the rapid to the first known place of a stretch, at the height that is there."""
    places = _ends(stretch.path)[:, :2]
    known = places[np.isfinite(places).all(axis=1)]
    if not len(known):
        return []
    x, y = (number_text(float(value) / UNIT_MM[units], HEIGHT_DECIMALS) for value in known[0])
    return [f"G0 X{x} Y{y}"]


def _ends(path: Toolpath) -> np.ndarray:
    """Return the ends of all rows in work coordinates, float64[n, axes]."""
    return path.table().end - path.offsets_mm()  # type: ignore[no-any-return]


def _verify(text: str, stretches: Sequence[_Stretch], language: Dialect, start: Start | None) -> None:
    """Raise ProgramError unless the cuts of the whole are those of the stretches, row by row."""
    whole = _cuts(interpret(text, start, language))
    wanted = np.concatenate([_cuts(stretch.path) for stretch in stretches])
    if whole.shape != wanted.shape:
        counts = Text("the arranged program has {count} cuts, not {wanted}", count=len(whole), wanted=len(wanted))
        raise ProgramError("arrange-moves", counts, advice="write each program so that it can run on its own")
    off = np.nan_to_num(np.abs(whole - wanted)).max(initial=0.0)
    if off > max(ROUNDED_MM, SAME_ENTRY_MM):
        what = "a cut of the arranged program lies elsewhere, or has another feed, spindle or tool"
        raise ProgramError(
            "arrange-moves", what, value=f"{off:g}", advice="write each program so that it can run on its own"
        )


def _cuts(path: Toolpath) -> np.ndarray:
    """Return kind, feed, spindle, tool and end of all rows but rapids, float64[n, 8]."""
    table = path.table()
    cut = table.kind != RAPID
    rows = [(SPINDLES.index(state.spindle), state.spindle_rpm, state.tool) for state in path.states]
    states = np.array(rows, float).reshape(-1, 3)
    return np.column_stack([table.kind[cut], table.feed[cut], states[table.state[cut]], _ends(path)[cut, :3]])
