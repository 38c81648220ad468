# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a 3D view draws of a lathe's program at a moment: the part by the tools that cut it, chuck, tailstock, tools."""

from __future__ import annotations

import numpy as np
import shapely
from shapely.geometry.base import BaseGeometry

from CNCStepper.job.turning.prove_turning import TurnedProof
from CNCStepper.machine.tools.turning_tool import TurningTool
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

INSERT_MM, SHANK_MM = 5.0, 20.0  # how thick an insert and a holder are drawn
HOLDER_BELOW_MM = 0.3  # the top of a holder below that of its insert


def timeline_of(proven: TurnedProof) -> TurnedTimeline:
    """Return the timeline of a proven program."""
    part = proven.verdict.part
    track = track_of(proven.path, proven.proof.times_s, part.moves, proven.first_row)
    return TurnedTimeline(part, proven.verdict.setup.tools, track, proven.first_row)


def part_groups(timeline: TurnedTimeline, moment: TurnedMoment, open_deg: float) -> dict[str, Strips]:
    """Return the part at a moment, cut open by an angle: its surface by tool, and its section."""
    region = drawn(moment.section.region)
    edges = edges_of(region)
    tools = timeline.cutters(moment, edges.middles, 2 * DRAWN_MM)
    groups = {_surface(tool): revolved_edges(edges[tools == tool], open_deg) for tool in np.unique(tools).tolist()}
    return {**groups, "section": section_faces(region, open_deg)}


def _surface(tool: int) -> str:
    return f"cut-{tool}" if tool else "raw"


def fixture_groups(obstacles: dict[str, BaseGeometry], open_deg: float) -> dict[str, Strips]:
    """Return chuck, jaws and tailstock, cut open as the part is."""
    return {name: revolved_strips(region, open_deg) for name, region in obstacles.items()}


def tool_groups(tools: dict[int, TurningTool]) -> dict[str, Strips]:
    """Return inserts, blades and drills with their holders, about their control points."""
    groups = {}
    for number, tool in tools.items():
        section = ToolSection.of(tool)
        if tool.kind == "drill":
            half = section.cutting.intersection(shapely.box(-1e4, 0.0, 1e4, 1e4))
            groups[f"tool-{number}"] = revolved_strips(half, 0.0)
            continue
        groups[f"tool-{number}"] = plate(section.cutting, 0.0, INSERT_MM)
        if section.holder is not None:
            groups[f"holder-{number}"] = plate(section.holder, -HOLDER_BELOW_MM, SHANK_MM)
    return groups
