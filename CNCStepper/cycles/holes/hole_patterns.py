# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hole patterns: points, lines, grids, bolt circles, arcs, and the circles of a drawing.

points   points_mm                            bolt_circle   centre_mm radius_mm count start_deg
line     start_mm end_mm count                arc           centre_mm radius_mm start_deg end_deg count
grid     origin_mm spacing_mm count           circles       circles: shapes of the drawing that are circles,
         rotation_deg                                       whose diameters bore and thread may take over
"""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Sequence
from itertools import product
from typing import Annotated, Literal, NamedTuple

import numpy as np
from pydantic import BaseModel, ConfigDict, Field

from CNCStepper.cycles.holes.hole_parameters import (
    MOST_HOLES,
    ArcParameters,
    BoltCircleParameters,
    GridParameters,
    LineParameters,
    Order,
    Point,
    PointsParameters,
)
from CNCStepper.cycles.parameter_types import CurveField
from CNCStepper.errors import CycleError, Text
from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.cut_order.cut_order import Stop, ordered
from CNCStepper.tolerances import SAME_HOLE_MM

ROUND_MM = 0.001  # by which a drawn circle may be off a circle


class Hole(NamedTuple):
    """The centre of a hole, and its diameter where the drawing has one, else 0."""

    x_mm: float
    y_mm: float
    diameter_mm: float = 0.0


class _Pattern(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False, arbitrary_types_allowed=True)


class Points(PointsParameters, _Pattern):
    """Holes at given points."""

    points_mm: tuple[Point, ...] = Field(min_length=1, max_length=MOST_HOLES)

    def holes(self) -> list[Hole]:
        """Return the holes in the order given."""
        return [Hole(x, y) for x, y in self.points_mm]


class Line(LineParameters, _Pattern):
    """Holes evenly spaced from `start_mm` to `end_mm`, both included."""

    def holes(self) -> list[Hole]:
        """Return the holes from the start on."""
        return [Hole(x, y) for x, y in np.linspace(self.start_mm, self.end_mm, self.count).tolist()]


class Grid(GridParameters, _Pattern):
    """Rows along X and columns along Y from `origin_mm`, the grid turned about it counter-clockwise."""

    def holes(self) -> list[Hole]:
        """Return the holes row by row."""
        if self.count[0] * self.count[1] > MOST_HOLES:
            value, limit = f"{self.count[0]} x {self.count[1]} holes", f"{MOST_HOLES} holes"
            advice = "drill it in several operations"
            raise CycleError("holes-many", "the grid has too many holes", value=value, limit=limit, advice=advice)
        cos, sin = math.cos(math.radians(self.rotation_deg)), math.sin(math.radians(self.rotation_deg))
        (x, y), (dx, dy) = self.origin_mm, self.spacing_mm
        steps = ((i * dx, k * dy) for k in range(self.count[1]) for i in range(self.count[0]))
        return [Hole(x + u * cos - v * sin, y + u * sin + v * cos) for u, v in steps]


class BoltCircle(BoltCircleParameters, _Pattern):
    """Holes evenly spaced all round a circle, counter-clockwise from `start_deg`."""

    def holes(self) -> list[Hole]:
        """Return the holes from the start on."""
        turns = np.arange(self.count) / self.count * 360.0
        return _around(self.centre_mm, self.radius_mm, self.start_deg + turns)


class Arc(ArcParameters, _Pattern):
    """Holes evenly spaced on an arc from `start_deg` to `end_deg`, both included; counter-clockwise if it is larger."""

    def holes(self) -> list[Hole]:
        """Return the holes from the start on."""
        return _around(self.centre_mm, self.radius_mm, np.linspace(self.start_deg, self.end_deg, self.count))


class Circles(_Pattern):
    """Holes where a drawing has circles; in a job file `circles` names shapes."""

    kind: Literal["circles"]
    circles: tuple[CurveField, ...] = Field(min_length=1, max_length=MOST_HOLES)

    def holes(self) -> list[Hole]:
        """Return the holes in the drawing's order; raises CycleError for a curve that is no circle."""
        return [_hole_of(curve) for curve in self.circles]


Pattern = Annotated[Points | Line | Grid | BoltCircle | Arc | Circles, Field(discriminator="kind")]


def placed(
    pattern: Pattern, order: Order, offset_mm: Point = (0.0, 0.0), *, own_diameters: bool = False
) -> tuple[list[Hole], list[str]]:
    """Return the holes in drilling order, and warnings; duplicates are drilled once.

    order: "short" makes the rapids between them short, "given" keeps the pattern's. own_diameters: each hole gets the
    diameter that is drawn, so that two about one centre are two. Raises CycleError.
    """
    drawn = [Hole(x + offset_mm[0], y + offset_mm[1], diameter) for x, y, diameter in pattern.holes()]
    holes = _once(drawn, own_diameters)
    twice = len(drawn) - len(holes)
    warnings: list[str] = (
        [
            Text(
                "{twice} of the {drawn} holes are at the place of others and are made once",
                twice=twice,
                drawn=len(drawn),
            )
        ]
        if twice
        else []
    )
    if order == "short":
        visits = ordered([Stop.at_point(hole.x_mm, hole.y_mm) for hole in holes])
        holes = [holes[visit.item] for visit in visits]
    return holes, warnings


def _once(holes: Sequence[Hole], own_diameters: bool) -> list[Hole]:
    """Return the holes without those that are within SAME_HOLE_MM of an earlier one."""
    kept: list[Hole] = []
    cells: defaultdict[tuple[int, ...], list[tuple[float, ...]]] = defaultdict(list)  # as wide as that distance
    for hole in holes:
        spot = tuple(hole) if own_diameters else hole[:2]
        cell = tuple(math.floor(value / SAME_HOLE_MM) for value in spot)
        beside = (tuple(map(sum, zip(cell, step, strict=True))) for step in product((-1, 0, 1), repeat=len(cell)))
        if all(math.dist(spot, other) > SAME_HOLE_MM for near in beside for other in cells.get(near, ())):
            kept.append(hole)
            cells[cell].append(spot)
    return kept


def _around(centre_mm: Point, radius_mm: float, angles_deg: np.ndarray) -> list[Hole]:
    angles = np.radians(angles_deg)
    xy = np.column_stack([np.cos(angles), np.sin(angles)]) * radius_mm + centre_mm
    return [Hole(x, y) for x, y in xy.tolist()]


def _hole_of(curve: Curve) -> Hole:
    """Return the hole that a circle draws."""
    if curve.closed and len(curve) and np.all(curve.bulge != 0):
        centre = curve.centres.mean(axis=0)
        away_mm = np.hypot(*(curve.xy - centre).T)
        same = np.hypot(*(curve.centres - centre).T).max() < ROUND_MM and np.ptp(away_mm) < ROUND_MM
        if same and abs(abs(float(curve.sweeps_rad.sum())) - 2.0 * math.pi) < 1e-6:
            return Hole(float(centre[0]), float(centre[1]), 2.0 * float(away_mm.mean()))
    x, y = curve.xy[0].tolist()
    raise CycleError(
        "hole-shape",
        "a shape of the pattern is no circle",
        value=f"from X{x:.3f} Y{y:.3f}",
        advice="draw holes as circles, or give points",
    )
