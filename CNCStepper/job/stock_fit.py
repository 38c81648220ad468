# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks that an operation fits into the stock, from its parameters alone, before any calculation.

depth_mm, through_mm ──► below the stock's bottom?      what is drawn, seen from above ──► outside the stock's outline?

A panel calls this while a person types. The checks of the program (`simulation/checks/stock_checks.py`,
`job/findings.py`)
report the same faults of the cut, in the same words.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import singledispatch
from typing import Any

import numpy as np
import shapely

from CNCStepper.cycles.contours.contour import Contour
from CNCStepper.cycles.contours.engrave import Engrave
from CNCStepper.cycles.cycle import Cycle
from CNCStepper.cycles.facing.face import Face
from CNCStepper.cycles.holes.bore import Bore
from CNCStepper.cycles.holes.drill import Drill
from CNCStepper.cycles.holes.thread_milling import Thread
from CNCStepper.cycles.pockets.circular_pocket import CircularPocket
from CNCStepper.cycles.pockets.elliptical_pocket import EllipticalPocket
from CNCStepper.cycles.pockets.pocket import Pocket
from CNCStepper.cycles.pockets.rectangular_pocket import RectangularPocket
from CNCStepper.cycles.sheet_cutting.sheet_cut import SheetCut
from CNCStepper.cycles.wire_cutting.wire_cut import WireCut
from CNCStepper.errors import Place, Text
from CNCStepper.geometry.curve import Curve, circle
from CNCStepper.geometry.shapes.ellipse import Ellipse
from CNCStepper.simulation.checks.stock_checks import ON_EDGE_MM, PASSED_MM, SPOIL_MM
from CNCStepper.simulation.finding import Finding, Severity, worst_first
from CNCStepper.simulation.stock import Stock

FLAT_MM = 0.005  # of chords for arcs: half of what may lie beside


def stock_findings(cycle: Cycle, stock: Stock) -> list[Finding]:
    """Return what of an operation does not fit into the stock, the worst first; both in work coordinates."""
    depth_mm = float(getattr(cycle, "depth_mm", 0.0)) + float(getattr(cycle, "through_mm", 0.0))
    found = (depth_below_stock(depth_mm, stock), region_outside_stock(drawn(cycle), stock))
    return worst_first(finding for finding in found if finding is not None)


def depth_below_stock(depth_mm: float, stock: Stock) -> Finding | None:
    """Return that a depth, counted from the top of the stock, ends below its bottom; None where it does not."""
    below_mm = stock.bottom_mm - PASSED_MM + depth_mm
    if below_mm <= 0.0:
        return None
    severity: Severity = "error" if below_mm > SPOIL_MM else "warning"
    text, advice = "the depth goes below the stock", "check the depth, or lay a spoil board under the stock"
    numbers = {"value": depth_mm, "limit": -stock.bottom_mm, "unit": "mm"}
    return Finding(severity, "below-stock", Place(""), text, advice, **numbers)  # type: ignore[arg-type]


def region_outside_stock(parts: Iterable[np.ndarray], stock: Stock) -> Finding | None:
    """Return that a part of a shape lies outside the stock's outline, and how far; None where none does.

    parts: points float64[n, 2] of its lines, in mm.
    """
    points = _outermost(np.concatenate([np.empty((0, 2)), *parts]), stock)
    outside_mm = shapely.distance(shapely.points(points), stock.outline)
    if not len(points) or outside_mm.max() <= ON_EDGE_MM:
        return None
    text, advice = (
        "part of the drawn shape is beside the stock",
        "move the shape or the work zero, or take larger stock",
    )
    return Finding("warning", "beside-stock", Place(""), text, advice, value=float(outside_mm.max()), unit="mm")


def _outermost(points: np.ndarray, stock: Stock) -> np.ndarray:
    """Return those of some points that may lie farthest outside: of a convex outline, the corners of their hull."""
    if len(points) < 3 or not stock.outline.convex_hull.equals(stock.outline):
        return points
    return shapely.get_coordinates(shapely.linestrings(points).convex_hull)  # type: ignore[no-any-return]


@singledispatch
def drawn(cycle: Any) -> list[np.ndarray]:
    """Return what an operation follows, as points float64[n, 2] of each line; nothing where the stock gives it."""
    raise TypeError(Text("the curve that {kind} follows is unknown", kind=type(cycle).__name__))


@drawn.register(Pocket)
@drawn.register(Face)
def _of_outlines(cycle: Pocket | Face) -> list[np.ndarray]:
    return _points(cycle.outlines, cycle.offset_mm)


@drawn.register(Contour)
@drawn.register(Engrave)
@drawn.register(SheetCut)
@drawn.register(WireCut)
def _of_curves(cycle: Contour | Engrave | SheetCut | WireCut) -> list[np.ndarray]:
    return _points(cycle.curves, cycle.offset_mm)


@drawn.register(CircularPocket)
def _of_circle(cycle: CircularPocket) -> list[np.ndarray]:
    return _points([circle(cycle.centre_mm, cycle.radius_mm)], cycle.offset_mm)


@drawn.register(RectangularPocket)
def _of_rectangle(cycle: RectangularPocket) -> list[np.ndarray]:
    return _points([cycle.outline()], cycle.offset_mm)


@drawn.register(EllipticalPocket)
def _of_ellipse(cycle: EllipticalPocket) -> list[np.ndarray]:
    ellipse = Ellipse.of_radii(cycle.centre_mm, cycle.radius_x_mm, cycle.radius_y_mm, cycle.rotation_deg)
    return [ellipse.points(FLAT_MM)]


@drawn.register(Drill)
@drawn.register(Bore)
@drawn.register(Thread)
def _of_holes(cycle: Drill | Bore | Thread) -> list[np.ndarray]:
    own_mm = float(getattr(cycle, "diameter_mm", 0.0) or getattr(cycle, "major_diameter_mm", 0.0))
    dx_mm, dy_mm = cycle.offset_mm
    holes = np.array([(x + dx_mm, y + dy_mm, own_mm or diameter) for x, y, diameter in cycle.pattern.holes()])
    lines: list[np.ndarray] = []
    for diameter_mm in np.unique(holes[:, 2]):
        lines += list(holes[holes[:, 2] == diameter_mm, None, :2] + _round(float(diameter_mm)))
    return lines


def _points(curves: Iterable[Curve], offset_mm: tuple[float, float]) -> list[np.ndarray]:
    return [curve.points(FLAT_MM) + np.asarray(offset_mm) for curve in curves]


def _round(diameter_mm: float) -> np.ndarray:
    """Return the outline of a hole about its centre; the centre alone where its diameter is the tool's."""
    if not diameter_mm:
        return np.zeros((1, 2))
    return circle((0.0, 0.0), diameter_mm / 2.0).points(FLAT_MM)
