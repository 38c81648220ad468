# SPDX-License-Identifier: LGPL-2.1-or-later
"""Outlines of lines and arcs that the shapes of the library are made of, exact and counter-clockwise."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

import numpy as np

from CNCStepper.errors import GeometryError, Text
from CNCStepper.geometry.curve import Curve, circle, from_points
from CNCStepper.tolerances import SAME_MM

Point = tuple[float, float]
HALF = 1.0  # bulge of a half circle


def disc(diameter_mm: float, centre: Point = (0.0, 0.0)) -> Curve:
    """Return a circle of that diameter."""
    return circle(centre, diameter_mm / 2.0)


def polygon(points: Iterable[Point]) -> Curve:
    """Return a closed polygon, turned counter-clockwise."""
    curve = from_points(points, closed=True)
    return curve if curve.area_mm2 > 0 else curve.reversed()


def bulged(rows: Sequence[tuple[float, float, float]]) -> Curve:
    """Return the closed outline through rows of x, y and the bulge to the next one, turned counter-clockwise."""
    columns = np.array([*rows, rows[0]], float)
    curve = Curve(columns[:, :2], columns[:-1, 2]).without_short()
    return curve if curve.area_mm2 > 0 else curve.reversed()


def bulge_of(sweep_deg: float) -> float:
    """Return the bulge of an arc that turns by an angle, counter-clockwise above 0."""
    return math.tan(math.radians(sweep_deg) / 4.0)


def on_circle(radius_mm: float, angle_deg: float, centre: Point = (0.0, 0.0)) -> Point:
    """Return the point of a circle at an angle from X."""
    angle = math.radians(angle_deg)
    return centre[0] + radius_mm * math.cos(angle), centre[1] + radius_mm * math.sin(angle)


def bolt_holes(
    circle_diameter_mm: float, hole_diameter_mm: float, count: int, start_deg: float = 0.0
) -> tuple[Curve, ...]:
    """Return holes evenly spaced on a circle about the zero."""
    radius_mm, step_deg = circle_diameter_mm / 2.0, 360.0 / count
    places = (on_circle(radius_mm, start_deg + number * step_deg) for number in range(count))
    return tuple(disc(hole_diameter_mm, place) for place in places)


def corner_holes(width_mm: float, height_mm: float, hole_diameter_mm: float) -> tuple[Curve, ...]:
    """Return four holes at the corners of a rectangle about the zero."""
    x, y = width_mm / 2.0, height_mm / 2.0
    return tuple(disc(hole_diameter_mm, place) for place in ((-x, -y), (x, -y), (x, y), (-x, y)))


def rounded(points: Sequence[Point], radius_mm: float | Sequence[float]) -> Curve:
    """Return a polygon whose corners are arcs of a radius, or each of its own; 0 leaves a corner sharp.

    Raises GeometryError where a radius is larger than the sides beside its corner allow.
    """
    radii = [radius_mm] * len(points) if isinstance(radius_mm, int | float) else list(radius_mm)
    places = [complex(*point) for point in points]
    cuts = [_cut(places, number, radius) for number, radius in enumerate(radii)]
    for number in range(len(places)):
        after = (number + 1) % len(places)
        side_mm = abs(places[after] - places[number])
        if cuts[number][0] + cuts[after][0] > side_mm + SAME_MM:
            raise GeometryError(
                "shape-size",
                Text("a corner radius of {radius:g} mm is too large for a side", radius=max(radii)),
                value=f"{cuts[number][0] + cuts[after][0]:.4g} mm",
                limit=f"{side_mm:.4g} mm",
                advice="make it smaller",
            )
    rows: list[tuple[float, float, float]] = []
    for number, (cut_mm, bulge) in enumerate(cuts):
        place, before, after_place = places[number], places[number - 1], places[(number + 1) % len(places)]
        if cut_mm == 0.0:
            rows.append((place.real, place.imag, 0.0))
            continue
        first = place + cut_mm * (before - place) / abs(before - place)
        last = place + cut_mm * (after_place - place) / abs(after_place - place)
        rows += [(first.real, first.imag, bulge), (last.real, last.imag, 0.0)]
    return bulged(rows)


def _cut(places: Sequence[complex], number: int, radius_mm: float) -> tuple[float, float]:
    """Return how far from a corner its arc begins, and the arc's bulge."""
    to_it = places[number] - places[number - 1]
    from_it = places[(number + 1) % len(places)] - places[number]
    turn = math.atan2((to_it.conjugate() * from_it).imag, (to_it.conjugate() * from_it).real)
    if radius_mm == 0.0 or turn == 0.0:
        return 0.0, 0.0
    return radius_mm * abs(math.tan(turn / 2.0)), math.tan(turn / 4.0)


def hull_of_circles(circles: Sequence[tuple[float, float, float]]) -> Curve:
    """Return the taut band around circles, rows of x, y and radius counter-clockwise, none within another.

    Raises GeometryError where one circle lies within its neighbour.
    """
    rows: list[tuple[float, float, float]] = []
    normals = [_normal(one, circles[(number + 1) % len(circles)]) for number, one in enumerate(circles)]
    for number, (x, y, radius) in enumerate(circles):
        arrives, leaves = normals[number - 1], normals[number]
        sweep = (math.atan2(leaves.imag, leaves.real) - math.atan2(arrives.imag, arrives.real)) % math.tau
        first, last = complex(x, y) + radius * arrives, complex(x, y) + radius * leaves
        parts = 2 if sweep > math.pi else 1
        middle = complex(x, y) + radius * arrives * complex(math.cos(sweep / 2.0), math.sin(sweep / 2.0))
        bulge = math.tan(sweep / parts / 4.0)
        rows.append((first.real, first.imag, bulge))
        rows += [(middle.real, middle.imag, bulge)] * (parts - 1)
        rows.append((last.real, last.imag, 0.0))
    return bulged(rows)


def _normal(one: tuple[float, float, float], other: tuple[float, float, float]) -> complex:
    """Return the outward normal, of length 1, of the tangent from one circle to the next, on the right of the way."""
    way = complex(other[0] - one[0], other[1] - one[1])
    share = (one[2] - other[2]) / abs(way) if abs(way) else 2.0
    if abs(share) >= 1.0:
        raise GeometryError(
            "shape-size", "one circle of the shape lies within another", advice="set them farther apart"
        )
    return way / abs(way) * complex(share, -math.sqrt(1.0 - share * share))
