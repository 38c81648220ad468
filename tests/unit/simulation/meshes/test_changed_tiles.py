# SPDX-License-Identifier: LGPL-2.1-or-later
"""A part tile by tile: closed, equal to the part drawn whole, and drawn anew only where it looks different."""

from __future__ import annotations

import numpy as np
import pytest
from programs import BALL, FLAT, begun
from test_mesh_faces import flux_mm3

from CNCStepper.simulation.meshes.changed_tiles import ChangedTiles
from CNCStepper.simulation.meshes.mesh_faces import Faces, faces_of, step_of
from CNCStepper.simulation.removal.heightmap import HeightMap
from CNCStepper.simulation.removal.timeline import Timeline
from CNCStepper.simulation.stock import Cylinder, Stock
from CNCStepper.simulation.views.coloured_faces import drawn, height_range_mm
from CNCStepper.toolpath import ARC_CCW

STOCK = Stock((60, 50, 20))
CELL_MM = 0.15  # 400 x 334 cells: four by three tiles, none of which ends where the stock does


def timeline(stock: Stock = STOCK, tool=FLAT) -> Timeline:
    program = begun().feed(0, 0, -2).feed(18, 12, -2).arc(ARC_CCW, (9, 12, -2), (0, 12, -4)).feed(-25, -20, -6)
    toolpath = program.feed(-25, -20, 2).feed(-10, 5, 2).feed(-10, 5, -21).toolpath()
    return Timeline(toolpath, np.arange(1.0, len(toolpath) + 1), tool, stock, CELL_MM)


def everything(relief: ChangedTiles) -> Faces:
    parts = [relief.faces(number) for number in range(len(relief))]
    return Faces(np.concatenate([p.corners for p in parts]), np.concatenate([p.normals for p in parts]))


def data(relief: ChangedTiles) -> list[bytes]:
    return [faces.corners.tobytes() + faces.normals.tobytes() for faces in map(relief.faces, range(len(relief)))]


def pieces(faces: Faces, x_mm: np.ndarray, y_mm: np.ndarray) -> dict[tuple, np.ndarray]:
    """Return the normals of the upright faces, cut at the lines between tiles' cells so that two drawings compare."""
    found = {}
    for corners, normal in zip(faces.corners.astype(float), faces.normals, strict=True):
        low, high = corners.min(axis=0), corners.max(axis=0)
        axis = int(np.argmin((high - low)[:2]))
        if (high - low)[axis] > 1e-6:
            continue
        lines = (x_mm, y_mm)[1 - axis]
        for begin in lines[(lines > low[1 - axis] - 1e-6) & (lines < high[1 - axis] - 1e-6)]:
            found[axis, round(low[axis], 4), round(begin, 4), round(low[2], 4), round(high[2], 4)] = normal
    return found


@pytest.mark.parametrize(
    ("tool", "stock"),
    [
        (FLAT, STOCK),
        pytest.param(BALL, STOCK, marks=pytest.mark.slow),
        pytest.param(FLAT, Cylinder((60, 60, 20)), marks=pytest.mark.slow),
    ],
)
def test_all_tiles_together_are_the_part_drawn_whole(tool, stock) -> None:
    part = timeline(stock, tool).at(1e9)
    relief = ChangedTiles(part.part.grid)
    relief.take(part.part)
    faces, whole = everything(relief), faces_of(part, 10**9)
    assert flux_mm3(faces) == pytest.approx(flux_mm3(whole), rel=1e-6)
    (ours, theirs) = (pieces(each, relief.x_mm, relief.y_mm) for each in (faces, whole))
    assert ours.keys() == theirs.keys() and len(ours) > 1000


def test_any_way_to_a_part_gives_the_same_faces_and_untouched_tiles_none() -> None:
    line = timeline()
    relief = ChangedTiles(line.parts[0].grid)
    assert relief.take(line.at(0.0).part) == []
    times_s = np.random.default_rng(11).uniform(0, line.duration_s, 12)
    seen: dict[int, bytes] = dict(enumerate(data(relief)))
    for time_s in times_s:
        changed = relief.take(line.at(time_s).part)
        now = data(relief)
        assert {k for k, faces in enumerate(now) if faces != seen[k]} <= set(changed)
        seen = dict(enumerate(now))
        fresh = ChangedTiles(line.parts[0].grid)
        fresh.take(line.at(time_s).part)
        assert data(fresh) == now
    small = relief.take(line.at(4.0).part), relief.take(line.at(4.05).part)
    assert 0 < len(small[1]) < len(relief) / 2


def test_larger_cells_where_a_part_has_too_many_faces_and_narrow_last_tiles() -> None:
    line = timeline(Stock((60, 19.3, 20)), BALL)  # 129 rows: the second tile has one
    part = line.at(1e9)
    step = step_of(part, 3000)
    assert step > 1
    relief = ChangedTiles(part.part.grid, step)
    relief.take(part.part)
    assert flux_mm3(everything(relief)) == pytest.approx(flux_mm3(faces_of(part, 3000)), rel=1e-6)
    assert min(len(relief.faces(number)) for number in range(len(relief))) == 0


def test_drawn_faces_are_a_trifle_larger_and_coloured_by_depth() -> None:
    part = HeightMap(STOCK, 1.0)
    faces = drawn(faces_of(part), height_range_mm(part))
    assert faces.corners.dtype == np.float32 and faces.rgba.dtype == np.uint32
    assert faces.corners[..., 0].max() == pytest.approx(30.01) and faces.rgba.shape == (len(faces.corners), 4)
    assert (faces.rgba & 0xFF == 0xFF).all() and faces.rgba[0, 0] == 0xF3EAD7FF
