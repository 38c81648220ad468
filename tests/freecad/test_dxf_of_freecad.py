# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drawings that FreeCAD itself writes as DXF come back where its geometry kernel has them."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace
from typing import Any

import Import
import numpy as np
import Part
import pytest
import shapely
from FreeCAD import Vector

from CNCStepper.drawing.dxf.reader import read_dxf
from CNCStepper.geometry.curve import Curve
from CNCStepper.workbench.drawings.curves import curves_of

CASES = 12
TOLERANCE_MM = 0.01


def random_edge(rng: np.random.Generator, kinds: int = 6) -> Any:
    """Return a line, an arc of a circle or an ellipse, one of these whole, or a B-spline, anywhere."""
    centre, (first, sweep) = Vector(*rng.uniform(-50, 50, 2)), rng.uniform((0, 0.05), (6, 6.2))
    kind = int(rng.integers(kinds))
    if kind == 0:
        return Part.makeLine(centre, Vector(*rng.uniform(-50, 50, 2)))
    if kind in (1, 2):
        circle = Part.Circle(centre, Vector(0, 0, float(rng.choice([-1, 1]))), float(10 ** rng.uniform(-1.5, 1.5)))
        return circle.toShape() if kind == 1 else Part.ArcOfCircle(circle, first, first + sweep).toShape()
    if kind in (3, 4):
        ellipse = Part.Ellipse(centre, *sorted(rng.uniform(1, 30, 2), reverse=True))
        ellipse.AngleXU = float(rng.uniform(-3, 3))
        return ellipse.toShape() if kind == 3 else Part.ArcOfEllipse(ellipse, first, first + sweep).toShape()
    spline = Part.BSplineCurve()
    points = [Vector(*point) for point in rng.uniform(-30, 30, (int(rng.integers(3, 9)), 2))]
    spline.interpolate(points, PeriodicFlag=bool(rng.random() < 0.4))
    return spline.toShape()


def apart_mm(curves: Any, shape: Any) -> float:
    """Return how far curves and points that OCCT puts on a shape leave each other, both ways.

    Its own distance to a shape is of no use here: of a B-spline that crosses itself it may find another extremum.
    """
    lines = [
        [tuple(edge.valueAt(t))[:2] for t in np.linspace(*edge.ParameterRange, 3000).tolist()] for edge in shape.Edges
    ]
    away = np.min([curve.distances_mm(np.vstack(lines)[::3]) for curve in curves], axis=0).max()
    here = np.vstack([curve.points(1e-3) for curve in curves])
    back = shapely.distance(shapely.MultiLineString(lines), shapely.points(here[:: len(here) // 300 + 1])).max()
    return float(max(away, back))


@pytest.mark.parametrize(("version", "kinds"), [(12, 3), (14, 6)])  # version 12 has neither ellipses nor splines
def test_what_freecad_writes_is_read(version: int, kinds: int, tmp_path: Path) -> None:
    for seed in range(CASES):
        rng = np.random.default_rng(seed)
        shape = Part.Compound([random_edge(rng, kinds) for _ in range(4)])
        path = tmp_path / "peça.dxf"
        Import.writeDXFShape([shape], str(path), version, False)
        drawing = read_dxf(path, TOLERANCE_MM)
        assert not drawing.damage and not drawing.skipped, f"seed {seed}: {drawing.skipped} {drawing.damage}"
        curves = [curve for layer in drawing.layers for curve in layer.curves]
        assert apart_mm(curves, shape) <= TOLERANCE_MM * 1.02, f"seed {seed}"


def test_the_shapes_themselves_are_read() -> None:
    for seed in range(CASES):
        shape = Part.Compound([random_edge(np.random.default_rng(1000 + seed)) for _ in range(2)])
        curves = curves_of(SimpleNamespace(Label="drawing", Shape=shape), (0.0, 0.0, 0.0), TOLERANCE_MM)
        assert apart_mm(curves, shape) <= TOLERANCE_MM, f"seed {1000 + seed}"


def test_arcs_go_on_over_the_knots_of_a_smooth_spline() -> None:
    t = np.linspace(0, 2 * np.pi, 121)
    spline = Part.BSplineCurve()
    spline.interpolate([Vector(40 * np.cos(a), 25 * np.sin(a)) for a in t[:-1]], PeriodicFlag=True)
    (curve,) = curves_of(SimpleNamespace(Label="drawing", Shape=spline.toShape()), (0.0, 0.0, 0.0), TOLERANCE_MM)
    assert isinstance(curve, Curve) and curve.closed and len(curve) < 25
    assert apart_mm([curve], spline.toShape()) <= TOLERANCE_MM


def test_the_corners_of_a_spline_are_vertices() -> None:
    corners = [Vector(0, 0), Vector(10, 0), Vector(10, 10), Vector(0, 10)]
    spline = Part.BSplineCurve()
    spline.buildFromPolesMultsKnots(corners, [2, 1, 1, 2], [0, 1, 2, 3], False, 1)
    (curve,) = curves_of(SimpleNamespace(Label="drawing", Shape=spline.toShape()), (0.0, 0.0, 0.0), TOLERANCE_MM)
    assert curve.xy.tolist() == [[0, 0], [10, 0], [10, 10], [0, 10]] and not curve.bulge.any()
