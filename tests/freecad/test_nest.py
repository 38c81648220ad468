# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_Nest: drawings, sketches and operations on sheets, which say when a part or a value has changed."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import FreeCAD
import Part
import pytest

from CNCStepper.errors import CNCStepperError, JobError
from CNCStepper.workbench import api
from CNCStepper.workbench.features.base import problem_of, proxy_type

SHEET = {"sheet_x_mm": 200, "sheet_y_mm": 100, "sheet_count": 3, "time_s": 1.0}


@pytest.fixture
def plate(document: Any) -> Any:
    """A plate of 60 x 40 mm with a hole, drawn far from the origin."""
    corners = [FreeCAD.Vector(*xy, 0) for xy in ((0, 0), (60, 0), (60, 40), (0, 40), (0, 0))]
    rim, hole = Part.makePolygon(corners), Part.Wire(Part.makeCircle(8, FreeCAD.Vector(20, 20, 0)))
    plate = document.addObject("Part::Feature", "Plate")
    plate.Shape = Part.makeCompound([rim, hole])
    plate.Placement.Base = FreeCAD.Vector(500, 300, 7)
    document.recompute()
    return plate


@pytest.fixture
def disc(document: Any) -> Any:
    disc = document.addObject("Part::Feature", "Disc")
    disc.Shape = Part.Wire(Part.makeCircle(10))
    return disc


def nested(document: Any, parts: list[tuple[Any, dict[str, Any]]], folder: Path, **values: Any) -> Any:
    nest = api.add_nest(document, [], folder=str(folder), **{**SHEET, **values})
    api.set_nest_parts(nest, parts)
    api.nest_parts(nest)
    document.recompute()
    return nest


def lengths(nest: Any) -> list[float]:
    shapes = [each.Shape for sheet in nest.Group for each in sheet.Group if each.Layer != "SHEET"]
    return sorted(round(shape.Length, 2) for shape in shapes)


def test_drawings_become_sheets_that_operations_follow(document: Any, plate: Any, disc: Any, tmp_path: Path) -> None:
    nest = nested(document, [(plate, {"count": 6}), (disc, {"count": 3, "priority": 2})], tmp_path / "folha ç")
    assert problem_of(nest) == "" and (nest.Placed, nest.Missing, nest.SheetCount) == (9, 0, 2)
    assert all(proxy_type(sheet) == "CNCStepper_Drawing" and problem_of(sheet) == "" for sheet in nest.Group)
    assert lengths(nest) == sorted([200.0] * 6 + [50.27] * 6 + [62.83] * 3)
    lefts = [min(each.Shape.BoundBox.XMin for each in sheet.Group) for sheet in nest.Group]
    assert lefts == pytest.approx([0.0, 250.0])
    job = api.new_job(document)
    outline = next(each for each in nest.Group[0].Group if each.Layer != "SHEET" and each.Shape.Length > 190)
    operation = api.add_operation(job, "contour", tool=api.add_tool(job), drawings=[(outline, ())])
    document.recompute()
    assert problem_of(operation) == ""
    of_operation = nested(document, [(operation, {"count": 2})], tmp_path / "again")
    assert of_operation.Placed == 2 and lengths(of_operation) == [200.0, 200.0]


def test_it_says_when_a_part_or_a_value_changes(document: Any, plate: Any, disc: Any, tmp_path: Path) -> None:
    nest = nested(document, [(plate, {"count": 2}), (disc, {"count": 1})], tmp_path)
    sheets = list(nest.Group)
    plate.Placement.Base = FreeCAD.Vector(0, 0, 0)
    document.recompute()
    assert problem_of(nest) == "", "where a part was drawn does not count"
    disc.Shape = Part.Wire(Part.makeCircle(12))
    document.recompute()
    assert "nest them again" in problem_of(nest)
    api.nest_parts(nest)
    document.recompute()
    assert problem_of(nest) == "" and nest.Group == sheets
    api.edit(nest, kerf_mm=0.5)
    document.recompute()
    assert "nest them again" in problem_of(nest)


