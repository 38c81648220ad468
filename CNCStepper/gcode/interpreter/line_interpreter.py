# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads a program a line at a time, from a start state, into the table of moves.

A line is parsed into a scratch block, checked whole and then executed: a refused line changes nothing.

Reads a line whose dialect has a preprocessor: piece by piece, errors with their place in the line as written.

In a language of records each is a block of its own: the records before a refused one have been read.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Generator, Iterable
from dataclasses import replace
from typing import Protocol

from CNCStepper.errors import Place, ProgramError, Text
from CNCStepper.gcode.dialects import Dialect, dialect_named
from CNCStepper.gcode.dialects.codes import MOTION_NAMES, NO_MOTION
from CNCStepper.gcode.dialects.definition import with_axes
from CNCStepper.gcode.dialects.preprocessor import Piece, pieces, reads_moves_directly
from CNCStepper.gcode.interpreter.active_comments import expanded_comment
from CNCStepper.gcode.interpreter.block import NumberedProfile, ProfileReader
from CNCStepper.gcode.interpreter.canonical_output import Canon
from CNCStepper.gcode.interpreter.execute import Execution
from CNCStepper.gcode.interpreter.expression_words import ExpressionWords, is_computed, read_items
from CNCStepper.gcode.interpreter.fast_path import fast_line
from CNCStepper.gcode.interpreter.flow.flow_line_parser import has_profile, leads, names_blocks
from CNCStepper.gcode.interpreter.functions import plasma
from CNCStepper.gcode.interpreter.state.interpreter_state import Model, Point, model_at
from CNCStepper.gcode.interpreter.state.modal_state_stack import leave_level
from CNCStepper.gcode.interpreter.state.system_parameters import SystemParameters
from CNCStepper.gcode.syntax.error_location import located_error
from CNCStepper.gcode.syntax.line_grammar import PLAIN_NUMBER, Grammar, Plan
from CNCStepper.gcode.syntax.words import (
    Comment,
    PercentMarkers,
    Word,
    is_percent_mark,
    packed_wire,
    scanned_codes,
    split_line,
    words_of,
)
from CNCStepper.state import Start
from CNCStepper.toolpath import TableBuilder, Toolpath

_WORD = re.compile(r"[A-Z][ \t]*[+-]?[0-9.]+", re.IGNORECASE)


class Reader(Protocol):
    """The line reader's interface for a preprocessor (`line_interpreter.py`)."""

    dialect: Dialect
    file: str
    line_number: int
    model: Model
    table: TableBuilder

    def forget_motion(self) -> None:
        """Let no motion be modal."""


def read_pieces(reader: Reader, line: str, read: Callable[[str], None]) -> None:
    """Read a line by `read`, which takes text in the form of RS274; raises ProgramError."""
    try:
        found = pieces(line, reader.dialect)
    except ProgramError as error:
        raise error.at(Place(reader.file, reader.line_number, error.place.column if error.place else 0)) from None
    for piece in found:
        try:
            read(piece.text)
        except ProgramError as error:
            raise _in_line(error, piece, line) from None
        if "records" in reader.dialect.front:
            _after_record(reader, piece)


def _in_line(error: ProgramError, piece: Piece, line: str) -> ProgramError:
    """Return the error with its column and its word as the line has them."""
    place = error.place or Place()
    column = piece.column(place.column)
    word = _WORD.match(line, column - 1) if column else None
    value = word[0] if word and error.value[:1] == word[0][0].upper() else error.value
    return ProgramError(
        error.code,
        error.what,
        advice=error.advice,
        value=value,
        limit=error.limit,
        place=Place(place.file, place.line, column),
    )


