# SPDX-License-Identifier: LGPL-2.1-or-later
"""The few movements of which every cycle is made, in work coordinates.

clearance  ------->  rapids in XY
                  |  rapid down
retract           v  from here down the tool feeds
z = 0      ========  the stock's top
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from CNCStepper.cycles.cycle import Setup
from CNCStepper.errors import CycleError, Text
from CNCStepper.geometry.curve import Curve
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.toolpath import ARC_CCW, ARC_CW, LINE, TableBuilder

Point = tuple[float, float]


class Track:
    """Curves that are run along one after the other, as columns of a table: made once, for all levels.

    kind: uint8[n], xy: float64[n, 2], centre: float64[n, 3], as those of a Chunk. rows: how many there are up to the
    end of each curve. moves: which segments they are; lines of no length are left out.
    """

    def __init__(self, curves: Sequence[Curve]):
        whole = Curve.trusted(
            np.concatenate([curves[0].xy[:1], *(curve.xy[1:] for curve in curves)]),
            np.concatenate([curve.bulge for curve in curves]),
        )
        moves = (whole.bulge != 0.0) | (whole.xy[1:] != whole.xy[:-1]).any(axis=1)
        bulge = whole.bulge[moves]
        self.moves = moves
        self.kind = np.where(bulge > 0.0, ARC_CCW, np.where(bulge < 0.0, ARC_CW, LINE)).astype(np.uint8)
        self.xy = whole.xy[1:][moves]
        self.centre = np.zeros((len(bulge), 3))
        self.centre[bulge != 0.0, :2] = whole.centres[moves][bulge != 0.0]
        self.rows = np.cumsum(moves)[np.cumsum([len(curve) for curve in curves]) - 1].tolist()
        self.end = point_of(whole.xy[-1])


class Moves:
    """Appends movements to a table and keeps the tool's position."""

    def __init__(self, table: TableBuilder, setup: Setup):
        self._table = table
        self._setup = setup
        self.position = (math.nan, math.nan, math.nan)

    @property
    def z_mm(self) -> float:
        """The tool's height."""
        return self.position[2]

    def approach(self, xy: Point) -> None:
        """Go by rapids over `xy` at clearance height and down to retract height."""
        self._rapid((*xy, self._setup.clearance_mm))
        self._rapid((*xy, self._setup.retract_mm))

    def retract(self) -> None:
        """Go straight up to clearance height."""
        self._rapid((*self.position[:2], self._setup.clearance_mm))

    def plunge(self, z_mm: float) -> None:
        """Feed straight down (or up) to `z_mm` at the plunge feed."""
        self._feed((*self.position[:2], z_mm), self._setup.tool.plunge_mm_min)

    def feed(self, xy: Point, feed_mm_min: float, z_mm: float | None = None) -> None:
        """Feed straight to `xy`, sinking to `z_mm` when it is given (never faster down than the plunge feed)."""
        z_mm = self.z_mm if z_mm is None else z_mm
        run_mm = math.hypot(xy[0] - self.position[0], xy[1] - self.position[1])
        self._feed((*xy, z_mm), self.sinking_feed(feed_mm_min, run_mm, self.z_mm - z_mm))

    def follow(self, curve: Curve, feed_mm_min: float) -> None:
        """Run along `curve`, which begins at the tool's position, at this height."""
        z_mm = self.z_mm
        rows = zip(curve.xy[1:].tolist(), curve.bulge.tolist(), curve.centres.tolist(), strict=True)
        for (x, y), bulge, (i, j) in rows:
            if bulge:
                self._arc((x, y, z_mm), bulge, (i, j), feed_mm_min)
            else:
                self._feed((x, y, z_mm), feed_mm_min)

    def run(self, track: Track, feed_mm_min: float) -> None:
        """Run along a track, which begins at the tool's position, at this height."""
        z_mm = self.z_mm
        self._table.add_cuts(
            track.kind, np.column_stack([track.xy, np.full(len(track.xy), z_mm)]), track.centre, feed_mm_min
        )
        self.position = (*track.end, z_mm)

    def slope(self, curve: Curve, z_mm: float, feed_mm_min: float) -> None:
        """Run along `curve`, which begins at the tool's position, with even fall to `z_mm` (as slowly as it must)."""
        top_mm, length_mm = self.z_mm, curve.length_mm
        feed_mm_min = self.sinking_feed(feed_mm_min, length_mm, top_mm - z_mm)
        heights = (top_mm + (z_mm - top_mm) * curve.before_mm[1:] / length_mm).tolist()
        heights[-1] = z_mm
        rows = zip(curve.xy[1:].tolist(), heights, curve.bulge.tolist(), curve.centres.tolist(), strict=True)
        for (x, y), height, bulge, (i, j) in rows:
            if bulge:
                self._arc((x, y, height), bulge, (i, j), feed_mm_min)
            else:
                self._feed((x, y, height), feed_mm_min)

    def hop(self, curve: Curve, lift_mm: float) -> None:
        """Go up and by rapids along straight lines, and stay up; `curve` begins at the tool's position."""
        z_mm = self.z_mm + lift_mm
        for xy in curve.xy.tolist():
            self._rapid((*xy, z_mm))

    def turn(self, centre: Point, z_mm: float, feed_mm_min: float, *, clockwise: bool = False) -> None:
        """Run one full turn about `centre`, counter-clockwise by default, ending at height `z_mm`."""
        radius_mm = math.dist(centre, self.position[:2])
        feed_mm_min = self.sinking_feed(feed_mm_min, 2.0 * math.pi * radius_mm, self.z_mm - z_mm)
        end = (*self.position[:2], z_mm)
        self._table.arc(ARC_CW if clockwise else ARC_CCW, end, (*centre, 0.0), feed_mm_min)
        self.position = end

    def sinking_feed(self, feed_mm_min: float, run_mm: float, fall_mm: float) -> float:
        """Return the feed along a slope whose downward part does not exceed the plunge feed."""
        if fall_mm <= 0.0:
            return feed_mm_min
        return min(feed_mm_min, self._setup.tool.plunge_mm_min * math.hypot(run_mm, fall_mm) / fall_mm)

    def _arc(self, end: tuple[float, float, float], bulge: float, centre: Point, feed_mm_min: float) -> None:
        self._table.arc(ARC_CCW if bulge > 0 else ARC_CW, end, (*centre, 0.0), feed_mm_min)
        self.position = end

    def _feed(self, end: tuple[float, float, float], feed_mm_min: float) -> None:
        if end != self.position:
            self._table.feed(end, feed_mm_min)
            self.position = end

    def _rapid(self, end: tuple[float, float, float]) -> None:
        if end != self.position:
            self._table.rapid(end)
            self.position = end


def require_setup(setup: Setup) -> None:
    """Raise CycleError when the tool has no feed or no plunge feed; a job has checked its heights."""
    for name in ("feed_mm_min", "plunge_mm_min"):
        require_feed(setup.tool, name)


def require_feed(tool: Tool, name: str) -> None:
    """Raise CycleError when the tool does not have the feed of that name."""
    feed_mm_min = getattr(tool, name)
    if not 0 < feed_mm_min < math.inf:
        raise CycleError(
            "feed-missing",
            Text("tool {tool_number} has no {name}", tool_number=tool.number, name=name),
            value=Text("{feed_mm_min:g} mm/min", feed_mm_min=feed_mm_min),
            limit="above 0 mm/min",
            advice=Text("give the tool a {name}", name=name),
        )


def point_of(row: np.ndarray) -> Point:
    """Return one vertex of a curve as a point."""
    return float(row[0]), float(row[1])
