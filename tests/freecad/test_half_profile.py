# SPDX-License-Identifier: LGPL-2.1-or-later
"""Half profiles from sketches, edges and solids of revolution against exact values, and what is refused."""

from __future__ import annotations

import itertools
import math
from types import SimpleNamespace
from typing import Any

import FreeCAD
import numpy as np
import Part
import pytest
import Sketcher  # noqa: F401
from FreeCAD import Placement, Rotation, Vector

from CNCStepper.errors import CNCStepperError
from CNCStepper.job.turning.profile_form import ProfileForm
from CNCStepper.job.turning.profile_form import _of_points as curve_of_rows
from CNCStepper.workbench.drawings.half_profile import half_profile, read_half_profile

UPRIGHT = Placement(Vector(), Rotation(Vector(1, 0, 0), 90))  # of FreeCAD's XZ plane
TILTED = Placement(Vector(7, -3, 11), Rotation(Vector(1, 2, 3), 50))


def thing(shape: Any) -> Any:
    return SimpleNamespace(Label="thing", Shape=shape, isDerivedFrom=lambda name: False)


def turned(*points: tuple[float, float]) -> Any:
    """Return the solid of a half section through points (z, r), turned about Z."""
    wire = Part.makePolygon([Vector(r, 0, z) for z, r in [*points, points[0]]])
    return Part.Face(wire).revolve(Vector(), Vector(0, 0, 1), 360)


def lathe(edges: list[Any]) -> Any:
    return Part.Face(Part.Wire(edges)).revolve(Vector(), Vector(0, 0, 1), 360)


@pytest.fixture
def sketch() -> Any:
    document = FreeCAD.newDocument("HalfProfile")
    yield document.addObject("Sketcher::SketchObject", "Sketch")
    FreeCAD.closeDocument(document.Name)


def drawn(sketch: Any, placement: Any, *geometry: Any) -> Any:
    sketch.Placement = placement
    for one in geometry:
        sketch.addGeometry(one, False)
    sketch.Document.recompute()
    return sketch


def line(*ends: tuple[float, float]) -> Any:
    return Part.LineSegment(*(Vector(*end, 0) for end in ends))


def arc(centre: tuple[float, float], radius: float, first_deg: float, last_deg: float) -> Any:
    circle = Part.Circle(Vector(*centre, 0), Vector(0, 0, 1), radius)
    return Part.ArcOfCircle(circle, math.radians(first_deg), math.radians(last_deg))


def near(rows: list[Any], *wanted: Any) -> None:
    """Require the rows to be these within the rounding of a row."""
    assert len(rows) == len(wanted), rows
    for row, want in zip(rows, wanted, strict=True):
        if isinstance(want, dict):
            assert row["arc"] == want["arc"]
            assert row["to"] + row["centre"] == pytest.approx(want["to"] + want["centre"], abs=2e-9)
        else:
            assert row == pytest.approx(want, abs=2e-9)


def refused(drawing: Any, names: tuple[str, ...] = (), **more: Any) -> CNCStepperError:
    with pytest.raises(CNCStepperError) as error:
        half_profile(drawing, names, **more)
    return error.value


def test_a_sketch_on_the_xz_plane_comes_over_exactly(sketch: Any) -> None:
    drawn(sketch, UPRIGHT, line((12, -30), (12, 0)), line((0, 0), (12, 0)), arc((12, -37), 7, 0, 90))
    want = {"to": [19, -37], "arc": "ccw", "centre": [12, -37]}
    near(half_profile(sketch), [0, 0], [12, 0], [12, -30], want)
    near(read_half_profile(sketch).rows("diameter")[:3], [0, 0], [24, 0], [24, -30])


def test_rows_are_what_a_job_file_takes(sketch: Any) -> None:
    drawn(sketch, UPRIGHT, line((12, 0), (12, -30)), arc((12, -37), 7, 0, 90))
    profile = read_half_profile(sketch)
    form = ProfileForm(name="shaft", points=profile.rows("diameter"))
    again = curve_of_rows(form.points or (), "diameter")
    assert np.allclose(again.xy, profile.chain.xy, atol=2e-9)
    assert np.allclose(again.bulge, profile.chain.bulge, atol=2e-9)


def test_a_sketch_on_the_xy_plane_has_its_axis_along_x(sketch: Any) -> None:
    drawn(sketch, Placement(), line((0, 10), (-30, 10)), arc((-37, 10), 7, 0, 90))
    near(half_profile(sketch), [10, 0], [10, -30], {"to": [17, -37], "arc": "ccw", "centre": [10, -37]})


def test_what_is_drawn_on_the_other_side_of_the_axis_is_turned_about_it(sketch: Any) -> None:
    drawn(sketch, UPRIGHT, line((-12, 0), (-12, -30)), arc((-12, -37), 7, 90, 180))
    near(half_profile(sketch), [12, 0], [12, -30], {"to": [19, -37], "arc": "ccw", "centre": [12, -37]})


