# SPDX-License-Identifier: LGPL-2.1-or-later
"""One line of a program whose path is put elsewhere: its places, lengths, feeds and units.

A line under edit: the values of its words, and where new values go.

The words of arcs: their radius, their centre, and the sense in which they run.
"""

from __future__ import annotations

import math

import numpy as np

from CNCStepper.errors import ProgramError, Text
from CNCStepper.gcode.dialects.codes import AXES, UNIT_CODES
from CNCStepper.gcode.edit.line_states import EXPAND, WITHOUT_CYCLES, Meaning
from CNCStepper.gcode.edit.line_tokens import Edit, Token
from CNCStepper.gcode.edit.path_transforms import TransformState
from CNCStepper.gcode.edit.word_values import (
    CANNED,
    OTHER_AXES,
    Value,
    decimals_of,
    dialect_decimals,
    feed_decimals,
    kinds,
    owner,
)
from CNCStepper.tolerances import SAME_MATRIX_SCALE
from CNCStepper.toolpath import PLANE_AXES, PLANE_NAMES
from CNCStepper.units import UNIT_MM

THREAD_CYCLE = "G76"
SYNCHRONISED = ("G33", "G33.1")  # whose feed follows the spindle


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
        """Return the axes with a coordinate in the new line: the old line's, and those that change with them."""
        return [axis for axis in range(3) if axis in axes or any(self.where.rows[axis][other] for other in axes)]

    def value(self, letter: str, axis: int) -> Value:
        """Return a word's value in mm; without the word the tool's position (`axis`), or 0 for a distance."""
        token = self.words.get(letter)
        if token is not None:
            return Value.of(token, self.from_mm * self._share(letter))
        if axis < 0:
            return Value(0.0)
        if math.isnan(self.meaning.begin[axis]) or self.meaning.compensated:
            what = Text(
                "the tool's {letter} is unknown here, and a rotation needs both coordinates",
                letter=letter,
            )
            raise self.refused("edit-place", what, self.tokens[-1], Text("add {letter} to the line", letter=letter))
        return Value(self.meaning.begin[axis])

    def _share(self, letter: str) -> float:
        """Return by how much a word's length is a coordinate's: half of one that is a diameter."""
        return 0.5 if letter == "X" and self.meaning.diameter else 1.0

    def put(self, letter: str, value: Value, axis: int, add_carry: bool = False) -> None:
        """Write a value (mm) in its word's place, or beside its neighbour; `axis` keeps the rounding error."""
        decimals = self.state.decimals(self.units)
        carry, to_mm = self.state.carry_mm, self.to_mm * self._share(letter)
        if axis >= 0 and value.is_number:
            exact = value.number + (carry[axis] if add_carry else 0.0)
            step = to_mm / 10**decimals
            counts = round(exact / step)
            carry[axis] = exact - counts * step
            value = Value(counts * step)
        elif axis >= 0:
            carry[axis] = 0.0
        token = self.words.get(letter)
        text = value.times(1.0 / to_mm).text(decimals, self._like(token))
        if token is None:
            self.insert(letter, text)
        elif not self._says(token, value, decimals):
            self.made.append((token.first, token.last, text))

    def _says(self, token: Token, value: Value, decimals: int) -> bool:
        """Whether a word has the new number already."""
        share = self._share(token.letter)
        if token.number is None or not value.is_number:
            return value.is_same(token, self.from_mm * share) and self.from_mm == self.to_mm
        return abs(token.number - value.number / (self.to_mm * share)) < 0.5 * 10.0**-decimals * 1e-3

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

    def refused(self, code: str, what: str, token: Token, advice: str) -> ProgramError:
        """Return the error that names this line and a word."""
        value = token.letter + token.written
        return self.state.source.refusal(self.number, code, what, token.begin + 1, value, advice=advice)


ARCS = {"G2": "G3", "G3": "G2"}
COMPENSATIONS = {"G41": "G42", "G42": "G41", "G41.1": "G42.1", "G42.1": "G41.1"}
CENTRES = "IJK"
NEAR = (-1, 0, 1)  # last digits by which a rounded centre may be another one
FARTHER = 0.25  # how much a centre farther from the exact one must be better


