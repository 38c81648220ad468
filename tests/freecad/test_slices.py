# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_Slices: a body as drawings of nested sheets, which say when the body or a value has changed."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import FreeCAD
import Part
import pytest

from CNCStepper.errors import JobError
from CNCStepper.workbench import api
from CNCStepper.workbench.features.base import problem_of, proxy_type


@pytest.fixture
def block(document: Any) -> Any:
    """A block of 40 x 30 x 12 mm with a hole through it."""
    shape = Part.makeBox(40, 30, 12).cut(Part.makeCylinder(5, 12, FreeCAD.Vector(20, 15, 0)))
    block = document.addObject("Part::Feature", "Block")
    block.Shape = shape
    return block


def sliced(document: Any, solid: Any, folder: Path, **values: Any) -> Any:
    slices = api.add_slices(document, solid, folder=str(folder), sheet_x_mm=200, sheet_y_mm=100, time_s=1.0, **values)
    api.slice_solid(slices)
    document.recompute()
    return slices


def test_a_body_becomes_drawings_of_its_nested_sheets(document: Any, block: Any, tmp_path: Path) -> None:
    slices = sliced(document, block, tmp_path / "fatias ç", thickness_mm=4, hole_mm=0)
    assert problem_of(slices) == "" and (slices.SliceCount, slices.SheetCount) == (3, 1)
    (sheet,) = slices.Group
    assert proxy_type(sheet) == "CNCStepper_Drawing" and problem_of(sheet) == ""
    outlines = [each.Shape for each in sheet.Group if each.Layer == "CUT"]
    lengths = sorted(round(shape.Length, 3) for shape in outlines)
    assert lengths == pytest.approx([31.416] * 3 + [140.0] * 3, abs=0.01)
    assert max(shape.BoundBox.XMax for shape in outlines) <= 200 - 3 + 0.01
    assert (tmp_path / "fatias ç" / "slice-003.dxf").exists()


def test_it_says_when_the_body_or_a_value_changes_and_slices_again(document: Any, block: Any, tmp_path: Path) -> None:
    slices = sliced(document, block, tmp_path, thickness_mm=4)
    (sheet,) = slices.Group
    block.Shape = Part.makeBox(40, 30, 20)
    document.recompute()
    assert "slice it again" in problem_of(slices)
    api.slice_solid(slices)
    document.recompute()
    assert problem_of(slices) == "" and slices.SliceCount == 5 and slices.Group == [sheet]
    api.edit(slices, thickness_mm=2)
    document.recompute()
    assert "slice it again" in problem_of(slices)


def test_a_mesh_is_sliced_too(document: Any, tmp_path: Path) -> None:
    import Mesh

    mesh = document.addObject("Mesh::Feature", "Ball")
    mesh.Mesh = Mesh.createSphere(15.0, 60)
    slices = sliced(document, mesh, tmp_path, thickness_mm=3, axis="x", hole_mm=0)
    assert problem_of(slices) == "" and slices.SliceCount == 10


@pytest.mark.parametrize(
    ("values", "code"),
    [
        ({"thickness_mm": 0}, "thickness_mm"),
        ({"thickness_mm": 0.001}, "sheets; use thicker"),
        ({"gap_mm": -1}, "gap_mm"),
    ],
)
def test_what_cannot_be_sliced_is_refused_and_nothing_changes(
    document: Any, block: Any, tmp_path: Path, values: dict[str, float], code: str
) -> None:
    slices = api.add_slices(document, block, folder=str(tmp_path / "none"), **values)
    with pytest.raises(JobError, match=code):
        api.slice_solid(slices)
    assert slices.Group == [] and not (tmp_path / "none").exists()


def test_without_a_solid_or_a_folder_it_says_so(document: Any, block: Any) -> None:
    slices = api.add_slices(document, document.addObject("App::FeaturePython", "Nothing"))
    with pytest.raises(JobError, match="no solid"):
        api.slice_solid(slices)
    api.edit(slices, solid=block)
    with pytest.raises(JobError, match="no folder"):
        api.slice_solid(slices)


def test_a_relative_folder_lies_beside_the_document(document: Any, block: Any, tmp_path: Path) -> None:
    slices = api.add_slices(document, block, folder="fatias ç", sheet_x_mm=200, sheet_y_mm=100, time_s=1.0)
    with pytest.raises(JobError, match=r"no folder.*whole path"):
        api.slice_solid(slices)
    document.saveAs(str(tmp_path / "block.FCStd"))
    api.slice_solid(slices)
    assert list((tmp_path / "fatias ç").glob("*.dxf"))


def test_it_survives_saving_and_opening(document: Any, block: Any, tmp_path: Path) -> None:
    slices = sliced(document, block, tmp_path / "out", thickness_mm=4)
    path, name = tmp_path / "block.FCStd", slices.Name
    document.saveAs(str(path))
    FreeCAD.closeDocument(document.Name)
    again = FreeCAD.openDocument(str(path))
    try:
        again.recompute()
        slices = again.getObject(name)
        assert problem_of(slices) == "" and slices.SliceCount == 3 and len(slices.Group) == 1
    finally:
        FreeCAD.closeDocument(again.Name)
