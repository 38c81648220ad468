# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plain programs at speed: runs of simple lines go through the kernel, others to the interpreter.

    bytes ──► run_lines ──► columns ──► table        a run: N, G0-G3, X Y Z, I J K R and F, in the modes that stand
                 │ stops before any other line
                 └──► Interpreter.line ──► table     executes or refuses that line; then the kernel continues

What a line of the run may hold is asked of the interpreter's own grammar, once for each shape; modes, offsets and the
dialect's limits are copied from the model before each run.

The kernel that executes runs of plain lines, from bytes straight into columns of the table of moves.

    bytes --read_words--> shape, values --verdicts[motion, shape]--> kind of move --> end, arc --> a row

It knows no grammar, no modes and no errors: which shapes of line may be executed stands in `verdicts`, all else in
`Facts`. Before a line that it does not know, or that it would have to refuse, it stops and has changed nothing.
"""

from __future__ import annotations

import math
import re
from collections.abc import Generator, Iterator

import numpy as np

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.dialects.codes import NO_MOTION
from CNCStepper.gcode.interpreter.canonical_output import Canon
from CNCStepper.gcode.interpreter.fast_path.trace_kernel import PRINTED, ROOM, write_calls
from CNCStepper.gcode.interpreter.line_interpreter import Interpreter
from CNCStepper.gcode.interpreter.motion import arcs
from CNCStepper.gcode.interpreter.motion.arcs import check_arc_words
from CNCStepper.gcode.interpreter.state.interpreter_state import Model
from CNCStepper.gcode.syntax.line_grammar import Grammar, Plan
from CNCStepper.gcode.syntax.word_kernels import (
    LEFT,
    LETTERS,
    N_LATE,
    SHAPES,
    G,
    N,
    after_line_end,
    new_roles,
    read_words,
)
from CNCStepper.gcode.syntax.words import words_of
from CNCStepper.kernels import njit_in_place
from CNCStepper.toolpath import ARC_CW, CHUNK_ROWS, LINE, PLANE_AXES, PLANE_NAMES, RAPID

FARTHEST_MM = 1e16  # whatever a line adds up to beyond is left to the interpreter
MOTIONS = 4  # G0 ... G3 as they may be modal
ALL_SHAPES = (MOTIONS + 1) * SHAPES
UNKNOWN, REFUSED, MOVELESS, FIRST_MOTION = 0, 1, 2, 3  # verdicts; FIRST_MOTION + n makes a move of kind n
FEED, RADIUS, CENTRE = LETTERS.index("F"), LETTERS.index("R"), LETTERS.index("I")

length, centre_by_radius = njit_in_place(arcs.length), njit_in_place(arcs.centre_by_radius)
radii_agree, sweep_rad = njit_in_place(arcs.radii_agree), njit_in_place(arcs.sweep_rad)

FACTS = np.dtype(  # state that the lines of a run cannot change
    [
        ("scale", "f8"),  # mm per unit of the text
        ("absolute", "i8"),  # G90
        ("centres_absolute", "i8"),  # G90.1
        ("plane", "i8"),
        ("first", "i8"),  # the plane's axes
        ("second", "i8"),
        ("normal", "i8"),
        ("slack", "f8"),  # `ArcRule`, in mm
        ("gap", "f8"),
        ("relative", "f8"),
        ("smallest_radius", "f8"),
        ("smallest_angle_rad", "f8"),
        ("radius_slack", "f8"),
        ("largest_number", "f8"),  # of an N word
        ("longest_line", "i8"),
    ]
)
NOW = np.dtype(  # where the run is
    [
        ("at", "i8"),  # byte
        ("line", "i8"),  # lines read
        ("rows", "i8"),  # rows made
        ("room", "i8"),  # rows at most
        ("changes", "i8"),  # feeds set
        ("state", "i8"),  # index of the state in force
        ("motion", "i8"),  # modal
        ("feed", "f8"),  # in force, mm/min
        ("told", "i8"),  # whether an F was read, 0 or 1
        ("words", "i8"),  # shape of the line before which it stopped, -1 where that cannot be said
    ]
)


def _fields(kind: np.dtype) -> np.ndarray:
    return np.zeros(1, kind).view(np.recarray)


def new_facts():
    """Return the memory of the facts, a record."""
    return _fields(FACTS)[0]


def new_now():
    """Return the memory of where a run is, a record."""
    return _fields(NOW)[0]


@njit_in_place
def end_of_move(facts, offset, position, shape, values, target):
    """Write where the axis words lead into `target`; return whether that is known, and within FARTHEST_MM."""
    for axis in range(len(position)):
        target[axis] = position[axis]
    for axis in range(3):
        if shape & (1 << axis):
            if facts.absolute:
                target[axis] = values[axis] * facts.scale + offset[axis]
            else:
                target[axis] += values[axis] * facts.scale
                if not abs(target[axis]) < FARTHEST_MM:  # or not a number
                    return False
    return True


@njit_in_place
def centre_of_arc(facts, offset, position, target, shape, values, clockwise):
    """Return whether the interpreter is sure to take the arc, and its centre along the plane's axes."""
    x0, y0, x1, y1 = position[facts.first], position[facts.second], target[facts.first], target[facts.second]
    if math.isnan(x0 + y0 + x1 + y1 + position[facts.normal] + target[facts.normal]):
        return False, 0.0, 0.0
    if shape & (1 << RADIUS):
        radius, chord = values[RADIUS] * facts.scale, length(x1 - x0, y1 - y0)
        if chord == 0 or chord / 2 - abs(radius) > facts.radius_slack:
            return False, 0.0, 0.0
        x, y = centre_by_radius(x0, y0, x1, y1, radius, clockwise)
    else:
        x, y = x0, y0
        if shape & (1 << (CENTRE + facts.first)):
            x = values[CENTRE + facts.first] * facts.scale + (offset[facts.first] if facts.centres_absolute else x0)
        if shape & (1 << (CENTRE + facts.second)):
            y = values[CENTRE + facts.second] * facts.scale + (offset[facts.second] if facts.centres_absolute else y0)
    return is_good_arc(facts, x0 - x, y0 - y, x1 - x, y1 - y, x0 == x1 and y0 == y1, clockwise), x, y


