# SPDX-License-Identifier: LGPL-2.1-or-later
"""STL meshes: sections and outlines against the solids that they are made of, and files that are none."""

from __future__ import annotations

import math
import struct
from pathlib import Path

import numpy as np
import pytest

from CNCStepper.drawing.drawing import Drawing
from CNCStepper.drawing.read_drawing import ReadOptions, read_drawing
from CNCStepper.errors import JobError

SIDES = 64


def tube(outer_mm: float, inner_mm: float, height_mm: float, taper: float = 1.0) -> np.ndarray:
    """Return the triangles of a tube on Z 0; its upper end is `taper` times as wide, float64[n, 3, 3]."""
    angles = np.arange(SIDES + 1) % SIDES * math.tau / SIDES
    ring = np.column_stack([np.cos(angles), np.sin(angles)])

    def at(radius: float, z: float) -> np.ndarray:
        wide = radius * (taper if z else 1.0)
        return np.column_stack([wide * ring, np.full(SIDES + 1, z)])

    bands = [(at(outer_mm, 0), at(outer_mm, height_mm)), (at(inner_mm, height_mm), at(inner_mm, 0))]
    bands += [(at(inner_mm, 0), at(outer_mm, 0)), (at(outer_mm, height_mm), at(inner_mm, height_mm))]
    lower = [np.stack([a[:-1], a[1:], b[1:]], axis=1) for a, b in bands]
    upper = [np.stack([a[:-1], b[1:], b[:-1]], axis=1) for a, b in bands]
    return np.concatenate(lower + upper)


def binary(triangles: np.ndarray, claimed: int | None = None) -> bytes:
    count = len(triangles) if claimed is None else claimed
    rows = b"".join(struct.pack("<12fH", 0, 0, 1, *map(float, each.ravel()), 0) for each in triangles)
    return b"solid is no text here".ljust(80) + struct.pack("<I", count) + rows


def ascii_text(triangles: np.ndarray) -> bytes:
    corners = ("\n".join(f"vertex {x:.9e} {y:.9e} {z:.9e}" for x, y, z in each) for each in triangles)
    facets = "".join(f"facet normal 0 0 0\nouter loop\n{text}\nendloop\nendfacet\n" for text in corners)
    return f"solid tube\n{facets}endsolid tube\n".encode()


def read(folder: Path, content: bytes, height_mm: float | None = None) -> Drawing:
    path = folder / "tube.STL"
    path.write_bytes(content)
    return read_drawing(path, ReadOptions(height_mm=height_mm))


def polygon_area_mm2(radius_mm: float) -> float:
    return SIDES / 2 * radius_mm**2 * math.sin(math.tau / SIDES)


@pytest.mark.parametrize("write", [binary, ascii_text])
@pytest.mark.parametrize("height_mm", [0.0, 2.0, 4.0 - 1e-7, None])
def test_a_tube_is_two_rings(tmp_path: Path, write: object, height_mm: float | None) -> None:
    drawing = read(tmp_path, write(tube(10, 6, 4)), height_mm)  # type: ignore[operator]
    outer, inner = (chain.curve for chain in drawing.chains)
    assert outer.closed and inner.closed and len(outer) == len(inner) == SIDES
    assert outer.area_mm2 == pytest.approx(polygon_area_mm2(10), rel=1e-5)
    assert inner.area_mm2 == pytest.approx(polygon_area_mm2(6), rel=1e-5)


def test_the_outline_of_a_cone_is_its_foot_and_a_section_lies_between(tmp_path: Path) -> None:
    content = binary(tube(10, 6, 4, taper=0.5))
    outline, hole = (chain.curve for chain in read(tmp_path, content).chains)
    assert outline.area_mm2 == pytest.approx(polygon_area_mm2(10), rel=1e-5)
    assert hole.area_mm2 == pytest.approx(polygon_area_mm2(3), rel=1e-5)
    outer, _ = (chain.curve for chain in read(tmp_path, content, 2.0).chains)
    assert outer.area_mm2 == pytest.approx(polygon_area_mm2(7.5), rel=1e-5)


def test_the_order_of_triangles_does_not_count(tmp_path: Path) -> None:
    triangles = tube(10, 6, 4)
    first = read(tmp_path, binary(triangles), 2.0)
    mixed = np.random.default_rng(1).permutation(np.roll(triangles, 1, axis=1))
    other = read(tmp_path, binary(mixed), 2.0)
    for own, others in zip(first.chains, other.chains, strict=True):
        assert own.curve.xy == pytest.approx(others.curve.xy, abs=1e-9)


@pytest.mark.parametrize(
    ("content", "why"),
    [
        (binary(tube(10, 6, 4), claimed=100_000_000), "100000000 triangles"),
        (binary(tube(10, 6, 4))[:-10], "ends too early"),
        (binary(np.full((1, 3, 3), math.nan)), "no number in bounds"),
        (binary(np.full((1, 3, 3), 3e30)), "no number in bounds"),
        (b"", "not an STL file"),
        (b"solid a\nfacet\nvertex 1 2 zero\nvertex 1 2 3\nvertex 1 2 3\n", "no number"),
        (b"solid a\nfacet\nvertex 1 2 3\nvertex 1 2 3\n", "not whole"),
        (b"solid a\nfacet\nendsolid\n", "not whole"),
    ],
)
def test_what_is_no_mesh_is_refused(tmp_path: Path, content: bytes, why: str) -> None:
    with pytest.raises(JobError, match=why):
        read(tmp_path, content)


def test_nothing_at_a_height_is_refused(tmp_path: Path) -> None:
    with pytest.raises(JobError, match="nothing at that height"):
        read(tmp_path, binary(tube(10, 6, 4)), 9.0)
    with pytest.raises(JobError, match="no solid and no face"):
        read(tmp_path, binary(np.zeros((1, 3, 3))), None)