class ArcWords(LineWords):
    """The edits that a line needs if it may be an arc."""

    def arc(self, by_kind: dict[str, list[str]]) -> None:
        """Find the edits of radius and centre; raises ProgramError where the map leaves no arc."""
        if self.owner not in ARCS or not any(letter in self.words for letter in "XYZIJKR"):
            return
        in_plane = self.where.in_plane(self.meaning.plane)
        if in_plane is None:
            what = Text("an arc in the plane {plane} would be no arc any more", plane=self.meaning.plane)
            advice = "scale all axes alike" if self.where.is_diagonal else "only arcs of G17 can be turned about Z"
            raise self.refused("edit-arc", what, self.tokens[-1], advice)
        if "R" in self.words:
            self._radius(in_plane[0])
        elif by_kind.get("centre"):
            self._centre(by_kind["centre"])

    def _radius(self, scale: float) -> None:
        """Write R; where rounding made it too short for the chord, a last digit longer."""
        value = Value.of(self.words["R"], self.from_mm).times(scale)
        if value.is_number:
            step = self.step_mm
            least = self._chord_mm() / 2.0
            if abs(round(value.number / step) * step) < least <= abs(value.number) + step:
                value = Value(math.copysign(math.ceil(least / step - 1e-9) * step, value.number))
        self.put("R", value, -1)

    def _chord_mm(self) -> float:
        """Return how far the rounded ends of the arc lie apart, 0 where that is not known."""
        ends = self._ends()
        return 0.0 if ends is None else abs(ends[1] - ends[0])

    def _ends(self) -> tuple[complex, complex] | None:
        """Return begin and end of the new arc in its plane, rounded, in mm; None where they are not known."""
        first, second, _ = PLANE_AXES[PLANE_NAMES.index(self.meaning.plane)]
        begin = np.array(self.meaning.begin[:3], float)
        end = begin.copy()
        for axis in (first, second):
            token = self.words.get(AXES[axis])
            if token is None:
                continue
            if token.number is None:
                return None
            given_mm = token.number * self.from_mm * self._share(token.letter)
            end[axis] = given_mm + (0.0 if self.meaning.absolute else begin[axis])
        if np.isnan(begin[[first, second]]).any() or self.meaning.compensated:
            return None
        steps = np.array([self.step_mm * self._share(letter) for letter in AXES])
        rounded = np.round(self.where.of(np.nan_to_num(np.array([begin, end]))) / steps) * steps
        return complex(rounded[0][first], rounded[0][second]), complex(rounded[1][first], rounded[1][second])

    def _centre(self, letters: list[str]) -> None:
        axes = [CENTRES.index(letter) for letter in letters]
        first, second, _ = PLANE_AXES[PLANE_NAMES.index(self.meaning.plane)]
        coupled = [axis for axis in self.coupled(axes) if axis in (first, second)]
        absolute = self.meaning.absolute_centres
        values = {axis: self.value(CENTRES[axis], -1) for axis in self.needed(axes)}
        new = {
            axis: Value.total(
                [(self.where.rows[axis][other], values[other]) for other in values],
                self.where.shift[axis] if absolute else 0.0,
            )
            for axis in coupled
        }
        if self.where.units or not (absolute or self.where.moves_only):
            new = self._best_centre(new, first, second)
        for axis in coupled:
            if CENTRES[axis] in self.words or not new[axis].is_number or abs(new[axis].number) > 0.0:
                self.put(CENTRES[axis], new[axis], -1)

    def _best_centre(self, new: dict[int, Value], first: int, second: int) -> dict[int, Value]:
        """Return the rounded centre from the begin whose circle passes best through the rounded end."""
        ends = self._ends()
        both = {axis: new.get(axis, Value(0.0)) for axis in (first, second)}
        if ends is None or self.meaning.absolute_centres or not all(value.is_number for value in both.values()):
            return new
        step = self.step_mm
        exact = complex(both[first].number, both[second].number) / step
        chord = (ends[1] - ends[0]) / step
        near = [
            complex(round(exact.real) + i, round(exact.imag) + j)
            for i in NEAR
            for j in NEAR
            if (not i or first in new) and (not j or second in new)
        ]
        best = min(near, key=lambda one: abs(abs(one) - abs(chord - one)) + FARTHER * abs(one - exact))
        counts = {first: best.real, second: best.imag}
        return {axis: Value(counts[axis] * step) for axis in new}

    def motion_words(self) -> None:
        """Turn arcs and compensations round where the map does."""
        in_plane = self.where.in_plane(self.meaning.plane)
        turned = in_plane is not None and in_plane[1] < 0
        said = next((token for token in self.tokens if token.name in ARCS), None)
        moves = self.owner in ARCS and any(letter in self.words for letter in "XYZIJKR")
        if self.meaning.motion not in ARCS:
            self.state.motion = ""
        elif said is not None or moves:
            wanted = ARCS[self.meaning.motion] if turned else self.meaning.motion
            if said is not None and wanted != said.name:
                self.rename(said, wanted)
            elif said is None and wanted != self.state.motion:
                at = next(token.begin for token in self.tokens if token.letter != "N")
                self.made.append((at, at, wanted + self.blank))
            self.state.motion = wanted
        for token in self.tokens:
            if turned and token.name in COMPENSATIONS:
                self.rename(token, COMPENSATIONS[token.name])


