# SPDX-License-Identifier: LGPL-2.1-or-later
"""All selected drawings are cut together: nested, joined, each once; what cannot be used is said with its reason."""

from __future__ import annotations

import itertools
import math
from itertools import pairwise
from pathlib import Path
from typing import Any

import Draft
import FreeCAD
import importSVG
import Part
import pytest
import shapely
from FreeCAD import Vector
from shapely.geometry.base import BaseGeometry

from CNCStepper.errors import CNCStepperError
from CNCStepper.job.make import make_program
from CNCStepper.workbench import api
from CNCStepper.workbench.document.core_job import machine_of
from CNCStepper.workbench.document.selection import Selected, members, selected_drawings
from CNCStepper.workbench.features.base import problem_of
from CNCStepper.workbench.features.catalogue import OPERATIONS
from CNCStepper.workbench.features.cycle_operation import drawings_of

Point = tuple[float, float]

SVG = """<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="80mm" viewBox="0 0 100 80">
<path id="ring" fill="#000" fill-rule="evenodd" d="M 5 5 H 45 V 45 H 5 Z M 15 15 H 35 V 35 H 15 Z"/>
<path id="A" fill="#000" fill-rule="evenodd" d="M 60 5 L 80 5 L 95 50 L 45.5 50 Z M 66 12 L 74 12 L 80 40 L 60 40 Z"/>
<circle id="disc" cx="20" cy="62" r="10" fill="#000"/>
<path id="B" fill="#000" fill-rule="evenodd"
 d="M 40 55 h 30 v 24 h -30 z M 44 58 h 22 v 7 h -22 z M 44 68 h 22 v 7 h -22 z"/>
</svg>"""
IN_SVG_MM2 = 40**2 - 20**2 + (20 + 49.5) / 2 * 45 - (8 + 20) / 2 * 28 + math.pi * 100 + 30 * 24 - 2 * 22 * 7


@pytest.fixture
def job(document: Any) -> Any:
    """A job with a small mill."""
    job = api.new_job(document, stock_size_mm=(300, 300, 20), clearance_mm=10)
    api.add_tool(job, diameter_mm=2, feed_mm_min=800, plunge_mm_min=200, spindle_rpm=10000)
    return job


def rectangle(document: Any, length: float, width: float, x: float = 0, y: float = 0, z: float = 0) -> Any:
    made = Draft.make_rectangle(length, width, FreeCAD.Placement(Vector(x, y, z), FreeCAD.Rotation()))
    document.recompute()
    return made


def circle(document: Any, radius: float, x: float = 0, y: float = 0, z: float = 0) -> Any:
    made = Draft.make_circle(radius, FreeCAD.Placement(Vector(x, y, z), FreeCAD.Rotation()))
    document.recompute()
    return made


def line(document: Any, *points: Point) -> Any:
    made = Draft.make_wire([Vector(*point, 0) for point in points])
    document.recompute()
    return made


def sketch(document: Any, *shapes: Any) -> Any:
    made = document.addObject("Sketcher::SketchObject", "Sketch")
    for shape in shapes:
        made.addGeometry(shape, False)
    document.recompute()
    return made


def box(document: Any) -> Any:
    made = document.addObject("Part::Box", "Box")
    made.Placement.Base = Vector(60, 60, -5)
    document.recompute()
    return made


def choose(cycle: str, *drawings: Any) -> Selected:
    pairs = [each if isinstance(each, tuple) else (each, ()) for each in drawings]
    return selected_drawings(OPERATIONS[cycle], [(part, names) for each, names in pairs for part in members(each)])


def cut(job: Any, cycle: str, *drawings: Any, **values: Any) -> Any:
    """Return the operation that a command would add for a selection, recomputed."""
    depths = {"depth_mm": 2, **({} if cycle == "drill" else {"stepdown_mm": 2})}
    depths |= {"stepover_mm": 0.8} if cycle in ("pocket", "face") else {}
    made = api.add_operation(job, cycle, drawings=choose(cycle, *drawings).used, **depths, **values)
    job.Document.recompute()
    return made


def region(job: Any) -> BaseGeometry:
    """Return what the job's operations want removed, seen from above."""
    return shapely.union_all([removal.region for removal in make_program(api.job_model(job), machine_of(job)).removals])


def reasons(found: Selected) -> dict[str, str]:
    return {error.what.split("'")[1]: error.code for error in found.refusals}


