# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shorter programs: runs of small straight moves become few longer lines, arcs and helices within a tolerance.

    G1 X1. F800      kept: it sets the feed
    X1.05            \\
    X1.1 Y.05         |  a run: nothing but straight moves at one feed, in one state
    ...               |  -> G3 X4. Y2. I.. J..
    X4. Y2.          /
    (here we are)    kept: every line with a comment, event, output, other motion or change of state

What is no run stays as it is written. The ends of the new moves are ends of old ones, so only the centres of arcs are
rounded; how far an arc as it is written leaves the old way is measured, and where that is too far lines take its place.

Writes a run of straight moves as few lines, arcs and helices, in the manner of the lines before.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import dataclass, replace
from math import isnan
from typing import NamedTuple

import numpy as np

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.dialects import Dialect, dialect_named
from CNCStepper.gcode.dialects.codes import AXES, MOTION_NAMES, NO_MOTION, PLANE_CODES
from CNCStepper.gcode.edit.edit_result import Edited, Lines
from CNCStepper.gcode.edit.line_states import is_compensated, require_straight, work_place
from CNCStepper.gcode.edit.line_tokens import changed, first_place, is_plain, tokens_of
from CNCStepper.gcode.edit.word_values import MOST_DECIMALS, decimals_of, dialect_decimals, number_text
from CNCStepper.gcode.interpreter.line_interpreter import Interpreter
from CNCStepper.gcode.interpreter.motion.arcs import sweep
from CNCStepper.gcode.syntax.words import NUMBER
from CNCStepper.gcode.writer.rounded_arcs import Limits, TrueArc, rounded
from CNCStepper.geometry.fitting.space_fit import PLANES, Piece, fit_space, serves_points, straight
from CNCStepper.state import Start
from CNCStepper.tolerances import SAME_SUM_MM
from CNCStepper.toolpath import ARC_CCW, ARC_CW, LINE, PLANE_NAMES

ARC_SHARE = 1.5  # last digits that an arc is kept away from the tolerance, for its centre will be rounded
LARGEST_RADIUS_MM = 2000.0  # where a dialect has none
_NUMBERS = re.compile(r"[XYZ]([-+0-9. \t]+)", re.IGNORECASE)


@dataclass
class Run:
    """How the lines of a run are to be read and written.

    plane: the one in force, by name. motion: the one in force before the run. decimals, fewest: the most and the fewest
    digits after the point that its lines have. blanks: whether blanks stand between the words.
    """

    dialect: Dialect
    units: str
    scale_mm: float
    absolute: bool
    absolute_centres: bool
    plane: str
    motion: int
    decimals: int = 0
    fewest: int = MOST_DECIMALS
    blanks: bool = False

    def tell(self, line: str) -> None:
        """Note how a line of the run is written."""
        self.blanks = self.blanks or " " in line.strip()
        for number in _NUMBERS.findall(line):
            digits = decimals_of(number)
            self.decimals, self.fewest = max(self.decimals, digits), min(self.fewest, digits)

    @property
    def digits(self) -> int:
        """The decimals of new numbers."""
        return max(self.decimals, dialect_decimals(self.dialect, self.units))

    @property
    def step_mm(self) -> float:
        """The last digit in mm."""
        return self.scale_mm / 10**self.digits


class New(NamedTuple):
    """The lines of a rewritten run; places: the point of the run (from 0) before each line's last one; owed: the word
    that a straight move after them needs."""

    lines: list[str]
    places: list[int]
    owed: str


def written(points: np.ndarray, run: Run, tolerance_mm: float) -> New | None:
    """Return the run as few lines as serve it, or None where the tolerance is too small for its digits."""
    fit_mm = tolerance_mm - ARC_SHARE * run.step_mm
    if not fit_mm > 0:
        return None
    places = np.nan_to_num(points)
    keep = np.concatenate([[True], (np.abs(np.diff(places, axis=0)) > SAME_SUM_MM).any(axis=1)])
    numbers = np.flatnonzero(keep)
    places = np.round(places[keep] / run.step_mm) * run.step_mm  # what adding up left is no height and no move
    writer = _RunWriter(run, places, tolerance_mm)
    first = 0
    for piece in fit_space(places, fit_mm):
        writer.piece(first, piece)
        first = piece.last
    writer.end()
    return New(writer.lines, [int(numbers[place]) - 1 for place in writer.ends], writer.owed)