INVERSE_DECIMALS = 6  # of F under G93: one a minute is a whole move


class Line(ArcWords):
    """Finds the edits of a line, and notes where that leads."""

    def edits(self) -> list[Edit]:
        """Return the replacements."""
        found = kinds(self.tokens, self.meaning.motion)
        lengths = [letter for letter in (found or {}) if letter in self.words]
        if found is None and any(token.letter in "XYZIJKRQPDEUVW@^" for token in self.tokens):
            raise self._not_edited()
        self._check_axes()
        self._check_lead()
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

    def _not_edited(self) -> ProgramError:
        """Return the refusal of a line whose words are no places."""
        if any(token.name == THREAD_CYCLE for token in self.tokens):
            what = "the words of G76 are the depths and angles of a thread, which no path edit changes"
            return self.refused("edit-code", what, self.tokens[0], WITHOUT_CYCLES)
        what = Text("the words of {codes} are not edited", codes=self._codes())
        return self.refused("edit-code", what, self.tokens[0], EXPAND)

    def _check_lead(self) -> None:
        """Refuse to scale a cut that follows the spindle: its lead would stay."""
        scale = self.where.scale
        if self.owner in SYNCHRONISED and (scale is None or abs(scale - 1.0) > SAME_MATRIX_SCALE):
            what = Text("a thread keeps its lead: a path with {owner} is not scaled", owner=self.owner)
            token = self.words.get("K", self.tokens[0])
            raise self.refused("edit-thread", what, token, "make the program again with the new thread")

    def _places(self, letters: list[str]) -> None:
        if not letters:
            return
        absolute, cycle = self.meaning.absolute, self.owner in CANNED
        axes = [AXES.index(letter) for letter in letters]
        self._check_relative(axes, absolute)
        coupled = self.coupled(axes)
        if self.owner in ("G28", "G30") and set(coupled) != set(axes):
            what = Text("{owner} by way of a place cannot be turned", owner=self.owner)
            advice = Text("write a G0 to that place, and {owner} alone on the next line", owner=self.owner)
            raise self.refused("edit-home", what, self.words[letters[0]], advice)
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
        what = "the path begins at the machine's position: it has incremental moves (G91) only"
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
            what = "G52 moves the zero about which the path is changed"
            raise self.refused("edit-zero", what, self.tokens[0], "use a work offset (G54) instead")
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
        """Return the factor of the path's length; an inverse time grows with it, so that the feed stays."""
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
            what = Text("only X, Y and Z are edited, not {letter}", letter=other.letter)
            raise self.refused("edit-axis", what, other, "leave those axes out")

    def _codes(self) -> str:
        names = [token.name or token.letter + token.written for token in self.tokens if token.letter in "GM"]
        return " ".join(names) or self.owner
