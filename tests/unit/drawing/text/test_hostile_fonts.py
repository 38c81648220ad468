# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hostile and rare fonts: refused by name, or set, in bounded time and memory; both tables of kerning, by hand."""

from __future__ import annotations

import random
import struct
import time
import tracemalloc
from collections.abc import Callable
from pathlib import Path
from typing import Any

import matplotlib
import pytest
from fontTools.fontBuilder import FontBuilder
from fontTools.pens.t2CharStringPen import T2CharStringPen
from fontTools.pens.ttGlyphPen import TTGlyphPen
from fontTools.ttLib import TTCollection, TTFont

from CNCStepper.drawing.text.font import open_font
from CNCStepper.drawing.text.text_curves import TextStyle, line_layout, text_curves
from CNCStepper.errors import JobError

SANS = Path(matplotlib.get_data_path()) / "fonts/ttf/DejaVuSans.ttf"
LONGEST_S, MOST_BYTES = 10.0, 300_000_000
UNITS, WIDE = 1000, 700
SEEDS = range(1, 61)


def built(folder: Path, two: bool = False, cubic: bool = False) -> Path:
    """Write a font of the letters H and V, outlines of squares and triangles; return its path."""
    builder = FontBuilder(UNITS, isTTF=not cubic)
    names = [".notdef", "H", "V"]
    builder.setupGlyphOrder(names)
    builder.setupCharacterMap({ord("H"): "H", ord("V"): "V"})
    if cubic:
        programs = {name: _drawn(T2CharStringPen(WIDE, None), name).getCharString() for name in names}
        if two:
            builder.setupCFF2(programs)
        else:
            builder.setupCFF("Made", {}, programs, {})
    else:
        builder.setupGlyf({name: _drawn(TTGlyphPen(None), name).glyph() for name in names})
    builder.setupHorizontalMetrics(dict.fromkeys(names, (WIDE, 50)))
    builder.setupHorizontalHeader(ascent=800, descent=-200)
    builder.setupNameTable({"familyName": "Made", "styleName": "Regular"})
    builder.setupOS2(sCapHeight=700)
    builder.setupPost()
    path = folder / ("made.otf" if cubic else "made.ttf")
    builder.save(path)
    return path


def _drawn(pen: Any, name: str) -> Any:
    corners = [(50, 0), (50, 700), (650, 700), (650, 0)] if name == "H" else [(350, 0), (50, 700), (650, 700)]
    pen.moveTo(corners[0])
    for corner in corners[1:]:
        pen.lineTo(corner)
    pen.closePath()
    return pen


def area_mm2(path: Path, text: str) -> float:
    """Return the area of a text of capitals 7 mm high: a unit of the made font is 0.01 mm."""
    return sum(curve.area_mm2 for curve in text_curves(TextStyle(file=path, height_mm=7.0), text, 0.005))


def bounded(call: Callable[[], object]) -> None:
    """Call it; fail where it takes longer, or more memory, than anything may."""
    tracemalloc.start()
    begun_s = time.process_time()
    try:
        call()
    finally:
        spent_s, (_, peak) = time.process_time() - begun_s, tracemalloc.get_traced_memory()
        tracemalloc.stop()
        assert spent_s < LONGEST_S and peak < MOST_BYTES, (spent_s, peak)


@pytest.mark.parametrize(("cubic", "two"), [(False, False), (True, False), (True, True)])
def test_outlines_of_each_kind_are_set(tmp_path: Path, cubic: bool, two: bool) -> None:
    path = built(tmp_path, two, cubic)
    assert area_mm2(path, "H") == pytest.approx(6.0 * 7.0) and area_mm2(path, "V") == pytest.approx(3.0 * 7.0)


