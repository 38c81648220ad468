# SPDX-License-Identifier: LGPL-2.1-or-later
"""The way that wire lines mean, in machine coordinates, read as they are sent and forgotten as they are done.

lines sent ──► interpreter ──► stretches   | done | maybe under way | sent |
                                                  ^ first           ^ last
"""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass
from math import acos, atan2, ceil, nan, pi

import numpy as np

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.interpret import Interpreter
from CNCStepper.state import Start
from CNCStepper.toolpath import ARC_CW, PLANE_AXES

CHORD_MM = 0.002  # how far a chord may lie inside its arc; the firmware's own default ($12)
SAME_ANGLE = 5e-7  # at most: the firmware takes it for a whole circle


@dataclass(frozen=True)
class Stretch:
    """One row's way: line: of the wire text, from 0. points: float64[k, 3], mm; NaN where nobody knows the place."""

    line: int
    points: np.ndarray


class PlannedPath:
    """The stretches of the lines sent so far that may not be done yet.

    start: how the machine stands. held: lines that say what else is in force there. first: the line, from 0, before
    which it stands. refused: why the way is not known from some line on, or None.
    """

    def __init__(self, lines: Sequence[str], start: Start, held: Sequence[str] = (), first: int = 0):
        self._stretches: deque[Stretch] = deque()
        self.refused: ProgramError | None = None
        self._lines = lines
        self._read = first
        self._interpreter = Interpreter(start)
        self._here = np.array(start.position_mm[:3], float)
        self._stretches.append(Stretch(first - 1, self._here[None]))
        for line in held:
            self._read_line(line)

    def read(self, sent: int) -> None:
        """Read the lines up to `sent`."""
        while self._read < sent and self.refused is None:
            self._read_line(self._lines[self._read])
            self._read += 1

    @property
    def line(self) -> int:
        """The first line of the wire text, from 0, that may not be done; -1 before all."""
        return self._stretches[0].line

    @property
    def end_mm(self) -> tuple[float, ...] | None:
        """Where the last line read ends; None where nobody knows."""
        return None if np.isnan(self._here).any() else tuple(self._here.tolist())

    def drop_planned_before(self, acknowledged: int, queued: int) -> None:
        """Forget what is done for sure: the lines that are `acknowledged` are planned, and `queued` may wait then."""
        planned = sum(stretch.line < acknowledged for stretch in self._stretches)
        self._drop(planned - queued)

    def drop_to(self, place_mm: Sequence[float], near_mm: Sequence[float]) -> bool:
        """Forget what lies before the first stretch at a place; return whether there is one.

        near_mm: how far away it may be, by axis. Where nobody knows the path, every place is on it.
        """
        away = self._away(np.asarray(place_mm), np.asarray(near_mm))
        there = np.flatnonzero(~(away > 1.0))
        if len(there):
            self._drop(int(there[0]))
        return bool(len(there))

    def ends_at(self, place_mm: Sequence[float], near_mm: Sequence[float]) -> bool:
        """Return whether the last line read leads to a place, or nobody knows where."""
        return not np.any(np.abs(self._here - place_mm) > near_mm)

    def _drop(self, count: int) -> None:
        for _ in range(count):
            self._stretches.popleft()

    def _away(self, place: np.ndarray, near: np.ndarray) -> np.ndarray:
        """Return how far a place is from each stretch, in allowed distances; NaN where a stretch is not known."""
        points = np.concatenate([stretch.points for stretch in self._stretches]) / near
        lasts = np.cumsum([len(stretch.points) for stretch in self._stretches]) - 1
        ends = np.append(points[1:], points[-1:], axis=0)
        ends[lasts] = points[lasts]  # the next stretch has a begin of its own
        firsts = np.append(0, lasts[:-1] + 1)
        return np.minimum.reduceat(distances(place / near, points, ends), firsts)

    def _read_line(self, text: str) -> None:
        table = self._interpreter.table
        try:
            if text.startswith("$"):
                raise ProgramError("path-unknown", f"'{text}' moves as only the controller knows")
            self._interpreter.line(text)
        except ProgramError as error:
            self._lose(error)
            return
        for chunk in table.take():
            for row in range(len(chunk)):
                end = chunk.end[row, :3]
                centre, turns = chunk.centre[row], int(chunk.turns[row])
                clockwise, plane = int(chunk.kind[row]) == ARC_CW, int(chunk.plane[row])
                points = arc_points(self._here, end, centre, plane, turns, clockwise) if turns else end[None]
                self._add(np.vstack([self._here, points]))
        if any(event.kind == "probe" for event in table.events):
            self._lose(ProgramError("path-unknown", "where a probe stops only the controller knows"))
        table.events.clear()

    def _lose(self, error: ProgramError) -> None:
        self.refused = error
        self._add(np.full((1, 3), nan))

    def _add(self, points: np.ndarray) -> None:
        self._stretches.append(Stretch(self._read, points))
        self._here = points[-1]


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
    sweep = (sweep if SAME_ANGLE < sweep < 2 * pi - SAME_ANGLE else 2 * pi) + 2 * pi * (turns - 1)
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
