# SPDX-License-Identifier: LGPL-2.1-or-later
"""The area that a contour removes: its swept area, in two layers where there are tabs.

 ____________________   top
|                    |     above the tabs: the whole path's sweep
|______      ________|   tabs' top
|      | tab|        |     below: without the stretches on which the tool is lifted
|______|____|________|   depth
"""

from __future__ import annotations

from collections.abc import Sequence

from shapely.geometry.base import BaseGeometry

from CNCStepper.cycles.contours.contour_model import ContourModel
from CNCStepper.cycles.contours.cutting_width import radius_at
from CNCStepper.cycles.contours.disc_swept_area import swept
from CNCStepper.cycles.contours.scrap_side import Sides
from CNCStepper.cycles.cycle import Removal
from CNCStepper.geometry.curve import Curve
from CNCStepper.machine.tools.tool import Tool


def removed(
    cycle: ContourModel,
    tool: Tool,
    radius_mm: float,
    sides: Sides,
    low: Sequence[Curve],
    every: Sequence[Curve],
    reliefs: Sequence[Curve],
) -> list[Removal]:
    """Return the removals of a contour.

    low: where the tool's centre is at the full depth. every: where it is above the tabs. reliefs: strokes that go
    beyond the wall.
    """
    depth_mm, promise_mm = cycle.depth_mm, cycle.tolerance_mm
    if cycle.kerf_mm:
        promise_mm += abs(cycle.kerf_mm / 2.0 - radius_at(tool, depth_mm, depth_mm))

    def scrap(curves: Sequence[Curve], cut_mm: float) -> BaseGeometry:
        return sides.scrap_of(swept(curves, cut_mm)).union(swept(reliefs, cut_mm))

    layers = [(low, depth_mm)]
    if cycle.tabs and len(low) and low is not every:
        layers.insert(0, (every, depth_mm - cycle.tabs.height_mm))
    floor_mm = radius_mm - tool.radius_mm + radius_at(tool, 0.0, depth_mm)
    found = []
    for curves, bottom_mm in layers:
        gone = scrap(curves, max(floor_mm, 0.0)) if floor_mm < radius_mm else None
        found.append(Removal(scrap(curves, radius_mm), 0.0, -bottom_mm, promise_mm, gone))
    return found
