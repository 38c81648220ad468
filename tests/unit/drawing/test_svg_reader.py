# SPDX-License-Identifier: LGPL-2.1-or-later
"""SVG drawings: places, units, layers, styles and texts; areas and lengths judged by fonttools' own reader of SVG."""

from __future__ import annotations

import gzip
import math
import time
from pathlib import Path
from xml.etree import ElementTree

import matplotlib
import numpy as np
import pytest
from fontTools.pens.areaPen import AreaPen
from fontTools.pens.perimeterPen import PerimeterPen
from fontTools.svgLib.path import SVGPath

from CNCStepper.drawing.drawing import Drawing
from CNCStepper.drawing.read_drawing import ReadOptions, read_drawing
from CNCStepper.errors import JobError

SIGN = Path("examples/drawings/sign.svg")
IMAGES = Path(matplotlib.get_data_path()) / "images"
HEAD = '<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" '
INKSCAPE = 'xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" '
SHEET = 'width="100mm" height="50mm" viewBox="0 0 100 50" '
BOX = '<rect x="10" y="10" width="20" height="5"/>'
MM_OF_POINT = 25.4 / 72.0


def drawing(tmp_path: Path, body: str, head: str = SHEET, options: ReadOptions | None = None) -> Drawing:
    """Return the drawing of an SVG with that body."""
    path = tmp_path / "drawing.svg"
    path.write_text(f"{HEAD}{head}>{body}</svg>", "utf-8")
    return read_drawing(path, options or ReadOptions())


def boxes(read: Drawing) -> list[list[float]]:
    """Return the boxes of all chains, rounded to a tenth of a micron."""
    return [[round(value, 4) + 0.0 for value in chain.curve.box_mm] for chain in read.chains]


def test_the_sign_has_an_outline_a_pocket_with_its_hole_and_two_letters_at_their_places() -> None:
    read = read_drawing(SIGN, ReadOptions())
    layers = {layer.name: layer.curves for layer in read.layers}
    assert {name: len(curves) for name, curves in layers.items()} == {"outline": 1, "pocket": 2, "letters": 2}
    assert all(chain.curve.closed for chain in read.chains) and not read.warnings and not read.skipped
    assert [chain.attributes.colour for chain in read.chains] == ["#ff0000", "#000000", "#000000", "#0000ff", "#0000ff"]
    (outline,) = layers["outline"]
    assert np.allclose(outline.box_mm, (2.0, 2.0, 158.0, 78.0), atol=1e-9)
    assert abs(outline.area_mm2) == pytest.approx(156.0 * 76.0 - (4.0 - math.pi) * 100.0, abs=1e-6)
    big, hole = sorted(layers["pocket"], key=lambda curve: -abs(curve.area_mm2))
    assert big.distances_mm(_pocket_wall()).max() <= 0.005
    assert hole.distances_mm(_hole_corners()).max() <= 1e-6
    m, e = layers["letters"]
    assert np.allclose(m.box_mm, (76.0, 26.0, 76.0 + 28.0 * 1.4, 26.0 + 26.0 * 1.4), atol=1e-9)
    assert np.allclose(e.box_mm, (76.0 + 34.0 * 1.4, 26.0, 76.0 + 50.0 * 1.4, 26.0 + 26.0 * 1.4), atol=1e-9)


def _placed(points: np.ndarray) -> np.ndarray:
    """Return points of the sign's pocket, complex128[m], where they lie in the sheet."""
    turned = points * np.exp(-1j * math.radians(8.0)) + (20.0 + 40.0j)
    return np.column_stack([turned.real, 80.0 - turned.imag])


def _pocket_wall() -> np.ndarray:
    t = np.linspace(0.0, 1.0, 200)
    rows = ((0 - 18j, 14 - 26j, 34 - 26j, 40 + 0j), (40 + 0j, 34 + 26j, 14 + 26j, 0 + 18j))
    curves = [(1 - t) ** 3 * a + 3 * (1 - t) ** 2 * t * b + 3 * (1 - t) * t**2 * c + t**3 * d for a, b, c, d in rows]
    return _placed(np.concatenate(curves))


