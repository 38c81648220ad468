# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every cycle from a drawing to a program without findings; saved and reopened, changed, refused."""

from __future__ import annotations

import math
from collections.abc import Callable
from itertools import pairwise
from pathlib import Path
from typing import Any

import Draft
import FreeCAD
import Part
import pytest
import shapely
from FreeCAD import Vector

from CNCStepper.cycles.catalogue import cycle_class
from CNCStepper.cycles.cycle import Removal
from CNCStepper.errors import GeometryError
from CNCStepper.job.make import make_program
from CNCStepper.job.prove import prove
from CNCStepper.workbench import api
from CNCStepper.workbench.document import program_file
from CNCStepper.workbench.document.core_job import machine_of
from CNCStepper.workbench.drawings.holes import holes_of
from CNCStepper.workbench.features.base import problem_of, values
from CNCStepper.workbench.features.catalogue import OPERATIONS
from CNCStepper.workbench.panels.field_errors import complaints

MILL = {"diameter_mm": 6, "feed_mm_min": 800, "plunge_mm_min": 200, "spindle_rpm": 10000}
DRILL = {"shape": "drill", "diameter_mm": 4, "feed_mm_min": 120, "plunge_mm_min": 120, "spindle_rpm": 8000}


@pytest.fixture
def job(document: Any) -> Any:
    """A job on a block of 100 × 70 × 10 with a mill and a drill."""
    job = api.new_job(document, stock_size_mm=(100, 70, 10))
    api.add_tool(job, **MILL)
    api.add_tool(job, **DRILL)
    return job


def sketch(document: Any, *shapes: Any, label: str = "Sketch") -> Any:
    """Return a sketch of edges, circles (as geometry) and points."""
    made = document.addObject("Sketcher::SketchObject", "Sketch")
    made.Label = label
    for shape in shapes:
        made.addGeometry(shape, False)
    document.recompute()
    return made


def polygon(*corners: tuple[float, float]) -> list[Any]:
    closed = [Vector(*corner, 0) for corner in (*corners, corners[0])]
    return [Part.LineSegment(a, b) for a, b in pairwise(closed)]


def circle(x: float, y: float, radius: float) -> Any:
    return Part.Circle(Vector(x, y, 0), Vector(0, 0, 1), radius)


def square(half: float, x: float = 0, y: float = 0) -> list[Any]:
    return polygon((x - half, y - half), (x + half, y - half), (x + half, y + half), (x - half, y + half))


def pocket(document: Any, job: Any) -> Any:
    drawing = sketch(document, *polygon((-40, -25), (40, -25), (30, 25), (-40, 25)), circle(0, 0, 8))
    return add(job, "pocket", drawing)


def circular(document: Any, job: Any) -> Any:
    return add(job, "circular_pocket", sketch(document, circle(5, 3, 20)))


def rectangular(document: Any, job: Any) -> Any:
    return add(job, "rectangular_pocket", turned_rectangle(document))


def face(document: Any, job: Any) -> Any:
    return add(job, "face", None, depth_mm=0.5, stepdown_mm=0.5, stepover_mm=4)


def contour(document: Any, job: Any) -> Any:
    leads = {"lead_in_kind": "arc", "lead_out_kind": "arc", "lead_in_radius_mm": 2, "lead_out_radius_mm": 2}
    outline = sketch(document, *polygon((-40, -25), (40, -25), (30, 25), (-40, 25)))
    return add(job, "contour", outline, depth_mm=10, tabs_by="count", **leads)


def drill(document: Any, job: Any) -> Any:
    points = [Part.Point(Vector(-30, -20, 0)), Part.Point(Vector(-30, 20, 0))]
    drawing = sketch(document, circle(30, 20, 2), circle(30, -20, 2), *points)
    return add(job, "drill", drawing, tool=job.Tools[1], pattern_kind="drawing", style="G83", depth_mm=8)


def bore(document: Any, job: Any) -> Any:
    drawing = sketch(document, circle(30, 20, 8), circle(-30, -20, 5))
    return add(job, "bore", drawing, pattern_kind="drawing", diameter_mm=0)


def thread(document: Any, job: Any) -> Any:
    add(job, "bore", None, diameter_mm=17.83)
    return add(job, "thread", None, major_diameter_mm=20, pitch_mm=2)


def engrave(document: Any, job: Any) -> Any:
    return add(job, "engrave", sketch(document, *square(20)), depth_mm=1)


def elliptical(document: Any, job: Any) -> Any:
    return add(job, "elliptical_pocket", sketch(document, circle(0, 0, 20)))


