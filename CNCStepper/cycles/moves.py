# SPDX-License-Identifier: LGPL-2.1-or-later
"""The few movements of which every cycle is made, in work coordinates.

clearance  ------->  rapids in XY
                  |  rapid down
retract           v  from here down the tool feeds
z = 0      ========  the stock's top
"""

from __future__ import annotations

import math

import numpy as np

from CNCStepper.cycles.form import Setup
from CNCStepper.errors import CycleError
from CNCStepper.geometry.curve import Curve
from CNCStepper.toolpath import ARC_CCW, ARC_CW, TableBuilder

Point = tuple[float, float]


class Moves:
    """Appends movements to a table and knows where the tool stands."""

    def __init__(self, table: TableBuilder, setup: Setup):
        self._table = table
        self._setup = setup
        self.position = (math.nan, math.nan, math.nan)

    @property
    def z_mm(self) -> float:
        """The height at which the tool stands."""
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
        """Run along `curve`, which begins where the tool stands, at this height."""
        z_mm = self.z_mm
        rows = zip(curve.xy[1:].tolist(), curve.bulge.tolist(), curve.centres.tolist(), strict=True)
        for (x, y), bulge, (i, j) in rows:
            if bulge:
                self._arc((x, y, z_mm), bulge, (i, j), feed_mm_min)
            else:
                self._feed((x, y, z_mm), feed_mm_min)

    def turn(self, centre: Point, z_mm: float, feed_mm_min: float) -> None:
        """Run one full counter-clockwise turn about `centre`, ending at height `z_mm`."""
        radius_mm = math.dist(centre, self.position[:2])
        feed_mm_min = self.sinking_feed(feed_mm_min, 2.0 * math.pi * radius_mm, self.z_mm - z_mm)
        end = (*self.position[:2], z_mm)
        self._table.arc(ARC_CCW, end, (*centre, 0.0), feed_mm_min)
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
        feed_mm_min = getattr(setup.tool, name)
        if not 0 < feed_mm_min < math.inf:
            raise CycleError(
                "feed-missing",
                f"tool {setup.tool.number} has no {name}",
                value=f"{feed_mm_min:g} mm/min",
                limit="above 0 mm/min",
                advice=f"give the tool a {name}",
            )


def point_of(row: np.ndarray) -> Point:
    """Return one vertex of a curve as a point."""
    return float(row[0]), float(row[1])