class _RunWriter:
    def __init__(self, run: Run, points: np.ndarray, tolerance_mm: float):
        self.run = run
        self.points = points
        self.tolerance_mm = tolerance_mm
        self.lines: list[str] = []
        self.ends: list[int] = []
        self._motion = run.motion
        self._plane = PLANE_NAMES.index(run.plane)
        self._line_word = _word(run.dialect, LINE)
        self._limits = _limits(run)

    @property
    def owed(self) -> str:
        return "" if self._motion == LINE else self._line_word

    def piece(self, first: int, piece: Piece) -> None:
        """Write a piece that begins at the point `first`; lines where the arc cannot be written well enough."""
        if piece.bulge and self._may_arc(piece.plane):
            centre = self._centre(first, piece)
            if centre is not None:
                self._arc(first, piece, centre)
                return
        if not piece.bulge:
            self._line(first, piece.last)
            return
        begin = first
        for one in straight(self.points[begin : piece.last + 1], self.tolerance_mm):
            self._line(first, begin + one.last)
            first = begin + one.last

    def end(self) -> None:
        """Take back the plane that was in force."""
        own = PLANE_NAMES.index(self.run.plane)
        if self._plane != own:
            self._put([PLANE_CODES[own]], self.ends[-1])

    def _may_arc(self, plane: int) -> bool:
        own = plane == self._plane or PLANE_CODES[plane] in self.run.dialect.codes
        return own and not (self.run.absolute_centres and not self.run.absolute)

    def _line(self, first: int, last: int) -> None:
        words = [self._line_word] if self._motion != LINE else []
        self._motion = LINE
        self._put([*words, *self._axis_words(first, last, ())], last)

    def _arc(self, first: int, piece: Piece, offset: tuple[int, int]) -> None:
        plane = PLANES[piece.plane]
        words = [PLANE_CODES[piece.plane]] if piece.plane != self._plane else []
        kind = ARC_CCW if piece.bulge > 0 else ARC_CW
        words += [_word(self.run.dialect, kind)] if kind != self._motion or words else []
        self._motion, self._plane = kind, piece.plane
        words += self._axis_words(first, piece.last, plane[:2])
        counts = dict(zip(plane[:2], offset, strict=True))
        for axis in sorted(counts):
            begin = self.points[first][axis] if self.run.absolute_centres else 0.0
            words.append("IJK"[axis] + self._number(begin / self.run.scale_mm + counts[axis] / 10**self.run.digits))
        self._put(words, piece.last)

    def _axis_words(self, first: int, last: int, always: tuple[int, ...]) -> list[str]:
        begin, end = self.points[first], self.points[last]
        ways = end if self.run.absolute else end - begin
        return [
            AXES[axis] + self._number(float(ways[axis]) / self.run.scale_mm)
            for axis in range(3)
            if axis in always or begin[axis] != end[axis]
        ]

    def _number(self, value: float) -> str:
        least = self.run.fewest if self.run.fewest == self.run.decimals else 0
        return number_text(value, self.run.digits, least)

    def _put(self, words: list[str], last: int) -> None:
        self.lines.append((" " if self.run.blanks else "").join(words))
        self.ends.append(last)

    def _centre(self, first: int, piece: Piece) -> tuple[int, int] | None:
        """Return the rounded centre from the begin in last digits, where the arc that it makes serves; else None."""
        a, b, _ = PLANES[piece.plane]
        exact = self.points[[first, piece.last]][:, [a, b]] / self.run.step_mm
        (x0, y0), (x1, y1) = np.round(exact).astype(int).tolist()
        half, middle = complex(x1 - x0, y1 - y0) / 2.0, complex(x0 + x1, y0 + y1) / 2.0
        centre = middle + half * 1j * (1.0 / piece.bulge - piece.bulge) / 2.0
        clockwise = piece.bulge < 0
        arc = TrueArc((x0, y0), (x1, y1), (centre.real, centre.imag), clockwise)
        pieces = rounded((x0, y0), arc, self._limits) if arc.radius <= self._limits.largest_radius else ()
        if len(pieces) != 1 or pieces[0].offset is None or pieces[0].end != (x1, y1):
            return None
        offset = pieces[0].offset
        bulge, slack = _as_written((x0, y0), (x1, y1), offset, clockwise)
        points = self.points[first : piece.last + 1]
        good = serves_points(points, piece.plane, bulge, self.tolerance_mm - slack * self.run.step_mm)
        return offset if good else None


def _as_written(
    begin: tuple[int, int], end: tuple[int, int], offset: tuple[int, int], clockwise: bool
) -> tuple[float, float]:
    """Return the bulge of the arc that a controller makes of rounded numbers, and how far it may be from that arc.

    Its radius goes from that at the begin to that at the end; the arc through both ends and the same angle lies
    within the difference of the radii from it.
    """
    centre = (begin[0] + offset[0], begin[1] + offset[1])
    angle = sweep(begin, end, centre, clockwise)
    radii = math.hypot(*offset), math.hypot(end[0] - centre[0], end[1] - centre[1])
    bulge = math.tan(angle / 4.0) * (-1.0 if clockwise else 1.0)
    half, middle = complex(end[0] - begin[0], end[1] - begin[1]) / 2.0, complex(begin[0] + end[0], begin[1] + end[1])
    apex = middle / 2.0 - 1j * half * bulge
    away = abs(abs(apex - complex(*centre)) - sum(radii) / 2.0)
    return bulge, abs(radii[0] - radii[1]) + away


def _limits(run: Run) -> Limits:
    rule = run.dialect.arc_rules[run.units]
    counts = 10**run.digits
    in_counts = replace(
        rule, slack=rule.slack * counts, gap=rule.gap * counts, smallest_radius=rule.smallest_radius * counts
    )
    largest_mm = run.dialect.writing.largest_radius_mm if run.dialect.writing else LARGEST_RADIUS_MM
    return Limits(in_counts, 0.0, largest_mm / run.step_mm)


