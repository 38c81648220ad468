# SPDX-License-Identifier: LGPL-2.1-or-later
"""A line under edit: the values of its words, and where new values go."""

from __future__ import annotations

import math

from CNCStepper.errors import ProgramError, Text
from CNCStepper.gcode.edit.executed_lines import Meaning
from CNCStepper.gcode.edit.line_tokens import Edit, Token
from CNCStepper.gcode.edit.transform_state import TransformState
from CNCStepper.gcode.edit.word_kinds import owner
from CNCStepper.gcode.edit.word_values import Value
from CNCStepper.units import UNIT_MM


class LineWords:
    """words: by letter. owner: the code that uses the axis words. made: the edits found so far."""

    def __init__(self, state: TransformState, number: int, meaning: Meaning, tokens: list[Token]):
        self.state = state
        self.where = state.where
        self.number = number
        self.meaning = meaning
        self.tokens = tokens
        self.words = {token.letter: token for token in tokens}
        self.owner = owner(tokens, meaning.motion)
        self.blank = state.blank
        self.units = state.units_of(meaning)
        self.from_mm = UNIT_MM[meaning.units]
        self.to_mm = UNIT_MM[self.units]
        self.made: list[Edit] = []

    @property
    def step_mm(self) -> float:
        """The last digit of the line's new numbers."""
        return self.to_mm / 10 ** self.state.decimals(self.units)

    def needed(self, axes: list[int]) -> list[int]:
        """Return the axes on which the new words of `axes` depend, in their order."""
        rows = self.coupled(axes)
        return [other for other in range(3) if any(self.where.rows[axis][other] for axis in rows)]

    def coupled(self, axes: list[int]) -> list[int]:
        """Return the axes of which the new line says a coordinate: the old line's, and those that change with them."""
        return [axis for axis in range(3) if axis in axes or any(self.where.rows[axis][other] for other in axes)]

    def value(self, letter: str, axis: int) -> Value:
        """Return a word's value in mm; without the word the tool's position (`axis`), or 0 for a distance."""
        token = self.words.get(letter)
        if token is not None:
            return Value.of(token, self.from_mm)
        if axis < 0:
            return Value(0.0)
        if math.isnan(self.meaning.begin[axis]) or self.meaning.compensated:
            what = Text(
                "where the tool stands along {letter} is not known here, and turning needs both coordinates",
                letter=letter,
            )
            raise self.refused("edit-place", what, self.tokens[-1], Text("add {letter} to the line", letter=letter))
        return Value(self.meaning.begin[axis])

    def put(self, letter: str, value: Value, axis: int, add_carry: bool = False) -> None:
        """Write a value (mm) in its word's place, or beside its neighbour; `axis` keeps the rounding error."""
        decimals = self.state.decimals(self.units)
        carry = self.state.carry_mm
        if axis >= 0 and value.is_number:
            exact = value.number + (carry[axis] if add_carry else 0.0)
            step = self.to_mm / 10**decimals
            counts = round(exact / step)
            carry[axis] = exact - counts * step
            value = Value(counts * step)
        elif axis >= 0:
            carry[axis] = 0.0
        token = self.words.get(letter)
        text = value.times(1.0 / self.to_mm).text(decimals, self._like(token))
        if token is None:
            self.insert(letter, text)
        elif not self._says(token, value, decimals):
            self.made.append((token.first, token.last, text))

    def _says(self, token: Token, value: Value, decimals: int) -> bool:
        """Whether a word says the new number already."""
        if token.number is None or not value.is_number:
            return value.is_same(token, self.from_mm) and self.from_mm == self.to_mm
        return abs(token.number - value.number / self.to_mm) < 0.5 * 10.0**-decimals * 1e-3

    def _like(self, token: Token | None) -> str:
        """Return the number after whose form the new one is written; in another unit it has its own."""
        return token.written if token is not None and not self.where.units else ""

    def insert(self, letter: str, text: str) -> None:
        """Write a new word beside its neighbour: X before Y, Y after X."""
        neighbour = next(self.words[one] for one in ("XYZ" if letter in "XYZ" else "IJKPQ") if one in self.words)
        if letter < neighbour.letter:
            self.made.append((neighbour.begin, neighbour.begin, f"{letter}{text}{self.blank}"))
        else:
            self.made.append((neighbour.last, neighbour.last, f"{self.blank}{letter}{text}"))

    def rename(self, token: Token, name: str) -> None:
        """Write another code: G03 for G02."""
        zero = "0" if token.written.startswith("0") else ""
        self.made.append((token.first, token.last, zero + name[1:]))

    def refused(self, code: str, what: str, token: Token, advice: str = "") -> ProgramError:
        """Return the error that names this line and a word."""
        value = token.letter + token.written
        return self.state.source.refusal(self.number, code, what, token.begin + 1, value, advice)
