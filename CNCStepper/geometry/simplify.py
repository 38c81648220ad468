# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fewer points of a freehand line, none of the line farther from the drawn one than a tolerance."""

from __future__ import annotations

import numpy as np
from shapely import LineString

from CNCStepper.errors import GeometryError
from CNCStepper.geometry.curve import Curve


def simplified(curve: Curve, tolerance_mm: float) -> Curve:
    """Return a polyline through some of the curve's own points (Douglas and Peucker 1973, through shapely).

    Every point of one lies within `tolerance_mm` of the other; ends stay. A curve with arcs is returned as it is.
    A closed curve keeps its first point and the one farthest from it, so that it never collapses.
    """
    if not tolerance_mm >= 0:
        raise GeometryError("simplify", "the tolerance is negative", value=f"{tolerance_mm:g} mm", limit="0 mm")
    if curve.bulge.any() or len(curve) < 2:
        return curve
    parts = _halves(curve.xy) if curve.closed else [curve.xy]
    kept = [np.asarray(LineString(part).simplify(tolerance_mm, preserve_topology=False).coords) for part in parts]
    xy = np.vstack([kept[0], *(part[1:] for part in kept[1:])])
    return Curve(xy, np.zeros(len(xy) - 1))


def _halves(ring: np.ndarray) -> list[np.ndarray]:
    farthest = int(np.argmax(np.hypot(*(ring - ring[0]).T)))
    if farthest in (0, len(ring) - 1):
        return [ring]
    return [ring[: farthest + 1], ring[farthest:]]