def test_a_variable_font_is_set_at_its_default(tmp_path: Path) -> None:
    path = built(tmp_path)
    font = TTFont(path)
    builder = FontBuilder(font=font)
    builder.setupFvar([("wght", 100, 400, 900, "Weight")], [])
    from fontTools.ttLib.tables.TupleVariation import TupleVariation

    wider = [(0, 0), (0, 0), (300, 0), (300, 0), (0, 0), (300, 0), (0, 0), (0, 0)]
    builder.setupGvar({"H": [TupleVariation({"wght": (0.0, 1.0, 1.0)}, wider)], "V": []})
    font.save(path)
    assert area_mm2(path, "H") == pytest.approx(6.0 * 7.0)


def test_each_face_of_a_collection_is_set(tmp_path: Path) -> None:
    collection = TTCollection()
    collection.fonts = [TTFont(built(tmp_path)), TTFont(SANS)]
    path = tmp_path / "both.ttc"
    collection.save(path)
    assert area_mm2(path, "H") == pytest.approx(42.0)
    assert open_font(path, 1).glyph("ç") is not None and open_font(path, 0).glyph("ç") is None
    with pytest.raises(JobError, match="no face 2"):
        open_font(path, 2)


def kern_table(pairs: dict[tuple[int, int], int], count: int | None = None) -> bytes:
    """Return a `kern` of format 0; `count` is the number of pairs that it pretends to have."""
    rows = b"".join(struct.pack(">HHh", *pair, value) for pair, value in sorted(pairs.items()))
    head = struct.pack(">HHHHHHHH", 0, 1, 0, 14 + len(rows), 1, len(pairs) if count is None else count, 0, 0)
    return head + struct.pack(">H", 0) + rows


@pytest.mark.parametrize("count", [None, 65_535])
def test_the_older_table_of_kerning_moves_letters_together(tmp_path: Path, count: int | None) -> None:
    path = built(tmp_path)
    font = TTFont(path)
    table = font["kern"] = _raw("kern", kern_table({(1, 2): -100, (2, 1): 50}, count))
    assert table.data
    font.save(path)
    style = TextStyle(file=path, height_mm=7.0)
    if count is None:
        assert [line_layout(open_font(path), style, text)[1] for text in ("HV", "VH", "HH")] == pytest.approx(
            [13.0, 14.5, 14.0]
        )
    else:
        bounded(lambda: _refused_or_set(path, "HV"))


def test_pairs_of_gpos_move_letters_together(tmp_path: Path) -> None:
    from fontTools.feaLib.builder import addOpenTypeFeaturesFromString

    path = built(tmp_path)
    font = TTFont(path)
    addOpenTypeFeaturesFromString(font, "@v = [V]; feature kern { pos H V -120; pos @v @v 40; } kern;")
    font.save(path)
    style = TextStyle(file=path, height_mm=7.0)
    assert line_layout(open_font(path), style, "HV")[1] == pytest.approx(12.8)
    assert line_layout(open_font(path), style, "VV")[1] == pytest.approx(14.4)


def _raw(tag: str, data: bytes) -> Any:
    from fontTools.ttLib.tables.DefaultTable import DefaultTable

    table = DefaultTable(tag)
    table.data = data
    return table


def _refused_or_set(path: Path, text: str) -> None:
    """Set a text, or see that the refusal names the font."""
    try:
        text_curves(TextStyle(file=path, height_mm=7.0), text, 0.005)
    except JobError as error:
        assert error.code in ("font-damaged", "font-file", "text-glyph", "text-empty", "fit-large"), error.code
        assert error.advice