@njit_in_place
def is_good_arc(facts, x0, y0, x1, y1, whole, clockwise):
    """Whether the radius vectors of an arc's ends pass the dialect's rule; what hangs by a hair is left."""
    radius, at_end = length(x0, y0), length(x1, y1)
    if min(radius, at_end) < facts.smallest_radius:
        return False
    if not radii_agree(radius, at_end, facts.slack, facts.gap, facts.relative):
        return False
    if whole or facts.smallest_angle_rad == 0:
        return True
    swept = sweep_rad(x0, y0, x1, y1, clockwise)
    return min(swept, arcs.FULL_TURN - swept) > 1.001 * facts.smallest_angle_rad


@njit_in_place
def run_lines(data, now, facts, offset, position, target, roles, verdicts, values, feeds, columns):
    """Execute lines from `now.at` on until one must be left, or `now.room` rows are made or `feeds` is full.

    data: uint8, whole lines. position: float64[axes], mm, changed. target, values: memory, float64[axes] and [G].
    feeds: each new feed, mm/min. columns: kind, end, centre, plane, turns, feed, state and line as in
    `toolpath.Chunk`; the rows of `centre`, `plane` and `turns` are 0.
    """
    kind, ends, centres, planes, turns, row_feed, row_state, row_line = columns
    end, now.words = len(data), -1
    while now.at < end and now.rows < now.room and now.changes < len(feeds):
        shape, at = read_words(data, now.at, end, roles, values)
        if at == LEFT or at - now.at >= facts.longest_line:
            return
        verdict = verdicts[now.motion, shape]
        if verdict < MOVELESS:
            now.words = shape
            return
        feed = now.feed
        if shape & (1 << FEED):
            feed = values[FEED] * facts.scale
            if math.copysign(1.0, feed) < 0:
                return
        if shape & (1 << N) and not 0 <= values[N] <= facts.largest_number:
            return
        if verdict >= FIRST_MOTION:
            motion, row = verdict - FIRST_MOTION, now.rows
            if not end_of_move(facts, offset, position, shape, values, target) or (motion != RAPID and feed <= 0):
                return
            if motion > LINE:
                good, x, y = centre_of_arc(facts, offset, position, target, shape, values, motion == ARC_CW)
                if not good:
                    return
                centres[row, facts.first], centres[row, facts.second] = x, y
                centres[row, facts.normal] = position[facts.normal]
                planes[row], turns[row] = facts.plane, 1
            kind[row], row_feed[row] = motion, 0.0 if motion == RAPID else feed
            row_state[row] = now.state + (feed != now.feed)
            row_line[row] = now.line + 1
            for axis in range(len(position)):
                ends[row, axis] = position[axis] = target[axis]
            now.rows, now.motion = row + 1, motion
        if feed != now.feed:
            feeds[now.changes] = now.feed = feed
            now.changes += 1
            now.state += 1
        if shape & (1 << FEED):
            now.told = 1
        now.line += 1
        now.at = after_line_end(data, at, end)


