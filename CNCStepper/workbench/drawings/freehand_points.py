# SPDX-License-Identifier: LGPL-2.1-or-later
"""The points of a freehand line, checked, and simplified or smoothed."""

from __future__ import annotations

import numpy as np

from CNCStepper.errors import GeometryError
from CNCStepper.geometry.curve import Curve, from_points
from CNCStepper.geometry.fitting.point_fit import refitted
from CNCStepper.geometry.fitting.simplify import simplified
from CNCStepper.tolerances import SAME_HEIGHT_MM


def freehand_curve(
    points: list[tuple[float, ...]], tolerance_mm: float, smooth_mm: float, closed: bool
) -> tuple[float, Curve]:
    """Return the height of a line's points (X, Y, Z), and their curve.

    With `smooth_mm` above 0 the curve has arcs and lines within it, else straight lines within `tolerance_mm`.
    Raises GeometryError for a negative tolerance, points at different heights, or fewer than two places.
    """
    require_not_negative(tolerance_mm)
    require_not_negative(smooth_mm)
    rows = np.array(points, float).reshape(-1, 3)
    if len(rows) and np.ptp(rows[:, 2]) > SAME_HEIGHT_MM:
        raise GeometryError(
            "line-not-flat",
            "the points of a freehand line lie at different heights",
            value=f"{np.ptp(rows[:, 2]):.4g} mm",
            limit=f"{SAME_HEIGHT_MM} mm",
            advice="give all points one Z and tilt the line by its Placement",
        )
    curve = from_points(rows[:, :2], closed)
    return float(rows[0, 2]), refitted(curve, smooth_mm) if smooth_mm else simplified(curve, tolerance_mm)


def require_not_negative(tolerance_mm: float) -> None:
    """Raise GeometryError for a negative tolerance."""
    if not tolerance_mm >= 0:
        raise GeometryError(
            "tolerance", "the tolerance must not be negative", value=f"{tolerance_mm:g} mm", advice="give 0 or more"
        )