def test_rotations_grain_remnants_and_locks_are_kept(document: Any, plate: Any, disc: Any, tmp_path: Path) -> None:
    rest = document.addObject("Part::Feature", "Rest")
    rest.Shape = Part.Wire(Part.makePolygon([FreeCAD.Vector(*xy, 0) for xy in ((0, 0), (90, 0), (0, 90), (0, 0))]))
    document.recompute()
    wanted = [(plate, {"count": 2, "turn": "any", "grain": "x"}), (disc, {"count": 2})]
    nest = api.add_nest(document, [], folder=str(tmp_path), sheet_grain="y", remnants=[rest], **SHEET)
    api.set_nest_parts(nest, wanted)
    api.nest_parts(nest)
    rows = json.loads(nest.Placements)
    assert {row[4] for row in rows if row[1] == 0} <= {90.0, 270.0}
    assert {row[0] for row in rows if row[1] == 1} == {0}, "the remnant is used first"
    locked = [[1, 0, 150.0, 20.0, 90.0, True]]
    nest.Placements = json.dumps(locked)
    api.nest_parts(nest)
    assert locked[0] in json.loads(nest.Placements) and nest.Placed == 4


def test_what_cannot_be_nested_is_refused_and_nothing_changes(document: Any, plate: Any, tmp_path: Path) -> None:
    box = document.addObject("Part::Box", "Box")
    line = document.addObject("Part::Feature", "Line")
    line.Shape = Part.makeLine((0, 0, 0), (10, 0, 0))
    document.recompute()
    for parts, values, why in (
        ([], {}, "there are no parts"),
        ([(line, {})], {}, "no closed outline"),
        ([(plate, {})], {"sheet_x_mm": 30}, "larger than every sheet"),
        ([(plate, {})], {"gap_mm": -1}, "gap_mm"),
        ([(plate, {})], {"folder": ""}, "no folder"),
        ([(box, {})], {}, "flat"),
    ):
        nest = api.add_nest(document, [], **{**SHEET, "folder": str(tmp_path / "none"), **values})
        api.set_nest_parts(nest, parts)
        with pytest.raises(CNCStepperError, match=why):
            api.nest_parts(nest)
        assert nest.Group == [] and not (tmp_path / "none").exists()


def test_it_survives_saving_and_opening(document: Any, plate: Any, tmp_path: Path) -> None:
    nest = nested(document, [(plate, {"count": 3, "turn": "half"})], tmp_path / "out")
    path, name = tmp_path / "nest.FCStd", nest.Name
    document.saveAs(str(path))
    FreeCAD.closeDocument(document.Name)
    again = FreeCAD.openDocument(str(path))
    try:
        again.recompute()
        nest = again.getObject(name)
        assert problem_of(nest) == "" and nest.Placed == 3 and len(nest.Group) == 1
    finally:
        FreeCAD.closeDocument(again.Name)


def test_a_bad_count_is_refused(document: Any, plate: Any, tmp_path: Path) -> None:
    nest = api.add_nest(document, [plate], folder=str(tmp_path / "none"), sheet_count=0)
    with pytest.raises(JobError, match="sheet_count"):
        api.nest_parts(nest)


def test_parts_of_two_thicknesses_lie_apart(document: Any, plate: Any, disc: Any, tmp_path: Path) -> None:
    nest = nested(document, [(plate, {"count": 2}), (disc, {"count": 3, "thickness_mm": 5.0})], tmp_path)
    rows = json.loads(nest.Placements)
    assert (nest.Placed, nest.Missing, nest.SheetCount) == (5, 0, 2)
    assert {(sheet, item) for sheet, item, *_ in rows} == {(0, 0), (3, 1)}, "three sheets of 3 mm come first"
    api.set_nest_parts(nest, [(plate, {"count": 2}), (disc, {"count": 3, "thickness_mm": 6.0})])
    document.recompute()
    assert "changed" in problem_of(nest)


def test_common_lines_give_blocks_and_lines(document: Any, plate: Any, tmp_path: Path) -> None:
    nest = nested(document, [(plate, {"count": 2})], tmp_path, gap_mm=0.0, kerf_mm=0.4, common_lines=True)
    assert problem_of(nest) == "" and {each.Layer for each in nest.Group[0].Group} == {"SHEET", "CUT", "COMMON"}
    sheet = {"stock_form": "sheet", "stock_size_mm": (200, 100, 3)}
    job = api.new_job(document, machine="laser-table", process="laser", material="plywood", **sheet)
    cut = next(each for each in nest.Group[0].Group if each.Layer == "CUT")
    operation = api.add_operation(job, "sheet_cut", cut, kerf_mm=0.4)
    document.recompute()
    assert api.program_text(job)
    operation.Kerf = 0.3
    document.recompute()
    with pytest.raises(JobError, match="another kerf than the nest") as refused:
        api.job_model(job)
    assert (refused.value.value, refused.value.limit) == ("0.3 mm", "0.4 mm")
    nest.Gap = 1.0
    with pytest.raises(JobError, match="no gap between their cuts"):
        api.nest_parts(nest)
