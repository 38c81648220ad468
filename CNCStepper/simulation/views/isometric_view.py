# SPDX-License-Identifier: LGPL-2.1-or-later
"""The isometric view: the part, and if wanted the path, the tool and the work surface, x, y and z to one scale.

The cut part as a shaded surface in isometric projection, x, y and z to one scale.

Seen from the right front above:            The quads of the surface are drawn from the back to
                                            the front (y falling, x rising), so that the nearer
        u = (x + y) / sqrt(2)               ones cover the farther; the front and right sides of
        v = (y - x + 2 z) / sqrt(6)         the block are two more rows of quads.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import product

import numpy as np
import shapely
from matplotlib.axes import Axes
from matplotlib.colors import Normalize
from matplotlib.patches import Polygon
from matplotlib.ticker import MaxNLocator

from CNCStepper.simulation.removal.heightmap import HeightMap
from CNCStepper.simulation.views.fallen_pieces import draw_fallen
from CNCStepper.simulation.views.picture_style import COLOURS, GREY, GROUND, MATERIAL_MAP, TEXTS, draw_path, number_text
from CNCStepper.simulation.views.scene import Scene
from CNCStepper.tolerances import NO_MATERIAL_MM

LIGHT = np.array([-0.35, -0.5, 0.8]) / np.linalg.norm([-0.35, -0.5, 0.8])
AMBIENT = 0.5
MOST_CELLS = 420  # along a side; more would not be seen
FRONT_SHADE, RIGHT_SHADE = 0.85, 0.66
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
    return np.maximum.reduce([z[:-1, :-1], z[:-1, 1:], z[1:, :-1], z[1:, 1:]]) <= bottom_mm + NO_MATERIAL_MM


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


SIDE = (0.84, 0.76, 0.62, 1.0)
MARGINS = np.array([[0.23, 0.06], [0.05, 0.02]])  # for the axes' numbers, in shares of the longest edge
ROUND = np.linspace(0, 2 * np.pi, 49)


def bounds(box_mm: np.ndarray, frame_mm: np.ndarray) -> np.ndarray:
    """Return low and high corner of the picture that shows a box, and the axes along a frame; float64[2, 2]."""
    corners = np.array([*product(*box_mm.T), *product(*frame_mm.T)])
    flat = _flat(corners)
    span = _span(frame_mm)
    return np.array([flat.min(axis=0) - span * MARGINS[0], flat.max(axis=0) + span * MARGINS[1]])


def frame_of(part: HeightMap, limits_mm: np.ndarray | None = None) -> np.ndarray:
    """Return the box with the axes on its edges: the stock, on the whole work surface where that is known."""
    frame = np.array([part.stock.low_mm, part.stock.high_mm])
    if limits_mm is not None:
        frame[0, :2], frame[1, :2] = limits_mm[0, :2], limits_mm[1, :2]
    return frame


def draw_part(axes: Axes, part: HeightMap, heights: Normalize) -> None:
    """Draw the shaded part."""
    u, v, colours = surface(part, lambda z: MATERIAL_MAP(heights(z)), SIDE)
    axes.pcolormesh(u, v, colours, edgecolors="none", antialiased=False, rasterized=True)


def draw_free(axes: Axes, scene: Scene) -> list[str]:
    """Draw the pieces that have been cut free, hatched on their top faces; return the names of what there is."""
    return draw_fallen(axes, scene.fallen, scene.part.stock.top_mm, _flat)


def draw_axes(axes: Axes, frame_mm: np.ndarray) -> None:
    """Draw the three scales along the edges of a box, and show all of `bounds` without a frame."""
    low, high = frame_mm
    right_foot = np.array([high[0], low[1], low[2]])
    for name, corner, axis, out in (
        ("X", low, 0, (0.0, -1.0, -0.5)),
        ("Y", right_foot, 1, (1.0, 0.0, -0.5)),
        ("Z", low, 2, (-0.75, -0.75, 0.0)),
    ):
        _axis(axes, name, corner, axis, float(high[axis]), _span(frame_mm) * np.array(out))
    axes.set_aspect("equal")
    axes.set_axis_off()


def draw_scene(axes: Axes, scene: Scene, heights: Normalize) -> list[str]:
    """Draw all of a scene; return the names of what there is, for the legend."""
    frame = frame_of(scene.part, scene.limits_mm)
    names = []
    if scene.limits_mm is not None:
        (left, front, bottom), (right, back, _) = frame
        floor = np.array([[left, front], [right, front], [right, back], [left, back]])
        axes.add_patch(
            Polygon(
                _flat(np.column_stack([floor, np.full(4, bottom)])),
                fc=GROUND,
                ec=COLOURS["limits"],
                ls=(0, (6, 3)),
                lw=1.2,
            )
        )
        names.append("limits")
    draw_part(axes, scene.part, heights)
    names += draw_free(axes, scene)
    names += draw_path(axes, scene.path((0, 1, 2)), _flat, plunge_lines=True)
    if scene.outlines and scene.tip_mm is not None:
        for outline, colour in zip(reversed(scene.outlines), ("shank", "cutter"), strict=True):
            axes.add_patch(Polygon(_silhouette(outline, scene.tip_mm), fc=COLOURS[colour], ec=GREY, lw=0.7, zorder=4))
        names.append("cutter")
    axes.plot(*_flat(np.zeros((1, 3))).T, "+", color=COLOURS["zero"], ms=12, mew=2.0, zorder=5)
    draw_axes(axes, frame)
    return [*names, "zero"]


def _silhouette(outline: np.ndarray, tip_mm: np.ndarray) -> np.ndarray:
    """Return the edge of a solid of revolution as it is seen: the hull of its circles, for each is convex."""
    circles = [
        np.column_stack([radius * np.cos(ROUND), radius * np.sin(ROUND), np.full(len(ROUND), height)])
        for radius, height in outline
    ]
    seen = _flat(np.vstack(circles) + tip_mm)
    return np.asarray(shapely.MultiPoint(seen).convex_hull.exterior.coords)


def _flat(points: np.ndarray) -> np.ndarray:
    return np.column_stack(projected(*points.T))


def _span(frame_mm: np.ndarray) -> float:
    return float((frame_mm[1] - frame_mm[0]).max())


def _axis(axes: Axes, name: str, corner: np.ndarray, axis: int, end: float, out: np.ndarray) -> None:
    """Draw the scale along an edge of the block: ticks and numbers in mm towards `out`, and the axis' name."""
    for value in _ticks(float(corner[axis]), end, float(np.abs(out).max())):
        start = corner.copy()
        start[axis] = value
        axes.plot(*_flat(np.stack([start, start + 0.015 * out])).T, color=GREY, lw=0.8)
        _text(axes, start + 0.042 * out, number_text(value), 9.0, GREY)
    middle = corner + 0.13 * out
    middle[axis] = (corner[axis] + end) / 2
    _text(axes, middle, TEXTS["axis"].format(name=name), 10.5, "black")


def _text(axes: Axes, point: np.ndarray, text: str, size: float, colour: str) -> None:
    ((u, v),) = _flat(point[None, :])
    axes.text(float(u), float(v), text, ha="center", va="center", fontsize=size, color=colour)


def _ticks(low: float, high: float, span: float) -> list[float]:
    """Return round values from low to high; an edge too short for several numbers gets its low end alone."""
    if high - low < 0.12 * span:
        return [low]
    count = max(2, min(6, int(8 * (high - low) / span)))
    values = MaxNLocator(count, steps=[1, 2, 2.5, 5, 10]).tick_values(low, high)
    return [float(value) for value in values if low - 1e-9 <= value <= high + 1e-9]
