# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drawings that are too large, or whose numbers make no curve: refused or named in words, in bounded time."""

from __future__ import annotations

import logging
import math
import os
import time
from pathlib import Path
from typing import Any

import ezdxf
import pytest

from CNCStepper.cancellation import interruptible
from CNCStepper.drawing.drawing import Drawing
from CNCStepper.drawing.dxf.limits import MOST_ENTITIES
from CNCStepper.drawing.dxf.reader import read_dxf
from CNCStepper.errors import CNCStepperError, JobError

MOST_S = 5.0  # of processor time


def new() -> Any:
    document = ezdxf.new(units=4)
    document.modelspace().add_line((0, 0), (10, 0))
    return document


def read(document: Any, folder: Path, **options: Any) -> Drawing:
    document.saveas(folder / "a.dxf", **options)
    return read_dxf(folder / "a.dxf", 0.005)


def refused(path: Path) -> str:
    """Return how a drawing is refused as too large, which takes no longer than MOST_S."""
    began_s = time.process_time()
    with pytest.raises(JobError) as error:
        read_dxf(path, 0.005)
    assert time.process_time() - began_s < MOST_S
    assert error.value.code == "dxf-large" and error.value.place
    return str(error.value)


def lines_file(folder: Path, count: int) -> Path:
    """Write a drawing of so many lines, faster than ezdxf would."""
    line = b"  0\nLINE\n  8\n0\n 10\n%d.0\n 20\n0.0\n 11\n%d.0\n 21\n1.0\n"
    path = folder / "lines.dxf"
    lines = b"".join(line % (3 * k, 3 * k) for k in range(count))
    path.write_bytes(b"  0\nSECTION\n  2\nENTITIES\n" + lines + b"  0\nENDSEC\n  0\nEOF\n")
    return path


@pytest.mark.slow
def test_a_million_lines_are_refused_before_they_are_read(tmp_path: Path) -> None:
    sentence = refused(lines_file(tmp_path, 1_000_000))
    assert "too many entities" in sentence and f"limit {MOST_ENTITIES}" in sentence and "value 1000" in sentence
    assert len(read_dxf(lines_file(tmp_path, 1000), 0.005).layers) == 1


@pytest.mark.slow
def test_entities_without_a_name_are_counted_and_zeros_of_other_groups_are_not(tmp_path: Path) -> None:
    nameless = tmp_path / "nameless.dxf"
    for pair, count in ((b"0\n0\n", 2_000_000), (b"  0\n7\n", 110_000), (b"0\r\n0\r\n", 110_000)):
        nameless.write_bytes(b"x\n" * 2 + pair * count)
        assert "too many entities" in refused(nameless)
    path = tmp_path / "zeros.dxf"
    group = b" 70\n0\n"  # which a line does not have: its value is no entity
    path.write_bytes(lines_file(tmp_path, 10).read_bytes().replace(b"  8\n", 20_000 * group + b"  8\n"))
    assert len(read_dxf(path, 0.005).layers[0].curves) == 10


