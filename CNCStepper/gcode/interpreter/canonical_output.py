# SPDX-License-Identifier: LGPL-2.1-or-later
"""Canonical output of a block to the table and the trace, committed when the whole block is valid.

event, call, comments ──► moves held back by compensation?  yes ──► waits among them (move_queue.py)
                                                             no ──► actions ──commit──► table, canon
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, Protocol

from CNCStepper.gcode.interpreter.active_comments import canonical_call
from CNCStepper.gcode.interpreter.cutter_compensation.compensation_state import QueuedMove
from CNCStepper.gcode.interpreter.motion.arcs import Arc
from CNCStepper.gcode.interpreter.state.interpreter_state import Model
from CNCStepper.gcode.interpreter.state.parameters import length_scale
from CNCStepper.gcode.syntax.words import Comment
from CNCStepper.toolpath import RAPID, TableBuilder

HELD_CALLS = (
    "COMMENT",
    "SET_FEED",
    "DWELL",
    "MIST",
    "FLOOD",
    "START_SPINDLE",
    "STOP_SPINDLE",
    "SET_SPINDLE",
    "ORIENT",
    "SPINDLE",
)  # that are delayed with compensated moves; all others are emitted at once
SET_FEED = "SET_FEED_RATE({})"


class Canon(Protocol):
    """A receiver of the canonical calls of a program (`canonical_trace.py`); `count`: how many it has numbered."""

    count: int

    def call(self, text: str) -> None:
        """Hear a call whose arguments are part of its text."""

    def printed(self, text: str) -> None:
        """Hear what (PRINT, ...) prints."""

    def lengths(self, template: str, values: tuple[float, ...], model: Model) -> None:
        """Hear a call whose arguments, the template's fields, are lengths in mm."""

    def move(self, motion: int, end: tuple[float, ...], arc: Arc | None, model: Model) -> None:
        """Hear a move to `end`, of three or nine axes."""

    def end_of_move(self, model: Model) -> str:
        """Return what the text of each move ends with while no axis but X, Y and Z moves."""

    def calls(self, text: str, count: int) -> None:
        """Hear whole lines of text with the calls of a run, the last of which has the number `count`."""


class CanonicalBlock:
    """A block on the scratch copy `model`; `actions` are executed after the whole block is accepted."""

    def __init__(self, model: Model, table: TableBuilder, line: int, canon: Canon | None):
        self.model = model
        self.table = table
        self.line = line
        self.canon = canon
        self.actions: list[tuple[Callable, tuple]] = []
        self.stop_text = ""

    def commit(self) -> None:
        """Do what was put off; afterwards the table names the model's state."""
        for action, arguments in self.actions:
            action(*arguments)
        self.table.set_state(self.model.state)

    def do(self, action: Callable, *arguments: Any) -> None:
        """Put an action off until the block is committed."""
        self.actions.append((action, arguments))

    def event(self, kind: str, value: float = 0.0, text: str = "") -> None:
        """Add an event to the table, after the moves that wait."""
        self._note(self.table.set_state, self.model.state)
        self._note(self.table.event, kind, value, text, self.line)

    def call(self, text: str) -> None:
        """Tell a canonical call."""
        if self.canon:
            waits = text.startswith(HELD_CALLS) and "Lathe" not in text
            (self._note if waits else self.do)(self.canon.call, text)

    def do_print(self, text: str) -> None:
        """Tell a line that the interpreter prints for itself."""
        if self.canon:
            self.do(self.canon.printed, text)

    def lengths(self, template: str, *values: float) -> None:
        """Tell a canonical call whose arguments are lengths in mm."""
        if self.canon:
            waits = template.startswith(HELD_CALLS)
            (self._note if waits else self.do)(self.canon.lengths, template, values, self.model.copy())

    def point(self, template: str, values: Sequence[float]) -> None:
        """Tell a canonical call whose arguments are the first axes of a point, mm and degrees."""
        scale = self.model.scale
        count = template.count("{}")
        numbers = [f"{value / length_scale(axis, scale):.4f}" for axis, value in enumerate(values[:count])]
        self.call(template.format(*numbers))

    def _note(self, action: Callable, *arguments: Any) -> None:
        """Do something after the moves that compensation holds back."""
        ours = self.model.compensation
        if ours and ours.held:
            note = QueuedMove(RAPID, (0.0, 0.0, 0.0), 0j, 0.0, note=(action, arguments))
            self.model.compensation = ours._replace(held=(*ours.held, note))
        else:
            self.do(action, *arguments)

    def comments(self, comments: tuple[Comment, ...], stops: bool) -> None:
        """Turn comments into events, and operation comments into spans; `stops`: an M0 shows the message itself."""
        spoken = [comment for comment in comments if not comment.to_end]
        if spoken and spoken[-1].kind == "print":
            self.do_print(spoken[-1].text)
        elif spoken:
            self.call(canonical_call(spoken[-1]))
        for comment in comments:
            if comment.message and stops:
                self.stop_text = comment.text.strip()
            elif comment.message:
                self.event("message", text=comment.text.strip())
            elif not self._operation(comment.text.strip()):
                self.event("comment", text=comment.text.strip())

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
