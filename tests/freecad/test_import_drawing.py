# SPDX-License-Identifier: LGPL-2.1-or-later
"""Imported drawings: exact Part objects that follow their file, keep their names, and are cut as contours."""

from __future__ import annotations

import math
import os
import shutil
from pathlib import Path
from typing import Any

import FreeCAD
import pytest

from CNCStepper.errors import JobError
from CNCStepper.workbench import api
from CNCStepper.workbench.document.drawing_files import look_now
from CNCStepper.workbench.features.base import problem_of

ROOT = Path(__file__).parents[2]
SIGN = ROOT / "examples" / "drawings" / "sign.svg"
PLATE = """<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="60mm" viewBox="0 0 100 60">
<g id="cut" fill="none" stroke="#ff0000"><rect id="edge" x="5" y="5" width="{width}" height="50"/></g>
<g id="holes" fill="none" stroke="#0000ff"><circle id="first" cx="20" cy="30" r="{radius}"/>{more}</g></svg>"""
SECOND = '<circle id="second" cx="60" cy="30" r="5"/>'


def plate(path: Path, width: float = 90, radius: float = 6, more: str = SECOND) -> Path:
    path.write_text(PLATE.format(width=width, radius=radius, more=more), "utf-8")
    os.utime(path, ns=(0, hash((width, radius, more)) % 10**15))
    return path


def names(drawing: Any) -> dict[str, str]:
    return {each.ChainName: each.Name for each in drawing.Group}


def job_of(document: Any) -> Any:
    job = api.new_job(document, stock_size_mm=(200, 200, 10), stock_origin="top-centre")
    api.add_tool(job, diameter_mm=3)
    return job


def test_lines_and_arcs_come_over_exactly_with_layer_colour_and_name(document: Any, tmp_path: Path) -> None:
    drawing = api.import_drawing(document, plate(tmp_path / "peça nº 1.svg"))
    document.recompute()
    assert problem_of(drawing) == ""
    found = {each.ChainName: each for each in drawing.Group}
    told = {(name, each.Layer, each.Colour, each.Closed) for name, each in found.items()}
    assert told == {
        ("edge", "cut", "#ff0000", True), ("first", "holes", "#0000ff", True), ("second", "holes", "#0000ff", True),
    }  # fmt: skip
    assert [edge.Curve.TypeId for edge in found["edge"].Shape.Edges] == ["Part::GeomLine"] * 4
    assert found["first"].Shape.Length == pytest.approx(12 * math.pi, abs=1e-9)
    assert found["edge"].Shape.BoundBox.XMax == pytest.approx(95, abs=1e-9)


def test_by_layer_there_is_one_object_for_each_layer_and_colour(document: Any, tmp_path: Path) -> None:
    drawing = api.import_drawing(document, plate(tmp_path / "a.svg"), split="layer")
    assert [(each.Layer, len(each.Shape.Wires)) for each in drawing.Group] == [("cut", 1), ("holes", 2)]


def test_a_reload_keeps_the_objects_and_what_stands_on_them(document: Any, tmp_path: Path) -> None:
    path = plate(tmp_path / "a.svg")
    drawing = api.import_drawing(document, path)
    before, job = names(drawing), job_of(document)
    edge = document.getObject(before["edge"])
    contour = api.add_operation(job, "contour", edge, side="outside", depth_mm=2)
    drill = api.add_operation(job, "bore", pattern_kind="drawing", depth_mm=2,
                              drawings=[document.getObject(before[name]) for name in ("first", "second")])  # fmt: skip
    document.recompute()
    assert [problem_of(each) for each in (contour, drill, job)] == ["", "", ""]
    text = api.program_text(job)
    edge.Placement.Base.x = 1.0
    plate(path, width=80, radius=4)
    assert look_now(drawing) == "changed"
    assert "has changed" in problem_of(drawing)
    api.reload_drawing(drawing)
    document.recompute()
    assert problem_of(drawing) == ""
    assert names(drawing) == before
    assert edge.Placement.Base.x == 1.0
    assert edge.Shape.BoundBox.XMax == pytest.approx(86, abs=1e-9)
    assert api.program_text(job) != text


def test_a_reload_adds_objects_beside_one_that_lies_in_a_nest(document: Any, tmp_path: Path) -> None:
    path = plate(tmp_path / "a.svg")
    drawing = api.import_drawing(document, path)
    edge = document.getObject(names(drawing)["edge"])
    nest = api.add_nest(document, [edge, *drawing.Group[1:2]], remnants=[drawing.Group[2]])
    parts, remnants, before = nest.Parts, nest.Remnants, drawing.Group
    plate(path, more=f'{SECOND}<circle id="third" cx="40" cy="12" r="2"/>')
    api.reload_drawing(drawing)
    assert len(drawing.Group) == len(before) + 1
    assert (nest.Parts, nest.Remnants) == (parts, remnants)
    assert set(before) < set(drawing.Group)
    plate(path, more="")
    api.reload_drawing(drawing)
    assert len(drawing.Group) == 2 and set(nest.Parts) | set(nest.Remnants) == set(drawing.Group)


def test_what_the_file_lost_is_told_where_it_was_cut(document: Any, tmp_path: Path) -> None:
    path = plate(tmp_path / "a.svg")
    drawing = api.import_drawing(document, path)
    job = job_of(document)
    drill = api.add_operation(job, "bore", document.getObject(names(drawing)["second"]), pattern_kind="drawing",
                              depth_mm=2)  # fmt: skip
    document.recompute()
    plate(path, more="")
    api.reload_drawing(drawing)
    document.recompute()
    assert len(drawing.Group) == 2
    assert "deleted" in problem_of(drill)