def _hole_corners() -> np.ndarray:
    middle = 10.0 + math.sqrt(64.0 - 36.0)
    return _placed(np.array([10 - 6j, 10 + 6j, 22 + 0j, middle - 8.0 if middle > 18 else middle - 8.0 + 0j][:3]))


@pytest.mark.parametrize(
    ("head", "unit_mm"),
    [
        ('width="100mm" height="50mm" viewBox="0 0 100 50"', 1.0),
        ('width="10cm" viewBox="0 0 100 50"', 1.0),
        ('width="2in" height="1in" viewBox="0 0 200 100"', 0.254),
        ('width="72pt" height="36pt" viewBox="0 0 72 36"', MM_OF_POINT),
        ('width="96px" height="48"', 25.4 / 96.0),
        ('viewBox="0 0 100 50"', 25.4 / 96.0),
        ('width="100%" height="100%" viewBox="0 0 100 50"', 25.4 / 96.0),
        ('style="width: 100mm; height: auto" viewBox="0 0 100 50"', 1.0),
        ('width="640" style="width: 100mm" height="320" viewBox="0 0 100 50"', 1.0),
        ('width="100mm" style="width: 640px" height="50mm" viewBox="0 0 100 50"', 1.0),
        (INKSCAPE + 'inkscape:version="0.91 r13725" width="90" height="45"', 25.4 / 90.0),
        (INKSCAPE + 'inkscape:version="1.2.2" width="90" height="45"', 25.4 / 96.0),
        (
            'xmlns:i="http://ns.adobe.com/AdobeIllustrator/10.0/" width="72px" height="36px" viewBox="0 0 72 36"',
            MM_OF_POINT,
        ),
    ],
)
def test_units_are_those_of_the_program_that_wrote_the_file(tmp_path: Path, head: str, unit_mm: float) -> None:
    read = drawing(tmp_path, BOX, head)
    left, low, right, top = read.chains[0].curve.box_mm
    assert right - left == pytest.approx(20.0 * unit_mm) and top - low == pytest.approx(5.0 * unit_mm)
    assert read.unit_mm == pytest.approx(unit_mm)
    assert bool(read.warnings) == ("mm" not in head and "cm" not in head and "2in" not in head and "pt" not in head)


def test_a_unit_from_outside_is_taken_and_zero_stays_at_the_lower_left(tmp_path: Path) -> None:
    read = drawing(tmp_path, BOX, 'width="100" height="50"', ReadOptions(unit_mm=2.0))
    assert boxes(read) == [[20.0, 70.0, 60.0, 80.0]]


@pytest.mark.parametrize(
    ("how", "box"),
    [
        ("none", [10.0, 35.0, 30.0, 40.0]),
        ("xMidYMid meet", [30.0, 35.0, 40.0, 40.0]),
        ("xMinYMax", [5.0, 35.0, 15.0, 40.0]),
        ("xMidYMid slice", [10.0, 45.0, 30.0, 55.0]),
    ],
)
def test_the_aspect_is_kept_as_the_file_says(tmp_path: Path, how: str, box: list[float]) -> None:
    head = f'width="100mm" height="50mm" viewBox="0 0 50 50" preserveAspectRatio="{how}"'
    assert boxes(drawing(tmp_path, '<rect x="5" y="10" width="10" height="5"/>', head)) == [box]