def test_a_rectangle_and_a_circle_are_a_pocket_with_an_island(document: Any, job: Any) -> None:
    pocket = cut(job, "pocket", rectangle(document, 60, 40), circle(document, 8, 30, 20))
    assert problem_of(pocket) == "" and pocket.Proxy.remarks == ()
    wanted = shapely.box(0, 0, 60, 40) - shapely.Point(30, 20).buffer(8, quad_segs=500)
    assert region(job).area == pytest.approx(60 * 40 - math.pi * 64, abs=0.5)
    assert region(job).symmetric_difference(wanted).area < 0.5


@pytest.mark.parametrize("cycle", ["pocket", "contour", "engrave", "face"])
def test_the_order_of_selection_does_not_matter(document: Any, job: Any, cycle: str) -> None:
    drawings = [rectangle(document, 60, 40), circle(document, 8, 20, 20), circle(document, 5, 45, 20)]
    made = cut(job, cycle, *drawings)
    programs = set()
    for order in itertools.permutations(drawings):
        api.edit(made, drawings=choose(cycle, *order).used)
        document.recompute()
        programs.add(api.program_text(job))
    assert len(programs) == 1


def test_holes_of_several_drawings_in_any_order(document: Any, job: Any) -> None:
    api.edit(job.Tools[0], shape="drill")
    points = [Draft.make_point(x, 5, 0) for x in (40, 10, 25)]
    sketched = sketch(document, Part.Circle(Vector(60, 5), Vector(0, 0, 1), 2), *polygon((0, 20), (9, 20), (9, 30)))
    drilling = cut(job, "drill", *points, sketched, pattern_kind="drawing")
    assert (problem_of(drilling), drilling.Holes) == ("", 4)
    assert any(
        "'Sketch' that are not whole circles, so that no hole is drilled: 3" in said for said in drilling.Proxy.warnings
    )
    text = api.program_text(job)
    api.edit(drilling, drawings=[sketched, *reversed(points)])
    document.recompute()
    assert api.program_text(job) == text
    points[0].X = 80
    document.recompute()
    assert "X80" in api.program_text(job)


def polygon(*corners: Point) -> list[Any]:
    return [Part.LineSegment(Vector(*a, 0), Vector(*b, 0)) for a, b in pairwise([*corners, corners[0]])]


def test_holes_drawn_twice_are_made_once_and_said(document: Any, job: Any) -> None:
    drilling = cut(job, "drill", circle(document, 4, 9, 9), circle(document, 2, 9, 9), pattern_kind="drawing")
    assert drilling.Holes == 1
    assert any("about the same centre" in said for said in drilling.Proxy.warnings)


def test_the_holes_of_an_svg_stay(document: Any, job: Any, tmp_path: Path) -> None:
    """FreeCAD's own importer: it makes one object of each part of a path, or a face with holes, as its version does."""
    path = tmp_path / "letras.svg"
    path.write_text(SVG, "utf-8")
    before = set(document.Objects)
    importSVG.insert(str(path), document.Name)
    document.recompute()
    imported = [obj for obj in document.Objects if obj not in before]
    found = choose("pocket", *imported)
    assert reasons(found) == {}
    pocket = api.add_operation(job, "pocket", drawings=found.used, depth_mm=2, stepdown_mm=2, stepover_mm=0.8)
    document.recompute()
    assert problem_of(pocket) == ""
    assert region(job).area == pytest.approx(IN_SVG_MM2, rel=1e-3)
    inside = [(25, -25), (70, -30), (55, -61), (55, -71)]  # holes; SVG's Y runs down
    outside = [(10, -25), (55, -45), (42, -60), (20, -62)]
    assert not any(region(job).contains(shapely.Point(place)) for place in inside)
    assert all(region(job).contains(shapely.Point(place)) for place in outside)


def test_what_cannot_be_used_is_named_with_its_reason(document: Any, job: Any) -> None:
    outline, island = rectangle(document, 60, 40), circle(document, 8, 30, 20)
    open_line, tilted = line(document, (100, 0), (120, 0), (120, 10)), circle(document, 5, 100, 100)
    tilted.Placement.Rotation = FreeCAD.Rotation(Vector(1, 0, 0), 30)
    again, solid, text = circle(document, 8, 30, 20), box(document), Draft.make_text(["words"], Vector(1, 1, 0))
    empty = document.addObject("Sketcher::SketchObject", "Sketch")
    document.recompute()
    unusable = [open_line, tilted, again, solid, text, empty]
    found = choose("pocket", *unusable, island, outline)
    assert [drawing for drawing, _ in found.used] == [outline, island]
    assert reasons(found) == {
        open_line.Label: "outline-open",
        tilted.Label: "drawing-not-flat",
        again.Label: "drawing-twice",
        solid.Label: "drawing-solid",
        text.Label: "drawing-kind",
        empty.Label: "drawing-empty",
    }
    made = cut(job, "pocket", *unusable, outline, island)
    assert problem_of(made) == ""
    assert region(job).area == pytest.approx(60 * 40 - math.pi * 64, abs=0.5)


