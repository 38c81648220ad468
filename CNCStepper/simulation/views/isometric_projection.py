# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cut part as a shaded surface in isometric projection, x, y and z to one scale.

Seen from the right front above:            The quads of the surface are drawn from the back to
                                            the front (y falling, x rising), so that the nearer
        u = (x + y) / sqrt(2)               ones cover the farther; the front and right sides of
        v = (y - x + 2 z) / sqrt(6)         the block are two more rows of quads.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from CNCStepper.simulation.removal.heightmap import HeightMap

LIGHT = np.array([-0.35, -0.5, 0.8]) / np.linalg.norm([-0.35, -0.5, 0.8])
AMBIENT = 0.5
MOST_CELLS = 420  # along a side; more would not be seen
FRONT_SHADE, RIGHT_SHADE = 0.85, 0.66
GONE_MM = 1e-6  # material that is thinner is none
SMOOTHINGS = 3  # of the heights before they are shaded: a round wall in square cells would look striped


def projected(x, y, z) -> tuple[np.ndarray, np.ndarray]:
    """Return the picture's coordinates u, v of points in mm."""
    x, y, z = np.asarray(x, float), np.asarray(y, float), np.asarray(z, float)
    return (x + y) / np.sqrt(2), (y - x + 2 * z) / np.sqrt(6)


def surface(
    part: HeightMap, colour_of: Callable[[np.ndarray], np.ndarray], side_colour: tuple[float, ...]
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return u, v of the surface's corners and the shaded colours of its quads, back to front.

    colour_of: RGBA float64[..., 4] of heights. side_colour: RGBA of the block's sides.
    """
    x, y, z = _closed_grid(part)
    smooth = _smoothed(z[:-1, :-1])
    slopes = _slopes(smooth, x[0, :-1], y[:-1, 0])
    shade = AMBIENT + (1 - AMBIENT) * np.clip(slopes @ LIGHT, 0.0, 1.0)
    colours = colour_of((smooth + z[:-1, :-1]) / 2)
    colours[..., :3] *= shade[..., None]
    colours[..., 3] = np.where(_is_floor(z, part.stock.bottom_mm), 0.0, colours[..., 3])
    colours[-1, :] = colours[:, -1] = side_colour
    colours[-1, :, :3] *= FRONT_SHADE
    colours[:, -1, :3] *= RIGHT_SHADE
    return *projected(x, y, z), np.clip(colours, 0.0, 1.0)


def _is_floor(z: np.ndarray, bottom_mm: float) -> np.ndarray:
    """Return the quads at whose four corners no material is left: there one looks through the part."""
    return np.maximum.reduce([z[:-1, :-1], z[:-1, 1:], z[1:, :-1], z[1:, 1:]]) <= bottom_mm + GONE_MM


def _smoothed(z: np.ndarray) -> np.ndarray:
    for _ in range(SMOOTHINGS):
        z = np.pad(z, 1, mode="edge")
        z = (z[:-2] + 2 * z[1:-1] + z[2:]) / 4
        z = (z[:, :-2] + 2 * z[:, 1:-1] + z[:, 2:]) / 4
    return z


def _slopes(z: np.ndarray, x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """Return the unit normals of the surface, float64[rows, columns, 3]."""
    along_y, along_x = np.gradient(z, y, x)
    normal = np.stack([-along_x, -along_y, np.ones_like(z)], axis=2)
    return normal / np.linalg.norm(normal, axis=2, keepdims=True)


def _closed_grid(part: HeightMap) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the corners of the surface: cell centres, stretched to the stock's edges, y falling, and the foot.

    The last row and column lie at the bottom of the front and the right side.
    """
    step = int(np.ceil(max(part.heights_mm.shape) / MOST_CELLS))
    low, high = part.stock.low_mm, part.stock.high_mm
    x = np.r_[low[0], part.x_mm[step // 2 :: step], high[0], high[0]]
    y = np.r_[high[1], part.y_mm[step // 2 :: step][::-1], low[1], low[1]]
    inner = np.maximum(part.heights_mm[step // 2 :: step, step // 2 :: step][::-1], part.stock.bottom_mm)
    z = np.pad(np.pad(inner, 1, mode="edge"), ((0, 1), (0, 1)), constant_values=part.stock.bottom_mm)
    grid_x, grid_y = np.meshgrid(x, y)
    return grid_x, grid_y, z