@pytest.mark.parametrize(
    ("body", "box"),
    [
        (f'<g transform="translate(5,-5) scale(2)">{BOX}</g>', [25.0, 25.0, 65.0, 35.0]),
        (f'<svg x="10" y="5" width="50" height="20" viewBox="0 0 100 40">{BOX}</svg>', [15.0, 37.5, 25.0, 40.0]),
        (f'<defs><g id="b">{BOX}</g></defs><use xlink:href="#b" x="3" y="4"/>', [13.0, 31.0, 33.0, 36.0]),
        (
            f'<symbol id="s" viewBox="0 0 40 20">{BOX}</symbol><use href="#s" width="20" height="10"/>',
            [5.0, 42.5, 15.0, 45.0],
        ),
        ('<circle cx="50" cy="25" r="10"/>', [40.0, 15.0, 60.0, 35.0]),
        ('<ellipse cx="50" cy="25" rx="20" ry="10"/>', [30.0, 15.0, 70.0, 35.0]),
        ('<path d="M10,10a5 5 0 0110 0z"/>', [10.0, 40.0, 20.0, 45.0]),
        ('<path d="M10 10h5V5H10zm20 0l5-5l0 5"/>', [10.0, 40.0, 15.0, 45.0]),
        ('<polygon points="1,1 5,1 5,4"/>', [1.0, 46.0, 5.0, 49.0]),
        ('<line x1="10%" y1="0" x2="20%" y2="1cm" stroke="red"/>', [10.0, 12.2047, 20.0, 50.0]),
        (
            f'<switch><foreignObject requiredExtensions="x"/>{BOX}<rect width="1" height="1"/></switch>',
            [10.0, 35.0, 30.0, 40.0],
        ),
        (f"<a>{BOX}</a>", [10.0, 35.0, 30.0, 40.0]),
        (f'<g style="transform:translate(5px, -5px) scaleX(2)">{BOX}</g>', [25.0, 40.0, 65.0, 45.0]),
        (
            f'<style>g {{transform: translateY(-10px)}}</style><g transform="scale(9)">{BOX}</g>',
            [10.0, 45.0, 30.0, 50.0],
        ),
        (f'<g transform="rotate(90)" transform-origin="20 20">{BOX}</g>', [25.0, 20.0, 30.0, 40.0]),
        (f'<g style="transform:rotate(180deg);transform-origin:center">{BOX}</g>', [70.0, 10.0, 90.0, 15.0]),
    ],
)
def test_shapes_stand_where_the_file_has_them(tmp_path: Path, body: str, box: list[float]) -> None:
    assert np.allclose(boxes(drawing(tmp_path, body))[0], box, atol=0.006)


@pytest.mark.parametrize("transform", ["rotate(1turn)", "translate(3mm)", "scale(2", "rotate(5) transform-origin"])
def test_a_transform_that_is_not_known_is_told(tmp_path: Path, transform: str) -> None:
    read = drawing(tmp_path, f'<g transform="{transform}">{BOX}</g>')
    assert boxes(read) == [[10.0, 35.0, 30.0, 40.0]]
    assert read.warnings == ("1 transforms are damaged and not applied",)


def test_circles_stay_arcs_where_they_are_circles(tmp_path: Path) -> None:
    body = '<g transform="rotate(30) scale(-2,2)"><circle cx="-10" cy="5" r="3"/></g>'
    body += '<circle cx="9" cy="9" r="2" transform="scale(2 1)"/>'
    round_one, long_one = (chain.curve for chain in drawing(tmp_path, body).chains)
    assert len(round_one) == 2 and np.allclose(round_one.radii_mm, 6.0)
    t = np.linspace(0.0, math.tau, 300)
    ellipse = np.column_stack([18.0 + 4.0 * np.cos(t), 41.0 + 2.0 * np.sin(t)])
    assert 4 < len(long_one) < 40 and long_one.distances_mm(ellipse).max() <= 0.005


def test_colours_fills_and_classes(tmp_path: Path) -> None:
    body = f"""<style>/* c */ .cut {{stroke: rgb(255, 0,0); fill:none}}
    g.deep rect, #mine {{ stroke:hsl(240,100%,50%) }}</style>
    <g class="cut">{BOX}</g><g class="deep"><rect width="3" height="2" fill="none"/></g>
    <rect width="4" height="2" style="fill:#0f0"/><g color="teal"><rect width="5" height="2" fill="currentColor"/></g>
    <rect width="6" height="2" stroke="none" fill="none"/><rect width="7" height="2" fill="url(#p)"/>
    <rect width="8" height="2" display="none"/><g visibility="hidden"><rect width="9" height="2"/></g>"""
    read = drawing(tmp_path, body)
    found = [(chain.attributes.colour, chain.attributes.filled) for chain in read.chains]
    assert found == [("#ff0000", False), ("#0000ff", False), ("#00ff00", True), ("#008080", True), ("", True)]
    assert [(each.kind, each.why) for each in read.skipped] == [("rect", "it has neither a stroke nor a fill")]


