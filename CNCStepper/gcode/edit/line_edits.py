# SPDX-License-Identifier: LGPL-2.1-or-later
"""One line of a program whose path is put elsewhere: its places, lengths, feeds and units."""

from __future__ import annotations

import numpy as np

from CNCStepper.errors import Text
from CNCStepper.gcode.dialects.codes import AXES, UNIT_CODES
from CNCStepper.gcode.edit.arc_words import ArcWords
from CNCStepper.gcode.edit.line_tokens import Edit, Token
from CNCStepper.gcode.edit.number_format import decimals_of, dialect_decimals, feed_decimals
from CNCStepper.gcode.edit.word_kinds import CANNED, OTHER_AXES, kinds
from CNCStepper.gcode.edit.word_values import Value
from CNCStepper.toolpath import PLANE_AXES, PLANE_NAMES
from CNCStepper.units import UNIT_MM

INVERSE_DECIMALS = 6  # of F under G93: one a minute is a whole move


class Line(ArcWords):
    """Finds the edits of a line, and notes where that leads."""

    def edits(self) -> list[Edit]:
        """Return what is to be replaced."""
        found = kinds(self.tokens, self.meaning.motion)
        lengths = [letter for letter in (found or {}) if letter in self.words]
        if found is None and any(token.letter in "XYZIJKRQPDEUVW@^" for token in self.tokens):
            raise self.refused(
                "edit-code", Text("the words of {codes} are not edited", codes=self._codes()), self.tokens[0]
            )
        self._check_axes()
        by_kind: dict[str, list[str]] = {}
        for letter in lengths:
            by_kind.setdefault((found or {})[letter], []).append(letter)
        self._places(by_kind.get("place", []))
        self.arc(by_kind)
        self._others(by_kind)
        self.motion_words()
        self._unit_words()
        self._leave(by_kind)
        return self.made

    def _places(self, letters: list[str]) -> None:
        if not letters:
            return
        absolute, cycle = self.meaning.absolute, self.owner in CANNED
        axes = [AXES.index(letter) for letter in letters]
        self._check_relative(axes, absolute)
        coupled = self.coupled(axes)
        if self.owner in ("G28", "G30") and set(coupled) != set(axes):
            raise self.refused(
                "edit-home",
                Text("{owner} by way of a place cannot be turned", owner=self.owner),
                self.words[letters[0]],
            )
        values = {axis: self.value(AXES[axis], axis if absolute else -1) for axis in self.needed(axes)}
        for axis in coupled:
            terms = [(self.where.rows[axis][other], values[other]) for other in values]
            new = Value.total(terms, self.where.shift[axis] if absolute else 0.0)
            carries = not (cycle and not absolute)
            self.put(AXES[axis], new, axis if carries else -1, add_carry=not absolute)
            self.state.free[axis] = False

    def _check_relative(self, axes: list[int], absolute: bool) -> None:
        """Refuse ways that begin at a place which the edit leaves where it is but ought to move."""
        loose = [axis for axis in axes if self.state.free[axis] and not absolute]
        if not loose or self.where.units or self.owner in ("G28", "G30"):
            return
        here = np.nan_to_num(np.array(self.meaning.begin[:3]))
        away = np.abs(self.where.of(here) - here)
        if not any(away[axis] > 0 for axis in loose):
            return
        what = "the path begins where the machine happens to stand: it is told by ways (G91) alone"
        advice = "write a move with G90 before it, or move the work zero"
        raise self.refused("edit-relative", what, self.tokens[-1], advice)

    def _others(self, by_kind: dict[str, list[str]]) -> None:
        normal = PLANE_AXES[PLANE_NAMES.index(self.meaning.plane)][2]
        along = self.where.rows[normal][normal]
        for letter in by_kind.get("height", []):
            shift = self.where.shift[normal] if self.meaning.absolute else 0.0
            self.put(letter, Value.of(self.words[letter], self.from_mm).times(along).plus(shift), -1)
        for letter in by_kind.get("depth", []):
            self.put(letter, Value.of(self.words[letter], self.from_mm).times(abs(along)), -1)
        for pair in ("IJ", "PQ"):
            self._vector([letter for letter in pair if letter in by_kind.get("vector", [])], pair)
        for letter in by_kind.get("here", []):
            self._here(letter)
        for letter in [*by_kind.get("length", []), *by_kind.get("machine", [])]:
            self.put(letter, Value.of(self.words[letter], self.from_mm), -1)
        if self.owner == "G52" and not self.where.moves_only:
            raise self.refused("edit-zero", "G52 moves the zero about which the path is changed", self.tokens[0])
        self._feed()

    def _vector(self, letters: list[str], pair: str) -> None:
        axes = [pair.index(letter) for letter in letters]
        for axis in self.coupled(axes):
            terms = [(self.where.rows[axis][other], self.value(pair[other], -1)) for other in (0, 1)]
            self.put(pair[axis], Value.total(terms, 0.0), -1)

    def _here(self, letter: str) -> None:
        """Give the tool's new place the name that keeps the offset as it was."""
        value = Value.of(self.words[letter], self.from_mm)
        axis = AXES.find(letter)
        if axis >= 0 and not self.state.free[axis]:
            if not self.where.moves_only:
                what = Text(
                    "{owner} sets the zero from where the tool stands after moves of the path", owner=self.owner
                )
                raise self.refused("edit-zero", what, self.words[letter], "set the zero with G10 L2 instead")
            value = value.plus(float(self.where.shift[axis]))
        self.put(letter, value, -1)

    def _feed(self) -> None:
        token = self.words.get("F")
        if token is None:
            return
        factor, decimals = 1.0, dialect_decimals(self.state.source.dialect, self.units)
        if self.meaning.inverse_time:
            factor = 1.0 / self._growth(token)
            decimals = max(decimals, decimals_of(token.written) if token.number is not None else 0, INVERSE_DECIMALS)
        elif self.where.units:
            factor = UNIT_MM[self.meaning.feed_units] / UNIT_MM[self.where.units]
            decimals = feed_decimals(factor * (token.number or 0.0), decimals)
        if factor != 1.0 or (self.where.units and not self.meaning.inverse_time):
            self.made.append((token.first, token.last, Value.of(token, 1.0).times(factor).text(decimals)))

    def _growth(self, token: Token) -> float:
        """Return by what the way grows, so that an inverse time grows with it and the feed stays."""
        if self.where.scale is None:
            what = "a feed of inverse time (G93) cannot stay where the axes are scaled differently"
            raise self.refused("edit-feed", what, token, "scale all axes alike, or write feeds a minute (G94)")
        return round(self.where.scale, 12)

    def _unit_words(self) -> None:
        for token in self.tokens:
            if self.where.units and token.name in UNIT_CODES.values():
                self.rename(token, UNIT_CODES[self.where.units])

    def _leave(self, by_kind: dict[str, list[str]]) -> None:
        """Note which axes a machine place has taken out of the work."""
        if by_kind.get("machine") or self.owner in ("G28", "G30"):
            named = [AXES.index(letter) for letter in AXES if letter in self.words]
            for axis in named or (range(3) if self.owner in ("G28", "G30") else ()):
                self.state.free[axis], self.state.carry_mm[axis] = True, 0.0

    def _check_axes(self) -> None:
        other = next((token for token in self.tokens if token.letter in OTHER_AXES), None)
        if other is not None and not self.where.units:
            raise self.refused(
                "edit-axis", Text("only X, Y and Z are edited, not {letter}", letter=other.letter), other
            )

    def _codes(self) -> str:
        names = [token.name or token.letter + token.written for token in self.tokens if token.letter in "GM"]
        return " ".join(names) or self.owner
