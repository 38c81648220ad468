# SPDX-License-Identifier: LGPL-2.1-or-later
r"""Helical bore: holes wider than the tool, by turns with even fall and a flat one on the floor.

 .-------.          helix 1 leaves no core: its radius is at most 0.8 of the tool's
( 3 ( 1 ) )         each next one runs `stepover_mm` farther out, down the whole depth again
 `-------'          the last one is on the wall; between them the tool goes up in the middle
"""

from __future__ import annotations

import math
from itertools import pairwise

from pydantic import BaseModel, ConfigDict

from CNCStepper.cycles.cycle import Answer, Removal, Setup
from CNCStepper.cycles.holes.hole_cycle import rings, widened
from CNCStepper.cycles.holes.hole_parameters import BoreParameters
from CNCStepper.cycles.holes.hole_patterns import Hole, Pattern, placed
from CNCStepper.cycles.moves import Moves, require_setup
from CNCStepper.cycles.passes import require_few_blocks, whole_steps
from CNCStepper.cycles.tool_requirements import require_flat, require_stepover
from CNCStepper.errors import CycleError, Text
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.toolpath import TableBuilder

NO_CORE = 0.8  # of the tool's radius: the first helix' radius at most
USUAL_STEPOVER = 0.4  # of the tool's diameter
NARROWEST_MM = 0.01  # radius of a helix that is one
LEAST_ROOM = 0.05  # of the tool's radius: a helix of a smaller one is a plunge, however small its pitch


