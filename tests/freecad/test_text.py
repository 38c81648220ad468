# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_Text: exact wires in fonts of the system and in single lines, which recompute and survive reopening."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import FreeCAD
import Part
import pytest

from CNCStepper.drawing.text.font_files import find_face
from CNCStepper.drawing.text.text_curves import TextStyle, text_curves
from CNCStepper.errors import JobError
from CNCStepper.job.shape_forms.text_form import TextForm
from CNCStepper.workbench import api
from CNCStepper.workbench.features.base import problem_of

FONT = "DejaVu Sans"


def test_a_text_has_the_curves_of_the_same_text_in_a_job_file(document: Any) -> None:
    text = api.add_text(document, "Peça à mão", font=FONT, height_mm=8)
    document.recompute()
    assert problem_of(text) == ""
    curves = TextForm(text="Peça à mão", font=FONT, height_mm=8).curves(Path())
    assert text.CurveCount == len(curves) == len(text.Shape.Wires)
    assert text.Shape.Length == pytest.approx(sum(curve.length_mm for curve in curves), rel=1e-9)
    assert all(wire.isClosed() for wire in text.Shape.Wires)
    kinds = {edge.Curve.TypeId for edge in text.Shape.Edges}
    assert kinds <= {"Part::GeomLine", "Part::GeomCircle"}


def test_a_single_line_font_is_open_and_engraved(document: Any) -> None:
    text = api.add_text(document, "ção", font="engraving")
    job = api.new_job(document, stock_size_mm=(100, 70, 10))
    api.add_tool(job, diameter_mm=3)
    engraving = api.add_engrave(job, text, depth_mm=0.3)
    document.recompute()
    assert any(not wire.isClosed() for wire in text.Shape.Wires)
    assert [problem_of(each) for each in (text, engraving, job)] == ["", "", ""]
    before = api.program_text(job)
    api.edit(text, text="mão")
    document.recompute()
    assert api.program_text(job) != before


def test_letters_stand_along_an_arc(document: Any) -> None:
    text = api.add_text(document, "ABC", font=FONT, along="arc", align="center", arc_radius_mm=30)
    document.recompute()
    assert problem_of(text) == ""
    assert text.Shape.BoundBox.YMin > 20
    assert text.Shape.BoundBox.Center.x == pytest.approx(0, abs=3)
    api.edit(text, along="line", line_begin_mm=(0, 0), line_end_mm=(0, 80))
    document.recompute()
    assert text.Shape.BoundBox.YLength > text.Shape.BoundBox.XLength


def without_hints(path: Path, target: Path) -> Path:
    """Write a font whose glyphs have no instructions: FreeCAD's letters follow these, which move their lines."""
    from fontTools.ttLib import TTFont

    font = TTFont(path)
    for name in font["glyf"].keys():  # noqa: SIM118  (no mapping)
        font["glyf"][name].removeHinting()
    font.save(target)
    return target


def filled(wires: Any) -> Any:
    """Return what the outlines of a letter fill: those within another are holes, those that cross it are part of it."""
    faces = sorted(map(Part.Face, wires), key=lambda face: -face.Area)
    whole = faces[0]
    for face in faces[1:]:
        common = whole.common(face).Area
        whole = whole.cut(face) if common > 0.999 * face.Area else whole.fuse(face)
    return whole.removeSplitter()


def test_letters_are_those_of_freecad_s_shape_string(tmp_path: Path) -> None:
    font = without_hints(find_face(FONT).path, tmp_path / "plain.ttf")
    style = TextStyle(file=font, height_mm=100.0, size="em")
    scales, wires = [], 0
    for letter, theirs in zip("maçã", Part.makeWireString("maçã", f"{tmp_path}/", font.name, 100.0, 0), strict=True):
        ours, shape = text_curves(style, letter, 0.001), filled(theirs)
        assert len(ours) == len(shape.Wires), letter  # FreeCAD leaves the cedilla over its c as two outlines
        scales.append(math.sqrt(shape.Area / sum(curve.area_mm2 for curve in ours)))
        wires += len(theirs) - len(ours)
        left, right = min(curve.box_mm[0] for curve in ours), max(curve.box_mm[2] for curve in ours)
        scales.append(shape.BoundBox.XLength / (right - left))
    assert wires == 1
    assert scales == pytest.approx([scales[0]] * 8, rel=5e-4)  # FreeCAD's size is another measure of a letter


@pytest.mark.parametrize(
    ("values", "sentence"),
    [
        ({"text": "a\u3042"}, "\u3042"),
        ({"font": "No Such Font"}, "no font"),
        ({"text": ""}, "text"),
        ({"height_mm": -1}, "height_mm"),
        ({"along": "arc", "arc_sweep_deg": 0}, "sweep"),
    ],
)
def test_what_cannot_be_written_says_why(document: Any, values: dict[str, Any], sentence: str) -> None:
    text = api.add_text(document, "A", font=FONT)
    api.edit(text, **values)
    document.recompute()
    assert sentence in problem_of(text)


def test_a_bad_choice_changes_nothing(document: Any) -> None:
    with pytest.raises(JobError):
        api.add_text(document, "A", align="upwards")
    assert not document.Objects


def test_it_survives_save_and_reopen_with_its_lines_and_place(document: Any, tmp_path: Path) -> None:
    text = api.add_text(document, 'uma "linha"\noutra', font=FONT)
    text.Placement.Base.x = 7
    document.recompute()
    length = text.Shape.Length
    document.saveAs(str(tmp_path / "letras.FCStd"))
    FreeCAD.closeDocument(document.Name)
    (again,) = FreeCAD.openDocument(str(tmp_path / "letras.FCStd")).Objects
    assert again.Text == 'uma "linha"\noutra'
    again.touch()
    again.Document.recompute()
    assert (again.Shape.Length, again.Placement.Base.x) == (pytest.approx(length), 7)
    assert isinstance(again.Shape, Part.Compound)
