# SPDX-License-Identifier: LGPL-2.1-or-later
"""From the wanted area to the region of the tool's centre, and the area that the tool cannot reach.

drawn      the outlines less the islands
wanted     drawn, less the stock to leave                                the removal
walls      wanted.offset(-radius): the room of the tool's centre
roughed    walls.offset(-finishing step)
reachable  walls.offset(+radius): what the tool's disc covers from there (the opening of `wanted`)
corners    wanted less reachable: exactly what stays
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import shapely
from shapely.geometry.base import BaseGeometry

from CNCStepper.cycles.cycle import RestCorner
from CNCStepper.errors import CycleError, Text
from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.fitting.point_fit import refitted
from CNCStepper.geometry.region import Region
from CNCStepper.geometry.shapely_polygons import polygons_of

ROUNDING_MM = 0.002  # what writing three decimals may add to a fitted arc
FIT_SHARE = 0.4  # of the tolerance: for few lines and arcs in place of many points
OFFSET_SHARE = 0.8  # of the tolerance: of which an offset takes at most an eighth, where rounding decides
SHORT = 0.05  # of what an offset may be off: shorter steps are joined up
FEW = 12  # segments for which a new fit gains nothing
SLOT_SHARE = 0.25  # of the tolerance: by which a tool may be wider than a slot
SLOT = 0.2  # of the tool's radius, squared: a slot has at least this area
WIDTH_MM = 0.001  # how well the widest tool that fits is known


@dataclass(frozen=True)
class ReachableRegions:
    """The region of the tool's centre and the reached area; see the module's text. Values for reports are lazy."""

    drawn: Region
    walls: Region
    roughed: Region
    reached: Region
    tolerance_mm: float

    @cached_property
    def wanted(self) -> BaseGeometry:
        """What is to be removed."""
        return polygons_of(self.drawn)

    @cached_property
    def reachable(self) -> BaseGeometry:
        """What of it the tool reaches."""
        return polygons_of(self.reached)

    @cached_property
    def corners(self) -> list[RestCorner]:
        """What stays, the thickest first."""
        return corners_of(self.wanted, self.reachable, self.tolerance_mm)


def reachable_regions(
    outlines: Sequence[Curve],
    islands: Sequence[Curve],
    tool_mm: float,
    stock_mm: float,
    finish_mm: float,
    tolerance_mm: float,
) -> ReachableRegions:
    """Return the rooms of a tool with the radius `tool_mm`; raises CycleError where it fits nowhere."""
    slack_mm = OFFSET_SHARE * tolerance_mm
    drawn = Region.of(outlines, islands).offset(-stock_mm, slack_mm)
    fit_mm = FIT_SHARE * (tolerance_mm - ROUNDING_MM)
    close = [[refitted(curve, fit_mm) if len(curve) > FEW else curve for curve in some] for some in (outlines, islands)]
    same = [*outlines, *islands] == [*close[0], *close[1]]
    fitted = drawn if same else Region.of(*close).offset(-stock_mm, slack_mm)
    walls, reached = _walls(fitted, tool_mm, tolerance_mm)
    if walls.empty:
        raise _too_narrow(fitted, tool_mm, slack_mm)
    return ReachableRegions(drawn, walls, walls.offset(-finish_mm, slack_mm), reached, tolerance_mm)


def _walls(region: Region, tool_mm: float, tolerance_mm: float) -> tuple[Region, Region]:
    """Return the room of the tool's centre and what the tool reaches from there.

    In slots just as wide as the tool the room is a line or a point, or nothing by rounding. Where a tool that is
    smaller by a share of the tolerance reaches more by such slots, the room is that tool's.
    """
    slack_mm = OFFSET_SHARE * tolerance_mm
    walls, reached = _opened(region, tool_mm, slack_mm)
    wider, more = _opened(region, tool_mm - SLOT_SHARE * (tolerance_mm - ROUNDING_MM), slack_mm)
    gained_mm2 = more.area_mm2 - reached.area_mm2
    return (wider, more) if gained_mm2 > SLOT * tool_mm**2 else (walls, reached)


def _opened(region: Region, tool_mm: float, slack_mm: float) -> tuple[Region, Region]:
    walls = region.offset(-tool_mm, slack_mm).without_short(SHORT * slack_mm)
    return walls, walls.offset(tool_mm, slack_mm)


def corners_of(wanted: BaseGeometry, reachable: BaseGeometry, tolerance_mm: float) -> list[RestCorner]:
    """Return what stays thicker than the tolerance, the thickest first; slivers along a wall join no corners."""
    rests = shapely.get_parts(wanted.difference(reachable))
    left, low, right, high = shapely.bounds(rests).T
    rests = rests[(np.hypot(right - left, high - low) > tolerance_mm) & (shapely.area(rests) > 0)]
    if not len(rests) or reachable.is_empty:
        return []
    rests = _apart(rests, tolerance_mm)
    places, of = shapely.get_coordinates(rests, return_index=True)
    thick_mm = _away_mm(reachable, places)
    found = []
    for number in np.unique(of[thick_mm > tolerance_mm]).tolist():
        own = np.flatnonzero(of == number)
        worst = own[int(np.argmax(thick_mm[own]))]
        found.append(RestCorner(float(thick_mm[worst]), tuple(places[worst].tolist()), rests[number].area))
    return sorted(found, key=lambda corner: -corner.thick_mm)


def _apart(rests: np.ndarray, tolerance_mm: float) -> np.ndarray:
    """Return the rests, those that slivers thinner than the tolerance join as the pieces without these."""
    half_mm = tolerance_mm / 2.0
    cores, of = shapely.get_parts(shapely.buffer(rests, -half_mm, join_style="mitre"), return_index=True)
    several = np.bincount(of, minlength=len(rests)) > 1
    grown = shapely.buffer(cores[several[of]], half_mm, join_style="mitre")
    return np.r_[rests[~several], shapely.intersection(grown, rests[of[several[of]]])]


def _away_mm(region: BaseGeometry, places: np.ndarray) -> np.ndarray:
    """Return how far places outside a region, float64[n, 2], are from it."""
    rings = shapely.get_parts(shapely.get_rings(shapely.get_parts(region)))
    xy, of = shapely.get_coordinates(rings, return_index=True)
    edges = np.stack([xy[:-1], xy[1:]], axis=1)[of[:-1] == of[1:]]
    tree = shapely.STRtree(shapely.linestrings(edges))
    return tree.query_nearest(shapely.points(places), all_matches=False, return_distance=True)[1]


def widest_mm(region: Region, least_mm: float, slack_mm: float) -> float:
    """Return the radius of the largest disc that fits into a region, at most `least_mm`, by halving."""
    low_mm, high_mm = 0.0, least_mm
    while high_mm - low_mm > WIDTH_MM:
        middle_mm = (low_mm + high_mm) / 2.0
        if region.offset(-middle_mm, slack_mm).empty:
            high_mm = middle_mm
        else:
            low_mm = middle_mm
    return low_mm


def _too_narrow(region: Region, tool_mm: float, slack_mm: float) -> CycleError:
    if region.empty:
        return CycleError(
            "pocket-empty",
            "the outlines, less islands and stock to leave, leave nothing to cut",
            advice="check which curves are outlines and which are islands, and stock_to_leave_mm",
        )
    widest = 2.0 * widest_mm(region, tool_mm, slack_mm)
    return CycleError(
        "tool-wide",
        "the tool is wider than the pocket",
        value=f"{2.0 * tool_mm:g} mm",
        limit=f"{widest:.3f} mm",
        advice=Text("choose a tool of at most {widest:.3f} mm diameter", widest=widest),
    )