@pytest.mark.parametrize(
    ("paint", "colour"),
    [
        ("rgb(0, 255, 0)", "#00ff00"),
        ("rgba(0, 255, 0, 0.5)", "#00ff00"),
        ("rgb(33.3% 10.5% 0%)", "#551b00"),
        ("rgb(12.6 300 -4 / 50%)", "#0dff00"),
        ("hsl(120, 100%, 50%)", "#00ff00"),
        ("hsla(0.5turn 100% 50% / .5)", "#00ffff"),
        ("hwb(120 0% 0%)", "#00ff00"),
        ("hwb(120deg 20% 40% / 0.5)", "#339933"),
        ("hwb(7 90% 30%)", "#bfbfbf"),
        ("#F0F8", "#ff00ff"),
        ("RebeccaPurple", "#663399"),
        ("#cd853f icc-color(acmecmyk, 0.11, 0.48, 0.83, 0.00)", "#cd853f"),
        ("lab(62% -34 47)", "#123456"),
        ("rgb(1, 2)", "#123456"),
    ],
)
def test_a_paint_that_is_no_colour_leaves_the_one_around_it(tmp_path: Path, paint: str, colour: str) -> None:
    (chain,) = drawing(tmp_path, f'<g fill="#123456"><rect width="3" height="2" fill="{paint}"/></g>').chains
    assert chain.attributes.colour == colour


def test_a_named_colour_stays_a_code_when_the_map_of_names_was_asked_before(tmp_path: Path) -> None:
    from PIL import ImageColor

    ImageColor.getrgb("olive")  # keeps numbers in its map
    (chain,) = drawing(tmp_path, '<rect width="1" height="2" stroke="olive"/>').chains
    assert chain.attributes.colour == "#808000"


def test_rules_of_a_printer_and_of_other_files_are_left_out_and_told(tmp_path: Path) -> None:
    body = f"""<style>@import "house.css"; rect {{fill: lime}} @media print {{ rect {{fill: red}} .a {{fill: red}} }}
    @media screen {{ .b {{fill: blue}} }} @font-face {{font-family: x}}</style>{BOX}
    <rect class="b" width="3" height="2"/>"""
    read = drawing(tmp_path, body)
    assert [chain.attributes.colour for chain in read.chains] == ["#00ff00", "#0000ff"]
    (warning,) = read.warnings
    assert warning.endswith('@import "house.css", @media print, @font-face')


def test_what_is_marked_important_is_the_strongest(tmp_path: Path) -> None:
    body = """<style>rect, path {fill: lime !important} .w {fill: red ! IMPORTANT} #i {fill: blue}</style>
    <rect width="1" height="2" class="w" id="i" style="fill:teal"/>
    <rect width="2" height="2" style="fill:teal !important"/><rect width="3" height="2" fill="red"/>
    <circle r="3" fill="red" style="fill:blue;fill:nonsense"/>"""
    colours = [chain.attributes.colour for chain in drawing(tmp_path, body).chains]
    assert colours == ["#ff0000", "#008080", "#00ff00", "#0000ff"]