@pytest.mark.parametrize(
    ("cycle", "code"), [("drill", "holes-missing"), ("bore", "holes-missing"), ("circular_pocket", "ellipse-missing")]
)
def test_what_a_kind_cannot_use_is_named(document: Any, cycle: str, code: str) -> None:
    round_one, lines = circle(document, 8), line(document, (100, 0), (120, 0))
    found = choose(cycle, lines, round_one)
    assert [drawing for drawing, _ in found.used] == [round_one]
    assert reasons(found) == {lines.Label: code}


def test_only_one_drawing_gives_a_shape(document: Any, job: Any) -> None:
    first, second = circle(document, 8), circle(document, 8, 40)
    found = choose("circular_pocket", second, first)
    assert [drawing for drawing, _ in found.used] == [first]
    assert reasons(found) == {second.Label: "drawing-second"}
    made = api.add_operation(job, "circular_pocket", drawings=[first, second], depth_mm=2)
    document.recompute()
    assert "follows one drawing" in problem_of(made)


def test_nothing_usable_is_refused_with_every_reason(document: Any) -> None:
    lines = [line(document, (0, 0), (9, 0), (9, 9)), line(document, (20, 0), (29, 0), (29, 9))]
    with pytest.raises(CNCStepperError, match="is open and encloses nothing"):
        choose("pocket", lines[0]).require()
    with pytest.raises(CNCStepperError, match="none of the selected drawings can be followed") as refusal:
        choose("pocket", *lines).require()
    assert all(f"'{each.Label}' is open" in str(refusal.value) for each in lines)


def test_lines_of_several_drawings_that_meet_are_one_outline(document: Any, job: Any) -> None:
    corners = [(0, 0), (50, 0), (50, 30), (0, 30)]
    sides = [line(document, a, b) for a, b in pairwise([*corners, corners[0]])]
    sides[1].Points = list(reversed(sides[1].Points))
    document.recompute()
    found = choose("pocket", *reversed(sides), line(document, (80, 0), (90, 0)))
    assert [drawing for drawing, _ in found.used] == sides
    pocket = cut(job, "pocket", *sides)
    assert problem_of(pocket) == ""
    assert region(job).area == pytest.approx(50 * 30, abs=1)
    sides[0].Points = [Vector(0, 0), Vector(40, 0)]
    document.recompute()
    assert "is open" in problem_of(pocket)


def test_faces_and_edges_of_solids_and_drawings_together(document: Any, job: Any) -> None:
    solid = document.addObject("Part::Feature", "Plate")
    solid.Shape = Part.makeBox(80, 50, 10, Vector(0, 0, -10)).cut(Part.makeBox(40, 30, 5, Vector(10, 10, -5)))
    island = circle(document, 5, 30, 25)
    document.recompute()
    faces = [f"Face{n}" for n, face in enumerate(solid.Shape.Faces, 1) if face.BoundBox.ZLength < 1e-6]
    floor = [name for name in faces if abs(solid.Shape.getElement(name).BoundBox.ZMax + 5) < 1e-6]
    pocket = cut(job, "pocket", (solid, tuple(floor)), island)
    assert problem_of(pocket) == ""
    assert region(job).area == pytest.approx(40 * 30 - math.pi * 25, abs=0.5)
    assert any("heights from Z-5 to Z0 mm" in said for said in pocket.Proxy.warnings)
    assert api.job_model(job).operation[0].depth_mm == 2


def test_faces_side_by_side_that_share_an_edge(document: Any, job: Any) -> None:
    solid = document.addObject("Part::Feature", "Steps")
    two = Part.makeBox(20, 20, 10, Vector(0, 0, -10)).multiFuse([Part.makeBox(20, 20, 10, Vector(20, 0, -10))])
    solid.Shape = two
    tops = tuple(f"Face{n}" for n, face in enumerate(two.Faces, 1) if abs(face.BoundBox.ZMin) < 1e-6)
    assert len(tops) == 2
    pocket = cut(job, "pocket", (solid, tops))
    assert problem_of(pocket) == ""
    assert region(job).area == pytest.approx(40 * 20, abs=0.5)


