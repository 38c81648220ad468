# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plain programs at speed: runs of simple lines go through the kernel of `line_run_kernel`, others to the interpreter.

    bytes ──► run_lines ──► columns ──► table        a run: N, G0-G3, X Y Z, I J K R and F, in the modes that stand
                 │ stops before any other line
                 └──► Interpreter.line ──► table     executes or refuses that line; then the kernel goes on

What a line of the run may hold is asked of the interpreter's own grammar, once for each shape; modes, offsets and the
dialect's limits are copied from the model before each run.
"""

from __future__ import annotations

import re
from collections.abc import Generator, Iterator

import numpy as np

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.dialects.codes import NO_MOTION
from CNCStepper.gcode.interpreter.fast_path.line_run_kernel import (
    ALL_SHAPES,
    FIRST_MOTION,
    MOTIONS,
    MOVELESS,
    REFUSED,
    UNKNOWN,
    new_facts,
    new_now,
    run_lines,
)
from CNCStepper.gcode.interpreter.line_interpreter import Interpreter
from CNCStepper.gcode.interpreter.motion.moves import check_arc_words
from CNCStepper.gcode.interpreter.state.model import Model
from CNCStepper.gcode.syntax.line_grammar import Grammar, Plan
from CNCStepper.gcode.syntax.word_kernels import LETTERS, N_LATE, SHAPES, G, after_line_end, new_roles
from CNCStepper.gcode.syntax.words import words_of
from CNCStepper.toolpath import CHUNK_ROWS, LINE, PLANE_AXES, PLANE_NAMES

NO_LIMIT = 2**40
MOST_FEEDS = CHUNK_ROWS  # set in one run, before the table is told
MOST_SKIPPED = 63  # lines that are not offered to the kernel after it took none
_LINE_END = re.compile(rb"[\r\n]")
_TURNS = 4  # place among the columns; centre, plane and turns stand side by side


class CompiledReader:
    """Reads whole lines of a program into an interpreter's table, as `Interpreter.line` would one after the other."""

    def __init__(self, interpreter: Interpreter):
        self.interpreter = interpreter
        self._verdicts = _Verdicts(interpreter.grammar)
        self._roles = new_roles()
        self._now, self._facts = new_now(), new_facts()
        self._values, self._feeds = np.empty(G), np.empty(MOST_FEEDS)
        self._columns = _new_columns(interpreter.table.axes)
        self._idle = self._skipped = 0

    def read(self, data: bytes, encoding: str = "utf-8") -> bool:
        """Read `data`, whole lines, up to the first line that leads elsewhere; return whether there was none.

        Raises ProgramError at the line that is refused, after all lines before it.
        """
        for line in self._others(data, encoding):
            if self.interpreter.leads(line):
                return False
            self.interpreter.line(line)
        return True

    def refused(self, data: bytes, encoding: str = "utf-8") -> Generator[ProgramError, None, bool]:
        """Read `data` as `read` does; yield why lines are refused, which change nothing, and go on after them."""
        for line in self._others(data, encoding):
            if self.interpreter.leads(line):
                return False
            try:
                self.interpreter.line(line)
            except ProgramError as error:
                yield error
        return True

    def _others(self, data: bytes, encoding: str) -> Iterator[str]:
        """Let the kernel execute its runs, and yield each line between them, which is to be read before going on."""
        view, at = np.frombuffer(data, np.uint8), 0
        while at < len(data):
            at = self._run(view, at)
            if at < len(data):
                found = _LINE_END.search(data, at)
                end = found.start() if found else len(data)
                yield data[at:end].decode(encoding, "surrogatepass")
                at = after_line_end(view, end, len(data))

    def _run(self, view: np.ndarray, at: int) -> int:
        """Let the kernel execute lines from byte `at` on; return where it left off."""
        reader = self.interpreter
        if not reader.runs:
            return at
        if self._skipped < self._idle:
            self._skipped += 1
            return at
        now, model, position = self._begin(at), reader.model, np.array(reader.model.position)
        target = position.copy()
        verdicts = self._verdicts.table(model)
        offset = np.array(model.offset)
        while now.at < len(view):
            run_lines(
                view,
                now,
                self._facts,
                offset,
                position,
                target,
                self._roles,
                verdicts,
                self._values,
                self._feeds,
                self._columns,
            )
            full = now.rows == now.room or now.changes == MOST_FEEDS
            self._hand_over()
            if not (full or self._verdicts.learned(model, int(now.motion), int(now.words))):
                break
        self._idle = 0 if now.line > reader.line_number else min(2 * self._idle + 1, MOST_SKIPPED)
        self._skipped = 0
        reader.ran(int(now.line), int(now.motion), tuple(position.tolist()), float(now.feed), bool(now.told))
        return int(now.at)

    def _begin(self, at: int) -> np.recarray:
        """Note where the model stands, for the kernel; return the record of the run."""
        reader, facts, now = self.interpreter, self._facts, self._now
        model, dialect = reader.model, reader.dialect
        state = model.state
        facts.scale, facts.absolute = model.scale, model.absolute
        facts.centres_absolute = state.arc_centres == "absolute"
        facts.plane = PLANE_NAMES.index(state.plane)
        facts.first, facts.second, facts.normal = PLANE_AXES[facts.plane]
        rule = dialect.arc_rules[state.units].limits(model.scale)
        facts.slack, facts.gap, facts.relative = rule.slack, rule.gap, rule.relative
        facts.smallest_radius, facts.radius_slack = rule.smallest_radius, rule.radius_slack
        facts.smallest_angle_rad = rule.smallest_angle_rad
        facts.largest_number = dialect.largest_line_number
        facts.longest_line = (dialect.line_limit or NO_LIMIT) - 1
        now.at, now.line, now.motion, now.feed, now.told = at, reader.line_number, model.motion, state.feed_mm_min, 0
        now.rows, now.room, now.changes, now.state = 0, reader.table.room, 0, len(reader.table.states) - 1
        return now

    def _hand_over(self) -> None:
        """Give the table the rows of the run and the states that its F words have made."""
        now, table = self._now, self.interpreter.table
        rows = int(now.rows)
        if now.changes:
            table.states.append_feeds(self.interpreter.model.state, self._feeds[: now.changes].copy())
        if rows == CHUNK_ROWS:
            table.extend(self._columns)
            self._columns = _new_columns(table.axes)
        elif rows:
            table.extend(tuple(column[:rows].copy() for column in self._columns))
            if self._columns[_TURNS][:rows].any():
                for column in self._columns[2 : _TURNS + 1]:
                    column[:rows] = 0
        now.rows, now.changes, now.room = 0, 0, table.room


