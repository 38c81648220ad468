# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random outlines for contours: alone, nested, side by side, open; with slivers, doubled points, crossings.

What they enclose is computed here by shapely alone, each outline turning part into hole and back.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import reduce

import numpy as np
import shapely
from shapely import Polygon
from shapely.geometry.base import BaseGeometry

from CNCStepper.geometry.curve import Curve, circle, from_points

CHORD_MM = 1e-4
LAYOUTS = ("alone", "nested", "deep", "neighbours", "sliver")
OPEN_MM = 40.0


@dataclass(frozen=True)
class Outlines:
    """Outlines and the tool; narrowest_mm: the width of the narrowest scrap that they bound, or of the part."""

    layout: str
    curves: tuple[Curve, ...]
    tool_mm: float
    narrowest_mm: float


def random_outlines(seed: int, rng: np.random.Generator, side: str) -> Outlines:
    """Return outlines for a side; the layout follows from the seed, so that each has its share."""
    layout = LAYOUTS[seed % len(LAYOUTS)]
    curves = tuple(_curves(layout, rng))
    narrowest_mm = narrowest(curves, side)
    return Outlines(
        layout, curves, round(narrowest_mm * float(rng.choice([rng.uniform(0.1, 1.0), 0.5, 0.9])), 3), narrowest_mm
    )


def random_line(rng: np.random.Generator) -> Curve:
    """Return an open chain of lines and arcs; it may cross itself."""
    count = int(rng.integers(2, 8))
    xy = np.column_stack([np.linspace(-OPEN_MM, OPEN_MM, count), rng.uniform(-15, 15, count)])
    if rng.random() < 0.3:
        xy = rng.uniform(-30, 30, (count, 2))
    bulge = rng.uniform(-0.6, 0.6, count - 1) * rng.integers(0, 2, count - 1)
    return Curve(xy, bulge)


def enclosed(curves: tuple[Curve, ...]) -> BaseGeometry:
    """Return what outlines enclose that hold or do not meet each other; those that cross are one."""
    shapes = sorted((polygon(curve) for curve in curves), key=lambda shape: -shape.area)
    return reduce(lambda part, shape: _toggled(part, shape), shapes, Polygon())


def _toggled(part: BaseGeometry, shape: BaseGeometry) -> BaseGeometry:
    inner = shape.buffer(-1e-3)
    return part.difference(shape) if not inner.is_empty and part.contains(inner) else part.union(shape)


def polygon(curve: Curve) -> BaseGeometry:
    """Return what a curve runs round, also where it crosses itself."""
    points = curve.points(CHORD_MM)
    simple = Polygon(points)
    if simple.is_valid:
        return simple
    faces = shapely.get_parts(shapely.polygonize([shapely.union_all(shapely.LineString(points))]))
    inside = [curve.winding(np.array([face.representative_point().coords[0]]))[0] != 0 for face in faces]
    return shapely.union_all(faces[inside])


def narrowest(curves: tuple[Curve, ...], side: str) -> float:
    """Return the width of the narrowest thing that the tool must fit into: a hole, an outline, else the part."""
    part = enclosed(curves)
    parts = list(shapely.get_parts(part))
    holes = [Polygon(ring) for each in parts for ring in each.interiors]
    bounded = [each for each in (parts if side == "inside" else holes or parts) if each.area > 0.5]
    return min(2.0 * shapely.maximum_inscribed_circle(each, tolerance=0.01).length for each in bounded)


