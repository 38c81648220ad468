# SPDX-License-Identifier: LGPL-2.1-or-later
"""Turned sections as strips and as closed meshes, against volumes and areas by hand."""

from __future__ import annotations

from collections import Counter

import numpy as np
import pytest
import shapely

from CNCStepper.simulation.meshes.revolved_section import (
    Strips,
    edges_of,
    plate,
    revolved_edges,
    revolved_strips,
    section_faces,
)
from CNCStepper.simulation.meshes.turned_mesh import turned_mesh
from CNCStepper.simulation.turning.half_section import HalfSection, bar

TUBE = bar(40, 60, 0, 10)
RING = HalfSection(shapely.box(0, 2, 20, 18).difference(shapely.Point(10, 10).buffer(4)))


def triangles(strips: Strips) -> np.ndarray:
    """Return the triangles of strips, each counter-clockwise as drawn, float64[n, 3, 3]."""
    found, first = [], 0
    for count in strips.counts.tolist():
        for k in range(first, first + count - 2):
            a, b, c = (0, 1, 2) if (k - first) % 2 == 0 else (1, 0, 2)
            found.append(strips.points[[k + a, k + b, k + c]])
        first += count
    return np.array(found, float)


def volume(strips: Strips) -> float:
    a, b, c = triangles(strips).transpose(1, 0, 2)
    return float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6)


@pytest.mark.parametrize("open_deg", [0.0, 90.0, 180.0])
@pytest.mark.parametrize("section", [TUBE, RING, bar(30, 50)])
def test_the_strips_enclose_the_part_that_is_left(section: HalfSection, open_deg: float) -> None:
    whole = section.volume_mm3 * (360.0 - open_deg) / 360.0
    assert volume(revolved_strips(section.region, open_deg)) == pytest.approx(whole, rel=2e-3)


def test_normals_point_out_of_the_part() -> None:
    strips = revolved_edges(edges_of(TUBE.region), 90.0)
    outside = np.hypot(*strips.points[:, :2].T) > 15
    along = np.einsum("ij,ij->i", strips.points[:, :2], strips.normals[:, :2])
    sides = np.abs(strips.normals[:, 2]) < 0.5
    assert (along[outside & sides] > 0).all()
    assert (along[~outside & sides] < 0).all()


def test_the_section_faces_have_the_area_of_the_section() -> None:
    a, b, c = triangles(section_faces(RING.region, 90.0)).transpose(1, 0, 2)
    assert np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2 == pytest.approx(2 * RING.region.area, rel=1e-6)
    assert len(section_faces(RING.region, 0.0).counts) == 0


def test_a_plate_stands_on_its_outline_across_the_axis() -> None:
    strips = plate(shapely.box(-3, -2, 5, 4), 0.0, 5.0)
    assert strips.points[:, 1].tolist().count(0.0) == 6 + 8
    assert strips.points.min(axis=0).tolist() == [-2, -5, -3]
    assert strips.points.max(axis=0).tolist() == [4, 0, 5]
    assert volume(strips) == pytest.approx(8 * 6 * 5 / 3 * 2)  # without its lower face, which the origin does not see


@pytest.mark.parametrize("section", [TUBE, RING, bar(30, 50), HalfSection(shapely.Polygon([(0, 0), (10, 0), (0, 8)]))])
def test_a_mesh_is_closed_and_has_the_volume(section: HalfSection) -> None:
    mesh = turned_mesh(section)
    edges = Counter(
        tuple(edge)
        for triangle in mesh.triangles.tolist()
        for edge in zip(triangle, np.roll(triangle, -1), strict=True)
    )
    assert all(edges[(b, a)] == count == 1 for (a, b), count in edges.items())
    assert mesh.volume_mm3 == pytest.approx(section.volume_mm3, rel=5e-4)
