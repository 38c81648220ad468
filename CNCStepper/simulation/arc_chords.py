# SPDX-License-Identifier: LGPL-2.1-or-later
"""The arcs and helices of a table of moves: their angles, their chords and their extremes."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from CNCStepper.tolerances import FULL_CIRCLE_RAD
from CNCStepper.toolpath import ARC_CCW, ARC_CW, PLANE_AXES, Chunk


def arcs_of(table: Chunk, begin: np.ndarray, end: np.ndarray, centre: np.ndarray) -> list[Arcs]:
    """Return the arcs of the three planes; points float64[n, 3] of each row in any one frame.

    Arcs that begin at an unknown point of their plane are left out; the height over it may be unknown.
    """
    is_arc = (table.kind == ARC_CW) | (table.kind == ARC_CCW)
    if not is_arc.any():
        return [Arcs.of(table, begin, end, centre, np.zeros(0, np.int64), plane) for plane in range(3)]
    known = [np.isfinite(begin[:, PLANE_AXES[plane][:2]]).all(axis=1) & (table.plane == plane) for plane in range(3)]
    return [Arcs.of(table, begin, end, centre, np.flatnonzero(is_arc & known[plane]), plane) for plane in range(3)]


def extremes(table: Chunk, begin: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the lowest and the highest coordinates that each row reaches, float64[n, 3]; unknown ones are NaN."""
    end = table.end[:, :3]
    low, high = np.fmin(begin, end), np.fmax(begin, end)
    for arcs in arcs_of(table, begin, end, table.centre):
        arcs.widen(low, high)
    return low, high


@dataclass(frozen=True)
class Arcs:
    """The arcs of one plane; `radius` at both ends, so that rounded arcs close exactly."""

    rows: np.ndarray
    axes: tuple[int, int, int]
    centre: np.ndarray
    radius: np.ndarray
    angle: np.ndarray
    sweep: np.ndarray

    @classmethod
    def of(
        cls, table: Chunk, begin: np.ndarray, end: np.ndarray, centre: np.ndarray, rows: np.ndarray, plane: int
    ) -> Arcs:
        """Return the arcs of `rows`, which lie in one plane."""
        first, second, _ = axes = PLANE_AXES[plane]
        from_centre = [(points[rows] - centre[rows])[:, [first, second]] for points in (begin, end)]
        angles = [np.arctan2(arm[:, 1], arm[:, 0]) for arm in from_centre]
        radius = np.stack([np.hypot(arm[:, 0], arm[:, 1]) for arm in from_centre], axis=1)
        sense = np.where(table.kind[rows] == ARC_CCW, 1.0, -1.0)
        sweep = np.mod((angles[1] - angles[0]) * sense, 2 * np.pi)
        sweep = np.where(sweep <= FULL_CIRCLE_RAD, 2 * np.pi, sweep)
        sweep += 2 * np.pi * np.maximum(table.turns[rows].astype(float) - 1, 0)
        return cls(rows, axes, centre[rows], radius, angles[0], sweep * sense)

    def counts(self, tolerance_mm: float) -> np.ndarray:
        """Return the number of chords of each arc; at least two, so that a full circle is no point."""
        radius = np.maximum(self.radius.max(axis=1), tolerance_mm)
        chord_rad = 2 * np.arccos(1 - np.minimum(tolerance_mm / radius, 1.0))
        return np.maximum(np.ceil(np.abs(self.sweep) / chord_rad), 2).astype(np.int64)

    def bend(self, points: np.ndarray, row: np.ndarray, share: np.ndarray) -> None:
        """Move the points of these arcs from their straight line onto the arc."""
        if not len(self.rows):
            return
        place = np.searchsorted(self.rows, row)
        place[place == len(self.rows)] = 0
        mine = np.flatnonzero(self.rows[place] == row)
        arc, part = place[mine], share[mine]
        angle = self.angle[arc] + self.sweep[arc] * part
        radius = self.radius[arc, 0] * (1 - part) + self.radius[arc, 1] * part
        points[mine, self.axes[0]] = self.centre[arc, self.axes[0]] + radius * np.cos(angle)
        points[mine, self.axes[1]] = self.centre[arc, self.axes[1]] + radius * np.sin(angle)

    def widen(self, low: np.ndarray, high: np.ndarray) -> None:
        """Widen the bounds of these rows by the four points where an arc can turn back on an axis."""
        sense = np.sign(self.sweep)
        for quarter in range(4):
            axis, bound = self.axes[quarter % 2], (high if quarter < 2 else low)
            turn = np.mod((quarter * np.pi / 2 - self.angle) * sense, 2 * np.pi)
            passed = turn < np.abs(self.sweep)
            rows, share = self.rows[passed], turn[passed] / np.abs(self.sweep[passed])
            radius = self.radius[passed, 0] * (1 - share) + self.radius[passed, 1] * share
            reach = self.centre[passed, axis] + (radius if quarter < 2 else -radius)
            bound[rows, axis] = (np.maximum if quarter < 2 else np.minimum)(bound[rows, axis], reach)