@pytest.mark.parametrize(
    ("style", "body", "box"),
    [
        ("", '<rect x="1" width="9" height="5" style="x: 10px; y: 5px; width: 10mm"/>', [10, 40, 47.7953, 45]),
        ("rect {width: 20%; height: 10px}", '<rect width="1" height="1"/>', [0, 40, 20, 50]),
        ("#c {r: 4px; cx: 10px !important}", '<circle id="c" cx="9" cy="10" r="2" style="cx: 3px"/>', [6, 36, 14, 44]),
        ("ellipse {rx: 4px; ry: 2px}", '<ellipse cx="9" cy="10" rx="1" ry="1"/>', [5, 38, 13, 42]),
        ("", """<path d="M0 0h1v1" style='d: path("M0 0h8v8z")'/>""", [0, 42, 8, 50]),
        ("use {x: 20px} g {x: 50px}", '<use href="#r" y="10"/><defs><rect id="r" width="2" height="2"/></defs>',
         [20, 38, 22, 40]),
        ("svg svg {x: 30px}", '<svg x="1" width="9" height="9"><rect width="2" height="2"/></svg>', [30, 48, 32, 50]),
        ("use {width: 20px; height: 10px}", '<use href="#s" width="5" height="5"/>'
         '<symbol id="s" viewBox="0 0 4 2" style="width: 3px"><rect width="4" height="2"/></symbol>', [0, 40, 20, 50]),
        ("rect {width: 20; height: auto}", '<rect width="3" height="4"/>', [0, 46, 3, 50]),
        ("g {width: 50px}", '<g><rect width="3" height="4"/></g>', [0, 46, 3, 50]),
    ],
)  # fmt: skip
def test_places_and_sizes_in_styles_are_stronger_than_attributes(
    tmp_path: Path, style: str, body: str, box: list[float]
) -> None:
    (found,) = boxes(drawing(tmp_path, f"<style>{style}</style>{body}"))
    assert found == pytest.approx(box, abs=0.005)  # the tolerance of an ellipse


def test_a_path_that_styles_take_away_is_not_drawn(tmp_path: Path) -> None:
    body = """<style>.off {d: none}</style><path class="off" d="M0 0h9v9z"/><path d="M0 0h2v2z" style="d: M0 0h9"/>"""
    assert boxes(drawing(tmp_path, body)) == [[0, 48, 2, 50]]


def test_of_several_languages_one_is_read_and_told(tmp_path: Path) -> None:
    body = """<switch><title/><rect systemLanguage="it" width="1" height="2"/>
    <rect systemLanguage="de, en-US" width="2" height="2"/><rect width="3" height="2"/></switch>
    <rect systemLanguage="it" width="4" height="2"/><foreignObject width="4" height="2"/>"""
    read = drawing(tmp_path, body)
    assert boxes(read) == [[0.0, 48.0, 2.0, 50.0]]
    assert [(each.kind, each.why) for each in read.skipped] == [
        ("rect", "it is of another language than English"),
        ("foreignObject", "it is drawn by programs with extensions alone"),
    ]
    assert read.warnings == ("2 elements are for one language: those in English, or in none, are read",)


@pytest.mark.parametrize("style", ["writing-mode:tb", "writing-mode:vertical-rl", "baseline-shift:super"])
def test_texts_off_a_straight_line_are_told(tmp_path: Path, style: str) -> None:
    read = drawing(tmp_path, f'<text y="20"><tspan style="{style}">i</tspan></text>')
    assert "1 texts are written downwards, raised or lowered: they are set on a straight line" in read.warnings


def test_layers_names_and_groups(tmp_path: Path) -> None:
    body = f"""<g inkscape:groupmode="layer" inkscape:label="Corte" id="layer1">
    <g id="inner" inkscape:label="Peça">{BOX}
    <rect id="own" width="3" height="2"/></g></g><g id="outer"><g id="nested">{BOX}</g></g>{BOX}"""
    found = [chain.attributes for chain in drawing(tmp_path, body, SHEET + INKSCAPE).chains]
    assert [each.layer for each in found] == ["Corte", "Corte", "outer", ""]
    assert [each.name for each in found] == ["Peça", "own", "nested", ""]
    assert [each.groups for each in found] == [("Corte", "Peça"), ("Corte", "Peça"), ("outer", "nested"), ()]


def test_lines_that_meet_become_one_chain_and_filled_ones_close(tmp_path: Path) -> None:
    body = """<g stroke="red" fill="none"><path d="M0 0H10"/><path d="M10 10V0"/><path d="M10 10H0V0"/></g>
    <path d="M20 20h5v5"/>"""
    read = drawing(tmp_path, body)
    assert [chain.curve.closed for chain in read.chains] == [True, True] and not read.gaps


