# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rectangles along the axes, their corners sharp or round."""

from __future__ import annotations

import math

import numpy as np

from CNCStepper.errors import GeometryError, Text
from CNCStepper.geometry.curve import Curve, from_points

QUARTER_BULGE = math.tan(math.pi / 8.0)


def rectangle(corner_a: tuple[float, float], corner_b: tuple[float, float], corner_radius_mm: float = 0.0) -> Curve:
    """Return the rectangle with that diagonal, counter-clockwise from the left end of its lower side.

    Raises GeometryError when it has no width or height, or a corner radius above half of the shorter side.
    """
    low, high = np.minimum(corner_a, corner_b), np.maximum(corner_a, corner_b)
    short_mm = float((high - low).min())
    if not short_mm > 0:
        raise GeometryError(
            "rectangle-flat",
            "the corners of a rectangle's diagonal must differ in x and in y",
            value=Text("{high:g} by {high2:g} mm", high=high[0] - low[0], high2=high[1] - low[1]),
            limit="above 0 mm",
            advice="move one of the corners",
        )
    if 2.0 * corner_radius_mm > short_mm:
        raise GeometryError(
            "rectangle-radius",
            "a rectangle's corner radius must not exceed half of its shorter side",
            value=f"{corner_radius_mm:g} mm",
            limit=f"{short_mm / 2.0:g} mm",
            advice="make the corner radius smaller",
        )
    corners = np.array([low, (high[0], low[1]), high, (low[0], high[1])])
    if not corner_radius_mm:
        return from_points(corners, closed=True)
    along = np.array([(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)]) * corner_radius_mm
    sides = [point for k in range(4) for point in (corners[k] + along[k], corners[(k + 1) % 4] - along[k])]
    return Curve(np.array([*sides, sides[0]]), np.array([0.0, QUARTER_BULGE] * 4)).without_short()
