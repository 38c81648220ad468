# SPDX-License-Identifier: LGPL-2.1-or-later
"""The colours of depths in pictures and the 3D view, from the deepest cut up to the top."""

from __future__ import annotations

import numpy as np

MATERIAL = ("#2f6f9f", "#7fb3d0", "#cfe0dc", "#f3ead7")
WALL = (214.0, 194.0, 158.0)
LIGHT = (-0.46, -0.58, 0.67)  # direction of the light: over the left shoulder of a person in front of the machine
CONTRAST = 0.4


def colours_of(height_mm: np.ndarray, deepest_mm: float, top_mm: float) -> np.ndarray:
    """Return the colour of every height as red, green, blue from 0 to 255: uint8[..., 3]."""
    share = np.clip((np.asarray(height_mm, float) - deepest_mm) / (top_mm - deepest_mm), 0.0, 1.0)
    stops = np.array([tuple(bytes.fromhex(colour[1:])) for colour in MATERIAL], float)
    places = np.linspace(0.0, 1.0, len(stops))
    mixed = np.stack([np.interp(share, places, stops[:, part]) for part in range(3)], axis=-1)
    return np.rint(mixed).astype(np.uint8)


def deepest_shown_mm(lowest_mm: float, bottom_mm: float, top_mm: float) -> float:
    """Return the lower end of the colour scale: the deepest cut, or a little below the top where nothing is cut."""
    deepest = max(lowest_mm, bottom_mm)
    return deepest if deepest < top_mm else top_mm - 1.0


def shaded(corners: np.ndarray, normals: np.ndarray, deepest_mm: float, top_mm: float) -> np.ndarray:
    """Return the colours of the corners of faces, uint8[n, 4, 3]; those of level faces are exactly the scale's.

    corners: float32[n, 4, 3]. normals: float32[n, 3]. The steeper a face, the more it has the colour of a wall.
    """
    level = np.abs(normals[:, 2])[:, None, None]
    colour = level * colours_of(corners[..., 2], deepest_mm, top_mm) + (1 - level) * np.array(WALL)
    light = 1 + CONTRAST * (normals @ np.array(LIGHT) - LIGHT[2])
    return np.clip(np.rint(colour * light[:, None, None]), 0, 255).astype(np.uint8)