def test_what_is_read_otherwise_is_told(tmp_path: Path) -> None:
    body = f"""<clipPath id="c">{BOX}</clipPath><g clip-path="url(#c)">{BOX}</g>
    <line x2="9" stroke="red" stroke-dasharray="1 2"/>
    <path d="M0 0L9 9 5 x"/><image id="photo" width="9" height="9" xlink:href="http://example.org/p.png"/>
    <text y="20" font-family="No Such Font">a</text><rect transform="turn(3)" width="5" height="2"/>"""
    read = drawing(tmp_path, body)
    words = " ".join(map(str, read.warnings))
    for word in ("clip paths", "dashed", "damaged and read up to", "No Such Font", "transforms"):
        assert word in words, word
    assert [(each.kind, each.handle) for each in read.skipped] == [("image", "photo")]


def test_texts_are_outlines_on_their_base_line(tmp_path: Path) -> None:
    body = """<g font-family="DejaVu Sans" font-size="10">
    <text x="50" y="30" text-anchor="middle">H<tspan dy="-5" fill="red">H</tspan></text>
    <path id="way" d="M0 40H100" fill="none"/>
    <text><textPath xlink:href="#way" startOffset="10">HI</textPath></text></g>"""
    one, two, three, four = (chain for chain in drawing(tmp_path, body).chains)
    height_mm = one.curve.box_mm[3] - one.curve.box_mm[1]
    assert height_mm == pytest.approx(7.29, abs=0.02) and one.curve.box_mm[1] == pytest.approx(20.0, abs=1e-6)
    assert two.curve.box_mm[1] == pytest.approx(25.0, abs=1e-6) and one.curve.box_mm[0] < 50.0 < two.curve.box_mm[2]
    assert (one.curve.box_mm[0] + two.curve.box_mm[2]) / 2.0 == pytest.approx(50.0, abs=0.05)
    assert three.curve.box_mm[1] == pytest.approx(10.0, abs=1e-6) and three.curve.box_mm[0] == pytest.approx(
        10.98, abs=0.05
    )
    assert four.curve.box_mm[0] > three.curve.box_mm[2]


def test_each_letter_stands_and_turns_as_the_file_says(tmp_path: Path) -> None:
    body = """<g font-family="DejaVu Sans" font-size="10"><text x="10 30" y="20 30" rotate="0 90">HHH</text>
    <text x="50 70" y="40">H<tspan x="60">H</tspan></text></g>"""
    first, second, third, fourth, fifth = boxes(drawing(tmp_path, body))
    width, height = first[2] - first[0], first[3] - first[1]
    assert first[:2] == pytest.approx([10.98, 30.0], abs=0.05) and height > 1.2 * width
    for turned in (second, third):  # the last turn goes on; a letter that is turned to the right hangs from its place
        assert turned[2] - turned[0] == pytest.approx(height, abs=1e-3)
        assert turned[3] - turned[1] == pytest.approx(width, abs=1e-3)
    assert second[0] == pytest.approx(30.0, abs=1e-3) and second[3] == pytest.approx(20.0 - 0.98, abs=0.05)
    assert fourth[0] == pytest.approx(50.98, abs=0.05) and fifth[0] == pytest.approx(60.98, abs=0.05)


@pytest.mark.parametrize(("adjust", "stretched"), [("spacing", False), ("spacingAndGlyphs", True)])
def test_a_text_is_brought_to_its_length(tmp_path: Path, adjust: str, stretched: bool) -> None:
    body = f"""<g font-family="DejaVu Sans" font-size="10"><text x="5" y="20">HHH</text>
    <text x="5" y="40" textLength="60" lengthAdjust="{adjust}">HHH</text></g>"""
    found = boxes(drawing(tmp_path, body))
    natural, fitted = found[:3], found[3:]
    side_mm = natural[0][0] - 5.0
    factor = (fitted[0][2] - fitted[0][0]) / (natural[0][2] - natural[0][0])
    assert fitted[2][2] == pytest.approx(65.0 - side_mm * (factor if stretched else 1.0), abs=0.01)
    assert (factor > 2.0) == stretched and factor >= 1.0 - 1e-6


