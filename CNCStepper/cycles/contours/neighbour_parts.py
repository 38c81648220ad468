# SPDX-License-Identifier: LGPL-2.1-or-later
r"""What a contour must leave standing of the parts that the job's other contours make.

  part      other part        A contour has its own material: `outside` its part, `inside` all but what it encloses.
+------+   . +------+         Another part that shares none of it lies beside it, and the cut may not enter there.
|      |( ) .|      |         One that does share some is cut on purpose: a plate with holes, with a tenon on it,
+------+   . +------+         or with a groove through its rim.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import shapely
from shapely.geometry.base import BaseGeometry

from CNCStepper.cycles.contours.scrap_side import Sides, enclosed
from CNCStepper.errors import CycleError, Text
from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.shapely_polygons import polygons_of

FLAT_MM = 0.002
SHARED = 1e-3  # of a part's area: what parts have in common below this is rounding of a common edge


def require_apart(sides: Sides, paths: Sequence[Curve], parts: Sequence[Sequence[Curve]], tolerance_mm: float) -> None:
    """Raise CycleError when the tool cuts into a neighbour part deeper than the tolerance."""
    if sides.region is None or not paths:
        return
    own, lines = polygons_of(sides.region), _lines(paths)
    for outlines in parts:
        part = polygons_of(enclosed(outlines))
        if not shapely.dwithin(part, lines, sides.tool_mm) or not _beside(sides, own, part):
            continue
        deep_mm, (x, y) = _deepest(lines, part, sides.tool_mm)
        if deep_mm > tolerance_mm:
            raise CycleError(
                "part-cut",
                Text("the cut goes into the part of another contour at X{x:.3f} Y{y:.3f}", x=x, y=y),
                value=Text("{deep_mm:.3f} mm deep", deep_mm=deep_mm),
                limit=f"{tolerance_mm:g} mm",
                advice="cut both in one operation, which leaves the gap standing, or use a smaller tool",
            )


def neighbour_warnings(
    paths: Sequence[Curve], radius_mm: float, keep: Sequence[Curve], tolerance_mm: float
) -> list[str]:
    """Return a warning when the tool on its paths comes too near to outlines of other contours, and where most."""
    if not keep or not paths:
        return []
    lines = _lines(paths)
    walls = np.array([shapely.LineString(curve.points(FLAT_MM)) for curve in keep])
    hurt = walls[shapely.dwithin(walls, lines, radius_mm - tolerance_mm)]
    if not len(hurt):
        return []
    nearest = hurt[shapely.distance(hurt, lines).argmin()]
    x, y = shapely.get_coordinates(shapely.shortest_line(nearest, lines))[0]
    return [
        Text(
            "the cut goes into {hurt} outline(s) that other contours leave standing, most at "
            "X{x:.3f} Y{y:.3f}, by {radius_mm:.3f} mm",
            hurt=len(hurt),
            x=x,
            y=y,
            radius_mm=radius_mm - shapely.distance(nearest, lines),
        )
    ]


def open_edge_warnings(cut: BaseGeometry, parts: Sequence[Sequence[Curve]], tolerance_mm: float) -> list[str]:
    """Return a warning for each part through whose edge a cleared area leads, and where."""
    told: list[str] = []
    for outlines in parts:
        part = polygons_of(enclosed(outlines))
        if min(cut.intersection(part).area, cut.difference(part).area) > tolerance_mm * cut.length:
            place = part.boundary.intersection(cut).representative_point()
            where = f"at X{place.x:.3f} Y{place.y:.3f}"
            told.append(
                Text("the cut leads through the edge of a part that a contour leaves standing, {where}", where=where)
            )
    return told


def _beside(sides: Sides, own: BaseGeometry, part: BaseGeometry) -> bool:
    """Return whether a part shares nothing with the material that the contour itself leaves standing."""
    shared = part.intersection(own) if sides.side == "outside" else part.difference(own)
    return shared.area <= SHARED * part.area


def _deepest(lines: BaseGeometry, part: BaseGeometry, radius_mm: float) -> tuple[float, tuple[float, float]]:
    """Return how deep a disc along lines enters a part, and where; straight lines within it are sampled."""
    within = lines.intersection(part)
    if within.is_empty:
        x, y = shapely.get_coordinates(shapely.shortest_line(part, lines))[0]
        return radius_mm - part.distance(lines), (float(x), float(y))
    places = shapely.get_coordinates(shapely.segmentize(within, radius_mm / 4.0))
    deep_mm = shapely.distance(shapely.points(places), part.boundary)
    x, y = places[deep_mm.argmax()]
    return radius_mm + float(deep_mm.max()), (float(x), float(y))


def _lines(paths: Sequence[Curve]) -> BaseGeometry:
    return shapely.multilinestrings([shapely.LineString(path.points(FLAT_MM)) for path in paths])
