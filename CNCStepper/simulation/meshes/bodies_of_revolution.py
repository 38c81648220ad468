# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies of revolution as faces for a 3D view."""

from __future__ import annotations

import numpy as np

AROUND = 32


def revolved(outline: np.ndarray) -> np.ndarray:
    """Return the faces of an outline turned about Z, float32[n, 4, 3], counter-clockwise from outside.

    outline: float64[n, 2], radius and height, from the lower end of the axis around the outside to its upper end.
    """
    angle = np.linspace(0, 2 * np.pi, AROUND + 1)
    around = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    points = np.empty((len(outline), AROUND + 1, 3))
    points[..., :2] = outline[:, None, :1] * around[None]
    points[..., 2] = outline[:, None, 1]
    corners = np.stack([points[:-1, :-1], points[:-1, 1:], points[1:, 1:], points[1:, :-1]], axis=2)
    return corners.reshape(-1, 4, 3).astype(np.float32)
