# SPDX-License-Identifier: LGPL-2.1-or-later
r"""The ways down to a level's floor at the begin of a run, in a room of any shape, and never out of it.

    plunge   straight down at the begin
    ramp     to and fro along the run's own first pass, with even fall, back to the begin
    helix    turns about a centre beside the begin, a flat one on the floor, from there to the begin

                .-->-.
               |  c   |        The circle lies in the room of the tool's centre with all of its disc, and so does
                '-.<-' ---> begin   the way from it to the begin. No core stays: its radius is below the tool's.

Where a helix has no place, the way down is a ramp; where the first pass is too short for one, a plunge.
"""

from __future__ import annotations

import itertools
import math
from dataclasses import dataclass

import numpy as np

from CNCStepper.cycles.clearing.pattern import Opening
from CNCStepper.cycles.clearing.straight_links import LinkRegion
from CNCStepper.cycles.moves import Moves, Point, point_of
from CNCStepper.errors import CycleError, Text
from CNCStepper.geometry.curve import Curve
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.tolerances import SAME_MM

HELIX_SHARES = (0.8, 0.6, 0.45, 0.3, 0.2, 0.1)  # of the tool's radius: below 1 no core stays
AWAY_SHARES = (1.0, 2.0, 4.0)  # how far from the begin the centre may be, in radii of the helix
WAYS = 32  # the directions in which a place for a helix is looked for
RAMP_DIAMETERS = 2.0  # how far along its first pass a ramp goes
SHORTEST_RAMP = 0.25  # of the tool's radius


@dataclass(frozen=True)
class Plunge:
    """Straight down."""

    begin: Point
    kind: str = "plunge"

    def descend(self, moves: Moves, top_mm: float, floor_mm: float, feed_mm_min: float) -> None:
        """Go down from `top_mm` with the tool at `begin`, and end on the floor at the run's begin."""
        moves.plunge(floor_mm)

    def blocks(self, fall_mm: float) -> int:
        """Return about how many blocks a fall takes."""
        return 1


@dataclass(frozen=True)
class Helix:
    """Turns about `centre` through `begin`, then straight to `end`, the run's begin."""

    begin: Point
    centre: Point
    end: Point
    angle_deg: float
    kind: str = "helix"

    def descend(self, moves: Moves, top_mm: float, floor_mm: float, feed_mm_min: float) -> None:
        """Go down from `top_mm` with the tool at `begin`, and end on the floor at the run's begin."""
        turns = self.blocks(top_mm - floor_mm)
        for number in range(1, turns + 1):
            moves.turn(self.centre, top_mm + (floor_mm - top_mm) * number / turns, feed_mm_min)
        moves.turn(self.centre, floor_mm, feed_mm_min)
        moves.feed(self.end, feed_mm_min)

    def blocks(self, fall_mm: float) -> int:
        """Return how many turns a fall takes."""
        a_turn_mm = 2.0 * math.pi * math.dist(self.begin, self.centre) * math.tan(math.radians(self.angle_deg))
        return max(math.ceil(fall_mm / a_turn_mm), 1)


@dataclass(frozen=True)
class Ramp:
    """To and fro along `way`, which begins at the run's begin."""

    way: Curve
    angle_deg: float
    kind: str = "ramp"

    @property
    def begin(self) -> Point:
        """Where it begins and ends."""
        return point_of(self.way.xy[0])

    def descend(self, moves: Moves, top_mm: float, floor_mm: float, feed_mm_min: float) -> None:
        """Go down from `top_mm` with the tool at `begin`, and end on the floor at the run's begin."""
        back, strokes = self.way.reversed(), 2 * self._rounds(top_mm - floor_mm)
        for number in range(1, strokes + 1):
            z_mm = top_mm + (floor_mm - top_mm) * number / strokes
            moves.slope(self.way if number % 2 else back, z_mm, feed_mm_min)

    def blocks(self, fall_mm: float) -> int:
        """Return how many blocks a fall takes."""
        return 2 * len(self.way) * self._rounds(fall_mm)

    def _rounds(self, fall_mm: float) -> int:
        a_round_mm = 2.0 * self.way.length_mm * math.tan(math.radians(self.angle_deg))
        return max(math.ceil(fall_mm / a_round_mm), 1)


Entry = Plunge | Helix | Ramp


def entry_for(kind: str, ground: LinkRegion, first: Curve, tool: Tool, angle_deg: float) -> Entry:
    """Return the way down to the begin of a run's first pass, of the `kind` asked for where that has a place.

    ground: the room of the tool's centre. Raises CycleError when only a plunge is left and the tool cannot plunge.
    """
    angle_deg = _angle_deg(tool, angle_deg)
    helix = _helix(ground, point_of(first.xy[0]), tool.radius_mm, angle_deg) if kind == "helix" else None
    if helix is not None:
        return helix
    if kind != "plunge" and first.length_mm > SHORTEST_RAMP * tool.radius_mm:
        return Ramp(_stretch(first, RAMP_DIAMETERS * tool.diameter_mm), angle_deg)
    if tool.core_diameter_mm:
        raise CycleError(
            "entry-room",
            "there is no room for a helix or ramp, and the tool does not cut over its centre",
            value=Text("{length_mm:.3f} mm to ramp on", length_mm=first.length_mm)
            if kind != "plunge"
            else 'entry "plunge"',
            advice="use a smaller tool or one that plunges" if kind != "plunge" else 'use entry "helix" or "ramp"',
        )
    return Plunge(point_of(first.xy[0]))


def opened(opening: Opening, begin: Point, tool: Tool, angle_deg: float) -> Helix:
    """Return the helix that opens the stock as a run relies on it, through the run's begin."""
    return Helix(begin, opening.centre_mm, begin, _angle_deg(tool, angle_deg))


def _angle_deg(tool: Tool, angle_deg: float) -> float:
    """Return how steep the tool may go down: one with a core only so much."""
    return min(angle_deg, tool.ramp_max_deg) if tool.core_diameter_mm else angle_deg


def _stretch(curve: Curve, length_mm: float) -> Curve:
    return curve if curve.length_mm <= length_mm else curve.part(0.0, length_mm)


def _helix(ground: LinkRegion, end: Point, tool_mm: float, angle_deg: float) -> Helix | None:
    """Return the largest helix near `end` from which a straight way leads there, the nearest of these."""
    angles = 2.0 * math.pi * np.arange(WAYS) / WAYS
    ways = np.column_stack([np.cos(angles), np.sin(angles)])
    for share, away in itertools.product(HELIX_SHARES, AWAY_SHARES):
        radius_mm = share * tool_mm
        centres = np.array(end) + away * radius_mm * ways
        free = ground.region.distances_mm(centres) >= radius_mm - SAME_MM
        free &= ground.region.contains(centres)
        for index in np.flatnonzero(free).tolist():
            begin = end if away == 1.0 else point_of(centres[index] - radius_mm * ways[index])
            if begin == end or ground.sees(begin, end):
                return Helix(begin, point_of(centres[index]), end, angle_deg)
    return None
