# SPDX-License-Identifier: LGPL-2.1-or-later
"""Texts and hatches of DXF files: where they lie, in which font, and what is left out."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import ezdxf
import numpy as np
import pytest
from ezdxf.enums import TextEntityAlignment

from CNCStepper.drawing.drawing import Drawing
from CNCStepper.drawing.dxf.reader import read_dxf
from CNCStepper.errors import JobError

FONT = "DejaVuSans.ttf"  # matplotlib brings it


@pytest.fixture
def document() -> Any:
    made = ezdxf.new("R2010")
    made.units = 4
    made.styles.add("outlines", font=FONT)
    made.styles.add("strokes", font="romans.shx")
    return made


def read(document: Any, folder: Path) -> Drawing:
    document.saveas(folder / "texts.dxf")
    return read_dxf(folder / "texts.dxf", 0.01)


def box(drawing: Drawing) -> list[float]:
    boxes = np.array([chain.curve.box_mm for chain in drawing.chains])
    return [*boxes[:, :2].min(axis=0).tolist(), *boxes[:, 2:].max(axis=0).tolist()]


ALIGNMENTS = {
    "LEFT": (0, 0),
    "CENTER": (0.5, 0),
    "RIGHT": (1, 0),
    "TOP_LEFT": (0, 1),
    "MIDDLE_CENTER": (0.5, 0.5),
    "BOTTOM_RIGHT": (1, -1 / 3),
    "MIDDLE": (0.5, 0.5),
}


@pytest.mark.parametrize("name", ALIGNMENTS)
@pytest.mark.parametrize("turn_deg", [0, 90])
def test_capitals_have_the_height_and_stand_at_the_point(
    document: Any, tmp_path: Path, name: str, turn_deg: int
) -> None:
    text = document.modelspace().add_text("IHI", height=10, rotation=turn_deg, dxfattribs={"style": "outlines"})
    text.set_placement((30, 40), align=TextEntityAlignment[name])
    left, low, right, high = box(read(document, tmp_path))
    if turn_deg:
        left, low, right, high = low - 40, -(right - 30), high - 40, -(left - 30)
    else:
        left, low, right, high = left - 30, low - 40, right - 30, high - 40
    share_x, share_y = ALIGNMENTS[name]
    assert high - low == pytest.approx(10, abs=0.02)
    assert low == pytest.approx(-10 * share_y, abs=0.02)
    margin = (right - left) * 0.06  # beside the outer letters
    assert left == pytest.approx(-share_x * (right - left), abs=margin + 0.8)


def test_width_factor_oblique_and_fit(document: Any, tmp_path: Path) -> None:
    space = document.modelspace()
    space.add_text("H", height=10, dxfattribs={"style": "outlines"})
    plain = box(read(document, tmp_path))
    space[0].dxf.width = 2.0
    wide = box(read(document, tmp_path))
    assert wide[2] == pytest.approx(2 * plain[2]) and wide[3] == pytest.approx(plain[3])
    space[0].dxf.width, space[0].dxf.oblique = 1.0, 15.0
    slanted = box(read(document, tmp_path))
    assert slanted[2] == pytest.approx(plain[2] + 10 * math.tan(math.radians(15)), abs=0.02)
    space[0].dxf.oblique = 0.0
    space[0].set_placement((0, 0), (100, 0), TextEntityAlignment.FIT)
    fitted = box(read(document, tmp_path))
    assert fitted[3] == pytest.approx(10, abs=0.02) and 80 < fitted[2] < 100
    space[0].set_placement((0, 0), (100, 0), TextEntityAlignment.ALIGNED)
    assert box(read(document, tmp_path))[3] > 50


def test_lines_of_mtext_lie_five_thirds_apart_and_are_wrapped(document: Any, tmp_path: Path) -> None:
    given = {"style": "outlines", "char_height": 3, "insert": (0, 0), "attachment_point": 1}
    text = document.modelspace().add_mtext("HH\\PHH", given)
    assert box(read(document, tmp_path))[1] == pytest.approx(-8, abs=0.02) and box(read(document, tmp_path))[3] < 0.02
    text.text, text.dxf.width = "HH HH HH", 8.0
    assert box(read(document, tmp_path))[1] == pytest.approx(-13, abs=0.02)
    text.dxf.attachment_point = 7
    assert box(read(document, tmp_path))[1] == pytest.approx(0, abs=0.02)


def test_an_shx_font_becomes_strokes_and_a_warning(document: Any, tmp_path: Path) -> None:
    document.modelspace().add_text("Hç", height=10, dxfattribs={"style": "strokes"})
    drawing = read(document, tmp_path)
    assert "romans.shx" in drawing.warnings[0] and not any(chain.attributes.filled for chain in drawing.chains)
    assert not drawing.chains[0].curve.closed


def test_an_attribute_of_a_block_is_text_on_its_layer(document: Any, tmp_path: Path) -> None:
    document.blocks.new("title").add_attdef("NAME", (0, 0))
    insert = document.modelspace().add_blockref("title", (5, 5), {"layer": "titles"})
    insert.add_attrib("NAME", "H", (50, 60), {"height": 4, "style": "outlines"})
    (letter,) = read(document, tmp_path).chains
    assert letter.attributes.layer == "titles" and letter.attributes.groups == ("title",) and letter.attributes.filled
    assert letter.curve.box_mm[1] == pytest.approx(60, abs=0.01)


def test_too_much_text_refuses_the_drawing(document: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("CNCStepper.drawing.dxf.texts.MOST_CHARACTERS", 10)
    document.modelspace().add_text("H" * 11)
    with pytest.raises(JobError, match="too much text"):
        read(document, tmp_path)


def test_boundaries_of_hatches_are_closed_and_exact(document: Any, tmp_path: Path) -> None:
    space = document.modelspace()
    space.add_hatch().paths.add_polyline_path([(0, 0), (10, 0, 1), (10, 10), (0, 10)])
    edges = space.add_hatch().paths.add_edge_path()
    edges.add_arc((50, 0), 5, 0, 180)
    edges.add_line((45, 0), (55, 0))
    space.add_hatch(dxfattribs={"extrusion": (0, 0, -1)}).paths.add_edge_path().add_arc((-90, 0), 2, 0, 360)
    ovals = space.add_hatch().paths.add_edge_path()
    ovals.add_ellipse((150, 0), (9, 0), 0.5, 0, 360)
    polyline, half, circle, oval = (chain.curve for chain in read(document, tmp_path).chains)
    assert all(curve.closed for curve in (polyline, half, circle, oval))
    assert abs(polyline.area_mm2) == pytest.approx(100 + 12.5 * math.pi)
    assert abs(half.area_mm2) == pytest.approx(12.5 * math.pi)
    assert abs(circle.area_mm2) == pytest.approx(4 * math.pi) and circle.box_mm[0] == pytest.approx(88)
    assert abs(oval.area_mm2) == pytest.approx(40.5 * math.pi, rel=1e-3)


def test_a_boundary_that_is_drawn_too_is_read_once_and_an_open_one_is_named(document: Any, tmp_path: Path) -> None:
    space = document.modelspace()
    square = [(0, 0), (10, 0), (10, 10), (0, 10)]
    space.add_lwpolyline(square, close=True)
    space.add_hatch().paths.add_polyline_path(square)
    space.add_hatch().paths.add_edge_path().add_line((0, 0), (10, 0))
    drawing = read(document, tmp_path)
    assert len(drawing.chains) == 1 and not drawing.chains[0].attributes.filled
    assert [(each.kind, each.why) for each in drawing.skipped] == [("HATCH", "its boundary is not closed")]
    assert "1 boundaries of hatches" in drawing.warnings[0]


@pytest.mark.parametrize("style", ["outlines", "strokes"])
@pytest.mark.parametrize("kind", ["add_text", "add_mtext"])
def test_a_letter_that_the_font_lacks_is_left_out_with_a_warning(
    document: Any, tmp_path: Path, style: str, kind: str
) -> None:
    space = document.modelspace()
    getattr(space, kind)("HI", dxfattribs={"style": style, "layer": "whole"})
    getattr(space, kind)("H日I", dxfattribs={"style": style, "layer": "lacking"})
    drawing = read(document, tmp_path)
    counts = [len(layer.curves) for layer in drawing.layers]
    assert counts[0] == counts[1] > 0
    assert [warning for warning in drawing.warnings if "lacks" in warning and "U+65E5" in warning]