def test_flip_and_end_put_the_zero_at_the_other_end(sketch: Any) -> None:
    drawn(sketch, UPRIGHT, line((5, 0), (5, 20)), line((5, 20), (8, 50)))
    near(half_profile(sketch, zero="end", flip=False), [8, 0], [5, -30], [5, -50])
    near(half_profile(sketch, flip=True), [5, 0], [5, -20], [8, -50])
    profile = read_half_profile(sketch, zero="end")
    assert profile.frame.multVec(Vector(0, 8, 0)).isEqual(Vector(8, 0, 50), 1e-9)


def test_a_sketched_spline_stays_within_the_tolerance(sketch: Any) -> None:
    spline = Part.BSplineCurve()
    spline.interpolate([Vector(6, 0, 0), Vector(9, -12, 0), Vector(7, -25, 0), Vector(12, -40, 0)])
    drawn(sketch, UPRIGHT, spline)
    for tolerance_mm in (0.01, 0.001):
        chain = read_half_profile(sketch, tolerance_mm=tolerance_mm).chain
        there = np.array([(p.y, p.x) for p in spline.toShape().discretize(2000)])
        assert chain.distances_mm(there).max() <= tolerance_mm
        assert chain.length_mm == pytest.approx(spline.length(), abs=10 * tolerance_mm)


def test_a_closed_profile_is_refused_with_a_place(sketch: Any) -> None:
    drawn(sketch, UPRIGHT, line((5, 0), (9, 0)), line((9, 0), (9, -8)), line((9, -8), (5, 0)))
    assert refused(sketch).code == "profile-closed"


def test_profiles_that_cross_themselves_or_the_axis_or_run_back_are_refused(sketch: Any) -> None:
    points = [(9, 0), (9, -20), (15, -20), (5, -10)]
    drawn(sketch, UPRIGHT, *(line(*pair) for pair in itertools.pairwise(points)))
    assert refused(sketch).code == "profile-crossing"
    for number in range(2, -1, -1):
        sketch.delGeometry(number)
    drawn(sketch, UPRIGHT, line((4, 0), (-2, -10)))
    assert refused(sketch).code == "profile-axis"
    sketch.delGeometry(0)
    drawn(sketch, UPRIGHT, line((4, 0), (4, -10)), line((4, -10), (6, -10)), line((6, -10), (8, -5)))
    error = refused(sketch)
    assert error.code == "profile-undercut"
    sketch.delGeometry(1)
    sketch.Document.recompute()
    assert refused(sketch).code == "profile-chains"


def test_a_sketch_beside_the_axis_is_refused(sketch: Any) -> None:
    drawn(sketch, Placement(Vector(0, 3, 0), UPRIGHT.Rotation), line((4, 0), (4, -10)))
    assert refused(sketch).code == "profile-plane"


def test_an_edge_chain_of_a_wire_counts_alone() -> None:
    wire = Part.makePolygon(
        [Vector(0, 0, 0), Vector(8, 0, 0), Vector(10, 0, -2), Vector(10, 0, -30), Vector(0, 0, -30)]
    )
    near(half_profile(thing(wire), ("Edge3", "Edge2")), [8, 0], [10, -2], [10, -30])
    assert refused(thing(wire), ("Edge1", "Edge3")).code == "profile-chains"
    assert refused(thing(wire), ("Vertex1",)).code == "profile-picked"


@pytest.mark.parametrize("placement", [Placement(), TILTED, Placement(Vector(5, 0, 0), Rotation(Vector(0, 1, 0), 90))])
def test_a_cone_has_its_own_axis_wherever_it_lies(placement: Any) -> None:
    cone = Part.makeCone(20, 8, 30)
    cone.Placement = placement
    near(half_profile(thing(cone)), [0, 0], [8, 0], [20, -30])


def test_the_seams_of_a_solid_are_picked_in_its_own_axis() -> None:
    shape = turned((0, 0), (0, 8), (-30, 20), (-50, 20), (-50, 0))
    shape.Placement = TILTED
    picked = tuple(f"Edge{number}" for number, edge in enumerate(shape.Edges, start=1)
                   if isinstance(edge.Curve, Part.Line) and edge.Length > 8.5)  # fmt: skip
    want = [[8, 0], [20, -30], [20, -50]]
    rows = half_profile(thing(shape), picked[:2]) if len(picked) == 2 else half_profile(thing(shape), picked[:3])
    assert all(any(row == pytest.approx(each, abs=1e-8) for row in rows) for each in want)


