# SPDX-License-Identifier: LGPL-2.1-or-later
"""A turned part as a closed mesh: its half section turned about Z in equal steps.

The corners of the mesh lie on the part's circles, so that its diameters are true and its volume is a little small.
"""

from __future__ import annotations

import numpy as np
import shapely

from CNCStepper.simulation.meshes.revolved_section import ON_AXIS_MM, drawn
from CNCStepper.simulation.meshes.stl_mesh import Mesh
from CNCStepper.simulation.turning.half_section import HalfSection

AROUND = 180  # corners of each circle


def turned_mesh(section: HalfSection, around: int = AROUND) -> Mesh:
    """Return the mesh of a part, X and Y about the axis Z; its outline is the section's within what a view shows."""
    parts = shapely.orient_polygons(shapely.get_parts(drawn(section.region)), exterior_cw=False)
    points, triangles, first = [np.zeros((0, 3))], [np.zeros((0, 3), int)], 0
    for ring in shapely.get_rings(parts):
        own, faces = _turned(np.asarray(ring.coords, float)[:-1], around)
        points.append(own)
        triangles.append(faces + first)
        first += len(own)
    return Mesh(np.concatenate(points), np.concatenate(triangles))


def _turned(corners: np.ndarray, around: int) -> tuple[np.ndarray, np.ndarray]:
    """Return points and triangles of a ring of corners (z, r) turned about the axis, where a corner is one point."""
    on_axis = corners[:, 1] <= ON_AXIS_MM
    counts = np.where(on_axis, 1, around)
    begins = np.cumsum(counts) - counts
    which = np.repeat(np.arange(len(corners)), counts)
    angle = 2 * np.pi * (np.arange(len(which)) - begins[which]) / around
    z, r = corners[which, 0], np.where(on_axis, 0.0, corners[:, 1])[which]
    points = np.column_stack([r * np.cos(angle), r * np.sin(angle), z])
    steps = np.arange(around)
    numbers = begins[:, None] + np.where(on_axis[:, None], 0, steps)
    here, after = numbers, np.roll(numbers, -1, axis=0)
    next_here, next_after = np.roll(here, -1, axis=1), np.roll(after, -1, axis=1)
    faces = np.stack([here, after, next_here, after, next_after, next_here], axis=2).reshape(-1, 3)
    distinct = (faces[:, 0] != faces[:, 1]) & (faces[:, 1] != faces[:, 2]) & (faces[:, 0] != faces[:, 2])
    return points, faces[distinct]