MADE: dict[str, Callable[[Any, Any], Any]] = {
    "pocket": pocket,
    "circular_pocket": circular,
    "rectangular_pocket": rectangular,
    "elliptical_pocket": elliptical,
    "face": face,
    "contour": contour,
    "drill": drill,
    "bore": bore,
    "thread": thread,
    "engrave": engrave,
}


def add(job: Any, cycle: str, drawing: Any, **given: Any) -> Any:
    """Return a new operation of 4 mm depth with the mill, unless something else is given."""
    plain = {"tool": job.Tools[0], "depth_mm": 4}
    return api.add_operation(job, cycle, drawing, **{**plain, **given})


def turned_rectangle(document: Any, radius: float = 5) -> Any:
    """Return a rounded rectangle of 60 × 30, turned by 15 degrees about its corner in (-25, -20)."""
    made = Draft.make_rectangle(60, 30)
    made.FilletRadius = radius
    made.Placement = FreeCAD.Placement(Vector(-25, -20, 0), FreeCAD.Rotation(Vector(0, 0, 1), 15))
    document.recompute()
    return made


def faults(job: Any) -> list[str]:
    """Return what the product's own proof finds in a job, remarks left out."""
    model, machine = api.job_model(job), machine_of(job)
    made = make_program(model, machine, job.Label)
    assert made.program == api.program_text(job)
    proof = prove(made.program, machine, removals=made.removals, tools=model.tools, stock=model.stock.stock())
    return [str(finding) for finding in proof.findings if finding.severity != "info"]


def wanted(job: Any) -> list[Removal]:
    return make_program(api.job_model(job), machine_of(job)).removals


def test_every_cycle_is_made_here() -> None:
    """Those of sheets are in test_process.py."""
    assert set(MADE) == {cycle for cycle, kind in OPERATIONS.items() if "milling" in kind.BY}


@pytest.mark.parametrize("cycle", OPERATIONS)
def test_a_cycle_has_a_property_for_every_key_of_the_core(cycle: str) -> None:
    kind = OPERATIONS[cycle]
    own = {entry.key for entry in kind.PROPERTIES if not entry.output}
    tables = {key for key in own if key.startswith(tuple(f"{name}_" for name in kind.TABLES))}
    drawn = {"curves", "outlines", "islands", "marks", "cycle", "offset_mm", "closed"}
    chosen = {"active", "drawings", "mark_drawings"}  # drawings of the document in place of curves
    assert set(cycle_class(cycle).model_fields) - drawn == (own - tables - chosen) | set(kind.TABLES)


@pytest.mark.parametrize("cycle", MADE)
def test_from_a_drawing_to_a_program_without_findings(document: Any, job: Any, cycle: str) -> None:
    operation = MADE[cycle](document, job)
    document.recompute()
    assert problem_of(operation) == ""
    assert faults(job) == []


@pytest.mark.parametrize("cycle", MADE)
def test_saved_and_reopened_it_is_the_same(document: Any, job: Any, cycle: str, tmp_path: Path) -> None:
    name, job_name = MADE[cycle](document, job).Name, job.Name
    document.recompute()
    text, held = api.program_text(job), plain_values(document.getObject(name))
    modes = shown_modes(document.getObject(name))
    document.saveAs(str(tmp_path / "peça nº 1.FCStd"))
    FreeCAD.closeDocument(document.Name)
    again = FreeCAD.openDocument(str(tmp_path / "peça nº 1.FCStd"))
    assert program_file.load(again.getObject(job_name)) == text
    assert plain_values(again.getObject(name)) == held
    assert shown_modes(again.getObject(name)) == modes
    for obj in again.Objects:
        obj.touch()
    again.recompute()
    assert api.program_text(again.getObject(job_name)) == text


def plain_values(obj: Any) -> dict[str, Any]:
    return {key: value for key, value in values(obj).items() if key not in ("tool", "drawings")}


def shown_modes(obj: Any) -> dict[str, Any]:
    return {entry.key: sorted(obj.getEditorMode(entry.name)) for entry in obj.Proxy.PROPERTIES}


@pytest.mark.parametrize("cycle", ["pocket", "circular_pocket", "contour", "engrave"])
def test_a_changed_drawing_changes_the_program(document: Any, job: Any, cycle: str) -> None:
    drawing = sketch(document, circle(0, 0, 20))
    operation = add(job, cycle, drawing)
    document.recompute()
    before = api.program_text(job)
    drawing.Geometry = [circle(0, 0, 15)]
    document.recompute()
    assert problem_of(operation) == ""
    assert api.program_text(job) != before
    drawing.Geometry = [circle(0, 0, 20)]
    document.recompute()
    assert api.program_text(job) == before


