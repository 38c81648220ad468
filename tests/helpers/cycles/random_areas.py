# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random areas for clearing patterns: islands, slivers, offsets that collapse or split; and what runs cut there."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import reduce

import numpy as np
import shapely
from shapely import Polygon
from shapely.geometry.base import BaseGeometry

from CNCStepper.cycles.clearing.pattern import Area, Run
from CNCStepper.cycles.cycle import Setup
from CNCStepper.cycles.moves import Moves, point_of
from CNCStepper.geometry.curve import Curve, circle, from_points
from CNCStepper.geometry.region import Region
from CNCStepper.state import Start
from CNCStepper.toolpath import TableBuilder, Toolpath
from helpers.cycles.product_verdict import tool

CHORD_MM = 1e-4
DEEP_MM = 1.0
TOLERANCE_MM = 0.01


@dataclass(frozen=True)
class Drawn:
    """Outlines and islands, what they enclose by shapely alone, and the tool's radius."""

    outlines: tuple[Curve, ...]
    islands: tuple[Curve, ...]
    region: BaseGeometry
    tool_mm: float
    sliver: bool

    def area(self, stepover_mm: float, climb: bool = True) -> Area:
        """Return the area that a pattern is given."""
        room = Region.of(self.outlines, self.islands).offset(-self.tool_mm, TOLERANCE_MM / 4)
        return Area(room, self.tool_mm, stepover_mm, TOLERANCE_MM, climb)


def random_area(seed: int) -> Drawn:
    """Return one or two outlines, up to four islands; the tool is 0.1 to 1.0 of the widest place's width."""
    rng = np.random.default_rng(seed)
    outlines = [_shape(rng, rng.uniform(12, 30)) for _ in range(rng.choice([1, 1, 2]))]
    islands = [_shape(rng, rng.uniform(1, 5)).moved(*rng.uniform(-15, 15, 2)) for _ in range(rng.choice([0, 1, 2, 4]))]
    sliver = bool(rng.random() < 0.3)
    if sliver:
        wide = rng.uniform(0.02, 0.6)
        outlines.append(from_points([(0, -wide), (45, 0), (0, wide)], closed=True).rotated(rng.uniform(0, 360)))
    outer, inner = (reduce(BaseGeometry.union, map(polygon, curves), Polygon()) for curves in (outlines, islands))
    region = outer.difference(inner)
    widest = max(region.geoms, key=lambda part: part.area) if hasattr(region, "geoms") else region
    tool_mm = shapely.maximum_inscribed_circle(widest, tolerance=0.01).length * rng.uniform(0.1, 1.0)
    return Drawn(tuple(outlines), tuple(islands), region, round(float(tool_mm), 3), sliver)


def _shape(rng: np.random.Generator, size_mm: float) -> Curve:
    kind = rng.integers(5)
    if kind == 0:
        return circle((0, 0), size_mm)
    if kind == 1:
        wide, high = np.round(size_mm * rng.uniform(0.4, 1.0, 2)) + 1
        return from_points([(-wide, -high), (wide, -high), (wide, high), (-wide, high)], closed=True)
    count = int(rng.integers(3, 10))
    angles = (np.arange(count) + rng.uniform(0, 0.8, count)) * 2 * math.pi / count
    star = from_points((size_mm * rng.uniform(0.4, 1.1, count) * np.array([np.cos(angles), np.sin(angles)])).T, True)
    bulge = rng.uniform(-0.3, 0.6, len(star)) if kind == 2 else np.zeros(len(star))
    return Curve(star.xy, bulge)


def polygon(curve: Curve) -> BaseGeometry:
    """Return what an outline encloses; arcs may cross their neighbours."""
    simple = Polygon(curve.points(CHORD_MM))
    if simple.is_valid:
        return simple
    faces = shapely.get_parts(shapely.polygonize([shapely.union_all(shapely.LineString(curve.points(CHORD_MM)))]))
    places = shapely.get_coordinates(shapely.point_on_surface(faces))
    return shapely.union_all(faces[curve.winding(places) != 0])


def path_of(runs: list[Run], tool_mm: float) -> Toolpath:
    """Return the runs as moves DEEP_MM below the top, each entered by a plunge, every pass in a span of its name."""
    table, setup = TableBuilder(Start()), Setup(tool(2 * tool_mm), 10.0, 2.0)
    moves = Moves(table, setup)
    for run in runs:
        moves.approach(point_of(run.passes[0].curve.xy[0]))
        moves.plunge(-DEEP_MM)
        for one in run.passes:
            assert math.dist(moves.position[:2], one.curve.xy[0]) < 1e-6
            table.open_span("pass", one.name)
            if one.lifted:
                moves.hop(one.curve, 0.3)
                moves.plunge(-DEEP_MM)
            else:
                moves.follow(one.curve, 800.0)
            table.close_span()
        moves.retract()
    return table.toolpath()