def test_sizes_are_relative_to_those_around(tmp_path: Path) -> None:
    body = """<g font-family="DejaVu Sans" font-size="10"><g font-size="2em"><text y="40" font-size="50%">H</text></g>
    <text y="40" style="font: italic bold 20px/1.2 'DejaVu Sans', serif">H</text></g>"""
    read = drawing(tmp_path, body)
    heights = [box[3] - box[1] for box in boxes(read)]
    assert heights == pytest.approx([7.29, 14.58], abs=0.02) and not read.warnings


def test_a_letter_that_the_font_lacks_is_told_and_the_others_are_read(tmp_path: Path) -> None:
    body = """<text y="20" font-family="DejaVu Sans">H\U00012345H</text>
    <line x2="9" stroke="red" marker-end="url(#m)"/><path id="w" d="M0 9H9" fill="none"/>
    <text font-size="5"><textPath href="#w">HHHHHH</textPath></text>"""
    read = drawing(tmp_path, body)
    words = " ".join(map(str, read.warnings))
    assert "U+12345" in words and "markers" in words and "longer than their path" in words
    assert len(read.chains) == 2 + 1 + 2


def test_packed_files_are_read(tmp_path: Path) -> None:
    path = tmp_path / "sign.svgz"
    path.write_bytes(gzip.compress(SIGN.read_bytes()))
    assert read_drawing(path, ReadOptions()).layers == read_drawing(SIGN, ReadOptions()).layers


def _visible(path: Path) -> bytes:
    """Return an icon without its definitions and its invisible frame."""
    tree = ElementTree.parse(path)
    for parent in tree.getroot().iter():
        for child in list(parent):
            paint = child.get("style", "") + ";fill:" + child.get("fill", "")
            if child.tag.endswith("}defs") or ("fill:none" in paint.replace(" ", "") and "stroke" not in paint):
                parent.remove(child)
    return ElementTree.tostring(tree.getroot())


@pytest.mark.parametrize(
    "path",
    [path for path in sorted(IMAGES.glob("*.svg")) if "<use" not in path.read_text("utf-8")],
    ids=lambda p: p.stem,
)
def test_areas_and_lengths_are_those_of_fonttools(path: Path) -> None:
    read = read_drawing(path, ReadOptions(tolerance_mm=0.001, same_mm=1e-9))
    scale = read.unit_mm
    area, perimeter = AreaPen(), PerimeterPen(tolerance=1e-4)
    for pen in (area, perimeter):
        SVGPath.fromstring(_visible(path)).draw(pen)
    length_mm = sum(chain.curve.length_mm for chain in read.chains)
    assert length_mm == pytest.approx(perimeter.value * scale, rel=1e-3)
    assert sum(chain.curve.area_mm2 for chain in read.chains if chain.curve.closed) == pytest.approx(
        -area.value * scale**2, abs=0.001 * length_mm
    )


def test_an_empty_drawing_is_refused_with_what_it_holds(tmp_path: Path) -> None:
    with pytest.raises(JobError) as refusal:
        drawing(tmp_path, '<image id="a" width="9" height="9"/>')
    assert refusal.value.code == "svg-empty" and "picture" in str(refusal.value.value)


def test_rules_select_by_attributes_and_unknown_selectors_are_told(tmp_path: Path) -> None:
    body = """<style>rect {fill:none} [id^=cut] {stroke:red} rect[id="b"], rect:hover {stroke:#00f}
    rect[class~=two], rect[data-x] {stroke:lime} rect:empty {display:none}</style>
    <rect id="cut1" width="5" height="5"/><rect id="b" x="10" width="5" height="5"/>
    <rect class="one two" x="20" width="5" height="5"/><rect id="c" x="30" width="5" height="5" stroke="black"/>"""
    read = drawing(tmp_path, body)
    assert [chain.attributes.colour for chain in read.chains] == ["#ff0000", "#0000ff", "#00ff00", "#000000"]
    assert read.warnings == ("1 rules of style are not applied, because of their selectors: rect:empty",)


