# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random regions for the tests of offsets, and shapely as the judge of what lies at a distance from them.

shapely's buffer of a whole outline is no judge: it simplifies the outline first and fills notches by that (seeds
162 and 258 showed areas of several mm² that lie farther from every wall than the distance). The union of the
buffers of single chords simplifies nothing.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import shapely
from shapely import Polygon
from shapely.geometry.base import BaseGeometry

from CNCStepper.geometry.curve import Curve, circle, from_points
from CNCStepper.geometry.region import Region

CHORD_MM = 5e-4  # how far the judge's chords leave arcs
SPECK_MM2 = 1e-6
KINDS = ("circle", "star", "arcs", "slot", "box", "tangle", "sampled", "comb", "tiny", "stadium-touch")


GRID_KINDS = ("box", "comb", "stadium-touch")


@dataclass(frozen=True)
class Case:
    """Outlines, islands and the distance; `kinds` says of what they are made."""

    seed: int
    outlines: list[Curve]
    islands: list[Curve]
    distance_mm: float
    kinds: set[str]


def random_case(seed: int) -> Case:
    """Return a case: one or two outlines, up to four islands, of all kinds; those on a grid touch."""
    rng = np.random.default_rng(seed)
    kinds = set()
    choice = GRID_KINDS if rng.random() < 0.4 else KINDS

    def curve(at: np.ndarray, size_mm: float) -> Curve:
        kind = str(rng.choice(choice))
        kinds.add(kind)
        return SHAPES[kind](rng, at, size_mm)

    outlines = [curve(rng.uniform(-10, 10, 2), rng.uniform(10, 40)) for _ in range(rng.choice([1, 1, 1, 2]))]
    islands = [curve(rng.uniform(-20, 20, 2), rng.uniform(1, 8)) for _ in range(rng.choice([0, 1, 2, 4, 5]))]
    distance_mm = rng.choice([rng.uniform(0.2, 4), rng.uniform(2, 5), rng.integers(1, 8), 0.5]) * rng.choice(
        [-1, -1, -1, 1]
    )
    return Case(seed, outlines, islands, float(distance_mm), kinds)


def polar(at: np.ndarray, angles: np.ndarray, radii_mm: np.ndarray) -> Curve:
    """Return the closed polyline through points given by angle and radius."""
    return from_points(np.asarray(at) + np.column_stack([radii_mm * np.cos(angles), radii_mm * np.sin(angles)]), True)


def a_circle(rng: np.random.Generator, at: np.ndarray, size_mm: float) -> Curve:
    """Return a full circle."""
    return circle((at[0], at[1]), size_mm)


def a_star(rng: np.random.Generator, at: np.ndarray, size_mm: float) -> Curve:
    """Return a polygon with deep notches."""
    count = rng.integers(3, 14)
    return polar(at, np.sort(rng.uniform(0, 2 * math.pi, count)), size_mm * rng.uniform(0.3, 1.2, count))


def some_arcs(rng: np.random.Generator, at: np.ndarray, size_mm: float) -> Curve:
    """Return a chain of lines and of arcs that turn either way."""
    count = rng.integers(3, 10)
    ring = polar(at, np.sort(rng.uniform(0, 2 * math.pi, count)), size_mm * rng.uniform(0.4, 1.2, count))
    return Curve(ring.xy, rng.uniform(-0.5, 0.9, len(ring)) * rng.integers(0, 2, len(ring)))


def a_slot(rng: np.random.Generator, at: np.ndarray, size_mm: float) -> Curve:
    """Return lines with tangent half circles."""
    half, wide = size_mm, size_mm * rng.uniform(0.1, 0.6)
    xy = [(-half, -wide), (half, -wide), (half, wide), (-half, wide), (-half, -wide)]
    turn = rng.choice([0.0, 45.0, rng.uniform(0, 360)])
    return Curve(np.array(xy), np.array([0, 1, 0, 1.0])).rotated(float(turn)).moved(*at)


def a_box(rng: np.random.Generator, at: np.ndarray, size_mm: float) -> Curve:
    """Return a box on a grid of 1 mm: such ones share edges and corners."""
    wide, high = np.maximum(np.round(size_mm * rng.uniform(0.3, 1.3, 2)), 1)
    x, y = np.round(at)
    return from_points([(x - wide, y - high), (x + wide, y - high), (x + wide, y + high), (x - wide, y + high)], True)


def a_tangle(rng: np.random.Generator, at: np.ndarray, size_mm: float) -> Curve:
    """Return a polygon that crosses itself."""
    return from_points(np.asarray(at) + rng.normal(0, size_mm, (rng.integers(4, 9), 2)), True)


def a_sampled(rng: np.random.Generator, at: np.ndarray, size_mm: float) -> Curve:
    """Return a smooth outline given by many points."""
    angles = np.linspace(0, 2 * math.pi, rng.integers(50, 400), endpoint=False)
    return polar(at, angles, size_mm * (1 + 0.3 * np.sin(rng.integers(2, 7) * angles + rng.uniform(0, 6))))


