# SPDX-License-Identifier: LGPL-2.1-or-later
r"""What a disc covers that runs along curves, exactly: lines and arcs again.

 .--------------.       A curve and the same curve run back bound a part of the plane that is no wider than
(  ------------  )      a line; what lies within the radius of it is that part grown.
 '--------------'
"""

from __future__ import annotations

from collections.abc import Sequence

import shapely
from shapely.geometry.base import BaseGeometry

from CNCStepper.geometry.curve import Curve, joined
from CNCStepper.geometry.curve_bundle import bundle_of
from CNCStepper.geometry.offset import left_loops
from CNCStepper.geometry.region import Region
from CNCStepper.geometry.shapely_polygons import polygons_of

TOLERANCE_MM = 0.004  # of which an offset uses an eighth at most
FLAT_MM = 0.0004


def swept(curves: Sequence[Curve], radius_mm: float) -> BaseGeometry:
    """Return the area as polygon(s) within 0.0005 mm; the curves themselves as lines when there is no radius."""
    if not curves:
        return shapely.Polygon()
    if not radius_mm > 0.0:
        return shapely.union_all([shapely.LineString(curve.points(FLAT_MM)) for curve in curves])
    strokes: list[Curve] = []
    for curve in curves:
        strokes += [curve, curve.reversed()] if curve.closed else [joined([curve, curve.reversed()])]
    around = left_loops(bundle_of(strokes), radius_mm, TOLERANCE_MM)
    return polygons_of(Region.trusted(around.reversed()), FLAT_MM)
