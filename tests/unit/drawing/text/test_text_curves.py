# SPDX-License-Identifier: LGPL-2.1-or-later
"""Text as outlines, judged by matplotlib's TextPath, which has FreeType read the fonts."""

from __future__ import annotations

from pathlib import Path

import matplotlib
import numpy as np
import pytest
from matplotlib.font_manager import FontProperties
from matplotlib.textpath import TextPath

from CNCStepper.drawing.text.font_files import families, find_face
from CNCStepper.drawing.text.text_curves import TextStyle, font_of, line_layout, text_along, text_curves
from CNCStepper.errors import JobError
from CNCStepper.geometry.curve import Curve, circle, straight

FONTS = Path(matplotlib.get_data_path()) / "fonts/ttf"
SANS, SERIF, ROMAN = (FONTS / f"{name}.ttf" for name in ("DejaVuSans", "DejaVuSerif-Italic", "cmr10"))
TOLERANCE_MM, EM_MM = 0.005, 20.0
FREETYPE_MM = EM_MM / 6400.0  # TextPath's grid
FINER = 64.0  # matplotlib flattens curves to some tenths of a unit


def drawn(path: Path, text: str) -> list[Curve]:
    """Return the closed outlines of a text as matplotlib draws it, one em of EM_MM."""
    shape = TextPath((0.0, 0.0), text, size=EM_MM * FINER, prop=FontProperties(fname=str(path)))
    polygons = [polygon / FINER for polygon in shape.to_polygons()]
    return [Curve(polygon, np.zeros(len(polygon) - 1)) for polygon in polygons if len(polygon) > 3]


@pytest.mark.parametrize("path", [SANS, SERIF, ROMAN])
def test_outlines_are_those_of_freetype(path: Path) -> None:
    text = "AVATo: gx&58" if path == ROMAN else "AVATo: gx&58 éñü"
    ours = text_curves(TextStyle(file=path, height_mm=EM_MM, size="em"), text, TOLERANCE_MM)
    theirs = drawn(path, text)
    assert len(ours) == len(theirs) > 14
    area_mm2 = abs(sum(curve.area_mm2 for curve in theirs))
    length_mm = sum(curve.length_mm for curve in theirs)
    assert sum(curve.area_mm2 for curve in ours) == pytest.approx(area_mm2, abs=length_mm * TOLERANCE_MM / 2.0)
    for curve in ours:
        away_mm = min(each.distances_mm(curve.points(0.01)).max() for each in theirs)
        assert away_mm <= TOLERANCE_MM + 3.0 * FREETYPE_MM, curve.box_mm


@pytest.mark.parametrize("pair", ["AV", "To", "VA", "LT"])
def test_kerning_brings_letters_nearer(pair: str) -> None:
    style = TextStyle(file=SANS)
    font = font_of(style)
    placed, width_mm = line_layout(font, style, pair)
    assert placed[1].x_mm < placed[0].advance_mm - 0.1
    assert width_mm == pytest.approx(sum(glyph.advance_mm for glyph in placed) + placed[1].x_mm - placed[0].advance_mm)


def test_capitals_are_as_high_as_asked_and_lines_stand_below_each_other() -> None:
    style = TextStyle(file=SANS, height_mm=5.0, align="center", line_pitch_mm=9.0)
    first, second = text_curves(style, "H\nH", TOLERANCE_MM)
    (left, bottom, right, top), low = first.box_mm, second.box_mm[1]
    assert top - bottom == pytest.approx(5.0, abs=1e-9) and bottom == pytest.approx(0.0, abs=1e-9)
    assert low == pytest.approx(-9.0) and left == pytest.approx(-right, abs=0.1)


def test_overlapping_outlines_become_one_area() -> None:
    crossed = text_curves(TextStyle(file=SANS, height_mm=10.0), "ç", TOLERANCE_MM)
    assert len(crossed) == 1 and crossed[0].area_mm2 > 0.0


def test_holes_run_clockwise() -> None:
    areas = [curve.area_mm2 for curve in text_curves(TextStyle(file=SANS), "B", TOLERANCE_MM)]
    assert sorted(area > 0.0 for area in areas) == [False, False, True]


def test_letters_stand_on_their_curve() -> None:
    style = TextStyle(file=SANS, height_mm=4.0, align="center")
    ring = circle((10.0, 20.0), 30.0).reversed()  # clockwise: letters stand outside
    centre = np.array([10.0, 20.0])
    for curve in text_along(style, "HHHHH", ring, TOLERANCE_MM, ring.length_mm / 2.0):
        away_mm = np.hypot(*(curve.xy - centre).T)
        assert away_mm.min() == pytest.approx(30.0, abs=0.1) and away_mm.max() == pytest.approx(34.0, abs=0.2)
    flat = text_along(style, "HAH", straight((0, 0), (50, 0)), TOLERANCE_MM, 25.0)
    for one, other in zip(flat, text_curves(style, "HAH", TOLERANCE_MM), strict=True):
        assert np.allclose(one.xy, other.moved(25.0, 0.0).xy, atol=1e-9)


@pytest.mark.parametrize(
    ("text", "code"),
    [("日", "text-glyph"), ("\u200b \n", "text-empty"), ("שלום", "text-script"), ("a" * 30_000, "text-long")],
)
def test_what_cannot_be_set_is_named(text: str, code: str) -> None:
    with pytest.raises(JobError) as refusal:
        text_curves(TextStyle(file=FONTS / "cmr10.ttf" if code == "text-glyph" else SANS), text, TOLERANCE_MM)
    assert refusal.value.code == code
    if code == "text-glyph":
        assert "U+65E5" in refusal.value.value


def test_a_text_longer_than_its_curve_is_refused() -> None:
    with pytest.raises(JobError) as refusal:
        text_along(TextStyle(file=SANS), "too long", straight((0, 0), (9, 0)), TOLERANCE_MM)
    assert refusal.value.code == "text-along"


def test_fonts_are_found_by_family_and_style() -> None:
    assert "DejaVu Sans" in families()
    bold = find_face("dejavu sans", "bold oblique")
    assert bold.style == "Bold Oblique" and find_face("DejaVu Sans Bold").style == "Bold"
    assert find_face("sans-serif").family
    with pytest.raises(JobError, match="no font") as refusal:
        find_face("DejaVu Nothing")
    assert "DejaVu Sans" in refusal.value.advice
    with pytest.raises(JobError) as refusal:
        find_face("DejaVu Sans", "fraktur")
    assert refusal.value.code == "font-style"
