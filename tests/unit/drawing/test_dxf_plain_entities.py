# SPDX-License-Identifier: LGPL-2.1-or-later
"""Entities read straight from the text of a DXF file give what ezdxf gives: chains, attributes and refusals."""

from __future__ import annotations

import io
import math
from collections import Counter
from pathlib import Path
from typing import Any

import ezdxf
import numpy as np
import pytest

from CNCStepper.drawing.drawing import Drawing
from CNCStepper.drawing.dxf.group_text import NotSplit
from CNCStepper.drawing.dxf.plain_entities import PlainEntities, SplitText, split_text
from CNCStepper.drawing.dxf.reader import read_dxf

SEEDS = range(12)


CASES = ["line", "arc", "circle", "below", "unseen", "tall", "far", "short", "polyline", "ellipse"]
OF_R12 = CASES[:-2]


def add_random(space: Any, rng: np.random.Generator, kinds: list[str]) -> str:
    """Add an entity, ordinary or not; return which case it is."""
    attributes: dict[str, Any] = {"layer": f"L{rng.integers(4)}", "color": int(rng.integers(0, 257))}
    if kinds == CASES and rng.random() < 0.2:
        attributes["true_color"] = int(rng.integers(1 << 24))
    x, y = rng.uniform(-90, 90, 2)
    case = str(rng.choice(kinds))
    if case == "line":
        space.add_line((x, y, 3), (x + rng.uniform(1, 9), y, 3), attributes)
    elif case == "arc":
        first = rng.uniform(0, 360)
        space.add_arc((x, y), rng.uniform(0.01, 9), first, first + rng.choice([0, 1, 180, 359]), dxfattribs=attributes)
    elif case == "circle":
        space.add_circle((x, y), rng.uniform(0.01, 9), attributes)
    elif case == "polyline":
        bulges = rng.choice([0.0, 1e-12, -0.5, 1.5], 4)
        rows = np.column_stack([x + np.array([0, 5, 5, 0]), y + np.array([0, 0, 5, 5]), bulges])
        space.add_lwpolyline(rows, "xyb", close=bool(rng.random() < 0.5), dxfattribs=attributes)
    elif case == "below":
        space.add_circle((x, y), 2, attributes | {"extrusion": (0, 0, -1)})
    elif case == "unseen":
        space.add_line((x, y), (x + 1, y), attributes | {"invisible": 1})
    elif case == "tall":
        space.add_line((x, y, 0), (x + 1, y, 9), attributes)
    elif case == "far":
        space.add_line((x, y), (2e6, y), attributes)
    elif case == "short":
        space.add_line((x, y), (x, y), attributes)
    else:
        space.add_ellipse((x, y), (5, 0), 0.5, dxfattribs=attributes)
    return case


def left_to_ezdxf(chunks: object) -> SplitText:
    raise NotSplit


def assert_same(one: Drawing, other: Drawing) -> None:
    assert one.skipped == other.skipped and one.unit_mm == other.unit_mm
    assert [chain.attributes for chain in one.chains] == [chain.attributes for chain in other.chains]
    for own, others in zip(one.chains, other.chains, strict=True):
        assert own.curve.xy == pytest.approx(others.curve.xy, abs=1e-9)
        assert own.curve.bulge == pytest.approx(others.curve.bulge, abs=1e-12)
    assert one.gaps == other.gaps


