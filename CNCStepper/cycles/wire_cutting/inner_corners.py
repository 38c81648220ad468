# SPDX-License-Identifier: LGPL-2.1-or-later
r"""What stays in inner corners of the parts, and in places narrower than the kerf: the wire is round and cannot enter.

|  part          the ring, half a kerf off, shrunk by half a kerf again, is
|   .            the part with round inner corners; the difference stays
|____ `.____
"""

from __future__ import annotations

from collections.abc import Sequence

import shapely

from CNCStepper.cycles.cycle import RestCorner
from CNCStepper.cycles.wire_cutting.wire_items import OFFSET_TOLERANCE_MM, Items
from CNCStepper.errors import Text
from CNCStepper.geometry.region import Region
from CNCStepper.geometry.shapely_polygons import polygons_of

THIN_MM = 0.02  # what is thinner is no rest


def rest_corners(items: Items, kerf_mm: float) -> list[RestCorner]:
    """Return the places that the wire does not reach, the thickest first."""
    found: list[RestCorner] = []
    for part in items.parts:
        rings = (part.ring.reversed(), *(hole.ring.reversed() for hole in part.holes))
        made = polygons_of(Region(rings).offset(-kerf_mm / 2.0, OFFSET_TOLERANCE_MM))
        rest = made.difference(part.polygon).buffer(-THIN_MM / 2.0)
        found += [_corner(piece) for piece in shapely.get_parts(rest) if not piece.is_empty]
    return sorted(found, key=lambda corner: -corner.thick_mm)


def rest_warnings(corners: Sequence[RestCorner]) -> list[str]:
    """Return a warning of what stays, with the place of the thickest."""
    if not corners:
        return []
    x, y = corners[0].place_mm
    return [
        Text(
            "the wire is too thick for {corners} inner corner(s) or narrow place(s); up to {thick_mm:.3f} mm stays, "
            "most at X{x:.3f} Y{y:.3f}",
            corners=len(corners),
            thick_mm=corners[0].thick_mm,
            x=x,
            y=y,
        )
    ]


def _corner(piece: shapely.Polygon) -> RestCorner:
    circle = shapely.maximum_inscribed_circle(piece, tolerance=THIN_MM / 4.0)
    x, y = circle.coords[0]
    return RestCorner(2.0 * circle.length + THIN_MM, (float(x), float(y)), float(piece.area))