def _word(dialect: Dialect, motion: int) -> str:
    code = dialect.motion_code(motion)
    return code.name if code else MOTION_NAMES[motion]


LEAST_MOVES = 2  # fewer are no run
_SMALL = re.compile(rf"(?:N[0-9.]+)?(?:G0*1(?![0-9.]))?(?:[XYZF]{NUMBER})+")
_MOTIONS = frozenset(MOTION_NAMES)


@dataclass
class _Gathered:
    """A run while it is read: its line numbers (from 0) and the places that it goes through, work mm."""

    lines: list[int]
    points: list[tuple[float, ...]]
    run: Run


def compact(
    text: str, tolerance_mm: float, dialect: str | Dialect = "grbl", start: Start | None = None, file: str = ""
) -> Edited:
    """Return the program with its runs of straight moves rewritten, never farther than `tolerance_mm` from the old way.

    The distance is measured both ways, curve to curve, in space. Raises ProgramError for a text that cannot be read,
    that has subroutines or loops, or a tolerance that is not above 0.
    """
    if not tolerance_mm > 0:
        advice = "give a tolerance above 0"
        raise ProgramError("tolerance", "the tolerance must be above 0", value=f"{tolerance_mm:g} mm", advice=advice)
    language, source = dialect_named(dialect), Lines(text)
    require_straight(text, language, file)
    lines: list[str] = []
    origins: list[int] = []
    owed = ""  # the motion word that the next straight move needs
    for item in _items(source.lines, language, start, file):
        if isinstance(item, _Gathered):
            item.run.motion = NO_MOTION if owed else item.run.motion
            new = written(np.array(item.points), item.run, tolerance_mm)
            if new is not None and len(new.lines) < len(item.lines):
                lines += new.lines
                origins += [item.lines[place] + 1 for place in new.places]
                owed = new.owed
                continue
            kept = [(number, True) for number in item.lines]
        else:
            kept = [item]
        for number, is_straight in kept:
            line = source.lines[number]
            if owed:
                line, owed = _with_motion(line, owed, is_straight)
            lines.append(line)
            origins.append(number + 1)
    return source.edited(lines, origins)


def _items(
    lines: list[str], language: Dialect, start: Start | None, file: str
) -> Iterator[_Gathered | tuple[int, bool]]:
    """Yield runs, and between them (number of a line, whether it makes a straight move)."""
    reader = Interpreter(start, language, file)
    run: _Gathered | None = None
    for number, line in enumerate(lines):
        before = _look(reader)
        reader.line(line)
        straight = reader.table.index == before.index + 1 and reader.model.motion == LINE
        if straight and _may_join(reader, before, line, language):
            if run is None:
                run = _Gathered([], [before.work], _run_of(reader, before, language))
            run.lines.append(number)
            run.points.append(work_place(reader))
            run.run.tell(line)
            continue
        if run is not None:
            yield from _ended(run)
            run = None
        yield number, straight
    if run is not None:
        yield from _ended(run)
    reader.toolpath()


@dataclass(frozen=True)
class _Look:
    """What the reader holds before a line."""

    index: int
    states: int
    events: int
    motion: int
    work: tuple[float, ...]


def _look(reader: Interpreter) -> _Look:
    table = reader.table
    return _Look(table.index, len(table.states), len(table.events), reader.model.motion, work_place(reader))


def _may_join(reader: Interpreter, before: _Look, line: str, language: Dialect) -> bool:
    """Whether a line is nothing but a straight move in the state of the lines before it."""
    table, state = reader.table, reader.model.state
    same = len(table.states) == before.states and len(table.events) == before.events
    steady = same and reader.model.plain and state.path_mode != "exact_stop"
    if not steady or is_compensated(reader) or reader.model.turn is not None or len(before.work) != 3:
        return False
    if state.distance != "absolute" and language.motion_code(LINE) != language.codes.get("G1"):
        return False
    known = not any(isnan(value) for value in before.work[:2])
    moved = before.work != work_place(reader)
    return known and moved and _SMALL.fullmatch("".join(line.split()).upper()) is not None


def _run_of(reader: Interpreter, before: _Look, language: Dialect) -> Run:
    state = reader.model.state
    return Run(
        dialect=language,
        units=state.units,
        scale_mm=reader.model.scale,
        absolute=state.distance == "absolute",
        absolute_centres=state.arc_centres == "absolute",
        plane=state.plane,
        motion=before.motion,
    )


def _ended(run: _Gathered) -> Iterator[_Gathered | tuple[int, bool]]:
    if len(run.lines) >= LEAST_MOVES:
        yield run
    else:
        yield from ((number, True) for number in run.lines)


def _with_motion(line: str, word: str, straight: bool) -> tuple[str, str]:
    """Return a kept line, with a motion word where it needs one, and the words that the next line must repeat."""
    if any(token.name in _MOTIONS for token in tokens_of(line)) or not is_plain(line):
        return line, ""
    if not straight:
        return line, word
    at = first_place(line)
    return changed(line, [(at, at, f"{word} ")]), ""
