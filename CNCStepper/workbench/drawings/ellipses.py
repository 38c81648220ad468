# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finds the one whole ellipse that a drawing holds."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from CNCStepper.errors import GeometryError, Text
from CNCStepper.tolerances import SAME_MM, SAME_SHARE
from CNCStepper.workbench.drawings.shapes import edges_of


@dataclass(frozen=True)
class EllipseFound:
    """An ellipse in the document's coordinates; rotation_deg is from X to the axis of radius_x_mm, in (-90, 90]."""

    centre_mm: tuple[float, float]
    radius_x_mm: float
    radius_y_mm: float
    rotation_deg: float


def ellipse_of(drawing: Any, picked: Sequence[str] = ()) -> EllipseFound:
    """Return the ellipse or circle of a drawing that holds nothing else; raises GeometryError.

    It may be drawn as several arcs that close it.
    """
    edges = edges_of(drawing, picked)
    found = [_found(edge.Curve, drawing.Label) for edge in edges]
    if any(not _same(found[0], other) for other in found[1:]):
        raise GeometryError(
            "ellipse-not-alone",
            Text("the drawing '{drawing}' holds more than one ellipse", drawing=drawing.Label),
            value=f"{len(edges)} lines",
            advice="leave one ellipse in it and draw the rest elsewhere or as construction lines",
        )
    sweep_rad = sum(edge.LastParameter - edge.FirstParameter for edge in edges)
    if abs(sweep_rad - math.tau) > SAME_SHARE:
        raise GeometryError(
            "ellipse-open",
            Text("the ellipse in '{drawing}' is open", drawing=drawing.Label),
            value=f"{math.degrees(sweep_rad):.4g} deg",
            limit="360 deg",
            advice="close it: draw a whole ellipse instead of an arc",
        )
    return found[0]


def _found(curve: Any, label: str) -> EllipseFound:
    import Part

    if isinstance(curve, Part.Circle):
        return EllipseFound((curve.Center.x, curve.Center.y), curve.Radius, curve.Radius, 0.0)
    if not isinstance(curve, Part.Ellipse):
        raise GeometryError(
            "ellipse-missing",
            Text("the drawing '{label}' holds a line that is no ellipse", label=label),
            value=type(curve).__name__,
            advice="leave one ellipse in it, drawn as an ellipse and not as a B-spline",
        )
    rotation_deg = math.degrees(math.atan2(curve.XAxis.y, curve.XAxis.x))
    return _upright((curve.Center.x, curve.Center.y), curve.MajorRadius, curve.MinorRadius, rotation_deg)


def _upright(centre: tuple[float, float], major_mm: float, minor_mm: float, rotation_deg: float) -> EllipseFound:
    """Name the axis nearer to X first, so that an ellipse drawn upright has no rotation."""
    turned = (rotation_deg + 90.0) % 180.0 - 90.0
    if abs(turned) <= 45.0:
        return EllipseFound(centre, major_mm, minor_mm, _clean(turned))
    return EllipseFound(centre, minor_mm, major_mm, _clean(turned - math.copysign(90.0, turned)))


def _clean(angle_deg: float) -> float:
    return 0.0 if abs(angle_deg) < 1e-9 else angle_deg


def _same(one: EllipseFound, other: EllipseFound) -> bool:
    near = math.dist(one.centre_mm, other.centre_mm) < SAME_MM
    radii = abs(one.radius_x_mm - other.radius_x_mm) + abs(one.radius_y_mm - other.radius_y_mm) < SAME_MM
    return near and radii and abs(one.rotation_deg - other.rotation_deg) < SAME_SHARE
