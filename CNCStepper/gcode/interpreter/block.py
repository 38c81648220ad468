# SPDX-License-Identifier: LGPL-2.1-or-later
"""One block while it is executed: the values of its words, and its moves.

The codes of a block are functions that take it (`execute.py`, `execute.py`), and `execute.py` calls them.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable
from math import isnan
from typing import Protocol

from CNCStepper.errors import ProgramError, Text
from CNCStepper.gcode.dialects import Dialect
from CNCStepper.gcode.dialects.codes import ALL_AXES
from CNCStepper.gcode.interpreter.canonical_output import SET_FEED, Canon, CanonicalBlock
from CNCStepper.gcode.interpreter.motion.moves import SMALLEST_INVERSE_FEED, Arc, chords, way_length
from CNCStepper.gcode.interpreter.state import stand_alone_position
from CNCStepper.gcode.interpreter.state.model import NO_FURTHER, Model, Point, rpm_at
from CNCStepper.gcode.interpreter.state.parameters import length_scale
from CNCStepper.gcode.syntax.line_grammar import Plan
from CNCStepper.gcode.syntax.words import Word
from CNCStepper.state import State
from CNCStepper.toolpath import RAPID, XY, TableBuilder


class ProfileReader(Protocol):
    """Runs a subroutine and hands its blocks to a cycle (`program_flow.py`)."""

    def __call__(self, number: int, model: Model, take: Callable[[Model, list[Word], list[float]], None]) -> None:
        """Run the subroutine O<number> from `model`; `take` gets the words of each block, and their values."""


class Block(CanonicalBlock, ABC):
    """One block that is checked and executed on `model`, the scratch copy."""

    def __init__(self, model: Model, dialect: Dialect, table: TableBuilder, line: int, canon: Canon | None):
        super().__init__(model, table, line, canon)
        self.dialect = dialect
        self.plan: Plan
        self.values: list[float]
        self.read_profile: ProfileReader | None = None
        self.asks_position = False  # afterwards the machine is asked where it is
        self.turning = "off"  # how the spindle turned when a canned cycle began
        self.unheard = False  # moves are not told: a call before them stands for all
        self.next_further: tuple[float, ...] = model.further  # where A B C U V W are after this block's move

    @abstractmethod
    def execute(self, plan: Plan, values: list[float]) -> None:
        """Execute words, which are the block's from then on (`execute.py`)."""

    # words

    def value(self, letter: str) -> float:
        """Return the number of a word that is there."""
        return self.values[self.plan.slots[letter]]

    def whole(self, letter: str, least: int, most: int, code: str = "bad-value") -> int:
        """Return a word's whole number; raises ProgramError when it is none or out of range."""
        value = self.value(letter)
        if value != int(value) or not least <= value <= most:
            what = Text("{letter} must be a whole number", letter=letter)
            raise ProgramError(code, what, value=letter, limit=f"{least} to {most}", advice=f"correct {letter}")
        return int(value)

    def not_negative(self, letter: str) -> float:
        """Return a word's number; raises ProgramError when it is below 0."""
        value = self.value(letter)
        if value < 0:
            raise ProgramError(
                "bad-value",
                Text("{letter} may not be negative", letter=letter),
                value=letter,
                advice=f"correct {letter}",
            )
        return value

    def known(self, axis: int) -> float:
        """Return the machine position along one axis; raises ProgramError when it is unknown."""
        position = (*self.model.position, *(self.model.further or NO_FURTHER))[axis]
        if isnan(position):
            name = ALL_AXES[axis]
            what = Text("the position along {name} is not known here", name=name)
            raise ProgramError("unknown-position", what, value=name, advice="move there with G90 first")
        return position

    def between(self, letter: str, least: float, most: float) -> float:
        """Return a word's number; raises ProgramError when it is out of range."""
        value = self.value(letter)
        if not least <= value <= most:
            what, limit = Text("{letter} is out of range", letter=letter), f"{least:g} to {most:g}"
            raise ProgramError("bad-value", what, value=letter, limit=limit, advice=f"correct {letter}")
        return value

    def must_have(self, letter: str, name: str) -> None:
        """Refuse a code without one of its words."""
        if letter not in self.plan.slots:
            raise ProgramError(
                "missing-word",
                Text("{name} needs a {letter} word", name=name, letter=letter),
                value=name,
                advice=f"add {letter}",
            )

    def axis_words(self) -> dict[int, float]:
        """Return the axis words by axis, mm and degrees."""
        slots, scale = self.plan.slots, self.model.scale
        there = {axis: slots[letter] for axis, letter in enumerate(ALL_AXES) if letter in slots}
        return {axis: self.values[slot] * length_scale(axis, scale) for axis, slot in there.items()}

    def scale_x(self, factor: float) -> None:
        """Multiply X by a factor, such as diameter to radius."""
        self.scale("X", factor)

    def scale(self, letter: str, factor: float) -> None:
        """Take a word, if it is there, `factor` times as large."""
        if letter in self.plan.slots:
            self.values[self.plan.slots[letter]] *= factor

    def uncompensated(self, what: str, value: str) -> None:
        """Refuse something while the radius of the tool is compensated."""
        if self.model.compensation:
            what = Text("{what} while the tool is compensated", what=what)
            raise ProgramError("compensation", what, value=value, advice="write G40 before")

    def known_position(self, axes: Iterable[int]) -> Point:
        """Return the machine position; raises ProgramError when one of `axes` is unknown."""
        for axis in axes:
            self.known(axis)
        return self.model.position

    # moves

    def rapid(self, end: Point, further: tuple[float, ...] = (), row: bool = True) -> None:
        """Rapid to `end`; A B C U V W keep their positions unless `further` gives others."""
        self.move(RAPID, end, None, 0.0, further or self.model.further, row)

    def move(
        self,
        motion: int,
        end: Point,
        arc: Arc | None,
        feed: float,
        further: tuple[float, ...] | None = None,
        row: bool = True,
    ) -> None:
        """Move to `end`, and note that the tool is there."""
        further = self.model.further if further is None else further
        self.emit(motion, end, arc, feed, self.line, self.model.state, further, row)
        self.model.further = further
        stand_alone_position.moved(self.model, end)

    def emit(
        self,
        motion: int,
        end: Point,
        arc: Arc | None,
        feed: float,
        line: int,
        state: State | None,
        further: tuple[float, ...],
        row: bool = True,
    ) -> None:
        """Append the row of a move and emit its call; the noted tool position stays."""
        whole = (*end, *further)
        if row:
            self.do(self.table.set_state, state)
            if motion == RAPID:
                self.do(self.table.rapid, whole, line)
            elif arc is None:
                self.do(self.table.feed, whole, feed, line)
            elif self.model.turn is not None and arc.plane != XY:
                for point in chords(self.model, motion, arc, end):
                    self.do(self.table.feed, (*point, *further), feed, line)
            else:
                self.do(self.table.arc, motion, whole, arc.centre, feed, arc.plane, arc.turns, line)
        self.model.stands = end
        if self.canon and not self.unheard:
            self.do(self.canon.move, motion, whole, arc, self.model.copy())

    def feed_of(
        self, motion: int, end: Point, arc: Arc | None = None, further: tuple[float, ...] = (), length: float = -1.0
    ) -> float:
        """Return the feed of the move to `end`, mm/min; its length may be given; an inverse time is emitted."""
        model = self.model
        if model.state.feed_mode == "per_minute":
            return model.state.feed_mm_min
        if model.state.feed_mode == "per_turn":
            return model.state.feed_mm_turn * rpm_at(model, end)
        if length < 0:
            begin = (*model.machine(model.programmed_work()), *(model.further or (0.0,) * len(further)))
            length = way_length(begin, (*end, *further), arc)
        feed = max(SMALLEST_INVERSE_FEED * model.scale, length * self.value("F"))
        self.lengths(SET_FEED, feed)
        model.feed_number = feed / model.scale
        return feed
