# SPDX-License-Identifier: LGPL-2.1-or-later
"""The ways down to a level's floor in the middle of an elliptical pocket: plunge, helix, ramp."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from CNCStepper.cycles.moves import Moves, point_of
from CNCStepper.errors import CycleError, Text
from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.shapes.ellipse import Ellipse

HELIX_SHARE = 0.8  # of the tool's radius: no core stays in the helix
LONGEST_RAMP = 2.0  # tool diameters to each side of the centre


@dataclass(frozen=True)
class Plunge:
    """Straight down in the centre, as published."""

    ellipse: Ellipse

    def descend(self, moves: Moves, top_mm: float, floor_mm: float, feed_mm_min: float) -> None:
        _begin(moves, self.ellipse.centre, feed_mm_min)
        moves.plunge(floor_mm)

    def blocks(self, fall_mm: float) -> int:
        """Return about how many blocks a fall takes."""
        return 1


@dataclass(frozen=True)
class Helix:
    """Turns about the centre with even fall, one flat turn, so that the floor under them is plane."""

    ellipse: Ellipse
    radius_mm: float
    angle_deg: float

    def descend(self, moves: Moves, top_mm: float, floor_mm: float, feed_mm_min: float) -> None:
        centre = self.ellipse.centre
        _begin(moves, (centre[0] + self.radius_mm, centre[1]), feed_mm_min)
        turns = self.blocks(top_mm - floor_mm)
        for number in range(1, turns + 1):
            moves.turn(centre, top_mm + (floor_mm - top_mm) * number / turns, feed_mm_min)
        moves.turn(centre, floor_mm, feed_mm_min)

    def blocks(self, fall_mm: float) -> int:
        """Return how many turns a fall takes."""
        a_turn_mm = 2.0 * math.pi * self.radius_mm * math.tan(math.radians(self.angle_deg))
        return math.ceil(fall_mm / a_turn_mm)


@dataclass(frozen=True)
class Ramp:
    """To and fro along the long axis with even fall, ending in the centre."""

    ellipse: Ellipse
    reach_mm: float
    angle_deg: float

    def descend(self, moves: Moves, top_mm: float, floor_mm: float, feed_mm_min: float) -> None:
        ends = self.ellipse.placed(Curve(np.array([(-self.reach_mm, 0.0), (self.reach_mm, 0.0)]), np.zeros(1))).xy
        there, back = point_of(ends[1]), point_of(ends[0])
        _begin(moves, self.ellipse.centre, feed_mm_min)
        rounds = self.blocks(top_mm - floor_mm) // 3
        for number in range(rounds):
            for xy, share in ((there, 0.25), (back, 0.75), (self.ellipse.centre, 1.0)):
                moves.feed(xy, feed_mm_min, top_mm + (floor_mm - top_mm) * (number + share) / rounds)

    def blocks(self, fall_mm: float) -> int:
        """Return how many blocks a fall takes, three for each time to and fro."""
        a_round_mm = 4.0 * self.reach_mm * math.tan(math.radians(self.angle_deg))
        return 3 * math.ceil(fall_mm / a_round_mm)


Entry = Plunge | Helix | Ramp


def entry_of(name: str, ellipse: Ellipse, tool_mm: float, roughed: Curve, angle_deg: float) -> Entry:
    """Return the entry called `name` that stays inside the last roughing pass; `tool_mm` is the tool's radius.

    Raises CycleError when the pocket has no room for it.
    """
    if name == "helix":
        free_mm = float(roughed.distances_mm(np.array([ellipse.centre]))[0])
        radius_mm = min(HELIX_SHARE * tool_mm, free_mm)
        if radius_mm < 0.1 * tool_mm:
            raise _no_room("helix", radius_mm, 0.1 * tool_mm, 'use entry "ramp" or "plunge"')
        return Helix(ellipse, radius_mm, angle_deg)
    if name == "ramp":
        angle = math.radians(ellipse.angle_deg)
        free_mm = float(((roughed.xy - ellipse.centre) @ (math.cos(angle), math.sin(angle))).max())
        reach_mm = min(free_mm, LONGEST_RAMP * 2.0 * tool_mm)
        if reach_mm < 0.25 * tool_mm:
            raise _no_room("ramp", reach_mm, 0.25 * tool_mm, 'use entry "plunge"')
        return Ramp(ellipse, reach_mm, angle_deg)
    return Plunge(ellipse)


def _begin(moves: Moves, xy: tuple[float, float], feed_mm_min: float) -> None:
    """Come to the entry: by rapids from above at first, then along the cleared floor of the level before."""
    if math.isnan(moves.z_mm):
        moves.approach(xy)
    else:
        moves.feed(xy, feed_mm_min)


def _no_room(entry: str, value_mm: float, limit_mm: float, advice: str) -> CycleError:
    return CycleError(
        "entry-room",
        Text("the pocket is too narrow for a {entry}", entry=entry),
        value=f"{value_mm:.3f} mm",
        limit=f"{limit_mm:.3f} mm",
        advice=advice,
    )
