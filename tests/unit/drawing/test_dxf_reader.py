# SPDX-License-Identifier: LGPL-2.1-or-later
"""DXF drawings as curves: judged by ezdxf's own flattening, on drawings made here and on some that others drew.

Splines are judged by the definition of a B-spline: ezdxf draws one that is closed by unclamped knots beyond its ends.
"""

from __future__ import annotations

import math
from collections import Counter
from dataclasses import replace
from pathlib import Path
from typing import Any

import ezdxf
import numpy as np
import pytest
import shapely

from CNCStepper.drawing.drawing import Drawing
from CNCStepper.drawing.dxf.reader import read_dxf
from CNCStepper.errors import JobError

DATA = Path(__file__).parents[2] / "data" / "dxf"
CASES = 25
TOLERANCE_MM = 0.01
FINE_MM = 2e-4  # of the judge
PLACES = 1500  # at which it measures
BELOW = {"extrusion": (0, 0, -1)}


def new_document(unit: int = 4) -> Any:
    document = ezdxf.new("R2010")
    document.units = unit
    return document


def read(document: Any, folder: Path, tolerance_mm: float = TOLERANCE_MM, **options: Any) -> Drawing:
    path = folder / "peça nº 1.dxf"
    document.saveas(path)
    return read_dxf(path, tolerance_mm, **options)


def add_random(space: Any, rng: np.random.Generator, layer: str) -> str:
    """Add one random entity to a model space or block; return which kind it is."""
    x, y = rng.uniform(-50, 50, 2)
    attributes = {"layer": layer} | (BELOW if rng.random() < 0.3 else {})
    level = {"layer": layer}
    points = rng.uniform(-20, 20, (int(rng.integers(4, 9)), 2)) + np.array([x, y])
    bulges = np.where(rng.random(len(points)) < 0.5, 0.0, rng.uniform(-2, 2, len(points)))
    closed, first, sweep = bool(rng.random() < 0.5), rng.uniform(0, 360), rng.uniform(0.5, 359.5)
    kind = str(
        rng.choice(["line", "arc", "tiny arc", "circle", "light", "old", "ellipse", "part", "spline", "rational"])
    )
    if kind == "line":
        space.add_line(points[0], points[1], level)
    elif kind in ("arc", "tiny arc"):
        space.add_arc(
            (x, y), 0.01 if kind == "tiny arc" else rng.uniform(1, 30), first, first + sweep, dxfattribs=attributes
        )
    elif kind == "circle":
        space.add_circle((x, y), rng.uniform(0.1, 30), attributes)
    elif kind == "light":
        space.add_lwpolyline(np.column_stack([points, bulges]), "xyb", close=closed, dxfattribs=attributes)
    elif kind == "old":
        space.add_polyline2d(np.column_stack([points, bulges]), "xyb", close=closed, dxfattribs=attributes)
    elif kind in ("ellipse", "part"):
        turn, ratio = rng.uniform(0, math.tau), float(rng.choice([1.0, rng.uniform(0.02, 1.0)]))
        major = (rng.uniform(1, 30) * math.cos(turn), rng.uniform(1, 30) * math.sin(turn))
        ends = (0, math.tau) if kind == "ellipse" else (math.radians(first), math.radians(first + sweep))
        space.add_ellipse((x, y), major, ratio, *ends, attributes)
    elif kind == "spline":
        spline = space.add_spline(dxfattribs=level)
        (spline.set_closed if closed else spline.set_open_uniform)(np.column_stack([points, np.zeros(len(points))]), 3)
    else:
        space.add_spline(dxfattribs=level).set_open_rational(
            np.column_stack([points, np.zeros(len(points))]), rng.uniform(0.3, 3, len(points)), 3
        )
    return kind


