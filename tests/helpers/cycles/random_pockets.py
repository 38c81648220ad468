# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random regions for pockets: islands, necks at which offsets fall apart, slivers, slots, crossings, touching shapes.

What is wanted is drawn here by shapely alone.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import shapely
from shapely.geometry.base import BaseGeometry

from CNCStepper.geometry.curve import Curve, circle, from_points
from helpers.cycles.random_outlines import polygon

LAYOUTS = ("islands", "neck", "sliver", "slot", "tangle", "arcs", "touching", "points")
SHARES = (0.1, 0.3, 0.5, 0.7, 0.95, 1.0)


@dataclass(frozen=True)
class Shapes:
    """Outlines, islands, and the tool; narrowest_mm: of what the tool is meant to go through."""

    layout: str
    outlines: tuple[Curve, ...]
    islands: tuple[Curve, ...]
    narrowest_mm: float
    tool_mm: float

    @property
    def region(self) -> BaseGeometry:
        """What lies in an outline and in no island."""
        outer, inner = (shapely.union_all([polygon(one) for one in some]) for some in (self.outlines, self.islands))
        return outer.difference(inner)


def random_shapes(seed: int, rng: np.random.Generator) -> Shapes:
    """Return shapes; the layout follows from the seed, so that each has its share."""
    layout = LAYOUTS[seed % len(LAYOUTS)]
    outlines, islands, narrowest_mm = _MAKERS[layout](rng)
    turn = float(rng.choice([0.0, 30.0, rng.uniform(0, 360)]))
    outlines, islands = ([one.rotated(turn) for one in some] for some in (outlines, islands))
    share = float(rng.choice([*SHARES[1:4], rng.uniform(*SHARES[:2]), rng.uniform(*SHARES[3:5]), *SHARES[4:]]))
    share = 1.0 if layout == "slot" and rng.random() < 0.5 else share
    return Shapes(layout, tuple(outlines), tuple(islands), narrowest_mm, share * narrowest_mm)


def box(x: float, y: float, wide: float, high: float) -> Curve:
    """Return a rectangle by its lower left corner."""
    return from_points([(x, y), (x + wide, y), (x + wide, y + high), (x, y + high)], True)


def slot(long_mm: float, wide_mm: float) -> Curve:
    """Return two lines with half circles."""
    x, y = long_mm / 2, wide_mm / 2
    return Curve(np.array([(-x, -y), (x, -y), (x, y), (-x, y), (-x, -y)]), np.array([0, 1, 0, 1.0]))


Made = tuple[list[Curve], list[Curve], float]


def _islands(rng: np.random.Generator) -> Made:
    gap_mm = rng.uniform(3, 6)
    size_mm = rng.uniform(3, 5)
    spots = [(gap_mm + size_mm, gap_mm + size_mm), (2 * gap_mm + 3 * size_mm, gap_mm + size_mm)]
    islands = [circle(spots[0], size_mm), box(spots[1][0] - size_mm, spots[1][1] - size_mm, 2 * size_mm, 2 * size_mm)]
    outline = box(0, 0, 3 * gap_mm + 4 * size_mm, 2 * gap_mm + 2 * size_mm)
    return [outline], islands, gap_mm


def _neck(rng: np.random.Generator) -> Made:
    """Two rooms and a passage: the offset falls in two where it is narrower than they are."""
    neck_mm = rng.uniform(2, 6)
    rooms = [box(0, 0, *rng.uniform(neck_mm + 3, 16, 2)), box(22, 0, *rng.uniform(neck_mm + 3, 16, 2))]
    return [*rooms, box(1, 1, 23, neck_mm)], [], neck_mm


def _sliver(rng: np.random.Generator) -> Made:
    long_mm, high_mm = rng.uniform(20, 40), rng.uniform(3, 8)
    return [from_points([(0, 0), (long_mm, 0), (long_mm, high_mm)], True)], [], 0.8 * high_mm


def _slot(rng: np.random.Generator) -> Made:
    wide_mm, long_mm = rng.uniform(2, 8), rng.uniform(0, 25)
    if long_mm < 5:
        return [circle((1, 2), wide_mm / 2)], [], wide_mm
    beside = [box(long_mm / 2 - 1, -wide_mm, 2 * wide_mm, 2 * wide_mm)] if rng.random() < 0.5 else []
    return [slot(long_mm, wide_mm), *beside], [], wide_mm


def _tangle(rng: np.random.Generator) -> Made:
    """One that crosses itself, with steps of no length and doubled points."""
    xy = rng.uniform(-15, 15, (rng.integers(4, 7), 2))
    xy = np.repeat(xy, rng.integers(1, 3, len(xy)), axis=0)
    outline = Curve(np.vstack([xy, xy[:1]]), np.zeros(len(xy)))
    return [outline], [], _widest(outline)


def _arcs(rng: np.random.Generator) -> Made:
    count = int(rng.integers(3, 8))
    angles = (np.arange(count) + rng.uniform(0, 0.6, count)) * 2 * math.pi / count
    radii = rng.uniform(8, 18, count)
    ring = from_points(np.column_stack([radii * np.cos(angles), radii * np.sin(angles)]), True)
    outline = Curve(ring.xy, rng.uniform(-0.3, 0.6, len(ring)) * rng.integers(0, 2, len(ring)))
    return [outline], [circle((0.0, 0.0), 2.0)] if rng.random() < 0.5 else [], _widest(outline) * 0.6


def _touching(rng: np.random.Generator) -> Made:
    """Islands that touch each other, the wall, or lie in each other."""
    gap_mm = float(rng.integers(3, 7))
    islands = [box(gap_mm, gap_mm, 4, 4), box(gap_mm + 4, gap_mm, 4, 4), circle((gap_mm + 2, gap_mm + 2), 1)]
    return [box(0, 0, 2 * gap_mm + 8, 2 * gap_mm + 4)], [*islands, box(-1, 0, 1.5, 2)], gap_mm


def _points(rng: np.random.Generator) -> Made:
    """A smooth outline of many points."""
    angles = np.linspace(0, 2 * math.pi, int(rng.integers(150, 500)), endpoint=False)
    radii = 12 + 2 * np.sin(rng.integers(2, 6) * angles)
    outline = from_points(np.column_stack([radii * np.cos(angles), radii * np.sin(angles)]), True)
    return [outline], [circle((3.0, 0.0), 2.0)] if rng.random() < 0.5 else [], 5.0


_MAKERS = dict(zip(LAYOUTS, (_islands, _neck, _sliver, _slot, _tangle, _arcs, _touching, _points), strict=True))


def _widest(outline: Curve) -> float:
    inner = shapely.maximum_inscribed_circle(polygon(outline), tolerance=0.01)
    return 2.0 * float(shapely.length(inner))