def test_a_group_means_what_it_holds(document: Any, job: Any) -> None:
    outline, island = rectangle(document, 60, 40), circle(document, 8, 30, 20)
    outer = document.addObject("App::DocumentObjectGroup", "Group")
    inner = document.addObject("App::DocumentObjectGroup", "Group")
    inner.addObject(island)
    outer.addObjects([outline, inner])
    part = document.addObject("App::Part", "Part")
    part.addObject(lonely := circle(document, 3, 100, 0))
    document.recompute()
    assert set(members(outer)) == {outline, island}
    assert members(part) == [lonely]
    pocket = cut(job, "pocket", outer, part)
    assert {drawing for drawing, _ in drawings_of(pocket)} == {outline, island, lonely}
    part.Placement.Base = Vector(5, 0, 0)
    document.recompute()
    assert region(job).bounds[2] == pytest.approx(108, abs=1e-3)


def test_a_changed_and_a_deleted_drawing_of_several(document: Any, job: Any) -> None:
    document.UndoMode = 1
    outline, island = rectangle(document, 60, 40), circle(document, 8, 30, 20)
    pocket = cut(job, "pocket", outline, island)
    good = api.program_text(job)
    island.Radius = 10
    document.recompute()
    assert region(job).area == pytest.approx(60 * 40 - math.pi * 100, abs=0.5)
    island.Radius = 8
    document.recompute()
    assert api.program_text(job) == good
    document.openTransaction("delete")
    label = island.Label
    document.removeObject(island.Name)
    document.commitTransaction()
    document.recompute()
    assert f"'{label}' that it followed was deleted" in problem_of(pocket)  # an island is not cut away unasked
    document.undo()
    document.recompute()
    assert (problem_of(pocket), api.program_text(job)) == ("", good)
    document.redo()
    api.edit(pocket, drawings=drawings_of(pocket))
    document.recompute()
    assert problem_of(pocket) == ""
    assert region(job).area == pytest.approx(60 * 40, abs=0.5)


def test_outlines_that_cross_are_refused_by_name(document: Any, job: Any) -> None:
    outline, crossing = rectangle(document, 60, 40), circle(document, 8, 60, 20)
    pocket = cut(job, "pocket", outline, crossing)
    assert f"'{crossing.Label}' and '{outline.Label}' cross" in problem_of(pocket)


def test_what_touches_is_no_crossing(document: Any, job: Any) -> None:
    pocket = cut(job, "pocket", rectangle(document, 60, 40), circle(document, 8, 8, 20), rectangle(document, 9, 9, 60))
    assert problem_of(pocket) == ""
    assert region(job).area == pytest.approx(60 * 40 - math.pi * 64 + 81, abs=1)


def test_facing_says_that_it_takes_what_lies_inside(document: Any, job: Any) -> None:
    facing = cut(job, "face", rectangle(document, 60, 40), circle(document, 8, 30, 20))
    assert problem_of(facing) == ""
    assert any("inside an outline is faced" in said for said in facing.Proxy.warnings)


def test_engraved_lines_are_cut_once(document: Any, job: Any) -> None:
    first, longer = line(document, (0, 0), (20, 0)), line(document, (0, 0), (20, 0), (20, 30))
    on_it = line(document, (5, 0), (15, 0))
    engraving = cut(job, "engrave", first, longer, on_it)
    assert [drawing for drawing, _ in drawings_of(engraving)] == [longer]
    assert float(engraving.LineLength) == pytest.approx(50)
    api.edit(engraving, drawings=[first, longer, on_it])
    document.recompute()
    assert float(engraving.LineLength) == pytest.approx(50)
    assert sum("counts once" in said for said in engraving.Proxy.warnings) == 2


def test_hundreds_of_drawings_are_quick(document: Any, job: Any) -> None:
    import time

    compound = Part.Compound([Part.makeCircle(1 + n % 3, Vector(6 * (n % 20), 6 * (n // 20), 0)) for n in range(400)])
    parts = [document.addObject("Part::Feature", "Hole") for _ in range(400)]
    for part, edge in zip(parts, compound.Edges, strict=True):
        part.Shape = edge
    begun_s = time.process_time()
    found = choose("pocket", *parts)
    assert len(found.used) == 400
    assert time.process_time() - begun_s < 5
