# SPDX-License-Identifier: LGPL-2.1-or-later
"""The path of the wire lines, in machine coordinates, read as they are sent and discarded as they are done.

lines sent ──► interpreter ──► moves   | done | maybe under way | sent |
                                              ^ first           ^ last
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import acos, atan2, ceil, nan, pi

import numpy as np

from CNCStepper.control.program.wire_line import ARCS
from CNCStepper.control.stream.backlash_side import BacklashTracker
from CNCStepper.errors import ProgramError, Text
from CNCStepper.gcode.interpreter.line_interpreter import Interpreter
from CNCStepper.machine.pulse_letters import COMMAND as LETTERS
from CNCStepper.machine.pulse_letters import letter_steps
from CNCStepper.state import Start, States
from CNCStepper.tolerances import FULL_CIRCLE_RAD
from CNCStepper.toolpath import ARC_CW, PLANE_AXES, Chunk

CHORD_MM = 0.002  # how far a chord may lie inside its arc; the firmware's own default ($12)
WATCH = "watch the machine until the job ends"


@dataclass(frozen=True)
class PathSegments:
    """Straight pieces of way, one after the other, in machine coordinates.

    begins, ends: float64[n, 3], mm; NaN where nobody knows the place. lines: int64[n], the line of the wire text that
    each is of, from 0. rows: int64[n], rising by one from line to line that goes some way: how a controller makes the
    moves of one line, an arc's chords or a drilling cycle's pecks, is its own matter.
    """

    begins: np.ndarray
    ends: np.ndarray
    rows: np.ndarray
    lines: np.ndarray

    def __len__(self) -> int:
        return len(self.rows)

    def from_row(self, row: int) -> PathSegments:
        """Return those of a row and all after it."""
        first = int(np.searchsorted(self.rows, row))
        return PathSegments(self.begins[first:], self.ends[first:], self.rows[first:], self.lines[first:])

    def with_moves(self, points: np.ndarray, counts: np.ndarray, lines: np.ndarray) -> PathSegments:
        """Return them with further moves: points float64[k, 3] that they lead to, counts and lines one a move."""
        begins, lines = np.concatenate([self.ends[-1:], points[:-1]]), np.repeat(lines, counts)
        rows = _rows_after(self.rows[-1], self.lines[-1], lines, (begins != points).any(axis=1))
        return PathSegments(
            np.concatenate([self.begins, begins]),
            np.concatenate([self.ends, points]),
            np.concatenate([self.rows, rows]),
            np.concatenate([self.lines, lines]),
        )


class PlannedPath:
    """The moves of the lines sent so far that may not be done yet; there is always one, at first where it begins.

    start: how the machine stands. held: lines that say what else is in force there. first: the line, from 0, before
    which it stands. gaps: follow the moves, where there is play. dialect: the controller's. refused: why the way is not
    known from the line `lost_at` (from 0) on, or None. step_mm: of the axes, where lines of pulse letters may come.
    """

    def __init__(
        self,
        lines: Sequence[str],
        start: Start,
        held: Sequence[str] = (),
        first: int = 0,
        gaps: BacklashTracker | None = None,
        dialect: str = "grbl",
        step_mm: Sequence[float] = (),
    ):
        self.refused: ProgramError | None = None
        self.lost_at = 0
        self._lines = lines
        self._gaps = gaps
        self._step_mm = np.asarray(step_mm, float)
        self._by_letters = False  # whether the place is no longer the interpreter's
        self._read = first
        self._interpreter = Interpreter(start, dialect)
        here = np.array([start.position_mm[:3]], float)
        self._pieces = PathSegments(here, here, np.array([0]), np.array([first - 1]))
        self._lines_before = first - 1  # of the line from which the interpreter counts
        for line in held:
            self._take_held(line)
        self._take_moves()

    def read(self, sent: int) -> None:
        """Read the lines up to `sent`, and take their moves."""
        self.read_on(sent)
        self._take_moves()

    def read_on(self, sent: int) -> None:
        """Read lines whose moves the next `read` takes, so that it has few left to read."""
        while self._read < sent and self.refused is None:
            self._read_line(self._lines[self._read])
            self._read += 1

    @property
    def line(self) -> int:
        """The first line of the wire text, from 0, that may not be done; -1 before all."""
        return int(self._pieces.lines[0])

    @property
    def end_mm(self) -> tuple[float, ...] | None:
        """The end of the last line read; None where it is unknown."""
        here = self._pieces.ends[-1]
        return None if np.isnan(here).any() else tuple(here.tolist())

    def drop_planned_before(self, acknowledged: int, queued: int) -> None:
        """Discard moves that are certainly done: `acknowledged` lines are planned, and `queued` moves may wait."""
        planned = int(np.searchsorted(self._pieces.lines, acknowledged))
        if planned:
            self._pieces = self._pieces.from_row(self._pieces.rows[planned - 1] + 1 - queued)

    def drop_to(self, place_mm: Sequence[float], near_mm: Sequence[float]) -> bool:
        """Forget what lies before the first move at a place; return whether there is one.

        near_mm: how far away it may be, by axis. Every place is on an unknown path.
        """
        near, pieces = np.asarray(near_mm), self._pieces
        away = distances(np.asarray(place_mm) / near, pieces.begins / near, pieces.ends / near)
        there = np.flatnonzero(~(away > 1.0))
        if len(there):
            self._pieces = pieces.from_row(pieces.rows[there[0]])
        return bool(len(there))

    def ends_at(self, place_mm: Sequence[float], near_mm: Sequence[float]) -> bool:
        """Return whether the last line read ends at a place, or its end is unknown."""
        return not np.any(np.abs(self._pieces.ends[-1] - place_mm) > near_mm)

    def _take_held(self, text: str) -> None:
        if text in ARCS:
            self._interpreter.repeat(text)
        else:
            self._lines_before -= 1
            self._read_line(text)

    def _read_line(self, text: str) -> None:
        table = self._interpreter.table
        try:
            if text.startswith(LETTERS) and len(self._step_mm):
                self._take_letters(text)
                return
            if (self._by_letters and not text.startswith("M")) or text.startswith("$"):
                what = Text("'{text}' is a move whose end only the controller knows", text=text)
                raise ProgramError("path-unknown", what, advice=WATCH)
            self._interpreter.line(text)
        except ProgramError as error:
            self._lose(error)
        if table.events:
            if any(event.kind == "probe" for event in table.events):
                why = "only the controller knows where a probe stops"
                self._lose(ProgramError("path-unknown", why, advice=WATCH))
            table.events.clear()

    def _take_letters(self, text: str) -> None:
        """Append the path of a line of pulse letters."""
        self._take_moves()
        moves = np.array([letter_steps(letter) for letter in text.removeprefix(LETTERS)], float)
        points = self._pieces.ends[-1] + np.cumsum(moves, axis=0) * self._step_mm
        self._pieces = self._pieces.with_moves(points, np.array([len(points)]), np.array([self._read]))
        self._lines_before += 1
        self._by_letters = True

    def _lose(self, error: ProgramError) -> None:
        self._take_moves()
        self.refused, self.lost_at = error, self._read
        self._pieces = self._pieces.with_moves(np.full((1, 3), nan), np.ones(1, int), np.array([self._read]))

    def _take_moves(self) -> None:
        """Append the interpreter's moves, and discard its other results."""
        table = self._interpreter.table
        for chunk in table.take():
            if self._gaps:
                self._gaps.follow(self._pieces.ends[-1], chunk.end[:, :3])
            points, counts = way_of(chunk, self._pieces.ends[-1])
            self._pieces = self._pieces.with_moves(points, counts, chunk.line + self._lines_before)
        table.states = States(table.states[-1:])
        table.spans.clear()


