# SPDX-License-Identifier: LGPL-2.1-or-later
"""The independent judge of engagement: at which step every cell of the material is cut, and so what the rim meets.

Cells are cut in the order of the path. The rim's front half meets those that are cut no sooner than 0.4 of a radius of
way (BEHIND) before: what the tool has just cut beside itself is still in its way, or the side of the rim would seem
free. The rim is looked at a little inside the true one: a corner tighter than the tool is touched all along its arc,
however thin the material there, so only what is thicker counts.

A rapid above the floor cuts nothing, and a little outside its rim no cell may be uncut: the walls count too, for cells
beyond them are never cut.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from CNCStepper.cycles.clearing.pattern import Run

CELLS = 48  # a radius
STEP = 0.05  # of the radius
BEHIND = 0.4  # of the radius
THIN = 0.03  # of the radius; at least THIN_MM
THIN_MM = 0.04
CLEAR = 0.03  # of the radius: rapids meet nothing that near outside the rim, walls too
NEVER = 2**30
LOOKS = np.radians(np.arange(-89.0, 90.0, 2.0))


@dataclass(frozen=True)
class Met:
    """What the rim meets at the ends of short steps: degrees, where, the steps' lengths, and which are rapids."""

    angle_deg: np.ndarray
    place_mm: np.ndarray
    length_mm: np.ndarray
    lifted: np.ndarray

    @property
    def worst(self) -> str:
        """Where most is met, for messages."""
        k = int(np.argmax(self.angle_deg))
        return f"{self.angle_deg[k]:.0f} degrees at {self.place_mm[k].round(3).tolist()}"

    @property
    def cut_mm(self) -> float:
        """The length of way on which anything is met."""
        return float(self.length_mm[self.angle_deg > 0.0].sum())

    @property
    def feed_mm(self) -> float:
        """The length of all the way at the feed, whether anything is met or not."""
        return float(self.length_mm[~self.lifted].sum())


def met_by(run: Run, tool_mm: float) -> Met:
    """Return what a tool of radius `tool_mm` meets along a run, after its opening."""
    begins, steps, lifted = _steps(run, STEP * tool_mm)
    length = np.hypot(*steps.T)
    places, ways = begins + steps, steps / length[:, None]
    cell, low = tool_mm / CELLS, places.min(axis=0) - 1.2 * tool_mm
    when = _cut_when(run, places, lifted, tool_mm, cell, low)
    way = np.cumsum(length)
    behind = np.searchsorted(way, way - BEHIND * tool_mm, side="right")
    before = np.where(lifted, np.arange(len(way)), behind)
    rim_mm = np.where(lifted, (1.0 + CLEAR) * tool_mm, tool_mm - max(THIN * tool_mm, THIN_MM))[:, None]
    angle = np.zeros(len(places))
    for look in LOOKS:
        turned = np.array([[math.cos(look), math.sin(look)], [-math.sin(look), math.cos(look)]])
        column, row = np.rint((places + rim_mm * ways @ turned - low) / cell).astype(int).T
        angle += 2.0 * ((when[row, column] >= before) & (lifted | (when[row, column] < NEVER)))
    return Met(angle, places, length, lifted)


def _steps(run: Run, longest_mm: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    begins, steps, lifted = [], [], []
    for one in run.passes:
        points = one.curve.points(0.0005)
        for a, b in pairwise(points):
            count = max(math.ceil(math.dist(a, b) / longest_mm), 1)
            begins.append(a + (b - a) * np.arange(count)[:, None] / count)
            steps.append(np.repeat((b - a)[None] / count, count, axis=0))
            lifted.append(np.full(count, one.lifted))
    begins, steps, lifted = np.vstack(begins), np.vstack(steps), np.concatenate(lifted)
    long = np.hypot(*steps.T) > 1e-9
    return begins[long], steps[long], lifted[long]


def _cut_when(
    run: Run, places: np.ndarray, lifted: np.ndarray, tool_mm: float, cell: float, low: np.ndarray
) -> np.ndarray:
    """Return at which step each cell is cut, int64[rows, columns]: -1 in the opening, NEVER where it stays."""
    columns, rows = (np.ceil((np.ptp(places, axis=0) + 2.4 * tool_mm) / cell).astype(int) + 2).tolist()
    when = np.full((rows, columns), NEVER)
    assert run.opening is not None
    x, y = np.array(run.opening.centre_mm) - low
    away = np.hypot(np.arange(columns)[None, :] * cell - x, np.arange(rows)[:, None] * cell - y)
    when[away <= run.opening.radius_mm] = -1
    reach = np.arange(-CELLS - 1, CELLS + 2)
    at = (places - low) / cell
    for k in np.flatnonzero(~lifted).tolist():
        x, y = at[k].tolist()
        column, row = round(x), round(y)
        near = when[row - CELLS - 1 : row + CELLS + 2, column - CELLS - 1 : column + CELLS + 2]
        disc = (row + reach - y)[:, None] ** 2 + (column + reach - x)[None, :] ** 2 <= CELLS**2
        near[disc & (near == NEVER)] = k
    return when