def truth(entity: Any) -> list[np.ndarray]:
    """Return what ezdxf makes of an entity, as fine lines."""
    if entity.dxftype() in ("LWPOLYLINE", "POLYLINE"):
        return [line for part in entity.virtual_entities() for line in truth(part)]
    if entity.dxftype() == "LINE":
        return [np.array([tuple(entity.dxf.start)[:2], tuple(entity.dxf.end)[:2]])]
    if entity.dxftype() == "ARC" and entity.dxf.radius * math.tau < 1e-6:
        return []
    if entity.dxftype() == "SPLINE":
        return [drawn_spline(entity)]
    return [np.array([tuple(place)[:2] for place in entity.flattening(FINE_MM)])]


def drawn_spline(entity: Any) -> np.ndarray:
    """Return points of a spline by the recursion of Cox and de Boor, between the knots where its bases sum to 1."""
    knots, poles = np.array(entity.knots), np.array([tuple(point)[:2] for point in entity.control_points])
    degree, weights = entity.dxf.degree, np.array(entity.weights if len(entity.weights) else np.ones(len(poles)))
    t = np.linspace(knots[degree], knots[len(poles)] * (1 - 1e-9), 4001)[:, None]
    bases = ((knots[:-1] <= t) & (t < knots[1:])).astype(float)
    for order in range(1, degree + 1):
        span = np.where(knots[order:] > knots[:-order], knots[order:] - knots[:-order], np.inf)
        rising, falling = (t - knots[:-order]) / span, (knots[order:] - t) / span
        bases = bases[:, :-1] * rising[:, :-1] + bases[:, 1:] * falling[:, 1:]
    return (bases * weights) @ poles / (bases @ weights)[:, None]


