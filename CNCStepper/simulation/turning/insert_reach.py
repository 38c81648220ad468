# SPDX-License-Identifier: LGPL-2.1-or-later
"""What of the stock a tool can take off at all, if it must leave a region whole: calculated from the outlines alone.

forbidden   where the control point may not be: the region to keep, widened by outline and holder turned round
free        the rest of a window about stock and tool, as far as it hangs together with the place outside
reached     the outline at every free place: an opening of the air about the region to keep
"""

from __future__ import annotations

import numpy as np
import shapely
from shapely.geometry.base import BaseGeometry

from CNCStepper.simulation.turning.half_section import solid
from CNCStepper.simulation.turning.swept_outline import hulls
from CNCStepper.simulation.turning.tool_section import ToolSection
from CNCStepper.simulation.turning.turned_part import CONTACT_MM


def out_of_reach(stock: BaseGeometry, keep: BaseGeometry, tool: ToolSection) -> BaseGeometry:
    """Return what this tool must leave of the stock beside `keep`, wherever it goes."""
    forbidden = _widened(keep, [-part for part in (*tool.cutting_parts, *tool.holder_parts)])
    free = _entered(shapely.box(*_window(stock, tool)).difference(forbidden))
    reached = _widened(free, tool.cutting_parts)
    return solid(stock.difference(shapely.union_all([reached, keep])))


def _window(stock: BaseGeometry, tool: ToolSection) -> tuple[float, float, float, float]:
    """Return where the control point may be: about the stock by more than the tool's size, and down to the axis."""
    low_z, low_r, high_z, high_r = tool.cutting.bounds
    size = max(high_z - low_z, high_r - low_r) + 1.0
    z_first, _, z_last, radius = stock.bounds
    return z_first - size, -tool.nose_radius_mm, z_last + size + max(0.0, -low_z), radius + size - min(0.0, low_r)


def _entered(free: BaseGeometry) -> BaseGeometry:
    """Return the parts of the free places from which the window's end at large z or large radius can be reached."""
    if free.is_empty:
        return free
    _, _, z_last, r_last = free.bounds
    outside = [
        part
        for part in shapely.get_parts(free)
        if part.bounds[2] > z_last - CONTACT_MM or part.bounds[3] > r_last - CONTACT_MM
    ]
    return shapely.union_all(outside)


def _widened(region: BaseGeometry, parts: list[np.ndarray]) -> BaseGeometry:
    """Return the Minkowski sum of a region and an outline of convex parts: swept along the edges, and shifted."""
    rings = shapely.get_rings(shapely.get_parts(region))
    points, ring = shapely.get_coordinates(rings, return_index=True)
    inside = ring[:-1] == ring[1:]
    begin, end = points[:-1][inside], points[1:][inside]
    swept = [shapely.union_all(hulls(part, begin, end)) for part in parts]
    shifted = [shapely.transform(region, lambda place, by=part[0]: place + by) for part in parts]
    return shapely.union_all(swept + shifted)
