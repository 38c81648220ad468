# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ellipse points by the digital differential analyser, as published with the fixed-cycle method (part C).

A circle of radius Ry is stepped in whole resolutions; its X is stretched by Rx/Ry. Registers, all in
steps, N = Ry/Res:

    qx = qy = py = 0, px = N            px holds Y, py holds X
    each iteration:  qx += px;  if qx >= N:  qx -= N, X += 1, py += 1
                     qy += py;  if qy >= N:  qy -= N, Y -= 1, px -= 1

The first quadrant runs from (0, Ry) to (Rx, 0); the others are its mirror images. Every point is
at most Res * max(1, Rx/Ry) off the ellipse: for a few N the registers would leave the circle by up
to 1.015 steps, and there the resolution is made finer until the promise holds.
"""

from __future__ import annotations

import math

import numpy as np

from CNCStepper.errors import GeometryError
from CNCStepper.geometry.curve import Curve
from CNCStepper.kernels import njit

FIRST_ORDER = 1.005  # covers the terms of higher order: a deviation is below a hundredth of the radii
MOST_STEPS = 200_000


def ellipse_by_dda(radius_x_mm: float, radius_y_mm: float, resolution_mm: float, promise_mm: float = math.inf) -> Curve:
    """Return the closed point-by-point ellipse about the origin, counter-clockwise from its +Y vertex.

    The resolution is adjusted so that Ry/Res is whole, and made finer only where a point would be farther from
    the ellipse than Res * max(1, Rx/Ry), or than `promise_mm` where that is less. Raises GeometryError for
    values that are not positive or a resolution that asks for more than MOST_STEPS steps a radius.
    """
    if not (radius_x_mm > 0 and radius_y_mm > 0 and resolution_mm > 0):
        raise GeometryError(
            "dda", "radii and resolution must be positive", value=f"{resolution_mm:g} mm", advice="give values above 0"
        )
    if radius_y_mm / resolution_mm > MOST_STEPS:
        raise GeometryError(
            "dda-fine",
            "the resolution is too fine for the ellipse",
            value=f"{resolution_mm:g} mm",
            limit=f"{radius_y_mm / MOST_STEPS:g} mm",
            advice="make resolution_mm larger",
        )
    count = max(round(radius_y_mm / resolution_mm), 1)
    promise_mm = min(promise_mm, resolution_mm * max(1.0, radius_x_mm / radius_y_mm))
    radii_mm = np.array([radius_x_mm, radius_y_mm])
    quadrant = _unit_quadrant(count) * radii_mm
    while _deviation_mm(quadrant, radii_mm) > promise_mm and count > 1:
        count += 1
        quadrant = _unit_quadrant(count) * radii_mm
    left = quadrant * (-1.0, 1.0)  # from +Y to -X: counter-clockwise
    half = np.vstack([left, -quadrant[::-1][1:]])
    xy = np.vstack([half, -half[1:]])
    return Curve(xy, np.zeros(len(xy) - 1))


def _unit_quadrant(count: int) -> np.ndarray:
    return quadrant_steps(count) / count


def _deviation_mm(points: np.ndarray, radii_mm: np.ndarray) -> float:
    """Return how far the worst point is off the ellipse, to first order (the deviations are far below the radii)."""
    off = np.abs(((points / radii_mm) ** 2).sum(axis=1) - 1.0)
    slope = 2.0 * np.hypot(*(points / radii_mm**2).T)
    return float((off / slope).max()) * FIRST_ORDER


@njit
def quadrant_steps(count):
    """Return the points of the first quadrant in steps, int64 (n, 2), from (0, count) to (count, 0)."""
    steps = np.empty((2 * count + 1, 2), np.int64)
    x, y, qx, qy, points = 0, count, 0, 0, 0
    while True:
        if points == 0 or steps[points - 1, 0] != x or steps[points - 1, 1] != y:
            steps[points] = x, y
            points += 1
        if y == 0:
            return steps[:points]
        qx += y
        if qx >= count:
            qx -= count
            x = min(x + 1, count)  # near the end rounding would carry X past its vertex: it stops there
        qy += x
        if qy >= count:
            qy -= count
            y -= 1
