# SPDX-License-Identifier: LGPL-2.1-or-later
"""Executes one block on a copy of the model; what it gives to the table waits until the whole block is good.

words -> Plan (parse.py) -> Execution on a copy -> all good: the copy is the model, the actions are done
                                                -> ProgramError: nothing has changed
"""

from __future__ import annotations

from collections.abc import Callable
from math import isnan
from typing import Any, Protocol

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.acts import ACTS, SET_FEED
from CNCStepper.gcode.codes import AXES, MOTION_NAMES, NO_MOTION, Code
from CNCStepper.gcode.dialects import Dialect
from CNCStepper.gcode.model import Model, Point
from CNCStepper.gcode.moves import Arc, arc_of, end_point, inverse_time_feed, machine_end_point
from CNCStepper.gcode.parse import Plan
from CNCStepper.gcode.words import Comment
from CNCStepper.toolpath import LINE, RAPID, TableBuilder


class Canon(Protocol):
    """Who wants to hear the canonical calls of a program (`trace.py`)."""

    def call(self, text: str) -> None:
        """Hear a call whose arguments are part of its text."""

    def lengths(self, template: str, values: tuple[float, ...], model: Model) -> None:
        """Hear a call whose arguments, the template's fields, are lengths in mm."""

    def move(self, motion: int, end: Point, arc: Arc | None, model: Model) -> None:
        """Hear a move."""


