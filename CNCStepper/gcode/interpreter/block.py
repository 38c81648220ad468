# SPDX-License-Identifier: LGPL-2.1-or-later
"""One block while it is executed: the values of its words, and its moves.

The codes of a block are functions that take it, and `execute.py` calls them. The feed of a move is worked out here: per
minute, per turn, or in inverse time, which needs the length of the move.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable, Sequence
from math import hypot, isnan, sqrt
from typing import Protocol

from CNCStepper.errors import ProgramError, Text
from CNCStepper.gcode.dialects import Dialect
from CNCStepper.gcode.dialects.codes import ALL_AXES, MOTION_NAMES
from CNCStepper.gcode.interpreter.canonical_output import SET_FEED, Canon, CanonicalBlock
from CNCStepper.gcode.interpreter.motion.arcs import Arc, chords
from CNCStepper.gcode.interpreter.motion.end_points import unknown_position
from CNCStepper.gcode.interpreter.state import stand_alone_position
from CNCStepper.gcode.interpreter.state.interpreter_state import NO_FURTHER, Model, Point, mean_rpm
from CNCStepper.gcode.interpreter.state.parameters import length_scale
from CNCStepper.gcode.syntax.line_grammar import Plan
from CNCStepper.gcode.syntax.words import Word
from CNCStepper.state import State
from CNCStepper.toolpath import PLANE_AXES, RAPID, XY, TableBuilder

SMALLEST_INVERSE_FEED = 0.1  # units a minute; RS274 never goes below


class ProfileReader(Protocol):
    """Runs a subroutine and hands its blocks to a cycle (`run_with_subroutines.py`)."""

    def __call__(self, number: int, model: Model, take: Callable[[Model, list[Word], list[float]], None]) -> None:
        """Run the subroutine O<number> from `model`; `take` gets the words of each block, and their values."""


class NumberedProfile(Protocol):
    """Finds blocks by their N words for the cycles of a lathe (`numbered_blocks.py`)."""

    def read(self, first: int, last: int, model: Model, take: Callable[[Model, list[Word], list[float]], None]) -> None:
        """Hand the words of the blocks from N<first> to N<last>, and their values, to `take`."""

    def run_after(self, first: int, last: int, back: Point) -> None:
        """Run these blocks after the present one, then rapid to a machine position."""


class Block(CanonicalBlock, ABC):
    """One block that is checked and executed on `model`, the scratch copy."""

    def __init__(self, model: Model, dialect: Dialect, table: TableBuilder, line: int, canon: Canon | None):
        super().__init__(model, table, line, canon)
        self.dialect = dialect
        self.plan: Plan
        self.values: list[float]
        self.read_profile: ProfileReader | None = None
        self.numbered: NumberedProfile | None = None
        self.asks_position = False  # afterwards the machine is asked where it is
        self.turning = "off"  # how the spindle turned when a canned cycle began
        self.unheard = False  # no calls for single moves: one call before them covers all
        self.next_further: tuple[float, ...] = model.further  # where A B C U V W are after this block's move

    @abstractmethod
    def execute(self, plan: Plan, values: list[float]) -> None:
        """Execute words, which become the block's own (`execute.py`)."""

    # words

    def value(self, letter: str) -> float:
        """Return the number of a word that is there."""
        return self.values[self.plan.slots[letter]]

    def whole(self, letter: str, least: int, most: int, code: str = "bad-value") -> int:
        """Return a word's whole number; raises ProgramError when it is none or out of range."""
        value = self.value(letter)
        if value != int(value) or not least <= value <= most:
            what = Text("{letter} must be a whole number", letter=letter)
            raise ProgramError(
                code, what, value=letter, limit=f"{least} to {most}", advice=Text("correct {letter}", letter=letter)
            )
        return int(value)

    def not_negative(self, letter: str) -> float:
        """Return a word's number; raises ProgramError when it is below 0."""
        value = self.value(letter)
        if value < 0:
            raise ProgramError(
                "bad-value",
                Text("{letter} may not be negative", letter=letter),
                value=letter,
                advice=Text("correct {letter}", letter=letter),
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
            raise ProgramError(
                "bad-value", what, value=letter, limit=limit, advice=Text("correct {letter}", letter=letter)
            )
        return value

    def must_have(self, letter: str, name: str) -> None:
        """Refuse a code without one of its words."""
        if letter not in self.plan.slots:
            raise ProgramError(
                "missing-word",
                Text("{name} needs a {letter} word", name=name, letter=letter),
                value=name,
                advice=Text("add {letter}", letter=letter),
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
            return model.state.feed_mm_turn * mean_rpm(model, end)
        if length < 0:
            begin = (*model.machine(model.programmed_work()), *(model.further or (0.0,) * len(further)))
            length = _way_length(begin, (*end, *further), arc)
        feed = max(SMALLEST_INVERSE_FEED * model.scale, length * self.value("F"))
        self.lengths(SET_FEED, feed)
        model.feed_number = feed / model.scale
        return feed


def check_feed(model: Model, motion: int, plan: Plan | None = None, values: Sequence[float] = ()) -> None:
    """Refuse a feed move while no feed is set, or in inverse time without its own F."""
    name, mode = MOTION_NAMES[motion], model.state.feed_mode
    if mode == "per_minute" and model.state.feed_mm_min <= 0:
        raise ProgramError("no-feed", Text("{name} has no feed", name=name), value=name, advice=_feed_advice(model))
    if mode == "per_turn" and (model.state.feed_mm_turn <= 0 or model.state.spindle_rpm <= 0):
        what = Text("{name} has no feed: a feed per turn needs F and a spindle that turns", name=name)
        raise ProgramError("no-feed", what, value=name, advice="write F and S above 0 before")
    if mode == "inverse_time" and plan and not ("F" in plan.slots and values[plan.slots["F"]] > 0):
        what = Text("in inverse time every {name} needs its own F above 0", name=name)
        raise ProgramError("no-feed", what, value=name, advice="add F, or write G94 before")


def _feed_advice(model: Model) -> str:
    """Return what to do where no feed is set: a controller that reads files is sent nothing that is not in them."""
    if not model.feed_of_file_mm_min:
        return "write an F word above 0 before"
    return Text(
        "write F{feed:.6g} into the file: its controller reads it itself, and would take an earlier feed",
        feed=model.feed_of_file_mm_min / model.scale,
    )


def _way_length(begin: tuple[float, ...], end: tuple[float, ...], arc: Arc | None) -> float:
    """Return the length of a move: along X Y Z, else U V W, else A B C (degrees for mm)."""
    if any(isnan(value) for value in (*begin, *end)):
        raise unknown_position("F", "an inverse-time feed needs a known position")
    way = [there - here for here, there in zip(begin, end, strict=True)]
    if arc is not None:
        return hypot(arc.radius * arc.sweep_rad, way[PLANE_AXES[arc.plane][2]])
    groups = (way[:3], way[6:], way[3:6])
    return next((sqrt(sum(part * part for part in group)) for group in groups if any(group)), 0.0)
