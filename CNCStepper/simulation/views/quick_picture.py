# SPDX-License-Identifier: LGPL-2.1-or-later
"""The first picture of a part: its depths from above, lit from the left, there before anything is judged.

It is not drawn by matplotlib, whose import and drawing take longer than to read and cut most programs.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
from PIL import Image
from PIL.PngImagePlugin import PngInfo

from CNCStepper.atomic_file import whole_file
from CNCStepper.simulation.removal.heightmap import HeightMap
from CNCStepper.simulation.views.depth_colours import CONTRAST, LIGHT, colours_of, deepest_shown_mm

LONG_SIDE = 900  # pixels
QUICKLY = 1  # of zlib's levels 1 to 9


def save_first_picture(file: Path, part: HeightMap) -> None:
    """Write the heights of a part by their colours as PNG, x to the right and y upwards, LONG_SIDE pixels long."""
    picture = Image.fromarray(_lit(part)[::-1])
    scale = LONG_SIDE / max(part.stock.size_mm[:2])
    x, y = (max(round(length * scale), 1) for length in part.stock.size_mm[:2])
    about = PngInfo()
    about.add_text("Software", "CNCStepper")
    with whole_file(file) as out:
        small = picture.resize((x, y), Image.Resampling.BILINEAR)
        small.save(out, format="PNG", compress_level=QUICKLY, pnginfo=about)


def _lit(part: HeightMap) -> np.ndarray:
    """Return the colour of each cell, darker where it slopes away from the light, uint8[rows, columns, 3]."""
    bottom, top = part.stock.bottom_mm, part.stock.top_mm
    heights = np.maximum(part.heights_mm, bottom)
    along = [_slope(heights, axis, cell) for axis, cell in zip((1, 0), part.cell_mm, strict=True)]
    length = np.sqrt(1 + along[0] ** 2 + along[1] ** 2)
    towards_light = (LIGHT[2] - LIGHT[0] * along[0] - LIGHT[1] * along[1]) / length
    light = 1 + CONTRAST * (towards_light - LIGHT[2])
    colours = colours_of(heights, deepest_shown_mm(float(heights.min()), bottom, top), top)
    return np.clip(colours * light[..., None], 0, 255).astype(np.uint8)


def _slope(heights: np.ndarray, axis: int, cell_mm: float) -> np.ndarray:
    """Return the slope along an axis; a part that is one cell wide has none."""
    return np.gradient(heights, cell_mm, axis=axis) if heights.shape[axis] > 1 else np.zeros_like(heights)