class Execution:
    """One block: `model` is the scratch copy, `actions` what is to be done when all went well."""

    def __init__(self, model: Model, dialect: Dialect, table: TableBuilder, line: int, canon: Canon | None):
        self.model = model
        self.dialect = dialect
        self.table = table
        self.line = line
        self.canon = canon
        self.actions: list[tuple[Callable, tuple]] = []
        self.plan: Plan
        self.values: list[float]
        self.stop_text = ""

    def commit(self) -> None:
        """Do what was put off; afterwards the table names the model's state."""
        for action, arguments in self.actions:
            action(*arguments)
        self.table.set_state(self.model.state)

    def comments(self, comments: tuple[Comment, ...], stops: bool) -> None:
        """Turn comments into events, and operation comments into spans; `stops`: an M0 shows the message itself."""
        spoken = [comment for comment in comments if not comment.to_end]
        if spoken and (spoken[-1].message or spoken[-1].text):
            self.call(f'{"MESSAGE" if spoken[-1].message else "COMMENT"}("{spoken[-1].text}")')
        for comment in comments:
            if comment.message and stops:
                self.stop_text = comment.text.strip()
            elif comment.message:
                self.event("message", text=comment.text.strip())
            elif not self._operation(comment.text.strip()):
                self.event("comment", text=comment.text.strip())

    def block(self, plan: Plan, values: list[float]) -> None:
        """Execute the words in RS274's order."""
        self.plan, self.values = plan, values
        for code in plan.codes:
            if code.group == "motion" and code.motion is not None:
                self._motion(code)
                continue
            changed = self._set(code)
            if changed or not code.silent:
                for call in code.calls:
                    self.call(call)
            if code.act:
                ACTS[code.act](self, code)

    def _set(self, code: Code) -> bool:
        """Set the code's fields of the modal state; whether that changed any."""
        before = self.model.state
        if code.sets:
            self.model.change(**code.sets)
        return self.model.state != before

    # what the table and the trace are told when all went well

    def do(self, action: Callable, *arguments: Any) -> None:
        """Put an action off until the block is committed."""
        self.actions.append((action, arguments))

    def event(self, kind: str, value: float = 0.0, text: str = "") -> None:
        """Add an event to the table."""
        self.do(self.table.set_state, self.model.state)
        self.do(self.table.event, kind, value, text, self.line)

    def call(self, text: str) -> None:
        """Tell a canonical call."""
        if self.canon:
            self.do(self.canon.call, text)

    def lengths(self, template: str, *values: float) -> None:
        """Tell a canonical call whose arguments are lengths in mm."""
        if self.canon:
            self.do(self.canon.lengths, template, values, self.model.copy())

    def told(self, motion: int, end: Point, arc: Arc | None = None) -> None:
        """Tell a move."""
        if self.canon:
            self.do(self.canon.move, motion, end, arc, self.model.copy())

    # words

    def value(self, letter: str) -> float:
        """Return the number of a word that is there."""
        return self.values[self.plan.slots[letter]]

    def whole(self, letter: str, least: int, most: int, code: str = "bad-value") -> int:
        """Return a word's whole number; raises ProgramError when it is none or out of range."""
        value = self.value(letter)
        if value != int(value) or not least <= value <= most:
            what = f"{letter} must be a whole number"
            raise ProgramError(code, what, value=letter, limit=f"{least} to {most}", advice=f"correct {letter}")
        return int(value)

    def not_negative(self, letter: str) -> float:
        """Return a word's number; raises ProgramError when it is below 0."""
        value = self.value(letter)
        if value < 0:
            raise ProgramError("bad-value", f"{letter} may not be negative", value=letter, advice=f"correct {letter}")
        return value

    def known(self, axis: int) -> float:
        """Return the machine position along one axis; raises ProgramError when it is unknown."""
        position = self.model.position[axis]
        if isnan(position):
            what = f"the position along {AXES[axis]} is not known here"
            raise ProgramError("unknown-position", what, value=AXES[axis], advice="move there with G90 first")
        return position

    # motion

    def rapid(self, end: Point, row: bool = True) -> None:
        """Rapid to `end`."""
        if row:
            self.do(self.table.set_state, self.model.state)
            self.do(self.table.rapid, end, self.line)
        self.told(RAPID, end)
        self.model.position = end

    def _motion(self, code: Code) -> None:
        self._set(code)
        motion = self.plan.motion
        self.model.motion = code.motion if code.motion is not None else NO_MOTION
        for call in code.calls:
            self.call(call)
        if motion == NO_MOTION:
            return
        if self.plan.machine:
            end = machine_end_point(self.model, self.plan, self.values, self.dialect)
        else:
            end = end_point(self.model, self.plan, self.values)
        if motion == RAPID:
            self.rapid(end, row=self.plan.moves)
        else:
            self._cut(motion, end)

    def _cut(self, motion: int, end: Point) -> None:
        """A feed move: line or arc."""
        model = self.model
        is_line = motion == LINE
        check_feed(model, motion)
        arc = None if is_line else arc_of(model, self.plan, self.values, end, motion, self.dialect)
        feed = model.state.feed_mm_min
        if not model.plain:
            feed = self._inverse_feed(motion, end, arc)
        if self.plan.moves:
            self.do(self.table.set_state, model.state)
            if arc is None:
                self.do(self.table.feed, end, feed, self.line)
            else:
                self.do(self.table.arc, motion, end, arc.centre, feed, arc.plane, arc.turns, self.line)
        self.told(motion, end, arc)
        model.position = end

    def _inverse_feed(self, motion: int, end: Point, arc: Arc | None) -> float:
        if "F" not in self.plan.slots or self.value("F") <= 0:
            what = f"in inverse time every {MOTION_NAMES[motion]} needs its own F above 0"
            raise ProgramError("no-feed", what, value=MOTION_NAMES[motion], advice="add F, or write G94 before")
        feed = inverse_time_feed(self.value("F"), self.model.position, end, arc, self.model.scale)
        self.lengths(SET_FEED, feed)
        return feed

    def _operation(self, text: str) -> bool:
        """Open or close the span of an operation comment; whether it was one."""
        for mark, opens in (("begin operation:", True), ("finish operation:", False)):
            if text[: len(mark)].lower() == mark:
                return self._open(text[len(mark) :].strip()) if opens else self._close(text[len(mark) :].strip())
        return False

    def _open(self, name: str) -> bool:
        self.model.operations = (*self.model.operations, name)
        self.do(self.table.open_span, "operation", name)
        return True

    def _close(self, name: str) -> bool:
        if self.model.operations[-1:] != (name,):
            return False
        self.model.operations = self.model.operations[:-1]
        self.do(self.table.close_span)
        return True


def check_feed(model: Model, motion: int) -> None:
    """Refuse a feed move while no feed is set."""
    if model.plain and model.state.feed_mm_min <= 0:
        what = f"{MOTION_NAMES[motion]} has no feed"
        raise ProgramError("no-feed", what, value=MOTION_NAMES[motion], advice="write an F word above 0 before")
