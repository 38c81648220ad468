# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mesh of a cut part: every edge belongs to two triangles that run it in both senses, and its volume is right."""

from __future__ import annotations

import struct

import numpy as np
import pytest

from CNCStepper.machine.tools.tool import Tool
from CNCStepper.simulation.meshes.stl_mesh import Mesh, mesh_of
from CNCStepper.simulation.removal.heightmap import HeightMap, height_map
from CNCStepper.simulation.stock import Cylinder, HeightField, Stock
from helpers.simulation.programs import BALL, FLAT, begun

STOCK = Stock((30, 22, 6))
HILL = HeightField((30, 22, 6), heights_mm=np.array([[3.0, 4, 3], [4, 6, 4], [3, 4, 3]]))


def assert_closed(mesh: Mesh) -> None:
    begin, end = np.vstack([mesh.triangles[:, pair] for pair in ([0, 1], [1, 2], [2, 0])]).T.astype(np.int64)
    count = int(mesh.triangles.max()) + 1
    there, back = np.sort(begin * count + end), np.sort(end * count + begin)
    assert (np.diff(there) > 0).all() and (there == back).all()


@pytest.mark.parametrize("tool", [FLAT, BALL, Tool(number=1, shape="v", diameter_mm=6, tip_angle_deg=60)])
@pytest.mark.parametrize("stock", [STOCK, Cylinder((22, 22, 6)), HILL], ids=["box", "cylinder", "heights"])
@pytest.mark.parametrize("deep", [-2.0, -7.0], ids=["pocket", "through"])
def test_it_is_closed_and_has_the_volume_of_the_part(tool: Tool, stock: Stock, deep: float) -> None:
    program = begun().rapid(-5, -4, 5).feed(-5, -4, deep).feed(3, 2, deep).feed(20, 2, deep - 1)
    part = height_map(program.toolpath(), tool, stock, 0.25)
    mesh = mesh_of(part)
    assert_closed(mesh)
    whole = mesh_of(HeightMap(stock, 0.25)).volume_mm3
    assert mesh.volume_mm3 == pytest.approx(whole - part.removed_volume_mm3, rel=1e-6)
    if not isinstance(stock, HeightField):
        assert whole == pytest.approx(stock.outline.area * 6, rel=1e-3)


def test_what_is_flat_takes_few_triangles() -> None:
    program = begun().rapid(-5, -4, 5).feed(-5, -4, -2).feed(5, -4, -2).feed(5, 4, -2).feed(-20, 4, -2)
    part = height_map(program.toolpath(), FLAT, STOCK, 0.05)
    mesh = mesh_of(part)
    assert_closed(mesh)
    assert mesh.volume_mm3 == pytest.approx(30 * 22 * 6 - part.removed_volume_mm3, rel=1e-9)
    assert len(mesh.triangles) < part.heights_mm.size / 5
    assert len(mesh_of(HeightMap(STOCK, 0.05)).triangles) < 5 * 2 * (600 + 440)


def test_the_file_says_the_same(tmp_path) -> None:
    mesh = mesh_of(height_map(begun().feed(0, 0, -2).toolpath(), FLAT, STOCK, 0.5))
    path = tmp_path / "peça cortada.stl"
    mesh.save_stl(path)
    data = path.read_bytes()
    (count,) = struct.unpack_from("<I", data, 80)
    assert count == len(mesh.triangles) and len(data) == 84 + 50 * count
    facets = np.frombuffer(data, np.dtype([("n", "<f4", 3), ("p", "<f4", (3, 3)), ("z", "<u2")]), offset=84)
    a, b, c = (facets["p"][:, k].astype(float) for k in range(3))
    assert (a * np.cross(b, c)).sum() / 6 == pytest.approx(mesh.volume_mm3, rel=1e-5)
    assert (np.cross(b - a, c - a) * facets["n"]).sum(axis=1).min() > 0


def test_nothing_is_left_of_a_part_that_is_cut_away() -> None:
    part = height_map(begun().feed(0, 0, -9).toolpath(), FLAT, Stock((3, 3, 5)), 0.5)
    assert len(mesh_of(part).triangles) == 0