NO_LIMIT = 2**40
MOST_FEEDS = CHUNK_ROWS  # set in one run, before the table gets them
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
        self._printed, self._text = _fields(PRINTED)[0], np.empty(ROOM if interpreter.canon else 0, np.uint8)
        self._columns = _new_columns(interpreter.table.axes)
        self._idle = self._skipped = 0

    def read(self, data: bytes, encoding: str = "utf-8") -> bool:
        """Read `data`, whole lines, up to the first line that leads elsewhere; return whether there was none.

        Raises ProgramError at the line that is refused, after all lines before it.
        """
        return self.interpreter.lines(self._others(data, encoding))

    def refused(self, data: bytes, encoding: str = "utf-8") -> Generator[ProgramError, None, bool]:
        """Read `data` as `read` does; yield the errors of refused lines, which change nothing, and continue."""
        return (yield from self.interpreter.refusals(self._others(data, encoding)))

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
            self._printed.at, self._printed.line = now.at, now.line
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
            if reader.canon:
                self._print(reader.canon, view, offset)
            self._hand_over()
            if not (full or self._verdicts.learned(model, int(now.motion), int(now.words))):
                break
        self._idle = 0 if now.line > reader.line_number else min(2 * self._idle + 1, MOST_SKIPPED)
        self._skipped = 0
        reader.ran(int(now.line), int(now.motion), tuple(position.tolist()), float(now.feed), bool(now.told))
        return int(now.at)

    def _begin(self, at: int) -> np.recarray:
        """Copy the model's state for the kernel; return the record of the run."""
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

    def _print(self, canon: Canon, view: np.ndarray, offset: np.ndarray) -> None:
        """Tell the canonical calls of the lines that the kernel has just executed."""
        now, printed, (kind, ends, centres, *_, row_line) = self._now, self._printed, self._columns
        printed.row, printed.count = 0, canon.count
        tail = np.frombuffer(canon.end_of_move(self.interpreter.model).encode() + b"\n", np.uint8)
        columns = kind, ends, centres, row_line
        while printed.at < now.at:
            printed.written = 0
            write_calls(
                view,
                int(now.at),
                printed,
                int(now.rows),
                self._facts,
                offset,
                self._roles,
                self._values,
                columns,
                tail,
                self._text,
            )
            canon.calls(self._text[: printed.written].tobytes().decode("ascii"), int(printed.count))

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
    """The grammar's verdict on each shape of line, filled at the shape's first line: uint8[motion, shape]."""

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
