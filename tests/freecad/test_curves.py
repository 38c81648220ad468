# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drawings as curves: exact where the drawing is lines and arcs, within the tolerance elsewhere."""

from __future__ import annotations

import math
from types import SimpleNamespace
from typing import Any

import Draft
import FreeCAD
import numpy as np
import Part
import pytest
from FreeCAD import Vector

from CNCStepper.errors import GeometryError
from CNCStepper.geometry.curve import Curve
from CNCStepper.workbench.drawings.curves import curves_of
from CNCStepper.workbench.drawings.ellipses import ellipse_of

ORIGIN = (0.0, 0.0, 0.0)


def drawing(shape: Any) -> Any:
    return SimpleNamespace(Label="drawing", Shape=shape)


def only(shape: Any, tolerance_mm: float = 0.01) -> Curve:
    (curve,) = curves_of(drawing(shape), ORIGIN, tolerance_mm)
    return curve


def deviation_mm(curve: Curve, shape: Any) -> float:
    """Return how far the two are apart at most, measured both ways."""
    there = np.array([(p.x, p.y) for edge in shape.Edges for p in edge.discretize(3000)])
    points = curve.points(1e-5)
    back = max(shape.distToShape(Part.Vertex(Vector(*point, 0)))[0] for point in points[:: max(1, len(points) // 300)])
    return max(float(curve.distances_mm(there).max()), back)


def bspline(*points: tuple[float, float], periodic: bool = False) -> Any:
    curve = Part.BSplineCurve()
    curve.interpolate([Vector(*point) for point in points], PeriodicFlag=periodic)
    return curve.toShape()


def corner_spline() -> Any:
    """A B-spline with corners inside: of degree 1."""
    curve = Part.BSplineCurve()
    poles = [Vector(0, 0), Vector(10, 0), Vector(10, 10), Vector(0, 10)]
    curve.buildFromPolesMultsKnots(poles, [2, 1, 1, 2], [0, 1, 2, 3], False, 1)
    return curve.toShape()


def ellipse(centre: Vector = Vector(), rx: float = 40, ry: float = 25, turned_deg: float = 0) -> Any:  # noqa: B008
    edge = Part.Ellipse(Vector(rx, 0), Vector(0, ry), Vector()).toShape()
    edge.Placement = FreeCAD.Placement(centre, FreeCAD.Rotation(Vector(0, 0, 1), turned_deg))
    return edge


@pytest.mark.parametrize(("axis", "area"), [((0, 0, 1), 25 * math.pi), ((0, 0, -1), -25 * math.pi)])
def test_a_circle_is_exact_and_keeps_its_sense(axis: tuple[float, ...], area: float) -> None:
    curve = only(Part.makeCircle(5, Vector(7, 3, 0), Vector(*axis)))
    assert curve.closed
    assert len(curve) == 2
    assert curve.area_mm2 == pytest.approx(area, rel=1e-12)


@pytest.mark.parametrize("sweep_deg", [10, 180, 200, 359])
def test_an_arc_is_exact(sweep_deg: float) -> None:
    shape = Part.makeCircle(5, Vector(), Vector(0, 0, 1), 20, 20 + sweep_deg)
    curve = only(shape)
    assert curve.length_mm == pytest.approx(5 * math.radians(sweep_deg), rel=1e-12)
    assert deviation_mm(curve, shape) < 1e-9


def test_a_mirrored_arc_turns_the_other_way() -> None:
    shape = Part.makeCircle(5, Vector(1, 2, 0), Vector(0, 0, 1), 0, 90).mirror(Vector(), Vector(1, 0, 0))
    assert only(shape).bulge[0] < 0
    assert deviation_mm(only(shape), shape) < 1e-9


def test_edges_in_any_order_and_direction_become_one_closed_curve() -> None:
    shape = Part.Compound(
        [
            Part.makeLine(Vector(10, 0), Vector(0, 0)),
            Part.makeLine(Vector(0, 10), Vector(0, 0)),
            Part.makeLine(Vector(10, 0), Vector(10, 10)),
            Part.makeCircle(5, Vector(5, 10), Vector(0, 0, 1), 0, 180),
        ]
    )
    curve = only(shape)
    assert curve.closed
    assert abs(curve.area_mm2) == pytest.approx(100 + 12.5 * math.pi)


def test_lines_that_do_not_touch_stay_apart_and_move_to_the_work_zero() -> None:
    shape = Part.Compound([Part.makeLine(Vector(0, 0), Vector(1, 0)), Part.makeLine(Vector(0, 5), Vector(1, 5))])
    curves = curves_of(drawing(shape), (10.0, 20.0, 0.0), 0.01)
    assert sorted(tuple(curve.xy[0]) for curve in curves) == [(-10.0, -20.0), (-10.0, -15.0)]


@pytest.mark.parametrize("tolerance_mm", [0.1, 0.01, 0.001])
@pytest.mark.parametrize(
    "shape",
    [
        bspline((0, 0), (10, 5), (20, -5), (30, 0)),
        bspline((0, 0), (10, 5), (20, -5), periodic=True),
        corner_spline(),
        ellipse(),
        ellipse(rx=40, ry=2),
        Part.ArcOfEllipse(Part.Ellipse(Vector(40, 0), Vector(0, 25), Vector()), 0.3, 4).toShape(),
    ],
    ids=["spline", "periodic", "corners", "ellipse", "thin ellipse", "elliptical arc"],
)
def test_free_curves_stay_within_the_tolerance(shape: Any, tolerance_mm: float) -> None:
    assert deviation_mm(only(shape, tolerance_mm), shape) <= tolerance_mm


def test_a_moved_turned_or_changed_ellipse_is_fitted_anew() -> None:
    shapes = [ellipse(), ellipse(), ellipse(rx=41), ellipse()]
    shapes[1].translate(Vector(5, 0, 0))
    shapes[3].Placement = FreeCAD.Placement(Vector(), FreeCAD.Rotation(Vector(0, 0, 1), 30))
    for _ in range(2):
        assert [deviation_mm(only(shape, 0.01), shape) <= 0.01 for shape in shapes] == [True] * 4


def test_a_straight_spline_is_lines() -> None:
    assert not only(bspline((0, 0), (1, 1), (2, 2), (3, 3))).bulge.any()


def test_draft_objects_and_turned_sketches_lie_where_they_are_seen(document: Any) -> None:
    wire = Draft.make_wire([Vector(0, 0), Vector(10, 0), Vector(10, 10)], closed=True)
    sketch = document.addObject("Sketcher::SketchObject", "Sketch")
    sketch.addGeometry(Part.LineSegment(Vector(0, 0), Vector(10, 0)))
    sketch.Placement = FreeCAD.Placement(Vector(1, 2, 3), FreeCAD.Rotation(Vector(0, 0, 1), 90))
    document.recompute()
    assert curves_of(wire, ORIGIN, 0.01)[0].length_mm == pytest.approx(20 + math.sqrt(200))
    assert sorted(map(tuple, curves_of(sketch, ORIGIN, 0.01)[0].xy.round(9))) == [(1.0, 2.0), (1.0, 12.0)]


def test_a_drawing_inside_a_moved_part_lies_where_it_is_seen(document: Any) -> None:
    part = document.addObject("App::Part", "Part")
    line = document.addObject("Part::Feature", "Line")
    line.Shape = Part.makeLine(Vector(0, 0), Vector(10, 0))
    part.addObject(line)
    part.Placement.Base = Vector(100, 0, 0)
    document.recompute()
    assert curves_of(line, ORIGIN, 0.01)[0].xy[:, 0].tolist() == [100.0, 110.0]


@pytest.mark.parametrize(
    ("shape", "sentence"),
    [
        (Part.Shape(), "holds no lines"),
        (Part.makeLine(Vector(0, 0, 0), Vector(1, 0, 1)), "does not lie flat"),
        (Part.makeCircle(5, Vector(), Vector(1, 0, 0)), "does not lie flat"),
    ],
)
def test_drawings_that_cannot_be_followed_are_refused(shape: Any, sentence: str) -> None:
    with pytest.raises(GeometryError, match=sentence):
        only(shape)


@pytest.mark.parametrize(
    ("turned_deg", "radii", "rotation_deg"),
    [
        (0, (40, 25), 0),
        (90, (25, 40), 0),
        (30, (40, 25), 30),
        (180, (40, 25), 0),
        (-60, (25, 40), 30),
        (135, (40, 25), -45),
    ],
)
def test_an_ellipse_is_found(turned_deg: float, radii: tuple[float, float], rotation_deg: float) -> None:
    found = ellipse_of(drawing(ellipse(Vector(10, -5, 2), turned_deg=turned_deg)))
    assert found.centre_mm == pytest.approx((10, -5))
    assert (found.radius_x_mm, found.radius_y_mm) == pytest.approx(radii)
    angle = math.radians(found.rotation_deg)  # the radii and the angle must name the very same ellipse
    for t in np.linspace(0, math.tau, 13):
        x, y = found.radius_x_mm * math.cos(t), found.radius_y_mm * math.sin(t)
        point = Vector(
            10 + x * math.cos(angle) - y * math.sin(angle), -5 + x * math.sin(angle) + y * math.cos(angle), 2
        )
        assert ellipse(Vector(10, -5, 2), turned_deg=turned_deg).distToShape(Part.Vertex(point))[0] < 1e-6
    assert found.rotation_deg == pytest.approx(rotation_deg)


def test_a_circle_and_an_ellipse_in_two_arcs_are_ellipses() -> None:
    whole = Part.Ellipse(Vector(40, 0), Vector(0, 25), Vector())
    halves = Part.Compound([Part.ArcOfEllipse(whole, 0, 2).toShape(), Part.ArcOfEllipse(whole, 2, math.tau).toShape()])
    assert ellipse_of(drawing(halves)).radius_x_mm == pytest.approx(40)
    assert ellipse_of(drawing(Part.makeCircle(7))).radius_y_mm == pytest.approx(7)


@pytest.mark.parametrize(
    ("shape", "sentence"),
    [
        (Part.ArcOfEllipse(Part.Ellipse(Vector(40, 0), Vector(0, 25), Vector()), 0, 3).toShape(), "is open"),
        (Part.makeCircle(5, Vector(), Vector(0, 0, 1), 0, 300), "is open"),
        (Part.Compound([ellipse(), ellipse(rx=10, ry=5)]), "more than one ellipse"),
        (Part.makeLine(Vector(), Vector(1, 0)), "no ellipse"),
        (Part.Compound([ellipse(), Part.makeLine(Vector(), Vector(1, 0))]), "no ellipse"),
    ],
)
def test_a_drawing_without_one_whole_ellipse_is_refused(shape: Any, sentence: str) -> None:
    with pytest.raises(GeometryError, match=sentence):
        ellipse_of(drawing(shape))
