# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far a program is cut, from the controller's status reports, and the path of the reported positions.

report: lines cut and sent, position ──► rows that may be under way ──► the nearest place on them ──► planned time
"""

from __future__ import annotations

import numpy as np

from CNCStepper.simulation.tip_track import TipTrack

MOST_ROWS = 256  # that are looked at for one report
PLACES = np.linspace(0.0, 1.0, 9)  # of a row that are compared with the position
NEAR_MM = 1.0  # farther away the tool is not on its path: it was led aside
AS_NEAR_MM = 0.05  # of several places as near, the earliest counts
MOST_POINTS = 4000  # of a path; when it is full every other point goes


class TipFollower:
    """The planned time up to which a program is cut; it never goes back."""

    def __init__(self, moves: TipTrack):
        self._moves = moves
        self.row, self.time_s = 0, 0.0

    def follow(self, cut_line: int, sent_line: int, tip_mm: np.ndarray) -> float:
        """Return the time for a report: the last lines that are surely cut and sent, the position, float64[3]."""
        moves = self._moves
        if not len(moves):
            return self.time_s
        first = max(self.row, moves.row_of_line(cut_line) if cut_line else 0)
        rows = np.arange(first, min(max(moves.row_of_line(sent_line), first) + 1, first + MOST_ROWS))
        row, time_s = self._nearest(rows, tip_mm)
        if time_s > self.time_s:
            self.row, self.time_s = row, time_s
        return self.time_s

    def _nearest(self, rows: np.ndarray, tip_mm: np.ndarray) -> tuple[int, float]:
        """Return the row and the time of the place of some rows that is nearest; their begin where none is near."""
        moves = self._moves
        shares = np.tile(PLACES, len(rows))
        rows = np.repeat(rows, len(PLACES))
        away_mm = np.linalg.norm(moves.tips_mm(rows, shares) - tip_mm, axis=1)
        away_mm = np.where(np.isfinite(away_mm), away_mm, np.inf)
        nearest_mm = away_mm.min()
        if nearest_mm > NEAR_MM:
            return int(rows[0]), float(moves.begins_s[rows[0]])
        place = int(np.argmax(away_mm <= nearest_mm + AS_NEAR_MM))
        row = int(rows[place])
        return row, float(moves.begins_s[row] + shares[place] * (moves.ends_s[row] - moves.begins_s[row]))


class ReportedPath:
    """The positions that were reported, in a memory that does not grow."""

    def __init__(self) -> None:
        self._points = np.zeros((MOST_POINTS, 3), np.float32)
        self._count = 0

    @property
    def points_mm(self) -> np.ndarray:
        """The path, float32[n, 3]."""
        return self._points[: self._count]

    def add(self, tip_mm: np.ndarray) -> bool:
        """Add a position; return whether the path has changed by that."""
        if not np.isfinite(tip_mm).all():
            return False
        if self._count and np.abs(self._points[self._count - 1] - tip_mm).max() < AS_NEAR_MM:
            return False
        if self._count == MOST_POINTS:
            self._count = MOST_POINTS // 2
            self._points[: self._count] = self._points[::2].copy()
        self._points[self._count] = tip_mm
        self._count += 1
        return True