SELECTED = [  # a selector, and which of the rectangles below it selects
    ("#g > rect", "abcd"),
    ("svg > rect", "fh"),
    ("svg rect", "abcdefh"),
    ("g > g rect", "e"),
    ("g rect:first-child", "ae"),
    ("rect:last-child", "eh"),
    ("rect:only-child", "e"),
    ("rect:nth-child(2n+1)", "acefh"),
    ("rect:nth-child(even)", "bd"),
    ("rect:nth-child(-n + 2)", "abe"),
    ("rect:nth-last-child(1)", "eh"),
    ("rect:nth-of-type(2)", "bh"),
    ("rect:first-of-type", "aef"),
    ("rect:last-of-type", "deh"),
    ("g circle ~ rect, rect#b + rect", "c"),
    ("rect ~ rect", "bcdh"),
    ("rect + rect", "bcd"),
    ("g + rect", "f"),
    ("#g ~ rect", "fh"),
    ("#f ~ circle + rect", "h"),
    ("rect:not(.x):not(#a)", "cdefh"),
    (":is(#a, .x, [data-n='h, i'])", "abh"),
    ("#g > :where(#a, .x)", "ab"),
    ("rect[data-n$=i], rect[data-n='two words']", "ch"),
    ("rect[inkscape|label=d]", "d"),
    ("svg|rect.x", "b"),
    (":root > rect:nth-child( 3 )", "f"),
    ("g > g > g rect", ""),
]


@pytest.mark.parametrize(("selector", "selected"), SELECTED)
def test_rules_select_by_the_places_of_elements(tmp_path: Path, selector: str, selected: str) -> None:
    rows = {name: f'<rect id="{name}" width="5" height="5" x="{9 * x}"' for x, name in enumerate("abcdefh")}
    body = f"""<style>rect {{stroke:red; fill:none}} {selector} {{stroke:lime !important}}</style>
    <g id="g" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape">{rows["a"]}/>{rows["b"]} class="x y"/>
    {rows["c"]} data-n="two words"/>{rows["d"]} inkscape:label="d"/><g>{rows["e"]}/></g></g>
    {rows["f"]}/><circle r="0"/>{rows["h"]} data-n="h, i"/>"""
    read = drawing(tmp_path, body)
    assert "".join(chain.attributes.name for chain in read.chains if chain.attributes.colour == "#00ff00") == selected
    assert len(read.chains) == 7 and not read.warnings


def test_the_strength_of_a_selector_counts_what_is_in_its_brackets(tmp_path: Path) -> None:
    body = """<style>rect:not(#z) {stroke:red} g rect.x {stroke:lime} g > rect {stroke:blue} :where(#a, #b) {fill:red}
    rect {fill:none}</style>
    <g><rect id="a" class="x" width="5" height="5"/><rect id="b" x="9" width="5" height="5"/></g>"""
    assert {chain.attributes.colour for chain in drawing(tmp_path, body).chains} == {"#ff0000"}
    assert not any(chain.attributes.filled for chain in drawing(tmp_path, body).chains)


def test_ten_thousand_elements_behind_each_other_are_selected_in_bounded_time(tmp_path: Path) -> None:
    rows = "".join(f'<path d="M{3 * x} 0v5"/>' for x in range(10_000))
    began_s = time.process_time()
    read = drawing(tmp_path, f"<style>path {{stroke:red}} g ~ path, path ~ path {{stroke:lime}}</style>{rows}")
    assert time.process_time() - began_s < 5.0
    assert sum(chain.attributes.colour == "#00ff00" for chain in read.chains) == 9_999


@pytest.mark.parametrize(
    "selector",
    ["rect:nth-child(n of .x)", "rect:has(g)", "rect >", "> rect", "rect:nth-child(99999999999999999999)", "["],
)
def test_a_selector_that_is_not_known_is_told(tmp_path: Path, selector: str) -> None:
    read = drawing(tmp_path, f'<style>{selector} {{display:none}}</style><rect width="5" height="5"/>')
    assert len(read.chains) == 1 and read.warnings[0].startswith("1 rules of style are not applied")
