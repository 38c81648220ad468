# SPDX-License-Identifier: LGPL-2.1-or-later
"""The program that is to be restarted: its lines in the order of their run, and the moves that they make.

file                      lines as they run        rows of the table
o1 repeat [2]
G1 X[#1] F100        ->   G1 X3 F100          ->   0          a line that is run twice stands there twice,
o1 endrepeat              G1 X6 F100               1          so that each place of the path has a line of its own

The stretches in which a program cuts, and the ways into them.

rapids      .........                            ............
                    :  descent                   :
                     \\   lead-in                 : (lift)
                      \\__,  contour ___________,-'
            |        |                          |
            |        +------ a stretch ---------+       from one rapid to the next, at one state of the spindle
"""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple

import numpy as np

from CNCStepper.errors import Place, ProgramError, Text
from CNCStepper.gcode.dialects import Dialect, dialect_named
from CNCStepper.gcode.interpreter.flow.flow_line_parser import is_plain
from CNCStepper.gcode.interpreter.flow.run_with_subroutines import run_whole
from CNCStepper.gcode.interpreter.flow.subprogram_files import Library
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.gcode.interpreter.line_interpreter import Interpreter
from CNCStepper.gcode.interpreter.motion.arc_lengths import Ways, ways_of
from CNCStepper.gcode.interpreter.state.interpreter_state import Model
from CNCStepper.gcode.syntax.words import program_lines
from CNCStepper.gcode.wire.expansion import expanded
from CNCStepper.gcode.wire.translation import translate
from CNCStepper.job.wire_round_trip import translated_to
from CNCStepper.machine.profile import Machine
from CNCStepper.state import Start
from CNCStepper.tolerances import CLOSED_CONTOUR_MM, SAME_MM
from CNCStepper.toolpath import LINE, PLANE_AXES, RAPID, Chunk, Span, Toolpath, require_straight_axes

RECORDS = "records"  # among the rules of a language whose programs are read by the lathe itself
_COMPENSATION = re.compile(r"G[ \t]*0*4[ \t]*[12]", re.IGNORECASE)


@dataclass(frozen=True)
class Program:
    """A program that runs undisturbed.

    lines: as they run, without loops and subroutines. file_lines: the file's line of each, from 1, int[n]. path: its
    moves in machine coordinates; their lines, from 1, are those of `lines`. is_translated: the lines are those that are
    sent, perhaps several for one of the file.
    """

    dialect: Dialect
    file: str
    start: Start
    lines: list[str]
    file_lines: np.ndarray
    path: Toolpath
    is_translated: bool = False

    @cached_property
    def table(self) -> Chunk:
        """All rows."""
        return self.path.table()

    @cached_property
    def begins(self) -> np.ndarray:
        """Where every row begins, float64[n, 3], machine coordinates."""
        return self.path.begins()[:, :3]

    @cached_property
    def ways(self) -> Ways:
        """Length and angle of every row."""
        return ways_of(self.table, self.begins, self.table.end[:, :3])

    @cached_property
    def feeds(self) -> np.ndarray:
        """Which rows are no rapids, bool[n]."""
        return self.table.kind != RAPID

    @cached_property
    def lengths_mm(self) -> np.ndarray:
        """The length of the tool in force on every row, float64[n]."""
        return np.array([state.tool_length_mm for state in self.path.states], float)[self.table.state]

    @cached_property
    def frame_mm(self) -> np.ndarray:
        """The machine coordinates of the stock's work zero, float64[3]: those of the first row."""
        state = self.path.states[int(self.table.state[0])]
        return np.array(state.offset_mm[:3], float) - (0.0, 0.0, state.tool_length_mm)

    @property
    def operations(self) -> list[Span]:
        """The operations named by its comments, in their order."""
        return sorted((span for span in self.path.spans if span.kind == "operation"), key=lambda span: span.first)

    @cached_property
    def compensated(self) -> np.ndarray:
        """Before which of the lines the tool's radius is compensated (G41, G42), bool[lines]."""
        found = np.zeros(len(self.lines), bool)
        if any(map(_COMPENSATION.search, self.lines)):
            reader = Interpreter(self.start, self.dialect, self.file)
            for number, text in enumerate(self.lines):
                found[number] = reader.model.compensation is not None
                reader.line(text)
        return found

    @cached_property
    def spindle_on(self) -> np.ndarray:
        """On which rows the spindle turns, or the beam is on, bool[n]."""
        return np.array([state.spindle_turns for state in self.path.states], bool)[self.table.state]

    def at(self, row: int, share: float) -> np.ndarray:
        """Return the place after a share of a row, float64[3], machine coordinates."""
        return self.places(np.array([row]), np.array([share]))[0]

    def places(self, rows: np.ndarray, shares: np.ndarray) -> np.ndarray:
        """Return the places after shares of rows, float64[k, 3], machine coordinates."""
        begin, end = self.begins[rows], self.table.end[rows, :3]
        places = begin + (end - begin) * shares[:, None]
        for place in np.flatnonzero(self.table.kind[rows] > LINE).tolist():
            places[place] = self._on_arc(int(rows[place]), float(shares[place]), places[place])
        return places

    def _on_arc(self, row: int, share: float, straight: np.ndarray) -> np.ndarray:
        """Return the place on an arc; `straight`: the same on its chord, whose height is right."""
        first, second, _ = PLANE_AXES[int(self.table.plane[row])]
        centre = self.table.centre[row]
        arms = [complex(*(point - centre)[[first, second]]) for point in (self.begins[row], self.table.end[row, :3])]
        radius = abs(arms[0]) * (1 - share) + abs(arms[1]) * share
        turned = arms[0] / abs(arms[0]) * radius * np.exp(1j * self.ways.sweep_rad[row] * share)
        place = straight.copy()
        place[first], place[second] = centre[first] + turned.real, centre[second] + turned.imag
        return place

    def tips(self, places: np.ndarray, rows: np.ndarray) -> np.ndarray:
        """Return places of rows, float64[k, 3], as those of the tool's tip in the stock's work coordinates."""
        tips = places - self.frame_mm
        tips[:, 2] -= self.lengths_mm[rows]
        return tips

    def file_line(self, row: int) -> int:
        """Return the file's line of a row."""
        return int(self.file_lines[int(self.table.line[row]) - 1])

    def model_before(self, line: int) -> Model:
        """Return what holds before a line is run, counted from 1."""
        reader = Interpreter(self.start, self.dialect, self.file)
        run_whole(reader, "".join(f"{text}\n" for text in self.lines[: line - 1]), Library())
        return reader.model

    def refusal(self, code: str, what: str, row: int, *, value: str = "", limit: str = "", advice: str) -> ProgramError:
        """Return the error that names the file's line of a row."""
        place = Place(self.file, self.file_line(row), 1)
        return ProgramError(code, what, value=value, limit=limit, advice=advice, place=place)