def test_closed_lines_are_outlines_and_islands_by_turns(document: Any, job: Any) -> None:
    drawing = sketch(document, *square(30), *square(20), *square(12), *square(5), *square(3, 40, 0))
    add(job, "pocket", drawing)
    document.recompute()
    (removal,) = wanted(job)
    area_mm2 = 60**2 - 40**2 + 24**2 - 10**2 + 6**2
    assert removal.region.area == pytest.approx(area_mm2, abs=1)
    assert not removal.region.contains(shapely.Point(16, 0)) and removal.region.contains(shapely.Point(8, 0))
    assert faults(job) == []


def test_several_outlines_in_one_island(document: Any, job: Any) -> None:
    inner = [edge for x in (-14, 0, 14) for edge in square(5, x, 0)]
    add(job, "pocket", sketch(document, *square(34), *square(25), *inner), tool=job.Tools[0])
    document.recompute()
    (removal,) = wanted(job)
    assert removal.region.area == pytest.approx(68**2 - 50**2 + 3 * 10**2, abs=1)


def test_an_open_line_is_refused_with_its_place(document: Any, job: Any) -> None:
    pocket = add(job, "pocket", sketch(document, *polygon((0, 0), (20, 0), (20, 20))[:2], label="Aberta"))
    document.recompute()
    assert "'Aberta' is open" in problem_of(pocket) and "X 20 Y 20" in problem_of(pocket)
    assert program_file.load(job) == ""


def test_without_a_drawing_it_says_what_to_choose(document: Any, job: Any) -> None:
    pocket = add(job, "pocket", None)
    drilling = add(job, "drill", None, pattern_kind="drawing")
    document.recompute()
    assert "choose a sketch, closed wires or faces" in problem_of(pocket)
    assert "choose a sketch with circles or points" in problem_of(drilling)


def plate(document: Any) -> Any:
    """Return a plate of 80 × 50 × 10 whose top is at Z 0, with a step of 5 mm in it and two holes of 4 mm."""
    solid = Part.makeBox(80, 50, 10, Vector(-40, -25, -10)).cut(Part.makeBox(40, 30, 5, Vector(-20, -15, -5)))
    for x in (-30, 30):
        solid = solid.cut(Part.makeCylinder(2, 10, Vector(x, 20, -10)))
    made = document.addObject("Part::Feature", "Plate")
    made.Shape = solid
    document.recompute()
    return made


def named(solid: Any, kind: str, accepts: Callable[[Any], bool]) -> list[str]:
    parts = solid.Shape.Faces if kind == "Face" else solid.Shape.Edges
    return [f"{kind}{number}" for number, part in enumerate(parts, start=1) if accepts(part)]


def level(part: Any, z: float) -> bool:
    return abs(part.BoundBox.ZMin - z) < 1e-6 and abs(part.BoundBox.ZMax - z) < 1e-6


def test_a_picked_face_is_a_pocket_and_moves_with_its_solid(document: Any, job: Any) -> None:
    solid = plate(document)
    add(job, "pocket", solid, picked=named(solid, "Face", lambda face: level(face, -5)), depth_mm=5)
    document.recompute()
    (removal,) = wanted(job)
    assert removal.region.bounds == pytest.approx((-20, -15, 20, 15), abs=1e-6)
    assert faults(job) == []
    solid.Placement.Base = Vector(3, 0, 0)
    document.recompute()
    (removal,) = wanted(job)
    assert removal.region.bounds == pytest.approx((-17, -15, 23, 15), abs=1e-6)


def test_the_inner_wires_of_a_picked_face_are_islands(document: Any, job: Any) -> None:
    solid = plate(document)
    add(job, "pocket", solid, picked=named(solid, "Face", lambda face: level(face, 0)), depth_mm=1)
    document.recompute()
    (removal,) = wanted(job)
    assert removal.region.area == pytest.approx(80 * 50 - 40 * 30 - 2 * math.pi * 4, rel=1e-4)


def test_picked_circular_edges_are_holes_once_each(document: Any, job: Any) -> None:
    solid = plate(document)
    rims = named(solid, "Edge", lambda edge: isinstance(edge.Curve, Part.Circle))
    assert len(rims) == 4
    drilling = add(job, "drill", solid, picked=rims, tool=job.Tools[1], pattern_kind="drawing", depth_mm=8)
    document.recompute()
    assert drilling.Holes == 2
    assert {hole.centre_mm for hole in holes_of(solid, rims)} == {(-30, 20), (30, 20)}
    assert {hole.diameter_mm for hole in holes_of(solid, rims)} == {4}
    assert faults(job) == []


def test_what_was_picked_and_is_gone_is_said(document: Any, job: Any) -> None:
    solid = plate(document)
    pocket = add(job, "pocket", solid, picked=["Face7"])
    solid.Shape = Part.makeSphere(5)
    document.recompute()
    assert "no longer exist" in problem_of(pocket)