def _curves(layout: str, rng: np.random.Generator) -> list[Curve]:
    outer = _shape(rng, rng.uniform(18, 40))
    if layout == "nested":
        return [outer, *_inside(outer, rng, int(rng.integers(1, 3)))]
    if layout == "deep":
        hole = circle((0.0, 0.0), 14.0) if rng.random() < 0.5 else _box(0.0, 0.0, 28.0, 26.0)
        return [_shape(rng, rng.uniform(2.0, 6.0)), hole, _box(0.0, 0.0, 60.0, 50.0)]
    if layout == "neighbours":
        width = outer.box_mm[2]
        other = _shape(rng, rng.uniform(8, 20))
        gap_mm = float(rng.choice([rng.uniform(0.5, 6.0), 0.0, 15.0]))
        return [outer, other.moved(width - other.box_mm[0] + gap_mm, rng.uniform(-10, 10))]
    if layout == "sliver":
        thin_mm = float(rng.choice([0.02, 0.3, 1.0]))
        spike = [(-20, -12), (20, -12), (20, 0), (34, thin_mm / 2), (20, thin_mm), (20, 12), (0, 12), (0, -2)]
        return [
            from_points([*spike, (-thin_mm, -2), (-thin_mm, 12), (-20, 12)], closed=True).rotated(rng.uniform(0, 360))
        ]
    return [outer]


def _inside(outer: Curve, rng: np.random.Generator, count: int) -> list[Curve]:
    """Return outlines well within the largest circle that the outer one holds."""
    line = shapely.maximum_inscribed_circle(polygon(outer), tolerance=0.01)
    (x, y), radius_mm = line.coords[0], line.length
    if count == 1:
        return [_fitted(_shape(rng, 10.0), x, y, 0.75 * radius_mm)]
    return [_fitted(_shape(rng, 10.0), x + way * radius_mm / 2, y, 0.4 * radius_mm) for way in (-1, 1)]


def _fitted(curve: Curve, x: float, y: float, radius_mm: float) -> Curve:
    far_mm = float(np.hypot(*curve.points(0.01).T).max())
    return curve.scaled(radius_mm / far_mm).moved(x, y)


def _shape(rng: np.random.Generator, size_mm: float) -> Curve:
    kind = rng.choice(["star", "arcs", "smooth", "slot", "box", "circle", "tangle", "doubled"])
    angles = np.sort((np.arange(7) + rng.uniform(0.1, 0.9, 7)) * 2 * math.pi / 7)
    ring = size_mm * np.column_stack([np.cos(angles), np.sin(angles)])
    if kind == "star":
        return from_points(ring * rng.uniform(0.45, 1.2, (7, 1)), closed=True)
    if kind == "arcs":
        closed = np.vstack([ring, ring[:1]]) * np.append(scale := rng.uniform(0.7, 1.1, 7), scale[0])[:, None]
        return Curve(closed, rng.uniform(-0.3, 0.5, 7) * rng.integers(0, 2, 7))
    if kind == "smooth":
        turn = np.linspace(0, 2 * math.pi, int(rng.integers(40, 120)), endpoint=False)
        far = size_mm * (1 + 0.3 * np.sin(rng.integers(2, 6) * turn))
        return from_points(np.column_stack([far * np.cos(turn), far * np.sin(turn)]), closed=True)
    if kind == "slot":
        wide = size_mm * rng.uniform(0.2, 0.6)
        xy = np.array([(-size_mm, -wide), (size_mm, -wide), (size_mm, wide), (-size_mm, wide), (-size_mm, -wide)])
        return Curve(xy, np.array([0, 1, 0, 1.0])).rotated(float(rng.uniform(0, 360)))
    if kind == "box":
        return _box(0.0, 0.0, *np.round(size_mm * rng.uniform(0.8, 2.0, 2)))
    if kind == "circle":
        return circle((0.0, 0.0), size_mm)
    if kind == "tangle":
        return from_points(ring[[0, 2, 3, 1, 5, 4]], closed=True)
    doubled = np.repeat(np.vstack([ring, ring[:1]]), 2, axis=0)
    return Curve(doubled, np.zeros(len(doubled) - 1))


def _box(x: float, y: float, width: float, height: float) -> Curve:
    corners = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)]) * (width / 2, height / 2)
    return from_points(corners + np.array([x, y]), closed=True)
