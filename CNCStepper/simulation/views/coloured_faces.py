# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faces as a 3D view takes them, coloured by depth: nothing is left to compute where they are shown."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from CNCStepper.simulation.meshes.mesh_faces import Faces
from CNCStepper.simulation.removal.heightmap import HeightMap
from CNCStepper.simulation.views.depth_colours import deepest_shown_mm, shaded

LAP_MM = 0.01  # where a long face meets several short ones no light shines through


class DrawnFaces(NamedTuple):
    """corners: float32[n, 4, 3], mm, counter-clockwise from outside. rgba: uint32[n, 4], a colour for every corner."""

    corners: np.ndarray
    rgba: np.ndarray


def height_range_mm(part: HeightMap) -> tuple[float, float]:
    """Return the heights at the two ends of the colour scale of a part, and of all parts that it went through."""
    stock = part.stock
    return deepest_shown_mm(float(part.heights_mm.min()), stock.bottom_mm, stock.top_mm), stock.top_mm


def drawn(faces: Faces, range_mm: tuple[float, float]) -> DrawnFaces:
    """Return faces a trifle larger, with the colours of a scale between two heights."""
    outward = np.sign(faces.corners - faces.corners.mean(axis=1, keepdims=True))
    rgb = shaded(faces.corners, faces.normals, *range_mm).astype(np.uint32)
    rgba = rgb[..., 0] << 24 | rgb[..., 1] << 16 | rgb[..., 2] << 8 | 0xFF
    return DrawnFaces((faces.corners + LAP_MM * outward).astype(np.float32), rgba)
