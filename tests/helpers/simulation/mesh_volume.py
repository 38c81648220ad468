# SPDX-License-Identifier: LGPL-2.1-or-later
"""The volume of a mesh by the theorem of Gauss."""

from __future__ import annotations

import numpy as np

from CNCStepper.simulation.meshes.mesh_faces import Faces


def flux_mm3(faces: Faces) -> float:
    """Return the volume that closed faces enclose when all are turned outwards (divergence theorem)."""
    corners = faces.corners.astype(float)
    area = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1]) / 2
    return float((corners.mean(axis=1) * area).sum() / 3)