def test_a_missing_file_is_told_and_nothing_is_lost(document: Any, tmp_path: Path) -> None:
    path = plate(tmp_path / "a.svg")
    drawing = api.import_drawing(document, path)
    path.rename(tmp_path / "b.svg")
    assert look_now(drawing) == "missing"
    assert "not there any more" in problem_of(drawing)
    with pytest.raises(JobError):
        api.reload_drawing(drawing)
    assert len(drawing.Group) == 3
    (tmp_path / "b.svg").rename(path)
    assert look_now(drawing) == "current"
    assert problem_of(drawing) == ""


def test_a_refused_file_or_option_adds_nothing(document: Any, tmp_path: Path) -> None:
    with pytest.raises(JobError):
        api.import_drawing(document, tmp_path / "not there.svg")
    with pytest.raises(JobError):
        api.import_drawing(document, plate(tmp_path / "a.svg"), tolerance_mm=-1)
    assert not document.Objects


def test_faults_are_counted_and_mended(document: Any, tmp_path: Path) -> None:
    path = tmp_path / "gap.svg"
    path.write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" width="50mm" height="50mm" viewBox="0 0 50 50">'
        '<path fill="none" stroke="#000000" d="M5 5 H40 V40 H5 V5.3"/></svg>', "utf-8"
    )  # fmt: skip
    drawing = api.import_drawing(document, path)
    assert drawing.Faults > 0
    assert not drawing.Group[0].Closed
    api.edit(drawing, mending=True)
    api.reload_drawing(drawing)
    assert drawing.Group[0].Closed
    assert drawing.Faults == 0


def test_undo_takes_an_import_back_and_two_documents_do_not_meddle(document: Any, tmp_path: Path) -> None:
    document.UndoMode = 1
    path = plate(tmp_path / "a.svg")
    other = FreeCAD.newDocument("Other")
    elsewhere = api.import_drawing(other, path)
    document.openTransaction("Import")
    drawing = api.import_drawing(document, path)
    document.commitTransaction()
    before = names(drawing)
    plate(path, radius=3)
    document.openTransaction("Reload")
    api.reload_drawing(drawing)
    document.commitTransaction()
    radius = [each.Shape.Length / math.tau for each in (*drawing.Group, *elsewhere.Group) if each.ChainName == "first"]
    assert radius == [pytest.approx(3), pytest.approx(6)]
    document.undo()
    assert names(drawing) == before
    assert [each.Shape.Length / math.tau for each in drawing.Group if each.ChainName == "first"] == [pytest.approx(6)]
    document.undo()
    assert not document.Objects


def test_it_survives_save_copy_and_reopening_in_another_folder(document: Any, tmp_path: Path) -> None:
    path = plate(tmp_path / "a.svg")
    drawing = api.import_drawing(document, path)
    copied = document.copyObject(drawing, True)
    copy = copied[0] if isinstance(copied, list) else copied
    assert {each.ChainName for each in copy.Group} == {"edge", "first", "second"}
    before = names(drawing)
    document.saveAs(str(tmp_path / "a.FCStd"))
    FreeCAD.closeDocument(document.Name)
    moved = tmp_path / "moved"
    moved.mkdir()
    for name in ("a.svg", "a.FCStd"):
        (tmp_path / name).rename(moved / name)
    plate(moved / "a.svg", radius=2)
    again = FreeCAD.openDocument(str(moved / "a.FCStd"))
    drawing = next(each for each in again.Objects if getattr(each, "FileState", "") and names(each) == before)
    assert look_now(drawing) == "changed"
    api.reload_drawing(drawing)
    assert names(drawing) == before
    assert min(each.Shape.Length for each in drawing.Group) == pytest.approx(4 * math.pi)


@pytest.mark.parametrize(("name", "objects"), [("sign.svg", 5), ("gasket.dxf", 0)])
def test_examples_come_in(document: Any, name: str, objects: int) -> None:
    drawing = api.import_drawing(document, ROOT / "examples" / "drawings" / name)
    assert len(drawing.Group) >= max(objects, 1)
    assert all(each.Shape.isValid() for each in drawing.Group)


def test_points_and_solids_come_in(document: Any, tmp_path: Path) -> None:
    (tmp_path / "line.csv").write_text("x,y\n0,0\n10,0\n10,5\n", "utf-8")
    points = api.import_drawing(document, tmp_path / "line.csv")
    assert points.Group[0].Shape.Length == pytest.approx(15)
    corners = [((0, 0), (10, 0), (0, 10)), ((10, 0), (10, 10), (0, 10))]
    facets = (
        "facet normal 0 0 1\nouter loop\n" + "".join(f"vertex {x} {y} 0\n" for x, y in three) + "endloop\nendfacet\n"
        for three in corners
    )
    (tmp_path / "t.stl").write_text("solid t\n" + "".join(facets) + "endsolid t\n", "utf-8")
    solid = api.import_drawing(document, tmp_path / "t.stl")
    assert solid.Kind == "solid"
    assert solid.Group[0].Shape.Length == pytest.approx(40)


def test_a_step_file_is_read_by_this_freecad(document: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("CNCSTEPPER_CADQUERY", "none")
    shutil.copy(ROOT / "examples" / "drawings" / "bracket.step", tmp_path / "peça nº 2.step")
    drawing = api.import_drawing(document, tmp_path / "peça nº 2.step")
    assert problem_of(drawing) == "" and all(each.Closed for each in drawing.Group) and len(drawing.Group) > 1