class Bore(BoreParameters, BaseModel):
    """A helical bore that can be cut."""

    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False, arbitrary_types_allowed=True)

    pattern: Pattern

    def cut(self, setup: Setup, table: TableBuilder) -> Answer:
        """Append the bores to `table`; raises CycleError before any row when they cannot be cut."""
        require_setup(setup)
        drawn, warnings = placed(self.pattern, self.order, self.offset_mm, own_diameters=not self.diameter_mm)
        holes = widened(drawn, self.diameter_mm, "diameter_mm")
        self._check(setup, min(hole.diameter_mm for hole in holes))
        bottom_mm = -(self.depth_mm + self.through_mm)
        steepest_mm = self._steepest_mm(holes, setup.tool)
        many = whole_steps(setup.retract_mm - bottom_mm, min(self.pitch_mm, steepest_mm))
        require_few_blocks(sum(self._roughing(hole, setup.tool.radius_mm)[2] + 2 for hole in holes) * (many + 6))
        radii, turns = [self._radii_mm(hole, setup.tool.radius_mm) for hole in holes], int(many)
        pitch_mm = (setup.retract_mm - bottom_mm) / turns
        moves = Moves(table, setup)
        for number, (hole, each) in enumerate(zip(holes, radii, strict=True), start=1):
            table.open_span("contour", f"hole {number}")
            self._bore(moves, table, hole, each, bottom_mm, turns, setup)
            table.close_span()
        passes, ae_mm = max(map(len, radii)), _widest(radii)
        figures = {"holes": len(holes), "ap_mm": pitch_mm, "pitch_mm": pitch_mm, "passes": passes, "ae_mm": ae_mm}
        if self.pitch_mm > steepest_mm:
            warnings = [*warnings, _lowered(pitch_mm, setup.tool.ramp_max_deg)]
        region = rings(holes, lambda hole: 0.0, lambda hole: hole.diameter_mm / 2)
        return Answer([Removal(region, 0.0, bottom_mm)], figures, warnings)

    def _bore(
        self,
        moves: Moves,
        table: TableBuilder,
        hole: Hole,
        radii_mm: list[float],
        bottom_mm: float,
        turns: int,
        setup: Setup,
    ) -> None:
        """Bore one hole helix by helix, each from retract height to the floor."""
        centre, top_mm = (hole.x_mm, hole.y_mm), setup.retract_mm
        for number, radius_mm in enumerate(radii_mm, start=1):
            last = number == len(radii_mm)
            finishing = last and self.finish_stepover_mm > 0
            feed = self.finish_feed_mm_min if finishing and self.finish_feed_mm_min else setup.tool.feed_mm_min
            table.open_span("pass", "finishing" if finishing else f"helix {number}")
            moves.approach((centre[0] + radius_mm, centre[1]))
            for turn in range(1, turns + 1):
                z_mm = bottom_mm if turn == turns else top_mm + (bottom_mm - top_mm) * turn / turns
                moves.turn(centre, z_mm, feed, clockwise=self.direction == "conventional")
            moves.turn(centre, bottom_mm, feed, clockwise=self.direction == "conventional")
            moves.feed(centre, feed)
            moves.retract()
            table.close_span()

    def _radii_mm(self, hole: Hole, tool_mm: float) -> list[float]:
        """Return the radii of the helices from the inner one to the wall's."""
        first_mm, reach_mm, steps = self._roughing(hole, tool_mm)
        roughing = [first_mm + (reach_mm - first_mm) * k / steps for k in range(int(steps))] + [reach_mm]
        wall_mm = hole.diameter_mm / 2 - tool_mm
        return roughing + [wall_mm] * (reach_mm < wall_mm)

    def _roughing(self, hole: Hole, tool_mm: float) -> tuple[float, float, float]:
        """Return the radii of the first and the last helix before the finishing one, and the steps between them."""
        wall_mm = hole.diameter_mm / 2 - tool_mm
        finish_mm = self.finish_stepover_mm if wall_mm > self.finish_stepover_mm + _least_mm(tool_mm) else 0.0
        reach_mm = wall_mm - finish_mm
        stepover_mm = self.stepover_mm or USUAL_STEPOVER * 2.0 * tool_mm
        first_mm = min(NO_CORE * tool_mm, reach_mm)
        return first_mm, reach_mm, whole_steps(reach_mm - first_mm, stepover_mm)

    def _check(self, setup: Setup, narrowest_mm: float) -> None:
        tool = setup.tool
        require_flat(tool)
        if narrowest_mm / 2 - tool.radius_mm < _least_mm(tool.radius_mm):
            raise CycleError(
                "tool-wide",
                "the bore leaves the tool no room for a helix",
                value=f"{tool.diameter_mm:g} mm",
                limit=Text(
                    "at most {narrowest_mm:.3f} mm",
                    narrowest_mm=min(narrowest_mm / (1.0 + LEAST_ROOM), narrowest_mm - 2.0 * NARROWEST_MM),
                ),
                advice="choose a smaller tool, or drill",
            )
        require_stepover(self.stepover_mm, tool)
        require_stepover(self.finish_stepover_mm, tool, "finish_stepover_mm (ae_acab)")

    def _steepest_mm(self, holes: list[Hole], tool: Tool) -> float:
        """Return the largest pitch at which no helix falls by more than the tool's ramp_max_deg."""
        radius_mm = min(self._roughing(hole, tool.radius_mm)[0] for hole in holes)
        return 2.0 * math.pi * radius_mm * math.tan(math.radians(tool.ramp_max_deg))


def _least_mm(tool_mm: float) -> float:
    """Return the radius of the smallest helix of a tool of that radius."""
    return max(LEAST_ROOM * tool_mm, NARROWEST_MM)


def _lowered(pitch_mm: float, most_deg: float) -> str:
    return Text(
        "pitch_mm is lowered to {pitch_mm:.3f} mm, for the helix must not fall by more than {most_deg:g}°",
        pitch_mm=pitch_mm,
        most_deg=most_deg,
    )


def _widest(radii_mm: list[list[float]]) -> float:
    """Return the largest step between two helices; that of a single one is its diameter of cut, 0 here."""
    return max((b - a for each in radii_mm for a, b in pairwise(each)), default=0.0)
