# SPDX-License-Identifier: LGPL-2.1-or-later
"""The isometric view: the part, and if wanted the path, the tool and the work surface, x, y and z to one scale."""

from __future__ import annotations

from itertools import product

import numpy as np
import shapely
from matplotlib.axes import Axes
from matplotlib.colors import Normalize
from matplotlib.patches import Polygon
from matplotlib.ticker import MaxNLocator

from CNCStepper.simulation.removal.heightmap import HeightMap
from CNCStepper.simulation.views.isometric_projection import projected, surface
from CNCStepper.simulation.views.picture_style import COLOURS, GREY, GROUND, MATERIAL_MAP, TEXTS, draw_path, number_text
from CNCStepper.simulation.views.scene import Scene

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
