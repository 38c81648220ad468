# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drilling: the canned cycles G81, G82, G83 and G73 over a pattern of holes.

|    |  ---- z = 0
|    |          depth_mm goes to the tip, as in LinuxCNC and FreeCAD CAM; with tip = "diameter" it is that of
|    |  ----    the full diameter, and the length of the point is added; so is through_mm, always
 \\  /
  \\/   ---- bottom
"""

from __future__ import annotations

from pydantic import BaseModel, ConfigDict
from shapely import Polygon

from CNCStepper.canned_cycle_expansion import OWN_WORD, Canned
from CNCStepper.cycles.cycle import Answer, Removal, Setup
from CNCStepper.cycles.holes.hole_cycle import cut_canned, discs
from CNCStepper.cycles.holes.hole_parameters import DrillParameters
from CNCStepper.cycles.holes.hole_patterns import Pattern, placed
from CNCStepper.cycles.moves import Point, require_feed
from CNCStepper.cycles.passes import require_few_blocks
from CNCStepper.errors import CycleError, Text
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.machine.tools.tool_profile import Form, form_of
from CNCStepper.machine.tools.tool_shapes import SUITED
from CNCStepper.toolpath import TableBuilder

STEPS = 8  # that stand for the cone of a point


class Drill(DrillParameters, BaseModel):
    """Drilling that can be cut."""

    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False, arbitrary_types_allowed=True)

    pattern: Pattern

    def cut(self, setup: Setup, table: TableBuilder) -> Answer:
        """Append the holes to `table`; raises CycleError before any row when they cannot be drilled."""
        self._check(setup)
        cone = form_of(setup.tool)
        bottom_mm = -(self.depth_mm + self.through_mm + (cone.rise_mm if self.tip == "diameter" else 0.0))
        holes, warnings = placed(self.pattern, self.order, self.offset_mm)
        places = [(hole.x_mm, hole.y_mm) for hole in holes]
        own = {"Q": self.peck_mm, "P": self.dwell_s}.get(OWN_WORD[self.style], 0.0)
        cycle = Canned(self.style, bottom_mm, setup.retract_mm, own, self.retract == "clearance")
        require_few_blocks(len(places) * 3 * (cycle.pecks + 1))
        cut_canned(table, setup, cycle, places)
        figures = {"holes": len(places), "depth_mm": -bottom_mm}
        return Answer(removals(places, bottom_mm, cone), figures, warnings + _core_warning(setup.tool))

    def _check(self, setup: Setup) -> None:
        tool = setup.tool
        if tool.shape not in SUITED["drill"]:
            raise CycleError(
                "tool-shape",
                Text("a {tool_shape} tool does not drill", tool_shape=tool.shape),
                advice="use a drill or a flat mill",
            )
        require_feed(tool, "plunge_mm_min")
        self._check_own_word()

    def _check_own_word(self) -> None:
        """Refuse a style without the key that it lives on, and a key that the style would pass over in silence."""
        word = OWN_WORD[self.style]
        if word == "Q" and not self.peck_mm:
            what, advice = (
                Text("{style} drills in pecks and needs peck_mm", style=self.style),
                "give peck_mm, or use G81",
            )
            raise CycleError("peck-missing", what, value=f"{self.peck_mm:g} mm", limit="above 0 mm", advice=advice)
        if word == "P" and not self.dwell_s:
            what, advice = (
                Text("{style} waits at the bottom and needs dwell_s", style=self.style),
                "give dwell_s, or use G81",
            )
            raise CycleError("dwell-missing", what, value=f"{self.dwell_s:g} s", limit="above 0 s", advice=advice)
        if word != "Q" and self.peck_mm:
            what, advice = (
                Text("{style} does not drill in pecks", style=self.style),
                "use G83 or G73, or leave peck_mm out",
            )
            raise CycleError(
                "peck-idle", what, value=Text("peck_mm {peck_mm:g} mm", peck_mm=self.peck_mm), advice=advice
            )
        if word != "P" and self.dwell_s:
            what, advice = (
                Text("{style} does not wait at the bottom", style=self.style),
                "use G82, or leave dwell_s out",
            )
            raise CycleError("dwell-idle", what, value=f"dwell_s {self.dwell_s:g} s", advice=advice)


def removals(places: list[Point], bottom_mm: float, cone: Form) -> list[Removal]:
    """Return the removals of a tool with that point whose tip goes down to `bottom_mm` at each place.

    The cone is a stair: the permitted removal is just outside it, the required one just inside.
    """
    heights = [cone.rise_mm * step / STEPS for step in range(STEPS)] if cone.rise_mm else []
    heights = [height for height in heights if bottom_mm + height < 0.0]
    stairs = []
    for height in heights:
        over_mm = min(height + cone.rise_mm / STEPS, -bottom_mm)
        inside_mm = float(cone.radius_at(height))
        inside = discs(places, inside_mm) if inside_mm > 0 else Polygon()
        stairs.append(Removal(discs(places, float(cone.radius_at(over_mm))), 0.0, bottom_mm + height, reachable=inside))
    if bottom_mm + cone.rise_mm < 0.0:
        stairs.append(Removal(discs(places, cone.radius_mm), 0.0, bottom_mm + cone.rise_mm))
    return stairs


def _core_warning(tool: Tool) -> list[str]:
    if not tool.core_diameter_mm:
        return []
    return [
        Text(
            "the {tool} tool does not cut over its centre: it must not go straight down into full material",
            tool=tool.words,
        )
    ]
