# SPDX-License-Identifier: LGPL-2.1-or-later
"""The records of a line as the lathe will run them: text, steps and time of each, and the modes behind it.

    G01X-10.F1.#G01Z-50.F1.#   ──►   two records, each with its "#"

Nothing of a line counts unless all of it can be read. A coordinate is rounded to steps record by record, since the
lathe counts its position in steps alone.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from CNCStepper.controllers.lathe import step_times
from CNCStepper.controllers.lathe.step_times import Move, Steps
from CNCStepper.errors import MachineRefusal, ProgramError
from CNCStepper.gcode.dialects import Dialect
from CNCStepper.gcode.dialects.codes import MOTION_NAMES
from CNCStepper.gcode.dialects.preprocessor import pieces
from CNCStepper.gcode.syntax.words import Word, words_of
from CNCStepper.toolpath import LINE, RAPID
from CNCStepper.units import MM_PER_INCH
from CNCStepper.virtual.grbl.alarms_and_errors import refused

END = "M2"
AXES = "XZ"
DIAMETER, RADIUS = "G7", "G8"  # the names of RS274
NO_WORD, NO_FEED, NO_AXIS, UNKNOWN, TOO_LONG, TWICE = 1, 22, 26, 20, 11, 25  # grbl's errors


@dataclass(frozen=True)
class Modes:
    """What is in force between two records; feed_mm_s: of the run of G01. place: steps from the program's zero."""

    motion: int | None = None
    feed_mm_s: float | None = None
    absolute: bool = False
    unit_mm: float = 1.0
    is_diameter: bool = False
    place: Steps = (0, 0)


@dataclass(frozen=True)
class Record:
    """One record: its text with "#", its move (None where it has none), the modes behind it.

    opening: the text where it opens a chunk, which must begin with a G or M word. begins_feed: a run of G01.
    """

    text: str
    opening: str
    move: Move | None
    modes: Modes
    ends_program: bool = False
    begins_feed: bool = False

    @property
    def lasts_s(self) -> float:
        """Its duration, by the published waits."""
        return self.move.lasts_s if self.move else 0.0


class RecordReader:
    """Reads lines of records; steps_per_mm: of X and Z. longest: bytes of a record, with "#"."""

    def __init__(self, dialect: Dialect, steps_per_mm: tuple[float, float], longest: int):
        self._codes = dialect.codes
        self._dialect = dialect
        self._per_mm = steps_per_mm
        self._longest = longest

    def first_modes(self) -> Modes:
        """Return the modes at the begin of automatic mode."""
        return Modes(absolute=self._dialect.distance == "absolute")

    def read(self, line: str, modes: Modes) -> list[Record]:
        """Return the records of a line; raises MachineRefusal with grbl's error and changes nothing."""
        if not line.endswith("#"):
            raise refused(UNKNOWN)
        found: list[Record] = []
        for text in line.removesuffix("#").split("#"):
            if text:
                found.append(self._record(f"{text}#", modes))
                modes = found[-1].modes
        return found

    def _record(self, text: str, modes: Modes) -> Record:
        words = self._words(text)
        before, modes = modes.motion, self._followed(words, modes)
        if len(self._opening(text, words, modes)) > self._longest:
            raise refused(TOO_LONG)
        move, modes = self._moved(words, modes)
        ends = any(word.name == END for word in words)
        begins_feed = move is not None and modes.motion == LINE and before != LINE
        return Record(text, self._opening(text, words, modes), move, modes, ends, begins_feed)

    def _words(self, text: str) -> list[Word]:
        """Return the words in the form of RS274: numbers with their point, F in mm or inches a minute."""
        try:
            words = [word for piece in pieces(text, self._dialect) for word in words_of(piece.text)]
        except ProgramError as error:
            raise MachineRefusal(f"error:{NO_WORD}", error.text) from error
        words = [word for word in words if word.letter != "N"]
        letters = [word.letter for word in words if word.letter not in "G"]
        if len(set(letters)) < len(letters):
            raise refused(TWICE)
        for word in words:
            if word.letter in "GM" and word.name not in self._codes:
                raise refused(UNKNOWN)
            if word.letter not in "GMXZF":
                raise refused(UNKNOWN)
        return words

    def _followed(self, words: list[Word], modes: Modes) -> Modes:
        """Return the modes after a record."""
        for code in (self._codes[word.name] for word in words if word.letter in "GM"):
            if code.motion is not None:
                modes = replace(modes, motion=code.motion, feed_mm_s=None)
            elif code.group == "units":
                modes = replace(modes, motion=None, unit_mm=MM_PER_INCH if code.sets["units"] == "inch" else 1.0)
            elif code.group == "distance":
                modes = replace(modes, motion=None, absolute=code.sets["distance"] == "absolute")
            else:
                is_diameter = {DIAMETER: True, RADIUS: False}.get(code.name, modes.is_diameter)
                modes = replace(modes, motion=None, is_diameter=is_diameter)
        if feeds := [float(word.number) for word in words if word.letter == "F"]:
            modes = replace(modes, feed_mm_s=feeds[0] / 60.0 * modes.unit_mm)
        return modes

    def _moved(self, words: list[Word], modes: Modes) -> tuple[Move | None, Modes]:
        ways = {word.letter: float(word.number) for word in words if word.letter in AXES}
        if not ways:
            return None, modes
        if modes.motion not in (RAPID, LINE) or (modes.absolute and len(ways) < len(AXES)):
            raise refused(NO_AXIS)
        if modes.motion == LINE and not (modes.feed_mm_s and modes.feed_mm_s > 0.0):
            raise refused(NO_FEED)
        steps = self._steps(ways, modes)
        place = (modes.place[0] + steps[0], modes.place[1] + steps[1])
        if modes.motion == RAPID:
            return step_times.rapid(steps), replace(modes, place=place)
        assert modes.feed_mm_s
        return step_times.feed(steps, modes.feed_mm_s, self._per_mm), replace(modes, place=place)

    def _steps(self, ways: dict[str, float], modes: Modes) -> Steps:
        found = [0, 0]
        for axis, letter in enumerate(AXES):
            if letter in ways:
                share = 0.5 if modes.is_diameter and letter == "X" else 1.0
                steps = _nearest(ways[letter] * modes.unit_mm * share * self._per_mm[axis])
                found[axis] = steps - modes.place[axis] if modes.absolute else steps
        return found[0], found[1]

    def _opening(self, text: str, words: list[Word], modes: Modes) -> str:
        """Return a record's text with its motion, and the feed that the G01 then needs."""
        if not words or words[0].letter in "GM" or modes.motion is None:
            return text
        name = MOTION_NAMES[modes.motion].removeprefix("G")
        code = f"G{int(name):02d}"
        lacks_feed = modes.motion == LINE and modes.feed_mm_s and not any(word.letter == "F" for word in words)
        after = f"F{(modes.feed_mm_s or 0.0) / modes.unit_mm:.4f}" if lacks_feed else ""
        return f"{code}{text.removesuffix('#')}{after}#"


def _nearest(value: float) -> int:
    """Return the nearest whole number, halves up."""
    return math.floor(value + 0.5)
