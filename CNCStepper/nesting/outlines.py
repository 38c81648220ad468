# SPDX-License-Identifier: LGPL-2.1-or-later
r"""Polygons that hold a region of lines and arcs, or that lie within it, so that no rounding lets parts overlap.

    holding (a part)                       within (a sheet)
      arc bulges out: tangents               chords
         .-*-.                                 .-.
        *     *     corners outside           *   *   corners on the arc
      arc bulges in: chords                  tangents

A part's polygon is never smaller than the part and a sheet's never larger than the sheet, by at most the tolerance.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import shapely
from shapely import Polygon
from shapely.geometry.base import BaseGeometry

from CNCStepper.errors import GeometryError, Text
from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.region import Region

EXACT_MM = 0.0005  # how far the judge's polygons leave the arcs
MOST_CHORDS = 720  # of an arc
MITRE_LIMIT = 2.0  # corners sharper than 60 degrees are cut off at twice the distance
MOST_CORNERS = 20_000  # of a part's polygon
TINY_MM = 1e-9


def holding_polygon(region: Region, tolerance_mm: float) -> Polygon:
    """Return a polygon that holds a region of one piece and nowhere exceeds it by more than the tolerance.

    Raises GeometryError where the region is of several pieces, or where it is empty.
    """
    rings = [_ring(loop, tolerance_mm, outside=1.0) for loop in _one_piece(region)]
    return _largest(_with_holes(rings))


def within_polygon(region: Region, tolerance_mm: float) -> Polygon:
    """Return a polygon within a region of one piece, which lacks no more than the tolerance; raises as above."""
    rings = [_ring(loop, tolerance_mm, outside=-1.0) for loop in _one_piece(region)]
    return _largest(_with_holes(rings))


def _one_piece(region: Region) -> Sequence[Curve]:
    outer = sum(loop.area_mm2 > 0 for loop in region.loops)
    if outer != 1:
        what = Text("a part has {count} outlines in place of one", count=outer) if outer else "a part has no area"
        raise GeometryError("nest-pieces", what, advice="give each piece as a part of its own")
    return region.loops


def _with_holes(rings: Sequence[np.ndarray]) -> BaseGeometry:
    """Return the first counter-clockwise ring without the clockwise ones, valid."""
    polygons = [(shapely.LinearRing(ring).is_ccw, shapely.make_valid(Polygon(ring))) for ring in rings if len(ring) > 3]
    outer = shapely.union_all([polygon for is_outer, polygon in polygons if is_outer])
    return outer.difference(shapely.union_all([polygon for is_outer, polygon in polygons if not is_outer]))


def _largest(found: BaseGeometry) -> Polygon:
    """Return the largest polygon; what tangents cut off is thinner than the tolerance."""
    parts = [part for part in shapely.get_parts(found) if isinstance(part, Polygon)]
    if not parts:
        raise GeometryError("nest-area", "a part has no area", advice="give a closed outline")
    return max(parts, key=lambda part: part.area)


def _ring(loop: Curve, tolerance_mm: float, outside: float) -> np.ndarray:
    """Return the corners round a loop that has the region on its left; outside = 1 holds the region, -1 lies in it."""
    parts = [loop.xy[:1]]
    for number, bulge in enumerate(loop.bulge.tolist()):
        begin, end = loop.xy[number], loop.xy[number + 1]
        if bulge != 0.0:
            parts.append(_arc(begin, end, bulge, tolerance_mm, tangents=bulge * outside > 0))
        parts.append(end[None])
    ring = np.concatenate(parts)
    if len(ring) > MOST_CORNERS:
        advice = "simplify it, or use a larger tolerance"
        raise GeometryError(
            "nest-corners", "a part has too many corners", value=f"{len(ring)}", limit=f"{MOST_CORNERS}", advice=advice
        )
    ring[-1] = ring[0]
    return ring


def _arc(begin: np.ndarray, end: np.ndarray, bulge: float, tolerance_mm: float, tangents: bool) -> np.ndarray:
    """Return the corners between the ends of an arc: on it, or where its tangents meet, float64[k, 2]."""
    chord = complex(*(end - begin))
    sweep = 4.0 * math.atan(bulge)
    centre = complex(*begin) + chord / 2.0 * (1.0 + 1j / math.tan(sweep / 2.0))
    radius_mm = abs(complex(*begin) - centre)
    share = min(tolerance_mm / max(radius_mm, 1e-12), 0.29)
    step = 2.0 * math.acos(1.0 / (1.0 + share) if tangents else 1.0 - share)
    count = min(max(math.ceil(abs(sweep) / step), 2), MOST_CHORDS)
    each = sweep / count
    angles = each * (np.arange(count) + 0.5 if tangents else np.arange(1, count))
    reach = 1.0 / math.cos(each / 2.0) if tangents else 1.0
    places = centre + (complex(*begin) - centre) * reach * np.exp(1j * angles)
    return np.column_stack([places.real, places.imag])


def grown(polygon: Polygon, distance_mm: float) -> Polygon:
    """Return a polygon that holds all within a distance of another one: sides move out, corners stay corners."""
    if distance_mm <= 0.0:
        return polygon
    return _largest(polygon.buffer(distance_mm, join_style="mitre", mitre_limit=MITRE_LIMIT))


def shrunk(polygon: Polygon, distance_mm: float) -> BaseGeometry:
    """Return what of a polygon lies at least a distance from its rim."""
    if distance_mm <= 0.0:
        return polygon
    beside = polygon.envelope.buffer(2.0 * distance_mm).difference(polygon)
    return polygon.difference(beside.buffer(distance_mm, join_style="mitre", mitre_limit=MITRE_LIMIT))


def simplified(polygon: Polygon, tolerance_mm: float) -> Polygon:
    """Return a polygon of fewer corners that holds another one, by at most the tolerance beyond its rim.

    Notches flatter than the tolerance are filled, and short edges are replaced by the corner of their neighbours.
    """
    shapely.prepare(rim := polygon.boundary)
    rings = [_simplified_ring(np.asarray(ring.coords)[:-1], tolerance_mm, rim) for ring in _oriented_rings(polygon)]
    made = Polygon(rings[0], [ring for ring in rings[1:] if len(ring) > 2])
    holds = made.is_valid and made.buffer(TINY_MM).covers(polygon)
    return made if holds else polygon


def _oriented_rings(polygon: Polygon) -> list[shapely.LinearRing]:
    """Return the rings with the polygon on the left of each."""
    oriented = shapely.geometry.polygon.orient(polygon)
    return [oriented.exterior, *oriented.interiors]


def _simplified_ring(xy: np.ndarray, tolerance_mm: float, rim: BaseGeometry) -> np.ndarray:
    corners = [complex(x, y) for x, y in xy.tolist()]
    fewer = True
    while fewer and len(corners) > 4:
        fewer = False
        number = 0
        while number < len(corners) and len(corners) > 4:
            fewer |= _drop(corners, number, tolerance_mm, rim)
            number += 1
    return np.array([(corner.real, corner.imag) for corner in corners])


def _drop(corners: list[complex], number: int, tolerance_mm: float, rim: BaseGeometry) -> bool:
    """Drop a corner that bends inwards by little, or let a short edge between two that bend outwards vanish."""
    count = len(corners)
    before, here, after, behind = (corners[(number + offset) % count] for offset in (-1, 0, 1, 2))
    chord = after - before
    depth = _cross(chord, here - before) / max(abs(chord), TINY_MM)  # above 0: the corner lies left, bends inwards
    if 0.0 <= depth <= tolerance_mm and _distance_mm(rim, (before + after) / 2.0) <= tolerance_mm:
        del corners[number]
        return True
    bends = _cross(here - before, after - here), _cross(after - here, behind - after)
    slope = _cross(here - before, behind - after)
    if min(bends) <= 0.0 or slope <= TINY_MM:
        return False
    meet = here + (here - before) * (_cross(after - here, behind - after) / slope)
    if _distance_mm(rim, meet) > tolerance_mm:
        return False
    corners[number] = meet
    del corners[(number + 1) % count]
    return True


def _distance_mm(rim: BaseGeometry, place: complex) -> float:
    return float(shapely.distance(rim, shapely.Point(place.real, place.imag)))


def _cross(one: complex, other: complex) -> float:
    return one.real * other.imag - one.imag * other.real
