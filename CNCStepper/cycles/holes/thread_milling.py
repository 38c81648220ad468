# SPDX-License-Identifier: LGPL-2.1-or-later
r"""Thread milling: one tooth on a helix of the thread's pitch, inside a drilled hole or round a boss.

    inside: from the middle by a half circle      outside: by a half circle from beside the boss
      .--->---.                                     .-->--.
     (    ._   )  the helix, left by another       (  ///  )_   it begins where the tool is just clear
      `---( )-'   half circle into the middle       `-<---'  )  of the boss, and touches the helix

A right-hand thread rises counter-clockwise. Climb milling is counter-clockwise inside and clockwise outside, so
a right-hand thread inside is cut upwards from the floor, and outside downwards from the top.

Only the ring between the minor and the major diameter is the thread's to remove: the hole, or the room round the boss
in which the tool runs, must have been made before, else the judge finds a gouge.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from pydantic import BaseModel, ConfigDict
from shapely import Polygon

from CNCStepper.cycles.cycle import Answer, Removal, Setup
from CNCStepper.cycles.holes.hole_cycle import rings, widened
from CNCStepper.cycles.holes.hole_parameters import ThreadParameters
from CNCStepper.cycles.holes.hole_patterns import Hole, Pattern, placed
from CNCStepper.cycles.moves import Moves, require_setup
from CNCStepper.cycles.passes import require_few_blocks, whole_steps
from CNCStepper.errors import CycleError, Text
from CNCStepper.geometry.curve import Curve
from CNCStepper.machine.tools.tool_profile import form_of
from CNCStepper.machine.tools.tool_shapes import SUITED
from CNCStepper.toolpath import TableBuilder

DEPTH_INSIDE, DEPTH_OUTSIDE = 1.0825, 1.2269  # of the pitch, in diameter: ISO 68-1, D1 and d3
NARROWEST_MM = 0.01
CLEAR_MM = 0.5  # between the tool and the boss where the lead-in begins
ROUNDING_MM = 1e-9  # farther than this from where its half circle begins, the tool goes there first


class Thread(ThreadParameters, BaseModel):
    """Thread milling that can be cut."""

    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False, arbitrary_types_allowed=True)

    pattern: Pattern

    @property
    def inside(self) -> bool:
        """Whether it is the thread of a hole."""
        return self.side == "inside"

    @property
    def clockwise(self) -> bool:
        """The sense of the helix as seen from above."""
        return self.inside != (self.direction == "climb")

    @property
    def upwards(self) -> bool:
        """Whether the helix is cut from the floor up."""
        return (self.hand == "right") != self.clockwise

    def minor_mm(self, hole: Hole) -> float:
        """Return the thread's minor diameter."""
        depth = DEPTH_INSIDE if self.inside else DEPTH_OUTSIDE
        return self.minor_diameter_mm or hole.diameter_mm - depth * self.pitch_mm

    def cut(self, setup: Setup, table: TableBuilder) -> Answer:
        """Append the threads to `table`; raises CycleError before any row when they cannot be cut."""
        require_setup(setup)
        drawn, warnings = placed(self.pattern, self.order, self.offset_mm, own_diameters=not self.major_diameter_mm)
        holes = widened(drawn, self.major_diameter_mm, "major_diameter_mm")
        for hole in holes:
            self._check(setup, hole)
        many = whole_steps(self.depth_mm, self.pitch_mm)
        require_few_blocks(len(holes) * self.passes * (many + 8))
        turns = int(many)
        moves = Moves(table, setup)
        for number, hole in enumerate(holes, start=1):
            table.open_span("contour", f"thread {number}")
            for k in range(1, self.passes + 1):
                self._pass(moves, self._way(hole, setup, k), turns, setup.tool.feed_mm_min)
            moves.retract()
            table.close_span()
        figures = {"holes": len(holes), "passes": self.passes, "turns": turns, "minor_mm": self.minor_mm(holes[0])}
        return Answer(self._removals(holes, setup), figures, warnings)

    def _pass(self, moves: Moves, way: _Way, turns: int, feed_mm_min: float) -> None:
        """Cut one helix: down beside it, in, round and round, out."""
        floor_mm, top_mm = -self.depth_mm, turns * self.pitch_mm - self.depth_mm
        begin_mm, rise_mm = (floor_mm, self.pitch_mm) if self.upwards else (top_mm, -self.pitch_mm)
        if math.isnan(moves.z_mm) or math.dist(moves.position[:2], way.start) > ROUNDING_MM:
            if not math.isnan(moves.z_mm):
                moves.retract()
            moves.approach(way.start)
        moves.plunge(begin_mm)
        moves.follow(way.lead_in, feed_mm_min)
        for turn in range(1, turns + 1):
            moves.turn(way.centre, begin_mm + rise_mm * turn, feed_mm_min, clockwise=self.clockwise)
        moves.follow(way.lead_out, feed_mm_min)

    def _way(self, hole: Hole, setup: Setup, number: int) -> _Way:
        """Return where pass `number` runs, counted from 1."""
        share = number / self.passes
        minor_mm, major_mm = self.minor_mm(hole) / 2, hole.diameter_mm / 2
        centre = (hole.x_mm, hole.y_mm)
        if self.inside:
            radius_mm = minor_mm + (major_mm - minor_mm) * share - setup.tool.radius_mm
            return _Way.of(centre, radius_mm, -radius_mm / 2, self.clockwise)
        radius_mm = major_mm - (major_mm - minor_mm) * share + setup.tool.radius_mm
        beside_mm = (major_mm + setup.tool.radius_mm + CLEAR_MM - radius_mm) / 2
        return _Way.of(centre, radius_mm, beside_mm, not self.clockwise)

    def _removals(self, holes: list[Hole], setup: Setup) -> list[Removal]:
        """Return the ring that may be cut down to the floor, and its part to be removed from one pitch above."""
        tool_mm, rise_mm = setup.tool.radius_mm, form_of(setup.tool).rise_mm
        ways = {hole: self._way(hole, setup, self.passes) for hole in holes}
        minor, major = (lambda hole: self.minor_mm(hole) / 2), (lambda hole: hole.diameter_mm / 2)
        allowed = rings(holes, minor, major)
        swept = rings(holes, lambda hole: ways[hole].radius_mm - tool_mm, lambda hole: ways[hole].radius_mm + tool_mm)
        removals = [Removal(allowed, 0.0, -self.depth_mm, reachable=Polygon())]
        full_mm = -self.depth_mm + self.pitch_mm + rise_mm
        return removals + [Removal(allowed, 0.0, full_mm, reachable=allowed.intersection(swept))] * (full_mm < 0)

    def _check(self, setup: Setup, hole: Hole) -> None:
        tool, minor_mm = setup.tool, self.minor_mm(hole)
        if tool.shape not in SUITED["thread"]:
            advice = "use a thread mill, given as an engraver or as flat"
            raise CycleError(
                "tool-shape", Text("a {tool_shape} tool mills no thread", tool_shape=tool.shape), advice=advice
            )
        if form_of(tool).rise_mm > self.pitch_mm:
            raise CycleError(
                "tooth-high",
                Text(
                    "the largest disc of the {tool} tool stands more than a pitch above its tip: it cuts no thread",
                    tool=tool.words,
                ),
                value=f"{form_of(tool).rise_mm:.3f} mm",
                limit=f"{self.pitch_mm:g} mm",
                advice="use a thread mill with one tooth, given as an engraver with a large tip_diameter_mm or as flat",
            )
        if not NARROWEST_MM < minor_mm < hole.diameter_mm:
            raise CycleError(
                "thread-depth",
                "the minor diameter does not fit the major one and the pitch",
                value=f"{minor_mm:.3f} mm",
                limit=Text("above 0, below {diameter_mm:g} mm", diameter_mm=hole.diameter_mm),
                advice="correct the diameters or pitch_mm",
            )
        if self.inside and tool.diameter_mm > minor_mm - 2.0 * NARROWEST_MM:
            raise CycleError(
                "tool-wide",
                "the tool does not go into the drilled hole",
                value=f"{tool.diameter_mm:g} mm",
                limit=Text("below {minor_mm:.3f} mm", minor_mm=minor_mm),
                advice="choose a smaller tool",
            )


@dataclass(frozen=True)
class _Way:
    """One helix: its axis and radius, and the half circles that lead to it from `start` and back there."""

    centre: tuple[float, float]
    radius_mm: float
    start: tuple[float, float]
    lead_in: Curve
    lead_out: Curve

    @classmethod
    def of(cls, centre: tuple[float, float], radius_mm: float, beside_mm: float, clockwise: bool) -> _Way:
        """Return the way with its leads' centre `beside_mm` outside the helix; `clockwise`: the leads' sense."""
        touch = (centre[0] + radius_mm, centre[1])
        start = (touch[0] + 2.0 * beside_mm, centre[1])
        bulge = np.array([-1.0 if clockwise else 1.0])
        there, back = Curve(np.array([start, touch]), bulge), Curve(np.array([touch, start]), bulge)
        return cls(centre, radius_mm, start, there, back)
