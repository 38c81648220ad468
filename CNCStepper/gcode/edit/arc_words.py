# SPDX-License-Identifier: LGPL-2.1-or-later
"""The words of arcs: their radius, their centre, and the sense in which they run."""

from __future__ import annotations

import math

import numpy as np

from CNCStepper.errors import Text
from CNCStepper.gcode.dialects.codes import AXES
from CNCStepper.gcode.edit.line_words import LineWords
from CNCStepper.gcode.edit.word_values import Value
from CNCStepper.toolpath import PLANE_AXES, PLANE_NAMES

ARCS = {"G2": "G3", "G3": "G2"}
COMPENSATIONS = {"G41": "G42", "G42": "G41", "G41.1": "G42.1", "G42.1": "G41.1"}
CENTRES = "IJK"
NEAR = (-1, 0, 1)  # last digits by which a rounded centre may be another one
FARTHER = 0.25  # how much a centre farther from the exact one must be better


class ArcWords(LineWords):
    """What a line that may be an arc asks for."""

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
            end[axis] = token.number * self.from_mm + (0.0 if self.meaning.absolute else begin[axis])
        if np.isnan(begin[[first, second]]).any() or self.meaning.compensated:
            return None
        step = self.step_mm
        rounded = np.round(self.where.of(np.nan_to_num(np.array([begin, end]))) / step) * step
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
