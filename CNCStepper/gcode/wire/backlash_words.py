# SPDX-License-Identifier: LGPL-2.1-or-later
"""The words of moves with the motors ahead of the tool (`backlash_compensation.py`).

A move that stays whole keeps its words, but for the ends that lie elsewhere; of one that is cut, the first piece has
the words that act before a move, the last one those that act after it.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.dialects.codes import MOTION_NAMES
from CNCStepper.gcode.interpreter.state.model import Model
from CNCStepper.gcode.syntax.words import Word
from CNCStepper.gcode.wire.monotonic_split import Piece
from CNCStepper.machine.backlash import SAME_MM
from CNCStepper.toolpath import PLANE_AXES, PLANE_NAMES

AXES, CENTRES = "XYZ", "IJK"
STOPS = frozenset(("M0", "M1", "M2", "M30", "M60"))  # they are executed after the move of their line
DECIMALS = {"mm": 5, "inch": 6}  # at least, of a number that changes: a hundredth of a step, or less
OF_ARCS = (*CENTRES, "R", "P")
MOTIONS = frozenset(MOTION_NAMES)


def crossing(model: Model, stood_mm: Sequence[float], end_mm: Sequence[float], feed_mm_min: float | None = None) -> str:
    """Return the line that takes the motors from elsewhere to `end_mm`, in the modes of `model`.

    feed_mm_min: None is a rapid.
    """
    if model.turn is not None:
        what = "the play of the axes cannot be taken up in coordinates that are turned"
        raise ProgramError("take-up", what, advice="turn the program instead")
    moved = [axis for axis, pair in enumerate(zip(stood_mm, end_mm, strict=True)) if abs(pair[0] - pair[1]) > SAME_MM]
    places = "".join(AXES[axis] + place_text(model, axis, stood_mm, end_mm) for axis in moved)
    if feed_mm_min is None:
        return f"G0{places}"
    way_mm = math.dist(*zip(*((stood_mm[axis], end_mm[axis]) for axis in moved), strict=True))
    return f"G1{places}{_feed_word(model, feed_mm_min, way_mm)}"


def place_text(model: Model, axis: int, stood_mm: Sequence[float], end_mm: Sequence[float]) -> str:
    """Return the number that leads the motor of an axis from where it stood to its end.

    Ways are those between places that are rounded themselves, so that what the digits leave out never adds up.
    """
    if model.absolute:
        return number_text((end_mm[axis] - model.offset[axis]) / model.scale, model)
    digits = DECIMALS[model.state.units]
    stood, end = (round(place[axis] / model.scale, digits) for place in (stood_mm, end_mm))
    return number_text(end - stood, model)


def _feed_word(model: Model, feed_mm_min: float, way_mm: float) -> str:
    """Return the F word of a way at this feed, nothing where the feed in force says it."""
    mode, feed = model.state.feed_mode, feed_mm_min / model.scale
    if mode == "inverse_time":
        feed = feed_mm_min / way_mm
    elif mode == "per_turn":
        feed /= model.state.spindle_rpm
    elif feed_mm_min == model.state.feed_mm_min:
        return ""
    return f"F{number_text(feed, model)}"


class Words:
    """Writes the pieces of one line, in their order.

    model: as it is after the line. centre_mm: of an arc that is cut, None for any other line.
    """

    def __init__(self, words: list[Word], model: Model, pieces: list[Piece], centre_mm: Sequence[float] | None):
        self._model, self._pieces, self._centre_mm = model, pieces, centre_mm
        self._codes = [word for word in words if word.letter in "GM" and word.name not in STOPS]
        self._stops = [word for word in words if word.name in STOPS]
        self._ends = [word for word in words if word.letter in AXES]
        self._others = [word for word in words if word.letter not in ("G", "M", *AXES)]

    def line(self, number: int, stood_mm: Sequence[float], motors_mm: Sequence[float], says_motion: bool) -> str:
        """Return the line of a piece, in which the motors go from `stood_mm` to `motors_mm`.

        says_motion: it must name its motion, since another one is modal on the wire.
        """
        first, last = number == 0, number == len(self._pieces) - 1
        codes = self._codes if first else []
        words = [word.text for word in codes]
        if (says_motion or not first) and not any(word.name in MOTIONS for word in codes):
            words.append(MOTION_NAMES[self._model.motion])
        if self._centre_mm is None:
            words += [self._end(word, motors_mm[AXES.index(word.letter)]) for word in self._ends]
        else:
            words += self._arc_words(self._pieces[number], stood_mm, motors_mm, self._centre_mm)
        words += [self._other(word, number) for word in self._others if first or self._is_shared(word)]
        return "".join([*words, *(word.text for word in self._stops if last)])

    def _end(self, word: Word, motor_mm: float) -> str:
        """Return an axis word with the number at which the motor stands."""
        ahead_mm = motor_mm - self._pieces[-1].end_mm[AXES.index(word.letter)]
        if math.isnan(ahead_mm) or abs(ahead_mm) <= SAME_MM or not self._model.absolute:
            return word.text
        places = len(word.number.partition(".")[2])
        return word.letter + number_text(float(word.number) + ahead_mm / self._model.scale, self._model, places)

    def _arc_words(self, piece: Piece, stood_mm, motors_mm, centre_mm) -> list[str]:
        """Return end and centre of a piece of an arc."""
        model = self._model
        one, two, normal = PLANE_AXES[PLANE_NAMES.index(model.state.plane)]
        named = [one, two] + [normal] * any(word.letter == AXES[normal] for word in self._ends)
        ends = [AXES[axis] + place_text(model, axis, stood_mm, motors_mm) for axis in named]
        arms = [(axis, (centre_mm[axis] - piece.begin_mm[axis]) / model.scale) for axis in (one, two)]
        return ends + [CENTRES[axis] + number_text(arm, model) for axis, arm in arms]

    def _is_shared(self, word: Word) -> bool:
        """Whether every piece needs a word: F, where it belongs to its line's move."""
        return word.letter == "F" and self._model.state.feed_mode == "inverse_time"

    def _other(self, word: Word, number: int) -> str:
        if self._centre_mm is not None and word.letter in OF_ARCS:
            return ""
        share = self._pieces[number].share
        if self._is_shared(word) and share < 1.0:
            return "F" + number_text(float(word.number) / share, self._model)
        return word.text


def number_text(value: float, model: Model, places: int = 0) -> str:
    """Return a number with its last digits trimmed, fine enough for the unit that is in force."""
    text = f"{value:.{max(DECIMALS[model.state.units], places)}f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text