def test_fillets_come_over_as_arcs() -> None:
    shape = turned((0, 0), (0, 12), (-30, 12), (-30, 20), (-60, 20), (-60, 0))
    inner = [e for e in shape.Edges if isinstance(e.Curve, Part.Circle) and abs(e.Curve.Center.z + 30) < 1e-6
             and abs(e.Curve.Radius - 12) < 1e-6]  # fmt: skip
    near(
        half_profile(thing(shape.makeFillet(2, inner))),
        [0, 0], [12, 0], [12, -28], {"to": [14, -30], "arc": "cw", "centre": [14, -28]}, [20, -30], [20, -60],
    )  # fmt: skip


def test_a_ball_and_a_torus_are_arcs() -> None:
    half_turn = {"to": [0, -20], "arc": "ccw", "centre": [0, -10]}
    near(half_profile(thing(Part.makeSphere(10))), [0, 0], half_turn)
    torus = thing(Part.makeTorus(30, 5))
    outside = read_half_profile(torus).chain
    bore = read_half_profile(torus, side="bore").chain
    assert outside.length_mm == pytest.approx(5 * math.pi, abs=1e-7)
    assert outside.points(1e-3)[:, 1].max() == pytest.approx(35, abs=1e-7)
    assert bore.points(1e-3)[:, 1].min() == pytest.approx(25, abs=1e-3)
    assert outside.xy[:, 0].min() == pytest.approx(-10, abs=1e-7)


def test_a_tube_has_an_outside_and_a_bore() -> None:
    shape = turned((0, 6), (0, 20), (-40, 20), (-40, 9), (-25, 9), (-20, 6))
    near(half_profile(thing(shape)), [6, 0], [20, 0], [20, -40])
    near(half_profile(thing(shape), side="bore"), [6, 0], [6, -20], [9, -25], [9, -40])


def test_a_blind_bore_ends_at_the_axis() -> None:
    shape = turned((-15, 0), (-15, 6), (0, 6), (0, 20), (-40, 20), (-40, 0))
    near(half_profile(thing(shape), side="bore"), [6, 0], [6, -15], [0, -15])
    near(half_profile(thing(shape)), [6, 0], [20, 0], [20, -40])
    assert refused(thing(shape), side="bore", flip=True).code == "profile-bore"


def test_a_spline_lathe_matches_the_section_of_the_solid() -> None:
    spline = Part.BSplineCurve()
    spline.interpolate([Vector(6, 0, 0), Vector(10, 0, -12), Vector(8, 0, -25), Vector(14, 0, -40)])
    closing = Part.makePolygon([Vector(14, 0, -40), Vector(0, 0, -40), Vector(0, 0, 0), Vector(6, 0, 0)]).Edges
    shape = lathe([spline.toShape(), *closing])
    shape.Placement = TILTED
    profile = read_half_profile(thing(shape))
    plane = profile.frame.Rotation.multVec(Vector(0, 0, 1))
    wires = shape.slice(plane, plane.dot(profile.frame.Base))
    inverse = profile.frame.inverse()
    section = [inverse.multVec(p) for wire in wires for edge in wire.Edges for p in edge.discretize(400)]
    outside = np.array([(p.x, p.y) for p in section if p.y > 0.01 and p.x > -40 + 1e-6])
    assert len(outside) > 300
    assert profile.chain.distances_mm(outside).max() <= 0.002 + 1e-5


@pytest.mark.parametrize(
    ("tool", "place"),
    [
        (Part.makeBox(6, 60, 30, Vector(17, -30, -60)), "Z -45"),  # a flat
        (Part.makeCylinder(3, 60, Vector(-30, 0, -20), Vector(1, 0, 0)), ""),  # a cross hole
        (Part.makeCylinder(3, 30, Vector(8, 0, -30)), "X 8"),  # a hole beside the axis
        (Part.makeBox(80, 80, 120, Vector(0, -40, -100)), ""),  # half of it is missing
    ],
)
def test_what_is_not_turned_is_refused_with_its_place(tool: Any, place: str) -> None:
    shape = turned((0, 0), (0, 20), (-60, 20), (-60, 0)).cut(tool)
    error = refused(thing(shape))
    assert error.code == "solid-revolution"
    assert place.split(" ")[0] in str(error.value)


def test_a_box_and_two_solids_are_refused() -> None:
    assert refused(thing(Part.makeBox(10, 20, 30))).code == "solid-revolution"
    two = Part.makeCompound([Part.makeCylinder(5, 10), Part.makeCylinder(5, 10, Vector(0, 0, 20))])
    assert refused(thing(two)).code == "profile-solids"


def test_a_hollow_inside_is_refused() -> None:
    shape = Part.makeCylinder(20, 60).cut(Part.makeCylinder(10, 20, Vector(0, 0, 20)))
    assert refused(thing(shape)).code == "section-hollow"