@pytest.mark.parametrize("version", ["R12", "R2000", "R2018"])
def test_both_ways_give_the_same_drawing(
    tmp_path: Path, version: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("CNCStepper.input_file.CHUNK_BYTES", 1500)  # several windows in each file
    cases, read_straight = Counter[str](), 0
    for seed in SEEDS:
        rng = np.random.default_rng(seed)
        document = ezdxf.new(version)
        document.units = int(rng.choice([1, 4]))
        for number in range(4):
            document.layers.add(f"L{number}", color=int(rng.integers(1, 256)))
        document.layers.get("L3").off()
        kinds = OF_R12 if version == "R12" else CASES
        cases.update(add_random(document.modelspace(), rng, kinds) for _ in range(40))
        path = tmp_path / f"{seed}.dxf"
        document.saveas(path)
        split = split_text([path.read_bytes()])
        read_straight += len(split.plain)
        straight = read_dxf(path, 0.01)
        with monkeypatch.context() as patch:
            patch.setattr("CNCStepper.drawing.dxf.reader.split_text", left_to_ezdxf)
            assert_same(straight, read_dxf(path, 0.01))
    print(f"seeds {SEEDS}: {cases}, {read_straight} read straight")
    assert len(cases) == len(kinds) and read_straight > 100


LINE = "0\nLINE\n5\nA1\n8\n0\n10\n0\n20\n0\n11\n50\n21\n0\n"


def text(entities: str) -> bytes:
    return f"0\nSECTION\n2\nENTITIES\n{entities}0\nENDSEC\n0\nEOF\n".encode()


@pytest.mark.parametrize(
    "changed",
    [
        ("8\n0\n", "8\n\\U+00E7\n"),  # a name that ezdxf decodes
        ("10\n0\n", "10\nnan\n"),
        ("10\n0\n", "10\n1e300\n"),
        ("11\n50\n", "11\n50\n11\n51\n"),  # a value that stands twice
        ("11\n50\n21\n0\n", "21\n0\n11\n50\n"),  # in another order
        ("11\n50\n", ""),
        ("8\n0\n", "8\n0\n62\nnan\n"),  # a colour that is no number
        ("8\n0\n", "8\n0\n420\n1e400\n"),
        ("8\n0\n", "8\n0\n67\n1\n"),  # in the paper space
        ("8\n0\n", "8\n0\n210\n1\n220\n0\n230\n0\n"),
        ("8\n0\n", "8\n0\n1001\nACAD\n1000\nnote\n"),
        ("LINE", "XLINE"),
    ],
)
def test_what_is_not_ordinary_is_left_to_ezdxf(changed: tuple[str, str]) -> None:
    other = LINE.replace("A1", "A2").replace(*changed)
    assert other != LINE.replace("A1", "A2")
    split = split_text([text(LINE + other)])
    assert [entity.handle for entity in split.plain] == ["A1"]
    assert split.numbers == {"A2": 1} and split.rest == text(other)


def test_a_bulge_before_the_first_vertex_is_not_given_to_the_polyline_before() -> None:
    square = "0\nLWPOLYLINE\n5\n{}\n8\n0\n90\n2\n70\n1\n{}10\n0\n20\n0\n10\n9\n20\n0\n"
    split = split_text([text(square.format("A1", "") + square.format("A2", "42\n1\n"))])
    (before,) = split.plain
    assert before.handle == "A1" and not before.curve.bulge.any() and split.numbers == {"A2": 1}


@pytest.mark.parametrize(
    "content",
    [
        b"",
        b"G1 X0\n",
        text(LINE)[:-20],
        text(LINE).replace(b"20\n0\n", b"20\nzero\n"),
        text(LINE + "0\nTEXT\n8\n0\n1\nwithout a handle\n"),
        text(""),
    ],
)
def test_a_damaged_file_or_one_without_handles_is_left_to_ezdxf(content: bytes) -> None:
    with pytest.raises(NotSplit):
        split_text([content])


@pytest.mark.parametrize("fault", [TypeError, ValueError, LookupError])
def test_a_fault_of_the_quick_reader_is_not_hidden(
    tmp_path: Path, fault: type[Exception], monkeypatch: pytest.MonkeyPatch
) -> None:
    def faulty(chunks: object) -> SplitText:
        raise fault("planted")

    path = tmp_path / "line.dxf"
    path.write_bytes(text(LINE))
    monkeypatch.setattr("CNCStepper.drawing.dxf.reader.split_text", faulty)
    with pytest.raises(fault, match="planted"):
        read_dxf(path, 0.01)


def test_a_rest_that_ezdxf_refuses_is_a_fault_where_the_file_is_whole(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "line.dxf"
    path.write_bytes(text(LINE))
    assert read_dxf(path, 0.01).damage == ""
    monkeypatch.setattr(
        "CNCStepper.drawing.dxf.reader.split_text",
        lambda chunks: SplitText(PlainEntities(), b"".join(chunks)[:-20], {}),
    )
    with pytest.raises(ezdxf.DXFError):
        read_dxf(path, 0.01)


def test_a_full_circle_is_closed_and_a_half_turn_is_one_arc() -> None:
    stream = io.StringIO()
    document = ezdxf.new()
    document.modelspace().add_circle((1, 2), 3)
    document.modelspace().add_arc((0, 0), 2, 0, 180)
    document.write(stream)
    split = split_text([stream.getvalue().encode()])
    circle, half = (entity.curve for entity in split.plain)
    assert circle.closed and circle.area_mm2 == pytest.approx(9 * math.pi) and len(circle) == 2
    assert len(half) == 1 and half.length_mm == pytest.approx(2 * math.pi)
