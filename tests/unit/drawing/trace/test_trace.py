# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures become contours at their places; what is no picture and what is too large is refused before it is read."""

from __future__ import annotations

import io
import random
import struct
import tracemalloc
import zlib
from math import pi
from pathlib import Path

import numpy as np
import pytest
import shapely
from PIL import Image, ImageDraw

from CNCStepper.drawing.drawing import Drawing
from CNCStepper.drawing.read_drawing import ReadOptions, read_drawing
from CNCStepper.drawing.trace.options import TraceOptions
from CNCStepper.drawing.trace.picture_file import MOST_PIXELS
from CNCStepper.errors import JobError
from CNCStepper.geometry.grid_contours import contours_of

FINE = 8  # pictures are drawn so many times larger: their edges are grey


def picture(path: Path, **keys: object) -> Path:
    """Write a ring and a bar of 0.1 mm pixels, 80 by 60 mm."""
    image = Image.new("L", (800 * FINE // 2, 600 * FINE // 2), 255)
    draw, unit = ImageDraw.Draw(image), 10 * FINE / 2
    draw.ellipse((10 * unit, 10 * unit, 50 * unit, 50 * unit), fill=0)
    draw.ellipse((25 * unit, 25 * unit, 35 * unit, 35 * unit), fill=255)
    draw.rectangle((60 * unit, 10 * unit, 70 * unit, 40 * unit), fill=0)
    image.resize((800, 600), Image.Resampling.BOX).save(path, **keys)
    return path


def traced(path: Path, **keys: object) -> Drawing:
    return read_drawing(path, ReadOptions(trace=TraceOptions(**keys)))


@pytest.mark.parametrize(
    ("name", "keys"), [("p.png", {"dpi": (254, 254)}), ("p.JPG", {"quality": 80, "dpi": (254, 254)})]
)
def test_areas_and_holes_are_where_they_were_drawn(tmp_path: Path, name: str, keys: dict[str, object]) -> None:
    drawing = traced(picture(tmp_path / name, **keys))
    bar, hole, ring = sorted((chain.curve for chain in drawing.chains), key=lambda curve: curve.box_mm[2], reverse=True)
    if hole.area_mm2 > 0:
        ring, hole = hole, ring
    assert drawing.unit_mm == pytest.approx(0.1, rel=1e-3) and drawing.warnings == ()
    assert bar.box_mm == pytest.approx((60, 20, 70, 50), abs=0.08)
    assert ring.area_mm2 == pytest.approx(pi * 20**2, rel=0.005) and ring.box_mm == pytest.approx(
        (10, 10, 50, 50), abs=0.1
    )
    assert hole.area_mm2 == pytest.approx(-pi * 5**2, rel=0.02)
    assert len(ring) <= 16 and len(bar) <= 8
    assert all(chain.attributes.filled and chain.curve.closed for chain in drawing.chains)


def test_options_choose_size_threshold_sense_and_detail(tmp_path: Path) -> None:
    path = picture(tmp_path / "p.png")
    assert "96 dpi" in traced(path).warnings[0]
    wide = traced(path, width_mm=160)
    assert max(chain.curve.box_mm[2] for chain in wide.chains) == pytest.approx(140, abs=0.2)
    assert traced(path, dpi=25.4).unit_mm == 1
    outside = traced(path, dpi=254, invert=True)
    assert max(chain.curve.area_mm2 for chain in outside.chains) == pytest.approx(80 * 60, rel=0.01)
    coarse = traced(path, dpi=254, simplify_mm=1.0)
    fine = traced(path, dpi=254, simplify_mm=0.02)
    assert sum(len(chain.curve) for chain in coarse.chains) < sum(len(chain.curve) for chain in fine.chains)
    assert len(traced(path, dpi=254, speck_mm2=100).chains) == 2
    assert traced(path, dpi=254, blur_px=3).chains[0].curve.closed


def test_transparent_and_sixteen_bit_pictures_are_read(tmp_path: Path) -> None:
    clear = Image.new("RGBA", (60, 40), (0, 0, 0, 0))
    ImageDraw.Draw(clear).rectangle((10, 10, 29, 29), fill=(0, 0, 90, 255))
    clear.save(tmp_path / "clear.png", dpi=(25.4, 25.4))
    deep = np.full((40, 60), 60_000, np.uint16)
    deep[10:30, 10:30] = 4_000
    Image.fromarray(deep).save(tmp_path / "deep.png", dpi=(25.4, 25.4))
    for name in ("clear.png", "deep.png"):
        (chain,) = traced(tmp_path / name).chains
        assert chain.curve.box_mm == pytest.approx((10, 10, 30, 30), abs=0.6), name


def area_of(contour: np.ndarray) -> float:
    z = contour @ (1.0, 1.0j)
    return float((np.conj(z) * np.roll(z, -1)).imag.sum() / 2.0)


def test_contours_agree_with_shapely_on_random_fields() -> None:
    saddles = 0
    for seed in range(20):
        chance = np.random.default_rng(seed)
        values = chance.integers(0, 256, (chance.integers(1, 300), chance.integers(1, 40))).astype(np.uint8)
        contours = contours_of(values, 127.5)
        dark = values < 127.5
        saddles += int((dark[1:, 1:] & dark[:-1, :-1] & ~dark[1:, :-1] & ~dark[:-1, 1:]).sum())
        rings = shapely.polygons([shapely.linearrings(contour) for contour in contours if len(contour) > 2])
        assert shapely.is_valid(rings).all()
        signed = [area_of(contour) for contour in contours]
        inside = sum(shapely.area(ring) * np.sign(area) for ring, area in zip(rings, signed, strict=True))
        whole = shapely.union_all([ring for ring, area in zip(rings, signed, strict=True) if area > 0])
        places = [(column, row) for row, column in zip(*np.nonzero(dark), strict=True)]
        assert inside > 0 and shapely.covers(whole, shapely.points(places)).all(), seed
    print(f"seeds 0 to 19: {saddles} saddles")
    assert saddles > 1000


def test_a_picture_without_dark_areas_is_refused(tmp_path: Path) -> None:
    Image.new("L", (20, 20), 255).save(tmp_path / "white.png")
    with pytest.raises(JobError, match="no dark areas"):
        traced(tmp_path / "white.png")


def bomb(width: int, height: int) -> bytes:
    """Return a small PNG that says it is huge."""

    def chunk(kind: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    head = struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)
    return (
        b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(bytes(1000))) + chunk(b"IEND", b"")
    )


@pytest.mark.parametrize("size", [(60_000, 60_000), (MOST_PIXELS + 1, 1)])
def test_a_decompression_bomb_is_refused_by_its_size(tmp_path: Path, size: tuple[int, int]) -> None:
    (tmp_path / "bomb.png").write_bytes(bomb(*size))
    tracemalloc.start()
    with pytest.raises(JobError) as refusal:
        traced(tmp_path / "bomb.png")
    assert refusal.value.code == "picture-large" and tracemalloc.get_traced_memory()[1] < 20_000_000
    tracemalloc.stop()


def test_damaged_pictures_are_refused_or_read_and_end(tmp_path: Path) -> None:
    buffer = io.BytesIO()
    Image.effect_noise((40, 40), 90).save(buffer, "PNG")
    whole, refused = buffer.getvalue(), 0
    for seed in range(60):
        chance = random.Random(seed)
        data = bytearray(whole[: chance.randint(0, len(whole))] if seed % 2 else whole)
        for _ in range(chance.randint(0, 6)):
            if data:
                data[chance.randrange(len(data))] = chance.randrange(256)
        (tmp_path / "x.png").write_bytes(data)
        try:
            traced(tmp_path / "x.png")
        except JobError as error:
            assert error.code.startswith("picture-") and "BytesIO" not in str(error), (seed, str(error))
            refused += 1
    print(f"seeds 0 to 59: {refused} refused")
    assert 30 <= refused <= 60