@pytest.mark.slow
def test_a_binary_drawing_is_counted_like_any_other(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for version in ("R12", "R2010"):
        document = ezdxf.new(version, units=4)
        for x in range(2000):
            document.modelspace().add_line((x, 0), (x, 1))
        document.saveas(tmp_path / f"{version}.dxf", fmt="bin")
        assert len(read_dxf(tmp_path / f"{version}.dxf", 0.005).layers[0].curves) == 2000
        with monkeypatch.context() as smaller:
            smaller.setattr("CNCStepper.drawing.dxf.limits.MOST_ENTITIES", 1999)
            assert "too many entities" in refused(tmp_path / f"{version}.dxf")


@pytest.mark.slow
def test_lines_drawn_a_thousand_times_are_joined_in_bounded_time_and_ten_thousand_refused(tmp_path: Path) -> None:
    document = ezdxf.new(units=4)
    for _ in range(800):
        document.modelspace().add_line((0, 0), (5, 5))
    began_s = time.process_time()
    assert read(document, tmp_path).layers[0].curves
    assert time.process_time() - began_s < MOST_S
    for _ in range(2000):
        document.modelspace().add_line((0, 0), (5, 5))
    document.saveas(tmp_path / "a.dxf")
    with pytest.raises(CNCStepperError, match=r"too many ends of lines.*2800 at one place"):
        read_dxf(tmp_path / "a.dxf", 0.005)


@pytest.mark.parametrize("fmt", ["asc", "bin"])
def test_rows_and_columns_of_a_block_are_counted_before_they_are_made(tmp_path: Path, fmt: str) -> None:
    document = new()
    document.blocks.new("B").add_line((0, 0), (1, 1))
    insert = document.modelspace().add_blockref("B", (0, 0))
    insert.grid(size=(30_000, 30_000), spacing=(2, 2))
    document.saveas(tmp_path / "a.dxf", fmt=fmt)
    assert "900000001" in refused(tmp_path / "a.dxf")


def test_blocks_in_blocks_are_counted_before_they_are_made(tmp_path: Path) -> None:
    document = new()
    document.blocks.new("B0").add_line((0, 0), (1, 1))
    for level in range(1, 20):
        block = document.blocks.new(f"B{level}")
        for k in range(10):
            block.add_blockref(f"B{level - 1}", (k, 0))
    document.modelspace().add_blockref("B19", (0, 0))
    document.saveas(tmp_path / "a.dxf")
    assert "more than a million million" in refused(tmp_path / "a.dxf")


def test_a_block_that_holds_itself_several_times_is_refused(tmp_path: Path) -> None:
    document = new()
    block = document.blocks.new("B")
    for k in range(5):
        block.add_blockref("B", (k, 0))
    document.modelspace().add_blockref("B", (0, 0))
    document.saveas(tmp_path / "a.dxf")
    assert "taken apart" in refused(tmp_path / "a.dxf")


def spline(document: Any, degree: int = 3, knots: Any = None, weights: Any = None, points: Any = None) -> None:
    """Add a spline with whatever numbers, which ezdxf's own functions would not make."""
    entity = document.modelspace().add_spline(degree=degree)
    entity.control_points = points or [(0, 0, 0), (1, 2, 0), (3, 1, 0), (4, 4, 0)]
    entity.knots = [0, 0, 0, 0, 1, 1, 1, 1] if knots is None else knots
    if weights is not None:
        entity.weights = weights


@pytest.mark.parametrize(
    ("wrong", "told"),
    [
        ({"degree": 250}, "degree"),
        ({"knots": [0.0] * 8}, "knots do not rise"),
        ({"knots": [0, 0, 0, 0, 1, 1, 1]}, "do not belong together"),
        ({"knots": [0, 0, 0, 0, 1, 1, 1, 1, 1, 1]}, "do not belong together"),
        ({"knots": [0, 0, 0, 0, math.nan, 1, 1, 1]}, "knots are no numbers"),
        ({"knots": [0, 0, 0, 0, 1, 1, 1, math.inf]}, "knots are no numbers"),
        ({"points": [(0, 0, 0), (1, math.nan, 0), (3, 1, 0), (4, 4, 0)]}, "points are no numbers"),
        ({"points": [(0, 0, 0), (1, 1e300, 0), (3, 1, 0), (4, 4, 0)]}, "points are no numbers"),
        ({"points": [(0, 0, 0), (0, 0, 0), (0, 0, 0), (0, 0, 0)]}, ""),
        ({"weights": [0.0, 0.0, 0.0, 0.0]}, "weights"),
        ({"weights": [1.0, -1.0, 1.0, 1.0]}, "weights"),
    ],
    ids=lambda value: str(value)[:30],
)
def test_a_spline_that_is_none_is_left_out_and_named(tmp_path: Path, wrong: dict[str, Any], told: str) -> None:
    document = new()
    spline(document, **wrong)
    drawing = read(document, tmp_path)
    assert len(drawing.layers[0].curves) == 1
    assert [(each.kind, told in each.why) for each in drawing.skipped] == [("SPLINE", True)], drawing.skipped


@pytest.mark.slow
def test_a_long_spline_takes_time_with_its_length_and_not_with_its_square(tmp_path: Path) -> None:
    document = ezdxf.new(units=4)
    document.modelspace().add_open_spline([(3 * k, 10 * math.sin(k)) for k in range(400)])
    began_s = time.process_time()
    (curve,) = read(document, tmp_path).layers[0].curves
    assert time.process_time() - began_s < MOST_S
    assert len(curve.xy) > 100


@pytest.mark.parametrize("number", [math.nan, math.inf, 1e300, -1e12])
def test_coordinates_that_are_no_lengths_are_left_out_and_named(tmp_path: Path, number: float) -> None:
    document = new()
    space = document.modelspace()
    space.add_line((0, 0), (number, 1))
    space.add_circle((0, 0), number)
    space.add_arc((number, 0), 5, 0, 90)
    space.add_lwpolyline([(0, 0), (1, number), (2, 0)])
    space.add_lwpolyline([(0, 0, 0, 0, number), (2, 0)])
    space.add_ellipse((number, 0), (5, 0), 0.5)
    drawing = read(document, tmp_path)
    assert len(drawing.layers[0].curves) == 1
    assert len(drawing.skipped) == 6 and all(each.why for each in drawing.skipped)


def test_things_without_length_are_left_out_and_named(tmp_path: Path) -> None:
    document = new()
    document.modelspace().add_line((1, 1), (1, 1))
    document.modelspace().add_circle((1, 1), 0)
    assert [each.kind for each in read(document, tmp_path).skipped] == ["LINE", "CIRCLE"]


def test_names_and_the_words_of_ezdxf_drive_no_terminal(
    tmp_path: Path, capfd: pytest.CaptureFixture[str], caplog: pytest.LogCaptureFixture
) -> None:
    document = new()
    layer, wild = "walls_and_more", b"walls\x1b]0;t\xe2\x80\xae"  # 14 bytes both
    document.modelspace().add_line((0, 0), (1, 1), {"layer": layer})
    document.modelspace().add_point((0, 0), {"layer": layer})
    document.saveas(tmp_path / "a.dxf")
    (tmp_path / "a.dxf").write_bytes((tmp_path / "a.dxf").read_bytes().replace(layer.encode(), wild))
    drawing = read_dxf(tmp_path / "a.dxf", 0.005)
    names = [each.name for each in drawing.layers] + [each.layer for each in drawing.skipped]
    assert all(name.isprintable() for name in names) and len(names) == 3
    with pytest.raises(JobError) as error:
        drawing.layer("none\x1b[2J")
    assert str(error.value).isprintable()
    path = lines_file(tmp_path, 3)
    path.write_bytes(path.read_bytes().replace(b"1.0", b"1.0\x1b[31m", 1))
    try:
        told = read_dxf(path, 0.005).damage
    except JobError as broken:
        told = str(broken)
    assert told.isprintable()
    shown = capfd.readouterr()
    assert "\x1b" not in shown.out + shown.err


@pytest.mark.slow
def test_what_ezdxf_logs_does_not_reach_the_terminal(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "a.dxf"
    new().saveas(path)
    real = ezdxf.read

    def loud(*given: Any) -> Any:
        logging.getLogger("ezdxf").error("lost \x1b[31mhandle")
        return real(*given)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("ezdxf.read", loud)
        drawing = read_dxf(path, 0.005)
    assert drawing.damage == "lost \\x1b[31mhandle"
    assert capfd.readouterr().err == ""


@pytest.mark.skipif(os.name != "posix", reason="only POSIX has FIFOs in folders")
def test_a_fifo_or_a_device_is_no_drawing(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "a.dxf")
    for path in (tmp_path / "a.dxf", Path("/dev/zero"), tmp_path):
        with pytest.raises(JobError, match="not a file"):
            read_dxf(path, 0.005)


@pytest.mark.slow
def test_a_block_scaled_to_ellipses_a_thousand_times_is_fitted_once(tmp_path: Path) -> None:
    document = new()
    document.blocks.new("B").add_circle((0, 0), 3)
    uneven = {"xscale": 2, "yscale": 1, "rotation": 30}
    document.modelspace().add_blockref("B", (100, 0), uneven).grid(size=(40, 40), spacing=(20, 20))
    began_s = time.process_time()
    drawing = read(document, tmp_path)
    assert time.process_time() - began_s < MOST_S
    rings = [curve for curve in drawing.layers[0].curves if curve.closed]
    assert len(rings) == 1600
    for ring in (rings[0], rings[-1]):
        assert ring.area_mm2 == pytest.approx(math.pi * 18, rel=1e-3)
        middle = (ring.xy[:-1].min(axis=0) + ring.xy[:-1].max(axis=0)) / 2
        along = ring.xy[0] - middle
        assert math.hypot(*along) == pytest.approx(6, abs=0.005)
        assert math.degrees(math.atan2(along[1], along[0])) % 180 == pytest.approx(30, abs=0.1)


def test_curves_that_take_too_long_together_refuse_the_drawing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    document = new()
    for ratio in (0.3, 0.4, 0.5):
        document.modelspace().add_ellipse((50, 0), (20, 0), ratio)
    assert len(read(document, tmp_path).layers[0].curves) == 4
    monkeypatch.setattr("CNCStepper.drawing.dxf.entities.MOST_SAMPLES_OF_ALL", 10_000)
    with pytest.raises(JobError, match="too many and too wild") as error:
        read_dxf(tmp_path / "a.dxf", 0.005)
    assert error.value.code == "dxf-large" and error.value.place and error.value.place.file


@pytest.mark.slow
def test_a_long_drawing_says_how_far_it_is_and_can_be_ended(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("CNCStepper.input_file.CHUNK_BYTES", 50_000)
    path, shares = lines_file(tmp_path, 3000), []
    read_dxf(path, 0.005, share=shares.append)
    assert len(shares) > 5 and shares == sorted(shares) and 0 < shares[0] < 0.6 < shares[-1] == 1

    class WantedNoMoreError(Exception):
        pass

    def look() -> None:
        raise WantedNoMoreError

    with interruptible(look), pytest.raises(WantedNoMoreError):
        read_dxf(path, 0.005)


def test_vertices_of_an_old_polyline_are_points_of_it(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """In R12 each stands in the file as an entity of its own."""
    monkeypatch.setattr("CNCStepper.drawing.dxf.limits.MOST_ENTITIES", 100)
    document = ezdxf.new("R12")
    document.modelspace().add_polyline2d([(index, index % 7) for index in range(1000)])
    assert read(document, tmp_path).layers


@pytest.mark.parametrize(("count", "characters"), [(1, 2_000_000), (40, 60_000)])
def test_a_text_is_measured_before_it_is_taken_apart(tmp_path: Path, count: int, characters: int) -> None:
    one = "0\nTEXT\n5\n{:X}\n8\n0\n10\n0\n20\n0\n40\n5\n1\n" + "%%k" * (characters // 3) + "\n"
    lines = lines_file(tmp_path, 3).read_text().replace("LINE\n  8", "LINE\n5\nA1\n  8", 1)
    texts = "".join(one.format(0x100 + number) for number in range(count))
    (tmp_path / "text.dxf").write_text(lines.replace("  0\nENDSEC", texts + "  0\nENDSEC"))
    assert "too much text" in refused(tmp_path / "text.dxf")
