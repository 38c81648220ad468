# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fewer points of a freehand line, none of the line farther from the drawn one than a tolerance."""

from __future__ import annotations

import numpy as np
from shapely import LineString

from CNCStepper.errors import GeometryError
from CNCStepper.geometry.curve import Curve

STRETCH = 2_000  # points simplified at once: shapely's search calls itself and takes n² steps at worst


def simplified(curve: Curve, tolerance_mm: float) -> Curve:
    """Return a polyline through some of the curve's own points (Douglas and Peucker 1973, through shapely).

    Every point of one lies within `tolerance_mm` of the other; ends stay. A curve with arcs is returned as it is.
    A closed curve keeps its first point and the one farthest from it, so that it never collapses; of a long one
    the ends of each STRETCH stay too.
    """
    if not tolerance_mm >= 0:
        raise GeometryError(
            "simplify", "the tolerance is negative", value=f"{tolerance_mm:g} mm", limit="0 mm", advice="give 0 or more"
        )
    if curve.bulge.any() or len(curve) < 2:
        return curve
    parts = [stretch for half in _halves(curve) for stretch in _stretches(half)]
    kept = [np.asarray(LineString(part).simplify(tolerance_mm, preserve_topology=False).coords) for part in parts]
    xy = np.vstack([kept[0], *(part[1:] for part in kept[1:])])
    return Curve(xy, np.zeros(len(xy) - 1))


def _halves(curve: Curve) -> list[np.ndarray]:
    """Return a closed curve's points from the first to the farthest and on; an open one's as they are."""
    farthest = int(np.argmax(np.hypot(*(curve.xy - curve.xy[0]).T)))
    if not curve.closed or farthest in (0, len(curve)):
        return [curve.xy]
    return [curve.xy[: farthest + 1], curve.xy[farthest:]]


def _stretches(xy: np.ndarray) -> list[np.ndarray]:
    return [xy[first : first + STRETCH + 1] for first in range(0, len(xy) - 1, STRETCH)]
