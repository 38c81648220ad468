# SPDX-License-Identifier: LGPL-2.1-or-later
"""The faces of a cut part: closed, turned outwards, exact in volume, and few."""

from __future__ import annotations

import numpy as np
import pytest

from CNCStepper.machine.tools.tool_profile import Form
from CNCStepper.simulation.meshes.mesh_faces import Faces, faces_of
from CNCStepper.simulation.removal.heightmap import HeightMap
from CNCStepper.simulation.stock import Stock
from CNCStepper.simulation.tip_segments import Segments
from helpers.simulation.mesh_volume import flux_mm3


def cut(*ends: tuple[float, float, float], form: Form, cell_mm: float = 0.1) -> HeightMap:
    part = HeightMap(Stock((20, 14, 5)), cell_mm)
    points = np.array(ends, float)
    part.cut(form, Segments(points[:-1], points[1:], np.zeros(len(points) - 1, np.int64)))
    return part


def outward(faces: Faces) -> np.ndarray:
    corners = faces.corners.astype(float)
    area = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
    return (faces.normals * area).sum(axis=1) / np.linalg.norm(area, axis=1)


@pytest.mark.parametrize(
    "ends, form",
    [
        ((), Form(3, 3)),
        (((-4, 0, -2), (4, 1, -2)), Form(3, 3)),
        (((-4, 0, -1), (4, 3, -3)), Form(2, 0, 2)),
        (((-4, 0, -6), (4, 0, -6)), Form(3, 3)),
        (((-12, -8, -2), (12, 8, -1)), Form(1.5, 1.5)),
    ],
    ids=["whole", "slot", "ball", "through", "across"],
)
def test_they_close_the_part_and_look_outwards(ends: tuple, form: Form) -> None:
    part = cut(*ends, form=form) if ends else HeightMap(Stock((20, 14, 5)), 0.1)
    faces = faces_of(part, most=10**9)
    length, width, height = part.stock.size_mm
    solid_mm3 = length * width * height - part.removed_volume_mm3  # which counts shares of cells
    assert flux_mm3(faces) == pytest.approx(solid_mm3, rel=2e-4)
    assert (outward(faces) > 0).all()
    assert np.linalg.norm(faces.normals, axis=1) == pytest.approx(1, abs=1e-5)


def test_flat_parts_have_few_faces_and_rough_ones_no_more_than_asked() -> None:
    assert len(faces_of(HeightMap(Stock((20, 14, 5)), 0.1))) == 6
    slot = cut((-4, 0, -2), (4, 0, -2), form=Form(3, 3))
    assert len(faces_of(slot)) < 400
    rough = cut((-9, -6, -1), (9, 6, -3), form=Form(5, 0, 5))
    assert 1000 < len(faces_of(rough, 5000)) <= 5000 < len(faces_of(rough, 10**9))


def test_a_round_wall_is_shaded_round_and_a_ramp_as_a_ramp() -> None:
    hole = cut((0, 0, -4), (0, 0, -4), form=Form(5, 5))
    faces = faces_of(hole)
    middle = faces.corners.mean(axis=1)
    wall = (np.abs(np.ptp(faces.corners[:, :, 2], axis=1) - 4) < 1e-3) & (np.hypot(*middle[:, :2].T) < 6)
    towards_axis = -middle[wall, :2] / np.linalg.norm(middle[wall, :2], axis=1, keepdims=True)
    assert ((faces.normals[wall, :2] * towards_axis).sum(axis=1) > 0.9).mean() > 0.9
    ramp = faces_of(cut((-30, 0, 0), (30, 0, -6), form=Form(30, 30)), 10**9)
    level = (np.ptp(ramp.corners[:, :, 2], axis=1) < 1e-6) & (ramp.normals[:, 2] > 0)
    assert np.median(ramp.normals[level, 0] / ramp.normals[level, 2]) == pytest.approx(0.1, abs=0.01)
