# SPDX-License-Identifier: LGPL-2.1-or-later
r"""The rings of a room: its pieces at depths one stepover apart, each with the deeper ones that it holds.

A place of a ring is at most one stepover from it, or in one of its children. So stepovers up to the tool's radius
leave nothing between rings; larger ones do where a ring turns sharply:

    ------------.        ring
        .   x    \       x is farther than the tool's radius from both. Passes half a stepover inside the ring reach
    ------.       \      all between, because no stepover is larger than the tool: as far as they come near
    child  \       \     such spots, they are cut too.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np
import shapely
from shapely.geometry.base import BaseGeometry

from CNCStepper.cycles.clearing.pattern import Area
from CNCStepper.cycles.passes import MOST_PASSES, require_few_blocks
from CNCStepper.errors import CycleError, Text
from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.region import Region
from CNCStepper.geometry.shapely_polygons import polygons_of
from CNCStepper.tolerances import NO_RING_MM2

FEW = 3  # levels after which it is looked how many there would be
SHORT = 0.05  # of the tolerance: shorter steps of a ring are joined up
STRIDE = 0.1  # of the tool's radius: between the sample places of a pass
SLACK = 0.8  # of the tolerance: of which an offset takes at most an eighth, where rounding decides
SURE = 0.25  # of the tolerance: what rings are taken to reach less than they do, where spots are looked for


@dataclass(eq=False)
class Ring:
    """A piece of the room at a depth; the tool runs along its loops. height: the depth of nesting."""

    region: Region
    parent: Ring | None = None
    children: list[Ring] = field(default_factory=list)
    height: int = 0


def ring_tree(room: Region, area: Area) -> Ring:
    """Return the rings of a room that hangs together, from the wall inwards; raises CycleError for too many."""
    root = Ring(room)
    levels, blocks = [[root]], 0
    while levels[-1]:
        deeper: list[Ring] = []
        for ring in levels[-1]:
            blocks += sum(map(len, ring.region.loops))
            ring.children = _children(ring, area)
            deeper += ring.children
        require_few_blocks(blocks)
        levels.append(deeper)
        if len(levels) == FEW:
            _require_few_rings(levels[-1], area)
    for level in reversed(levels):
        for ring in level:
            ring.children = [child for child in ring.children if child.children or _needed(child, area)]
            ring.height = 1 + max((child.height for child in ring.children), default=0)
    return root


def _require_few_rings(rings: list[Ring], area: Area) -> None:
    """Raise CycleError where rings go deeper than MOST_PASSES of them would."""
    far_mm = MOST_PASSES * area.stepover_mm
    if any(not ring.region.offset(-far_mm, SLACK * area.tolerance_mm).empty for ring in rings):
        raise CycleError(
            "passes-many",
            Text("stepover_mm asks for more than {most_passes} passes", most_passes=MOST_PASSES),
            value=f"{area.stepover_mm:g} mm",
            advice="make stepover_mm larger",
        )


def _children(ring: Ring, area: Area) -> list[Ring]:
    inner = ring.region.offset(-area.stepover_mm, SLACK * area.tolerance_mm).without_short(SHORT * area.tolerance_mm)
    return [Ring(part, ring) for part in inner.parts()]


def _needed(child: Ring, area: Area) -> bool:
    """Return whether the ring around it leaves something in a child."""
    beyond_mm = area.tool_mm - area.stepover_mm
    return beyond_mm <= 0.0 or not child.region.offset(-beyond_mm, SLACK * area.tolerance_mm).empty


def spots(ring: Ring, area: Area) -> list[Curve]:
    """Return the passes, open or closed, that clear what a ring and its children leave between them."""
    if area.stepover_mm <= area.tool_mm:
        return []
    slack_mm = SLACK * area.tolerance_mm
    reach_mm = area.tool_mm - SURE * area.tolerance_mm
    left = polygons_of(ring.region.offset(-reach_mm, slack_mm))
    done = [polygons_of(child.region.offset(reach_mm, slack_mm)) for child in ring.children]
    left = left.difference(shapely.union_all(done))
    if left.area < NO_RING_MM2:
        return []
    shapely.prepare(left)
    between = ring.region.offset(-area.stepover_mm / 2.0, slack_mm)
    return [part for loop in between.loops for part in _near(loop, left, area.tool_mm)]


def _near(loop: Curve, left: BaseGeometry, tool_mm: float) -> list[Curve]:
    """Return the stretches of a loop that are within the tool's radius, and a little more, of what is left."""
    count = max(math.ceil(loop.length_mm / (STRIDE * tool_mm)), 8)
    stride_mm = loop.length_mm / count
    places = shapely.points(loop.at_length(stride_mm * np.arange(count))[0])
    near = shapely.distance(left, places) <= tool_mm + stride_mm
    if near.all():
        return [loop]
    begins = np.flatnonzero(near & ~np.roll(near, 1))
    ends = np.flatnonzero(near & ~np.roll(near, -1))
    ends = np.roll(ends, -1) if len(ends) and ends[0] < begins[0] else ends
    return [
        loop.part((begin - 1) % count * stride_mm, (end + 1) % count * stride_mm)
        for begin, end in zip(begins, ends, strict=True)
    ]
