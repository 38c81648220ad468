# SPDX-License-Identifier: LGPL-2.1-or-later
"""Chains as polygons: parts with their holes, and the scrap inside a hole."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import shapely

from CNCStepper.cycles.sheet_cutting.chains import Chain, polygon_of
from CNCStepper.cycles.sheet_cutting.chord_pieces import points_of

FLAT_MM = 0.0004  # of the polygons of parts
ROUGH_MM = 0.01


def parts_of(chains: Sequence[Chain], kerf_mm: float) -> dict[int, list[shapely.Polygon]]:
    """Return the parts by the index of their outline, each with its holes, within 0.0005 mm.

    Open lines that are cut through an outline divide it: what their kerf leaves are its parts.
    """
    points = points_of([chain.curve for chain in chains], FLAT_MM)
    holes: dict[int, list[np.ndarray]] = {}
    for chain, ring in zip(chains, points, strict=True):
        if chain.is_hole:
            holes.setdefault(chain.holder, []).append(ring)
    lines = [shapely.LineString(ring) for chain, ring in zip(chains, points, strict=True) if chain.is_open]
    whole = {
        index: shapely.Polygon(points[index], holes.get(index)) for index, chain in enumerate(chains) if chain.is_part
    }
    tree = shapely.STRtree(lines)
    return {index: _divided(part, [lines[n] for n in tree.query(part)], kerf_mm) for index, part in whole.items()}


def _divided(part: shapely.Polygon, lines: Sequence[shapely.LineString], kerf_mm: float) -> list[shapely.Polygon]:
    """Return what the kerf of lines leaves of a part, without crumbs of less than half a kerf."""
    cutting = [
        line.buffer(kerf_mm / 2.0) for line in lines if part.contains_properly(line.interpolate(0.5, normalized=True))
    ]
    if not cutting:
        return [part]
    pieces = shapely.get_parts(part.difference(shapely.union_all(cutting)))
    return [piece for piece in pieces if not piece.buffer(-kerf_mm / 4.0).is_empty]


def scrap_in(chains: Sequence[Chain], hole: Chain, kerf_mm: float) -> np.ndarray | None:
    """Return the place in a hole that is farthest from its wall and from the cuts of parts in it, float64[2]."""
    inner = [
        polygon_of(chain.curve, ROUGH_MM).buffer(kerf_mm)
        for chain in chains
        if not chain.is_open and chain.holder >= 0 and chain.depth == hole.depth + 1 and _lies_in(chain, hole)
    ]
    scrap = polygon_of(hole.curve, ROUGH_MM).difference(shapely.union_all(inner))
    if scrap.is_empty:
        return None
    middle, edge = shapely.get_coordinates(shapely.maximum_inscribed_circle(scrap))
    centre, wall = np.array(scrap.centroid.coords[0]), scrap.boundary
    room_mm = float(np.hypot(*(edge - middle))) - 2.0 * ROUGH_MM
    best = wall.distance(shapely.Point(centre)) >= room_mm and scrap.contains(shapely.Point(centre))
    return centre if best else middle


def _lies_in(chain: Chain, hole: Chain) -> bool:
    return bool(hole.curve.winding(chain.curve.xy[:1])[0])