def _after_record(reader: Reader, piece: Piece) -> None:
    """A motion lasts until the next G or M; in absolute mode an axis without a word stays, with a warning."""
    code = piece.text.partition("(")[0].upper()
    known = [reader.dialect.codes[name] for name in scanned_codes(code) if name in reader.dialect.codes]
    if piece.ends_chunk or (known and all(one.group != "motion" for one in known)):
        reader.forget_motion()
    axes = [axis for axis in "XZ" if axis in code]
    if len(axes) == 1 and reader.model.absolute:
        absent = "XZ".replace(axes[0], "")
        what = Text(
            "{absent} is absent: the axis stays here, but the published control would drive it to 0", absent=absent
        )
        reader.table.event("warning", text=what, line=reader.line_number)


NO_LIMIT = 2**40


class Interpreter:
    """Reads a program line by line; `table` grows, and a stream may `take()` its chunks at any time."""

    def __init__(
        self,
        start: Start | None = None,
        dialect: str | Dialect = "grbl",
        file: str = "",
        canon: Canon | None = None,
    ):
        start = start or Start()
        self.dialect = with_axes(dialect_named(dialect), len(start.position_mm))
        self.file = file
        self.canon = canon
        self.model = model_at(start, self.dialect, bare=canon is not None)
        self.table = TableBuilder(replace(start, position_mm=self.model.position), self.model.state)
        self.line_number = 0
        self.sequence = ""  # the N word's digits of the line being read
        self.grammar = Grammar(self.dialect)
        self._plans = self.grammar.plans(self.model.motion)
        self._keeps_moves = reads_moves_directly(self.dialect)
        self._too_long = self.dialect.line_limit if self.dialect.reads_files else NO_LIMIT
        self.tape = PercentMarkers()
        self.read_profile: ProfileReader | None = None  # the flow control that calls subroutines, if there is one
        self.numbered: NumberedProfile | None = None  # who finds blocks by their N words, if there is one
        self._place: Place | None = None  # of a line whose place differs from `line_number`

    @property
    def ended(self) -> bool:
        """Whether the program has ended: nothing more is read."""
        return self.tape.closed or (self.model.ended and self.dialect.stops_at_end)

    @property
    def runs(self) -> bool:
        """Whether the next lines may be executed as a run (`compiled_reader.py`): in plain modes, and from a place
        that is known where its calls are told."""
        model = self.model
        plain = model.plain and model.motion < NO_MOTION and self._keeps_moves
        known = self.canon is None or all(map(math.isfinite, model.position))
        return plain and known and self.tape.begun and not self.ended

    def leads(self, text: str) -> bool:
        """Whether a line leads elsewhere in this dialect: an O-word, M98 or M99, or a cycle with a profile."""
        branches = self.dialect.o_words and (leads(text) or has_profile(text))
        return branches or (self.dialect.two_block_cycles and names_blocks(text))

    def ran(self, line_number: int, motion: int, position: Point, feed_mm_min: float, told: bool) -> None:
        """Note the end of a run of lines whose rows and states are in the table already; `told`: it had an F."""
        self.line_number = line_number
        self.model.position, self.model.motion = position, motion
        self._plans = self.grammar.plans(motion)
        if told:
            self.model.feed_number = feed_mm_min / self.model.scale
        if feed_mm_min != self.model.state.feed_mm_min:
            self.model.change(feed_mm_min=feed_mm_min)

    def line(self, text: str) -> None:
        """Read the next line; raises ProgramError, and then the line has changed nothing but the line count."""
        self.line_number += 1
        if self.dialect.front and not self.ended:
            read_pieces(self, text, self._line)
        else:
            self._line(text)

    def lines(self, lines: Iterable[str]) -> bool:
        """Read lines up to the first that leads elsewhere; return whether there was none.

        Raises ProgramError at the line that is refused, after all lines before it.
        """
        for line in lines:
            if self.leads(line):
                return False
            self.line(line)
        return True

    def refusals(self, lines: Iterable[str]) -> Generator[ProgramError, None, bool]:
        """Read lines as `lines` does; yield the errors of refused lines, which change nothing, and continue."""
        for line in lines:
            if self.leads(line):
                return False
            try:
                self.line(line)
            except ProgramError as error:
                yield error
        return True

    def forget_motion(self) -> None:
        """Let no motion be modal."""
        self._repeat(NO_MOTION)

    def repeat(self, name: str) -> None:
        """Let a motion be modal, "G0" to "G3", as a machine has it whose earlier lines were not read."""
        self._repeat(MOTION_NAMES.index(name))

    def _repeat(self, motion: int) -> None:
        self.model.motion = motion
        self._plans = self.grammar.plans(motion)

    def _line(self, text: str) -> None:
        """Read a line in the form of RS274."""
        if len(text) >= self._too_long:
            raise self._long_line()
        code = packed_wire(text)
        plan = self._plans.get(PLAIN_NUMBER.sub("", code))
        if plan is not None and plan.simple and self.model.plain and not self.canon and text.isascii():
            values = list(map(float, PLAIN_NUMBER.findall(code)))
            bare = plan.number < 0 or code[1:2].isdigit() or not self.dialect.line_number_first
            if bare and len(values) == len(plan.slots) and self._simple(plan, values, text):
                return
        self._any_line(text)

    # for a program whose lines are not read in their order (`run_with_subroutines.py`)

    def line_at(self, text: str, line_number: int, place: Place) -> None:
        """Read the line at `place`; its moves get `line_number`."""
        self.line_number, self._place = line_number - 1, place
        self.line(text)

    def flow_line(self, sequence: str, line_number: int, place: Place) -> None:
        """Note a line that only leads elsewhere."""
        self.line_number, self._place, self.sequence = line_number, place, sequence
        self.tape.begun = True

    def check_skipped(self, text: str, place: Place) -> None:
        """Refuse what even a line that is skipped may not hold."""
        self._place = place
        if len(text) >= self._too_long:
            raise self._long_line()
        try:
            split_line(text, self.dialect.strict_comments)
        except ProgramError as error:
            raise self._placed(error, []) from None

    def taken_at(self, text: str, place: Place) -> tuple[list[Word], list[float]]:
        """Return the words of a line for execution elsewhere, and the values of all but G and M."""
        self._place = place
        words: list[Word] = []
        try:
            items = self._items(split_line(text, self.dialect.strict_comments).code)
            words = items.words
            self._assign(items)
        except ProgramError as error:
            raise self._placed(error, words) from None
        return items.words, items.values

    def leave_call(self, restore: bool) -> None:
        """End a subroutine: its parameters are the caller's again, and what M73 has kept comes back."""
        execution = Execution(self.model.copy(), self.dialect, self.table, self.line_number, self.canon)
        execution.execute(self.grammar.plan([], self.model.motion), [])
        level = self.model.parameters.level
        self.model.parameters.leave(restore)
        leave_level(execution, level)
        self._keep(execution)

    def rapid_back(self, place: Point) -> None:
        """Rapid to a machine position, as a cycle's end does."""
        execution = Execution(self.model.copy(), self.dialect, self.table, self.line_number, self.canon)
        execution.execute(self.grammar.plan([], self.model.motion), [])
        execution.rapid(place)
        self._keep(execution)

    def toolpath(self) -> Toolpath:
        """End the program and return its table; raises ProgramError when the dialect wants an end and has none."""
        if self.dialect.needs_end and not (self.model.ended or (self.tape.closed and self.tape.opened_by_mark)):
            raise ProgramError(
                "no-end",
                "the program has no end",
                advice="write M2 or M30 as its last line",
                place=Place(self.file, self.line_number),
            )
        return self.table.toolpath()

    def _simple(self, plan: Plan, values: list[float], text: str) -> bool:
        """Make the move of a line that holds nothing else; false when it takes the general way."""
        if self.ended or not fast_line.is_short(self.model, plan, values, self.dialect.largest_line_number):
            return False
        before = self.model.motion
        try:
            fast_line.move(self.model, self.table, plan, values, self.dialect, self.line_number)
        except ProgramError as error:
            raise self._placed(error, words_of(text)) from None
        if plan.motion != before:
            self._plans = self.grammar.plans(plan.motion)
        return True

    def _long_line(self) -> ProgramError:
        limit = f"{self._too_long - 1} characters"
        advice = "write it in two lines, or make the comment shorter"
        what = "the line is too long for the machine"
        return ProgramError("line-too-long", what, limit=limit, advice=advice, place=self._at(self._too_long))

    def _any_line(self, text: str) -> None:
        """Read any line, with all words that it may hold."""
        if self.ended:
            self.tape.closed = self.tape.closed or is_percent_mark(text)
            return
        words: list[Word] = []
        try:
            if self.tape.is_mark(text, self.dialect.strict_percent_markers):
                return
            line = split_line(text, self.dialect.strict_comments)
            if line.deleted and self.dialect.skips_deleted:
                return
            items = self._items(line.code)
            words = items.words
            plan = self.grammar.plan(words, self.model.motion)
            self._number(plan, items.values, words)
            self._block(plan, items, line.comments)
        except ProgramError as error:
            raise self._placed(error, words) from None
        if words or line.comments:
            self.tape.begun = True

    def _items(self, code: str) -> ExpressionWords:
        """Return the words, values and assignments of a line without comments."""
        if self.dialect.expressions and is_computed(code):
            return read_items(code, self._known())
        words = words_of(code)
        return ExpressionWords(words, [float(word.number) for word in words if word.letter not in "GM"], [])

    def _known(self) -> SystemParameters:
        return SystemParameters(self.model, self._place.line if self._place else self.line_number)

    def _block(self, plan: Plan, items: ExpressionWords, comments: tuple[Comment, ...]) -> None:
        """Check and execute one block on a copy of the model, then let the copy be the model."""
        execution = Execution(self.model.copy(), self.dialect, self.table, self.line_number, self.canon)
        execution.read_profile, execution.numbered = self.read_profile, self.numbered
        try:
            self._assign(items)
            if self.model.plasma:
                plasma.note_settings(execution, items.assignments)
                comments = plasma.take_comments(execution, comments)
            execution.comments(self._expanded_comments(comments), stops=any(code.act == "stop" for code in plan.codes))
            execution.execute(plan, items.values)
        except ProgramError:
            self.model.parameters.rollback()
            raise
        self._keep(execution)

    def _keep(self, execution: Execution) -> None:
        """Let what was executed be so."""
        self.model = execution.model
        self.model.parameters.commit()
        self._plans = self.grammar.plans(self.model.motion)
        execution.commit()

    def _assign(self, items: ExpressionWords) -> None:
        """Give parameters their values: only now, so that the words of the line had the old ones."""
        for target, value in items.assignments:
            if isinstance(target, int):
                self.model.parameters.set(target, value)
            else:
                self.model.parameters.set_named(target, value)

    def _expanded_comments(self, comments: tuple[Comment, ...]) -> tuple[Comment, ...]:
        """Return the comments with the values that they speak of."""
        if not self.dialect.expressions:
            return comments
        return tuple(comment._replace(text=expanded_comment(comment, self._known())) for comment in comments)

    def _number(self, plan: Plan, values: list[float], words: list[Word]) -> None:
        """Check and keep the N word."""
        self.sequence = next((word.number.partition(".")[0] for word in words if word.letter == "N"), "")
        if plan.number >= 0:
            number = values[plan.number]
            if self.dialect.line_number_first and not words[0].number[:1].isdigit():
                raise ProgramError("line-number", "a line number begins with a digit", value="N", advice="write N10")
            if not 0 <= number <= self.dialect.largest_line_number:
                limit = f"0 to {self.dialect.largest_line_number}"
                what, advice = "the line number is out of range", "write a number within the limit, or leave N out"
                raise ProgramError("line-number", what, value="N", limit=limit, advice=advice)

    def _placed(self, error: ProgramError, words: list[Word]) -> ProgramError:
        """Return the error of the line being read, with its place and the word that it blames."""
        return located_error(error, words, self.dialect, self._at)

    def _at(self, column: int) -> Place:
        """Return a place in the line being read."""
        if self._place:
            return replace(self._place, column=column)
        return Place(self.file, self.line_number, column)
