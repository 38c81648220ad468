# SPDX-License-Identifier: LGPL-2.1-or-later
"""From program text to the table of moves, whole or a line at a time, from a start state.

A line is parsed into a scratch block, checked whole and then executed: a refused line changes nothing.
"""

from __future__ import annotations

from dataclasses import replace

from CNCStepper.errors import Place, ProgramError
from CNCStepper.gcode.codes import ARC_WORDS, AXES
from CNCStepper.gcode.dialects import Dialect, dialect_named
from CNCStepper.gcode.execute import Canon, Execution, check_feed
from CNCStepper.gcode.model import model_at
from CNCStepper.gcode.moves import arc_of, end_point
from CNCStepper.gcode.parse import PLAIN_NUMBER, Grammar, Plan
from CNCStepper.gcode.words import Comment, Word, is_tape_mark, program_lines, split_line, words_of
from CNCStepper.state import Start
from CNCStepper.toolpath import LINE, RAPID, TableBuilder, Toolpath


def interpret(text: str, start: Start | None = None, dialect: str | Dialect = "grbl", file: str = "") -> Toolpath:
    """Return the table of moves of a whole program, in machine coordinates.

    start: where the machine stands and what it holds; None is a machine whose position and zero are unknown.
    Raises ProgramError naming file, line, column and word.
    """
    interpreter = Interpreter(start, dialect, file)
    for line in program_lines(text):
        interpreter.line(line)
    return interpreter.toolpath()


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
        self.dialect = dialect_named(dialect)
        self.file = file
        self.canon = canon
        self.model = model_at(start, self.dialect)
        self.table = TableBuilder(replace(start, position_mm=self.model.position), self.model.state)
        self.line_number = 0
        self.sequence = ""  # the N word's digits of the line being read
        self._grammar = Grammar(self.dialect)
        self._plans = self._grammar.plans(self.model.motion)
        self._tape = ""  # "", "begun" by "%" or by the first line, "closed" by another "%"
        self._opened_by_mark = False

    @property
    def lacks_mark(self) -> bool:
        """Whether a "%" opened the program and none closed it."""
        return self._opened_by_mark and self._tape != "closed"

    @property
    def ended(self) -> bool:
        """Whether the program has ended: nothing more is read."""
        return self._tape == "closed" or (self.model.ended and self.dialect.stops_at_end)

    def line(self, text: str) -> None:
        """Read the next line; raises ProgramError, and then the line has changed nothing but the line count."""
        self.line_number += 1
        code = text.replace(" ", "").upper()
        plan = self._plans.get(PLAIN_NUMBER.sub("", code))
        if plan is not None and plan.simple and self.model.plain and not self.canon and text.isascii():
            values = list(map(float, PLAIN_NUMBER.findall(code)))
            if len(values) == len(plan.slots) and self._simple(plan, values, text):
                return
        self._any_line(text)

    def toolpath(self) -> Toolpath:
        """End the program and return its table; raises ProgramError when the dialect wants an end and has none."""
        if self.dialect.needs_end and not (self.model.ended or (self._tape == "closed" and self._opened_by_mark)):
            raise ProgramError(
                "no-end",
                "the program has no end",
                advice="write M2 or M30 as its last line",
                place=Place(self.file, self.line_number),
            )
        return self.table.toolpath()

    def _simple(self, plan: Plan, values: list[float], text: str) -> bool:
        """Make the move of a line that holds nothing else; false when it takes the general way."""
        model, motion = self.model, plan.motion
        if self.ended or (plan.number >= 0 and not 0 <= values[plan.number] <= self.dialect.largest_line_number):
            return False
        if plan.feed >= 0 and values[plan.feed] * model.scale != model.state.feed_mm_min:
            return False
        try:
            end = end_point(model, plan, values)
            if motion == RAPID:
                self.table.rapid(end, self.line_number)
            else:
                check_feed(model, motion)
                feed = model.state.feed_mm_min
                if motion == LINE:
                    self.table.feed(end, feed, self.line_number)
                else:
                    arc = arc_of(model, plan, values, end, motion, self.dialect)
                    self.table.arc(motion, end, arc.centre, feed, arc.plane, arc.turns, self.line_number)
        except ProgramError as error:
            raise self._placed(error, words_of(text)) from None
        model.position = end
        if motion != model.motion:
            model.motion = motion
            self._plans = self._grammar.plans(motion)
        return True

    def _any_line(self, text: str) -> None:
        """Read any line, with all that may stand on it."""
        if self.ended:
            self._tape = "closed" if is_tape_mark(text) else self._tape
            return
        if self._tape_mark(text):
            return
        words: list[Word] = []
        try:
            line = split_line(text, self.dialect.strict_comments)
            if line.deleted and self.dialect.skips_deleted:
                return
            words = words_of(line.code)
            plan, values, words = self._grammar.read(line.code, self.model.motion)
            self._number(plan, values, words)
            self._block(plan, values, line.comments)
        except ProgramError as error:
            raise self._placed(error, words) from None
        if words or line.comments:
            self._tape = "begun"

    def _block(self, plan: Plan, values: list[float], comments: tuple[Comment, ...]) -> None:
        """Check and execute one block on a copy of the model, then let the copy be the model."""
        execution = Execution(self.model.copy(), self.dialect, self.table, self.line_number, self.canon)
        execution.comments(comments, stops=any(code.act == "stop" for code in plan.codes))
        execution.block(plan, values)
        self.model = execution.model
        self._plans = self._grammar.plans(self.model.motion)
        execution.commit()

    def _number(self, plan: Plan, values: list[float], words: list[Word]) -> None:
        """Check and keep the N word."""
        self.sequence = next((word.number.partition(".")[0] for word in words if word.letter == "N"), "")
        if plan.number >= 0:
            number = values[plan.number]
            if not 0 <= number <= self.dialect.largest_line_number:
                limit = f"0 to {self.dialect.largest_line_number}"
                raise ProgramError("line-number", "the line number is out of range", value="N", limit=limit)

    def _tape_mark(self, text: str) -> bool:
        """Heed a line that is only "%": the first line opens the program, a later one closes it."""
        if not is_tape_mark(text):
            return False
        if not self._tape:
            self._tape, self._opened_by_mark = "begun", True
        elif self._opened_by_mark or not self.dialect.strict_tape:
            self._tape = "closed"
        else:
            place = Place(self.file, self.line_number, text.index("%") + 1)
            what = "% may stand only on the first and the last line"
            raise ProgramError("misplaced", what, value="%", advice="take it out", place=place)
        return True

    def _placed(self, error: ProgramError, words: list[Word]) -> ProgramError:
        """Return the error with its place, the whole word for its value, and the controller's own answer."""
        column = error.place.column if error.place else 0
        word = _blamed(error.value, words)
        answer = self.dialect.errors.get(error.code)
        answers = f"{self.dialect.title} answers {answer}" if answer else ""
        return ProgramError(
            error.code,
            error.what,
            advice="; ".join(part for part in (error.advice, answers) if part),
            value=word.text if word and column == 0 else error.value,
            limit=error.limit,
            place=Place(self.file, self.line_number, column or (word.column if word else 1)),
        )


def _blamed(name: str, words: list[Word]) -> Word | None:
    """Return the last word called `name`; a modal motion is not on its line, its first coordinate is."""
    named = [word for word in words if name and name in (word.name, word.letter)]
    coordinates = [word for word in words if word.letter in AXES + ARC_WORDS]
    return next(iter(named[-1:] or coordinates[:1] or words[:1]), None)
