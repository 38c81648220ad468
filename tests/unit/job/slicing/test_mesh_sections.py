# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sections and volumes of meshes beside trimesh's own, height for height."""

from __future__ import annotations

import numpy as np
import pytest
import shapely
import trimesh

from CNCStepper.job.slicing.sections import AXES, mesh_sections, section_area, volume_mm3
from helpers.solids.closed_meshes import hull_with_cavities, sphere, thin_wall

SOLIDS = {"sphere": sphere(20.0, rings=40), "hull": hull_with_cavities(), "wall": thin_wall()}
HEIGHTS, POINTS = 12, 500


def solid_of(mesh: np.ndarray) -> trimesh.Trimesh:
    return trimesh.Trimesh(mesh.reshape(-1, 3), np.arange(3 * len(mesh)).reshape(-1, 3), process=False)


def lines_at(mesh: np.ndarray, heights_mm: np.ndarray) -> list[np.ndarray]:
    """Return the lines in which trimesh's planes cut a mesh, float64[n, 2, 2] for each height."""
    up = np.array([0.0, 0.0, 1.0])
    found, _, _ = trimesh.intersections.mesh_multiplane(solid_of(mesh), np.zeros(3), up, heights_mm)
    return list(found)


def held(lines: np.ndarray, points: np.ndarray) -> np.ndarray:
    """Return which points, float64[k, 2], have an odd number of lines to their right."""
    (x0, y0), (x1, y1) = lines[:, 0].T, lines[:, 1].T
    x, y = points[:, :1], points[:, 1:]
    spans = (y0 > y) != (y1 > y)
    with np.errstate(divide="ignore", invalid="ignore"):
        across_mm = x0 + (y - y0) / (y1 - y0) * (x1 - x0)
    return np.count_nonzero(spans & (across_mm > x), axis=1) % 2 == 1


@pytest.mark.parametrize("axis", "xyz")
@pytest.mark.parametrize("name", SOLIDS)
def test_sections_hold_the_points_that_those_of_trimesh_hold(name: str, axis: str) -> None:
    mesh, rng = SOLIDS[name][:, :, AXES[axis]], np.random.default_rng(5)
    low_mm, high_mm = mesh.min(axis=(0, 1)), mesh.max(axis=(0, 1))
    heights_mm = rng.uniform(low_mm[2], high_mm[2], HEIGHTS)
    inside = 0
    for height_mm, lines in zip(heights_mm, lines_at(mesh, heights_mm), strict=True):
        area = section_area(mesh, height_mm)
        near = shapely.get_coordinates(shapely.segmentize(area.boundary, 0.5))
        points = np.concatenate(
            [rng.uniform(low_mm[:2], high_mm[:2], (POINTS, 2)), near + rng.normal(0, 0.05, near.shape)]
        )
        wanted = held(lines, points)
        assert (shapely.contains_xy(area, *points.T) == wanted).all(), height_mm
        inside += int(wanted.sum())
    assert inside > HEIGHTS * 20


@pytest.mark.parametrize("name", SOLIDS)
def test_volumes_are_those_of_trimesh(name: str) -> None:
    mesh = SOLIDS[name]
    volume = abs(solid_of(mesh).volume)
    assert volume_mm3(mesh) == pytest.approx(volume) == pytest.approx(mesh_sections(mesh, "z", 1.0).volume_mm3)