def _new_columns(axes: int) -> tuple[np.ndarray, ...]:
    """Return the columns of a whole chunk; what arcs alone use is zero, and takes no memory until an arc comes."""
    rows = CHUNK_ROWS
    return (
        np.empty(rows, np.uint8),
        np.empty((rows, axes)),
        np.zeros((rows, 3)),
        np.zeros(rows, np.uint8),
        np.zeros(rows, np.uint16),
        np.empty(rows),
        np.empty(rows, np.int32),
        np.empty(rows, np.int32),
    )


class _Verdicts:
    """What the grammar says of each shape of line, asked when a shape is first met: uint8[motion, shape]."""

    def __init__(self, grammar: Grammar):
        self._grammar = grammar
        self._tables: dict[tuple[str, str], np.ndarray] = {}

    def table(self, model: Model) -> np.ndarray:
        """Return the verdicts that hold in the model's plane and mode of arc centres."""
        key = model.state.plane, model.state.arc_centres
        if key not in self._tables:
            self._tables[key] = np.full((MOTIONS, ALL_SHAPES), UNKNOWN, np.uint8)
        return self._tables[key]

    def learned(self, model: Model, motion: int, shape: int) -> bool:
        """Ask the grammar for the verdict of a shape (-1 is none); return whether lines of it can now be executed."""
        table = self.table(model)
        if shape < 0 or table[motion, shape] != UNKNOWN:
            return False
        table[motion, shape] = self._verdict(model, motion, shape)
        return bool(table[motion, shape] != REFUSED)

    def _verdict(self, model: Model, motion: int, shape: int) -> int:
        try:
            plan = self._grammar.plan(words_of(_line_of(shape)), motion)
            if plan.simple and plan.motion > LINE:
                check_arc_words(plan, model, self._grammar.dialect)
        except ProgramError:
            return REFUSED
        if plan.simple:
            return FIRST_MOTION + plan.motion
        return MOVELESS if _only_feeds(plan) else REFUSED


def _line_of(shape: int) -> str:
    """Return a line of this shape."""
    explicit, mask = divmod(shape, SHAPES)
    words = [f"{letter}1" for place, letter in enumerate(LETTERS) if letter != "N" and mask >> place & 1]
    words = [f"G{explicit - 1}"] * (explicit > 0) + words
    number = ["N1"] * (mask >> LETTERS.index("N") & 1)
    return "".join(words + number if mask & N_LATE else number + words)


def _only_feeds(plan: Plan) -> bool:
    """Whether a line does nothing but set the feed, if that."""
    return plan.motion == NO_MOTION and not plan.moves and all(code.name == "F" for code in plan.codes)