def test_draft_points_and_circles_drawn_as_arcs_are_holes(document: Any) -> None:
    points = [Draft.make_point(x, 5, 0) for x in (1, 2, 3)]
    document.recompute()
    group = document.addObject("Part::Compound", "Points")
    group.Links = points
    document.recompute()
    assert [hole.centre_mm for hole in holes_of(group)] == [(1, 5), (2, 5), (3, 5)]
    assert [holes_of(point)[0].centre_mm for point in points] == [(1, 5), (2, 5), (3, 5)]
    half = [Part.ArcOfCircle(circle(7, 8, 3), a, a + math.pi) for a in (0, math.pi)]
    (hole,) = holes_of(sketch(document, *half, *square(20)))
    assert (hole.centre_mm, hole.diameter_mm) == ((7, 8), 6)


def test_construction_lines_and_open_arcs_are_no_holes(document: Any) -> None:
    made = sketch(document, Part.ArcOfCircle(circle(0, 0, 3), 0, 3), circle(9, 9, 2))
    made.addGeometry(Part.Point(Vector(1, 1, 0)), True)
    made.toggleConstruction(1)
    document.recompute()
    with pytest.raises(GeometryError, match="no circles and no points"):
        holes_of(made)


@pytest.mark.parametrize("radius", [0, 5])
def test_a_drawn_rectangle_gives_diagonal_corner_and_rotation(document: Any, job: Any, radius: float) -> None:
    made = add(job, "rectangular_pocket", turned_rectangle(document, radius))
    document.recompute()
    assert problem_of(made) == ""
    assert tuple(made.CornerA)[:2] == pytest.approx((-25, -20))
    assert tuple(made.CornerB)[:2] == pytest.approx((35, 10))
    assert (float(made.CornerRadius), float(made.Rotation)) == pytest.approx((radius, 15))
    assert "ReadOnly" in made.getEditorMode("CornerA")
    api.edit(made, drawing=None)
    assert "ReadOnly" not in made.getEditorMode("CornerA")


@pytest.mark.parametrize("corners", [((0, 0), (20, 0), (22, 10), (0, 10)), ((0, 0), (20, 0), (10, 10))])
def test_what_is_no_rectangle_is_refused(document: Any, job: Any, corners: tuple[tuple[float, float], ...]) -> None:
    made = add(job, "rectangular_pocket", sketch(document, *polygon(*corners)))
    document.recompute()
    assert "no single rectangle" in problem_of(made)


def test_only_what_counts_is_seen_and_given(document: Any, job: Any) -> None:
    made = contour(document, job)
    api.edit(made, tabs_by="none", lead_in_kind="none")
    document.recompute()
    hidden = {entry.key for entry in made.Proxy.PROPERTIES if "Hidden" in made.getEditorMode(entry.name)}
    assert {"tabs_count", "tabs_width_mm", "lead_in_radius_mm", "lead_out_length_mm"} <= hidden
    assert "lead_out_radius_mm" not in hidden
    operation = api.job_model(job).operation[0]
    assert operation.tabs is None and operation.lead_in.kind == "none" and operation.lead_out.radius_mm == 2
    api.edit(made, tabs_by="spacing", tabs_spacing_mm=40)
    document.recompute()
    assert api.job_model(job).operation[0].tabs.spacing_mm == 40
    assert "Hidden" not in made.getEditorMode("TabsWidth")


@pytest.mark.parametrize(("kind", "count"), [("bolt_circle", 6), ("grid", 12), ("line", 6), ("arc", 6), ("points", 1)])
def test_every_pattern_by_numbers(document: Any, job: Any, kind: str, count: int) -> None:
    drilling = add(job, "drill", None, tool=job.Tools[1], pattern_kind=kind)
    document.recompute()
    assert (problem_of(drilling), drilling.Holes) == ("", count)
    assert faults(job) == []


def test_several_tools_in_one_program(document: Any, job: Any) -> None:
    for cycle in ("pocket", "drill"):
        MADE[cycle](document, job)
    document.recompute()
    text = api.program_text(job)
    assert text.index("T1") < text.index("M0") < text.index("T2")


@pytest.mark.parametrize(
    ("key", "value", "word"), [("tabs_width_mm", 0, "tabs.width_mm"), ("overcut_mm", -1, "overcut")]
)
def test_a_bad_value_is_named(document: Any, job: Any, key: str, value: float, word: str) -> None:
    made = contour(document, job)
    api.edit(made, **{key: value})
    document.recompute()
    assert word in problem_of(made)
    found = complaints(cycle_class("contour"), made.Proxy.given(values(made)), lambda key, number: f"{number:g}")
    assert set(found) == {key}