def read_program(text: str, dialect: str | Dialect = "grbl", start: Start | None = None, file: str = "") -> Program:
    """Return a program as it runs from `start`; raises ProgramError for one that cannot be read or restarted."""
    language, start = dialect_named(dialect), start or Start()
    if RECORDS in language.front:
        what = "a program of the mini-lathe begins at the work zero and cannot be entered in its middle"
        advice = "switch the lathe off and on, set its zero by hand, and send the whole program"
        raise ProgramError("restart-lathe", what, advice=advice, place=Place(file))
    if language.front or not language.writing:
        what = Text("a program for {language} cannot be restarted in its middle", language=language.title)
        advice = "restarts are written for grbl, grblHAL, FluidNC, LinuxCNC and Mach: convert it, or run it whole"
        raise ProgramError("restart-dialect", what, advice=advice, place=Place(file))
    if (language.expressions or language.o_words) and not is_plain(text):
        lines, numbers = _written_out(text, language, start, file)
        path = interpret("".join(f"{line}\n" for line in lines), start, language, file)
    else:
        lines = program_lines(text)
        numbers, path = list(range(1, len(lines) + 1)), interpret(text, start, language, file)
    if not len(path):
        raise ProgramError("restart-empty", "the program moves nothing", advice="choose another", place=Place(file))
    return Program(language, file, start, lines, np.array(numbers, int), require_straight_axes(path, file))


def read_on_machine(text: str, machine: Machine, dialect: str, start: Start | None = None, file: str = "") -> Program:
    """Return a program as `read_program` does, of a language that the machine's controller lacks as it is sent to it.

    Such a language may have no words for an entry, as that of the thesis's table: the lines that are sent have.
    file_lines: of the file. Raises ProgramError too where the program cannot be translated.
    """
    language = machine.language(dialect)
    if (target := translated_to(machine, language)) is None:
        return read_program(text, language, start, file)
    wire, path = translate(text, language, target, file, start)
    program = read_program(wire.text, target, path.start, file)
    return replace(program, file_lines=np.asarray(wire.file_lines, int)[program.file_lines - 1], is_translated=True)


def _written_out(text: str, language: Dialect, start: Start, file: str) -> tuple[list[str], list[int]]:
    """Return the lines of a program as they run, and the file's line of each."""
    lines, numbers = [], []
    for block in expanded(text, language, start, file):
        comments = [f"({'MSG,' * one.message}{one.text})" for one in block.comments]
        lines.append(" ".join([*(word.text for word in block.words if word.letter != "N"), *comments]))
        numbers.append(block.line)
    return lines, numbers


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

    A fall on a surface that rises and falls repeatedly is none.
    """
    rows = slice(stretch.first, stretch.last)
    way = program.table.end[rows, :3] - program.begins[rows]
    falls = way[:, 2] < -SAME_MM
    level = np.abs(way[:, 2]) <= SAME_MM
    upright = falls & (np.hypot(way[:, 0], way[:, 1]) <= SAME_MM) & (program.ways.sweep_rad[rows] == 0)
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
    """Return the end of a lead-in from `first` on: the first place that the path visits again; `first` for none."""
    ends = program.table.end[first : stretch.last, :3]
    for row in range(first, min(first + LEAD_ROWS, stretch.last - 1)):
        back = np.abs(ends[row - first :] - program.begins[row]).max(axis=1) <= CLOSED_CONTOUR_MM
        if back.any():
            return row
    return first
