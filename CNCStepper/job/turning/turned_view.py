# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a 3D view draws of a lathe's program at a moment: the part by the tools that cut it, chuck, tailstock, tools."""

from __future__ import annotations

import numpy as np
import shapely

from CNCStepper.job.turning.turning_proof_folder import TurnedQuestion
from CNCStepper.simulation.meshes.revolved_section import (
    DRAWN_MM,
    Strips,
    drawn,
    edges_of,
    plate,
    revolved_edges,
    revolved_strips,
    section_faces,
)
from CNCStepper.simulation.turning.tool_section import ToolSection
from CNCStepper.simulation.turning.turned_timeline import TurnedMoment, TurnedTimeline, track_of
from CNCStepper.simulation.turning.turning_checks import TurningSetup
from CNCStepper.tolerances import SAME_MM

INSERT_MM, SHANK_MM = 5.0, 20.0  # how thick an insert and a holder are drawn
FAR_MM = 1e4
HOLDER_BELOW_MM = 0.3  # the top of a holder below that of its insert


def timeline_of(proven: TurnedQuestion) -> TurnedTimeline:
    """Return the timeline of a proven program."""
    part = proven.verdict.part
    track = track_of(proven.on_part, proven.proof.times_s, part.moves, proven.first_row)
    return TurnedTimeline(part, proven.verdict.setup.tools, track, proven.first_row)


def operation_ends_s(proven: TurnedQuestion) -> list[float]:
    """Return when each operation of a program ends."""
    spans = [span for span in proven.proof.toolpath.spans if span.kind == "operation" and span.last > span.first]
    return [float(proven.proof.times_s[span.last - 1]) for span in spans]


def part_groups(timeline: TurnedTimeline, moment: TurnedMoment, open_deg: float) -> dict[str, Strips]:
    """Return the part at a moment, cut open by an angle: its surface by tool, and its section."""
    region = drawn(moment.section.region)
    edges = edges_of(region)
    tools = timeline.cutters(moment, edges.middles, 2 * DRAWN_MM)
    groups = {_surface(tool): revolved_edges(edges[tools == tool], open_deg) for tool in np.unique(tools).tolist()}
    return {**groups, "section": section_faces(region, open_deg)}


def _surface(tool: int) -> str:
    return f"cut-{tool}" if tool else "raw"


def fixture_groups(setup: TurningSetup, open_deg: float) -> dict[str, Strips]:
    """Return chuck, jaws and tailstock, cut open as the part is, without what the raw bar takes up of them."""
    regions = {name: region.difference(setup.stock.region) for name, region in setup.obstacles.items()}
    return {name: revolved_strips(region, open_deg) for name, region in regions.items() if not region.is_empty}


def tool_groups(tools: dict[int, ToolSection]) -> dict[str, Strips]:
    """Return inserts and blades with their holders, and drills, about their control points."""
    groups = {}
    for number, tool in tools.items():
        low, high = tool.cutting.bounds[1], tool.cutting.bounds[3]
        if abs(low + high) < SAME_MM:  # a drill: it turns about the axis
            half = tool.cutting.intersection(shapely.box(-FAR_MM, 0.0, FAR_MM, FAR_MM))
            groups[f"tool-{number}"] = revolved_strips(half, 0.0)
            continue
        groups[f"tool-{number}"] = plate(tool.cutting, 0.0, INSERT_MM)
        if tool.holder is not None:
            groups[f"holder-{number}"] = plate(tool.holder, -HOLDER_BELOW_MM, SHANK_MM)
    return groups