def far_apart_mm(drawing: Drawing, lines: list[np.ndarray]) -> float:
    """Return how far the curves that were read and ezdxf's lines leave each other, both ways."""
    drawn = shapely.MultiLineString([line for line in lines if len(line) > 1 and np.ptp(line, axis=0).any()])
    read_lines = [curve.points(FINE_MM) for layer in drawing.layers for curve in layer.curves]
    fitted = shapely.MultiLineString(read_lines)
    shapely.prepare([drawn, fitted])
    there, here = shapely.get_coordinates(shapely.segmentize(drawn, 1.0)), np.vstack(read_lines)
    away = shapely.distance(fitted, shapely.points(there[:: len(there) // PLACES + 1])).max()
    return float(max(away, shapely.distance(drawn, shapely.points(here[:: len(here) // PLACES + 1])).max()))


@pytest.mark.slow
def test_random_drawings_are_where_ezdxf_draws_them(tmp_path: Path) -> None:
    seen: Counter[str] = Counter()
    for seed in range(CASES):
        rng, document = np.random.default_rng(seed), new_document()
        seen.update(add_random(document.modelspace(), rng, f"layer {rng.integers(3)}") for _ in range(8))
        drawing = read(document, tmp_path)
        layers = {entity.dxf.layer for entity in document.modelspace()}
        assert {layer.name for layer in drawing.layers} == layers and not drawing.skipped, f"seed {seed}"
        lines = [line for entity in document.modelspace() for line in truth(entity)]
        assert far_apart_mm(drawing, lines) <= TOLERANCE_MM + 2 * FINE_MM, f"seed {seed}"
    assert len(seen) == 10 and min(seen.values()) >= CASES // 5, f"seeds 0 to {CASES - 1}: {seen}"


def test_blocks_lie_where_ezdxf_puts_them(tmp_path: Path) -> None:
    uneven = 0
    for seed in range(10):
        rng, document = np.random.default_rng(seed), new_document()
        block = document.blocks.new("inner")
        for _ in range(4):
            add_random(block, rng, "0")
        scale = rng.uniform(0.3, 2) * np.array([rng.choice([-1, 1]), 1.0 if rng.random() < 0.5 else 1.5])
        uneven += abs(scale[0]) != scale[1]
        outer = document.blocks.new("outer")
        turned = {"xscale": scale[0], "yscale": scale[1], "rotation": rng.uniform(0, 360), "layer": "0"}
        outer.add_blockref("inner", (3, 4), turned)
        document.modelspace().add_blockref("outer", (100, 0), {"layer": "cut", "rotation": 30})
        drawing = read(document, tmp_path)
        assert [layer.name for layer in drawing.layers] == ["cut"], f"seed {seed}"
        (insert,) = document.modelspace()
        (inner,) = insert.virtual_entities()
        lines = [line for entity in inner.virtual_entities() for line in truth(entity)]
        assert far_apart_mm(drawing, lines) <= TOLERANCE_MM + 2 * FINE_MM, f"seed {seed}"
    assert 0 < uneven < 10


def test_rows_of_a_block_and_a_block_that_holds_itself(tmp_path: Path) -> None:
    document = new_document()
    document.blocks.new("hole").add_circle((0, 0), 2)
    rows = {"row_count": 2, "column_count": 3, "row_spacing": 10, "column_spacing": 20}
    document.modelspace().add_blockref("hole", (0, 0), rows)
    itself = document.blocks.new("itself")
    itself.add_circle((0, 50), 1)
    itself.add_blockref("itself", (1, 0))
    document.modelspace().add_blockref("itself", (0, 0))
    drawing = read(document, tmp_path)
    centres = sorted(tuple(curve.centres[0].round(9)) for curve in drawing.layers[0].curves if curve.radii_mm[0] > 1.5)
    assert centres == [(x, y) for x in (0, 20, 40) for y in (0, 10)]
    assert [entity.kind for entity in drawing.skipped] == ["INSERT"]


def test_lines_arcs_circles_and_bulges_are_exact(tmp_path: Path) -> None:
    document = new_document()
    space = document.modelspace()
    space.add_circle((3, 4), 5, {"layer": "circle"})
    space.add_arc((0, 0), 2, 90, 0, dxfattribs={"layer": "arc"})
    space.add_lwpolyline([(0, 0, 1), (10, 0, 0), (10, 10, 0)], "xyb", close=True, dxfattribs={"layer": "poly"})
    drawing = read(document, tmp_path, 1.0)
    circle, arc, poly = (drawing.layer(name).curves[0] for name in ("CIRCLE", "arc", "poly"))
    assert circle.closed and circle.area_mm2 == pytest.approx(25 * math.pi, rel=1e-14)
    assert arc.length_mm == pytest.approx(3 * math.pi, rel=1e-14) and arc.xy[0] == pytest.approx((0, 2), abs=1e-15)
    assert poly.closed and poly.bulge.tolist() == [1, 0, 0] and poly.xy.tolist() == [[0, 0], [10, 0], [10, 10], [0, 0]]


def test_loose_lines_become_a_contour_and_a_gap_is_told(tmp_path: Path) -> None:
    document = new_document()
    corners = [(0, 0), (10, 0), (10, 10), (0, 10)]
    for number, corner in enumerate(corners):
        ends = [corner, corners[(number + 1) % 4]]
        document.modelspace().add_line(*(ends if number % 2 else ends[::-1]), {"layer": "whole"})
        document.modelspace().add_line(ends[0], np.array(ends[1]) - (0, 0.3 if number == 3 else 0), {"layer": "open"})
    drawing = read(document, tmp_path)
    (whole,) = drawing.layer("whole").curves
    assert whole.closed and abs(whole.area_mm2) == 100 and drawing.layer("whole").gaps == ()
    (gap,) = drawing.layer("open").gaps
    assert gap.place_mm == pytest.approx((0, -0.15)) and gap.size_mm == pytest.approx(0.3)


@pytest.mark.parametrize(
    ("unit", "said_mm", "length_mm"), [(0, None, 10), (4, None, 10), (1, None, 254), (5, None, 100)]
)
def test_the_unit_of_the_file_counts(tmp_path: Path, unit: int, said_mm: float | None, length_mm: float) -> None:
    document = new_document(unit)
    document.modelspace().add_line((0, 0), (10, 0))
    document.modelspace().add_ellipse((50, 0), (20, 0), 0.3)
    drawing = read(document, tmp_path, unit_mm=said_mm)
    line, oval = drawing.layers[0].curves
    assert line.length_mm == pytest.approx(length_mm)
    t = np.linspace(0, math.tau, 2001)
    places = np.column_stack([50 + 20 * np.cos(t), 6 * np.sin(t)]) * drawing.unit_mm
    assert oval.distances_mm(places).max() <= TOLERANCE_MM
    assert read(document, tmp_path, unit_mm=2.0).layers[0].curves[0].length_mm == 20


def test_what_cannot_be_followed_is_named(tmp_path: Path) -> None:
    document = new_document()
    space = document.modelspace()
    space.add_line((0, 0), (1, 0), {"layer": "cut"})
    space.add_line((0, 0, 0), (1, 0, 5), {"layer": "cut"})
    space.add_line((2, 2), (2, 2), {"layer": "cut"})
    space.add_text("שלום", dxfattribs={"layer": "notes"})
    space.add_circle((0, 0), 1, {"extrusion": (0, 1, 0)})
    space.add_linear_dim((0, 5), (0, 0), (1, 0)).render()
    drawing = read(document, tmp_path)
    assert [layer.name for layer in drawing.layers] == ["cut"] and len(drawing.layers[0].curves) == 1
    said = [(entity.kind, entity.layer, entity.why) for entity in drawing.skipped]
    assert said == [
        ("LINE", "cut", "does not lie flat"),
        ("LINE", "cut", "the curve has no length"),
        ("TEXT", "notes", "scripts that are written from the right are not set"),
        ("CIRCLE", "0", "does not lie flat"),
        ("DIMENSION", "0", "nothing that a tool could follow"),
    ]
    assert all(document.entitydb[entity.handle].dxftype() == entity.kind for entity in drawing.skipped)


def test_what_is_hidden_or_on_paper_is_not_read(tmp_path: Path) -> None:
    document = new_document()
    for name in ("seen", "off", "frozen"):
        document.layers.add(name)
        document.modelspace().add_line((0, 0), (1, 0), {"layer": name})
    document.layers.get("off").off()
    document.layers.get("frozen").freeze()
    document.modelspace().add_line((0, 0), (1, 0), {"layer": "unseen", "invisible": 1})
    document.layout("Layout1").add_line((0, 0), (1, 0), {"layer": "paper"})
    assert [layer.name for layer in read(document, tmp_path).layers] == ["seen"]


def test_a_spline_keeps_its_corner(tmp_path: Path) -> None:
    document = new_document()
    spline = document.modelspace().add_spline(dxfattribs={"layer": "s"})
    points = [(0, 0, 0), (2, 5, 0), (8, 5, 0), (10, 0, 0), (12, 5, 0), (18, 5, 0), (20, 0, 0)]
    spline.control_points, spline.dxf.degree = points, 3
    spline.knots = [0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2]
    (curve,) = read(document, tmp_path).layers[0].curves
    assert np.hypot(*(curve.xy - (10, 0)).T).min() < 1e-12


@pytest.mark.parametrize(
    ("name", "layers", "closed", "gaps", "skipped"),
    [
        ("A4_Landscape.dxf", {"BORDER": 37, "TITLEBLOCK": 18, "LOGO": 3, "PAPERSIZE": 4}, 3, 4, {}),
        ("A4_Landscape_plain.dxf", {"PAPERSIZE": 4, "LOGO": 4}, 2, 2, {}),
    ],
)
def test_drawings_of_others(name: str, layers: dict[str, int], closed: int, gaps: int, skipped: dict[str, int]) -> None:
    drawing = read_dxf(DATA / name, TOLERANCE_MM)
    texts = {text.dxf.handle for text in ezdxf.readfile(DATA / name).modelspace().query("TEXT")}
    letters = [chain for chain in drawing.chains if chain.attributes.name in texts]
    assert len({chain.attributes.name for chain in letters}) == len(texts)
    drawing = replace(drawing, chains=tuple(chain for chain in drawing.chains if chain not in letters))
    assert {layer.name: len(layer.curves) for layer in drawing.layers} == layers
    assert sum(curve.closed for layer in drawing.layers for curve in layer.curves) == closed
    assert sum(gap.size_mm < 0.5 for layer in drawing.layers for gap in layer.gaps) >= gaps
    assert Counter(entity.kind for entity in drawing.skipped) == skipped
    lines = [
        line
        for entity in ezdxf.readfile(DATA / name).modelspace()
        if entity.dxftype() != "TEXT"
        for line in truth(entity)
    ]
    assert far_apart_mm(drawing, lines) <= TOLERANCE_MM + 2 * FINE_MM


@pytest.mark.parametrize(
    ("content", "code"),
    [(b"", "dxf-file"), (b"G1 X0\n", "dxf-file"), (bytes(range(256)) * 40, "dxf-file"), (None, "input-missing")],
)
def test_what_is_no_drawing_is_refused(tmp_path: Path, content: bytes | None, code: str) -> None:
    path = tmp_path / "a.dxf"
    if content is not None:
        path.write_bytes(content)
    with pytest.raises(JobError) as refusal:
        read_dxf(path, 0.01)
    assert refusal.value.code == code and refusal.value.advice


@pytest.mark.slow
def test_a_damaged_drawing_is_mended_with_a_word_or_refused(tmp_path: Path) -> None:
    whole = (DATA / "A4_Landscape_plain.dxf").read_bytes().splitlines(keepends=True)
    path, outcomes = tmp_path / "damaged.dxf", Counter[str]()
    for seed in range(40):
        rng = np.random.default_rng(seed)
        lines, first = list(whole), int(rng.integers(len(whole)))
        if seed % 2:
            del lines[first:]
        else:
            lines[first] = bytes(rng.integers(32, 126, 8).tolist()) + b"\n"
        path.write_bytes(b"".join(lines))
        try:
            outcomes["mended" if read_dxf(path, 0.01).damage else "sound"] += 1
        except JobError as error:
            outcomes[error.code] += 1
    assert set(outcomes) == {"mended", "sound", "dxf-file"}, f"seeds 0 to 39: {outcomes}"


def test_an_empty_drawing_and_an_unknown_layer_are_refused(tmp_path: Path) -> None:
    document = new_document()
    with pytest.raises(JobError, match="holds no curves"):
        read(document, tmp_path)
    document.modelspace().add_line((0, 0), (1, 0), {"layer": "cut"})
    with pytest.raises(JobError, match=r"'Outline'.*on 'cut'"):
        read(document, tmp_path).layer("Outline")
    with pytest.raises(JobError, match="above 0"):
        read(document, tmp_path, 0.0)


def test_a_file_without_a_header_is_in_mm(tmp_path: Path) -> None:
    path = tmp_path / "bare.dxf"
    path.write_text("0\nSECTION\n2\nENTITIES\n0\nLINE\n8\n0\n10\n0\n20\n0\n11\n50\n21\n0\n0\nENDSEC\n0\nEOF\n")
    drawing = read_dxf(path, 0.01)
    assert drawing.unit_mm == 1.0 and drawing.layers[0].curves[0].length_mm == 50.0


def test_no_chain_is_a_speck() -> None:
    drawing = read_dxf(Path(__file__).parents[2] / "data" / "dxf" / "A4_Landscape_plain.dxf", 0.01)
    assert min(curve.length_mm for layer in drawing.layers for curve in layer.curves) > 1.0