@pytest.mark.parametrize("loop", ["itself", "each other", "ten of ten of ten"])
def test_composite_glyphs_that_hold_themselves_are_refused(tmp_path: Path, loop: str) -> None:
    path = built(tmp_path)
    font = TTFont(path)
    inner = {"itself": ("H", 1), "each other": ("V", 1), "ten of ten of ten": ("V", 10)}[loop]
    table = font["glyf"]
    table["H"] = _composite(*inner)
    if loop != "itself":
        table["V"] = _composite("H", inner[1])
    data = {name: table[name].compile(table, recalcBBoxes=False) for name in table.keys()}  # noqa: SIM118
    glyphs = [data[name] + b"\0" * (len(data[name]) % 2) for name in font.getGlyphOrder()]
    places = [sum(map(len, glyphs[:number])) for number in range(len(glyphs) + 1)]
    long = bool(font["head"].indexToLocFormat)
    form = f">{len(places)}" + ("L" if long else "H")
    raw = {"glyf": b"".join(glyphs), "loca": struct.pack(form, *(place if long else place // 2 for place in places))}
    _with_tables(path, raw)
    bounded(lambda: _assert_refused(path, "H", "too many parts"))


def _composite(name: str, count: int) -> Any:
    from fontTools.ttLib.tables._g_l_y_f import Glyph, GlyphComponent

    glyph = Glyph()
    glyph.numberOfContours = -1
    glyph.xMin = glyph.yMin = glyph.xMax = glyph.yMax = 0
    glyph.components = []
    for number in range(count):
        part = GlyphComponent()
        part.glyphName, part.x, part.y, part.flags = name, number, 0, 0x2
        glyph.components.append(part)
    return glyph


def _with_tables(path: Path, raw: dict[str, bytes]) -> None:
    """Put bytes in the place of tables of a font file, without a look at them."""
    content = path.read_bytes()
    count = struct.unpack_from(">H", content, 4)[0]
    tables = {}
    for row in range(count):
        tag, _, at, length = struct.unpack_from(">4sLLL", content, 12 + 16 * row)
        tables[tag.decode()] = content[at : at + length]
    tables |= raw
    head, body = content[:4] + struct.pack(">HHHH", len(tables), 0, 0, 0), b""
    begin = 12 + 16 * len(tables)
    for tag, data in sorted(tables.items()):
        head += struct.pack(">4sLLL", tag.encode(), 0, begin + len(body), len(data))
        body += data + b"\0" * (-len(data) % 4)
    path.write_bytes(head + body)


def _assert_refused(path: Path, text: str, why: str) -> None:
    with pytest.raises(JobError) as refusal:
        text_curves(TextStyle(file=path), text, 0.005)
    assert refusal.value.code == "font-damaged" and why in refusal.value.what and refusal.value.place is not None


@pytest.mark.parametrize("share", [0.0, 0.001, 0.01, 0.1, 0.5, 0.9, 0.999])
def test_truncated_fonts_are_refused_or_set(tmp_path: Path, share: float) -> None:
    content = SANS.read_bytes()
    path = tmp_path / "short.ttf"
    path.write_bytes(content[: int(share * len(content))])
    bounded(lambda: _refused_or_set(path, "Ação"))


@pytest.mark.parametrize("tag", ["maxp", "hhea", "cmap", "loca", "head"])
def test_huge_counts_are_refused_or_set(tmp_path: Path, tag: str) -> None:
    path = built(tmp_path)
    content = bytearray(TTFont(path).reader[tag])
    content[4:] = b"\xff" * (len(content) - 4)
    _with_tables(path, {tag: bytes(content)})
    bounded(lambda: _refused_or_set(path, "HV"))


@pytest.mark.parametrize("kind", ["glyf", "CFF", "CFF2"])
def test_mutated_fonts_are_refused_or_set(tmp_path: Path, kind: str) -> None:
    made = built(tmp_path, kind == "CFF2", kind != "glyf").read_bytes()
    set_ones = 0
    for seed in SEEDS:
        chance = random.Random(f"{kind} {seed}")
        content = bytearray(made)
        for _ in range(chance.randint(1, 12)):
            content[chance.randrange(len(content))] = chance.choice((0, 1, 0x7F, 0x80, 0xFF, chance.randrange(256)))
        path = tmp_path / f"{kind}-{seed}.ttf"
        path.write_bytes(content)
        begun_s = time.process_time()
        try:
            set_ones += bool(text_curves(TextStyle(file=path, height_mm=7.0), "HV", 0.005))
        except JobError as error:
            assert error.what, seed
        assert time.process_time() - begun_s < LONGEST_S, seed
    assert 0 < set_ones < len(SEEDS)  # some are set, some are refused