def _rows_after(row: int, line: int, lines: np.ndarray, goes: np.ndarray) -> np.ndarray:
    """Return the rows of pieces after one of a row and line: a line that goes nowhere takes no place in the planner."""
    begun = np.flatnonzero(np.diff(lines, prepend=line))  # where each line begins
    first = np.zeros(len(lines), int)
    first[begun] = np.logical_or.reduceat(goes, begun) if len(begun) else 0
    return row + np.cumsum(first)


def way_of(chunk: Chunk, here: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the points that moves from a place lead to, float64[k, 3], mm, and how many are of each, int64[moves]."""
    ends = chunk.end[:, :3]
    if not chunk.turns.any():
        return ends, np.ones(len(ends), int)
    ways = []
    for row, end in enumerate(ends):
        turns, clockwise = int(chunk.turns[row]), int(chunk.kind[row]) == ARC_CW
        arc = arc_points(here, end, chunk.centre[row], int(chunk.plane[row]), turns, clockwise) if turns else end[None]
        ways.append(arc)
        here = end
    return np.concatenate(ways), np.array([len(way) for way in ways])


def arc_points(
    begin: np.ndarray, end: np.ndarray, centre: np.ndarray, plane: int, turns: int, clockwise: bool
) -> np.ndarray:
    """Return the points of an arc or helix after its begin, float64[k, 3]; all as in the table of moves, mm."""
    first, second, _ = PLANE_AXES[plane]
    radius_mm = float(np.hypot(begin[first] - centre[first], begin[second] - centre[second]))
    if not radius_mm > CHORD_MM:
        return end[None]
    begins, ends = (atan2(place[second] - centre[second], place[first] - centre[first]) for place in (begin, end))
    sweep = (begins - ends if clockwise else ends - begins) % (2 * pi)
    sweep = (sweep if FULL_CIRCLE_RAD < sweep < 2 * pi - FULL_CIRCLE_RAD else 2 * pi) + 2 * pi * (turns - 1)
    count = ceil(sweep / (2 * acos(1 - CHORD_MM / radius_mm)))
    shares = np.arange(1, count + 1) / count
    angles = begins + (-sweep if clockwise else sweep) * shares
    points = begin + (end - begin) * shares[:, None]
    points[:, first] = centre[first] + radius_mm * np.cos(angles)
    points[:, second] = centre[second] + radius_mm * np.sin(angles)
    points[-1] = end
    return points


def distances(place: np.ndarray, begins: np.ndarray, ends: np.ndarray) -> np.ndarray:
    """Return the distance of a place from each straight line, float64[n]."""
    ways = ends - begins
    lengths2 = np.einsum("ij,ij->i", ways, ways)
    shares = np.einsum("ij,ij->i", place - begins, ways) / np.where(lengths2 > 0, lengths2, 1.0)
    return np.linalg.norm(begins + np.clip(shares, 0.0, 1.0)[:, None] * ways - place, axis=1)