def a_comb(rng: np.random.Generator, at: np.ndarray, size_mm: float) -> Curve:
    """Return equal teeth and slots on the grid: many places at just the same distance."""
    teeth = rng.integers(2, 6)
    w = round(size_mm / teeth) + 1
    spine = w * rng.choice([1.0, 0.4])
    xy = [(2 * i * w + x, y) for i in range(teeth) for x, y in ((0, 0), (0, 3 * w), (w, 3 * w), (w, 0))]
    return from_points(np.array([*xy, ((2 * teeth - 1) * w, -spine), (0, -spine)]) + np.round(at), True)


def a_tiny(rng: np.random.Generator, at: np.ndarray, size_mm: float) -> Curve:
    """Return a polygon whose points stand there twice, or nearly, with steps down to a nanometre between."""
    star = a_star(rng, at, size_mm).xy[:-1]
    steps = rng.normal(0, 1, star.shape) * 10.0 ** rng.uniform(-9, -2, (len(star), 1))
    xy = np.stack([star, star, star + steps], axis=1).reshape(-1, 2)
    return Curve(np.vstack([xy, xy[:1]]), np.zeros(len(xy)))


def a_touching(rng: np.random.Generator, at: np.ndarray, size_mm: float) -> Curve:
    """Return a box on the grid with half circles on two sides, which touch others in one point."""
    return Curve(a_box(rng, at, size_mm).xy, np.array([0, 1.0, 0, 1.0]))


SHAPES = dict(
    zip(
        KINDS,
        (a_circle, a_star, some_arcs, a_slot, a_box, a_tangle, a_sampled, a_comb, a_tiny, a_touching),
        strict=True,
    )
)


def polygon(curve: Curve) -> BaseGeometry:
    """Return what a curve runs round, by shapely's own faces where it crosses itself."""
    points = curve.points(CHORD_MM / 10)
    simple = Polygon(points) if len(points) > 3 else Polygon()
    if simple.is_valid:
        return simple
    faces = shapely.get_parts(shapely.polygonize([shapely.union_all(shapely.LineString(points))]))
    places = shapely.get_coordinates(shapely.point_on_surface(faces))
    return shapely.union_all(faces[turns(points, places) != 0])


def turns(points: np.ndarray, places: np.ndarray) -> np.ndarray:
    """Return how often a closed polyline runs round each place, by the angles that it is seen to turn."""
    seen = (points @ (1, 1j))[None, :] - (places @ (1, 1j))[:, None]
    return np.rint(np.angle(seen[:, 1:] / seen[:, :-1]).sum(axis=1) / (2 * math.pi)).astype(int)


def wanted_region(case: Case) -> BaseGeometry:
    """Return what lies in an outline and in no island."""
    outer, inner = (shapely.union_all([polygon(curve) for curve in curves]) for curves in (case.outlines, case.islands))
    return without_specks(outer.difference(inner))


def without_specks(region: BaseGeometry) -> BaseGeometry:
    """Return the region without parts and holes of less than SPECK_MM2: chords leave such between arcs that touch."""
    parts = [part for part in shapely.get_parts(region) if part.area > SPECK_MM2]
    holes = [[hole for hole in part.interiors if Polygon(hole).area > SPECK_MM2] for part in parts]
    return shapely.union_all([Polygon(part.exterior, hole) for part, hole in zip(parts, holes, strict=True)])


def wanted_offset(region: BaseGeometry, distance_mm: float) -> BaseGeometry:
    """Return the region grown or shrunk, from the buffers of its single chords."""
    lines = shapely.get_parts(shapely.get_parts(region.simplify(CHORD_MM).boundary))
    coordinates, index = shapely.get_coordinates(lines, return_index=True)
    edges = np.stack([coordinates[:-1], coordinates[1:]], axis=1)[index[:-1] == index[1:]]
    quarter = math.ceil(math.pi / 4 / math.sqrt(2 * CHORD_MM / max(abs(distance_mm), CHORD_MM))) + 2
    band = shapely.union_all(shapely.buffer(shapely.linestrings(edges), abs(distance_mm), quad_segs=quarter))
    return region.union(band) if distance_mm > 0 else region.difference(band)


def shapely_of(region: Region) -> BaseGeometry:
    """Return a region of ours for the judge."""
    found = []
    for part in region.parts():
        outer = [shapely.make_valid(polygon(loop)) for loop in part.loops if loop.area_mm2 > 0]
        holes = [shapely.make_valid(polygon(loop)) for loop in part.loops if loop.area_mm2 <= 0]
        found.append(shapely.union_all(outer).difference(shapely.union_all(holes)))
    return shapely.union_all(found)
