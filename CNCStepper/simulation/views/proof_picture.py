# SPDX-License-Identifier: LGPL-2.1-or-later
"""The picture of a program: the cut part in isometric view, and its depth with the tool's path from above."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

from CNCStepper.quantities import duration_text
from CNCStepper.simulation.removal.heightmap import HeightMap
from CNCStepper.simulation.removal.timeline import TimelinePosition
from CNCStepper.simulation.views import isometric_view
from CNCStepper.simulation.views.fallen_pieces import draw_fallen
from CNCStepper.simulation.views.flat_views import draw_depths
from CNCStepper.simulation.views.path_lines import DrawnPath
from CNCStepper.simulation.views.picture_style import (
    COLOURS,
    TEXTS,
    draw_path,
    head,
    heights_scale,
    legend,
    new_figure,
    save_figure,
)
from CNCStepper.simulation.views.scene import Scene

WIDTH_INCH = 16.0
HEAD_INCH, FOOT_INCH = 1.35, 1.15
LEFT, LEFT_WIDTH = 0.32, 7.36  # of the isometric view, in inches
RIGHT, RIGHT_WIDTH = 8.8, 5.76  # and of the plan
MOST_INCH = 6.1


def save_picture(file: Path, scene: Scene, title: str = "", facts: list[str] | None = None) -> None:
    """Write a program's picture as PNG or SVG, 1600 pixels wide and as high as its two views.

    facts: the lines of the head below the title, as of `facts_of`.
    """
    path = scene.path((0, 1))
    frame = isometric_view.frame_of(scene.part)
    isometric, plan = isometric_view.bounds(frame, frame), _plan_bounds(scene.part, path)
    sizes = [_fitted(isometric, LEFT_WIDTH), _fitted(plan, RIGHT_WIDTH)]
    content = max(height for _, height in sizes)
    figure = new_figure(WIDTH_INCH, HEAD_INCH + content + FOOT_INCH)
    head(figure, title, facts or [])
    _draw_isometric(figure, scene, isometric, _box(figure, LEFT, LEFT_WIDTH, sizes[0], content))
    _draw_plan(figure, scene, path, plan, _box(figure, RIGHT, RIGHT_WIDTH, sizes[1], content))
    save_figure(figure, file)


def facts_of(scene: Scene, tools: str, time_s: float, moment: TimelinePosition | None = None) -> list[str]:
    """Return the lines of a picture's head: tools, time, moves, stock, volume. tools: in words, "flat 6 mm"."""
    size, whole = scene.part.stock.size_mm, duration_text(time_s)
    at = moment and TEXTS["moment"].format(text=duration_text(moment.time_s), whole=whole, line=moment.line)
    return [
        TEXTS["tool"].format(text=tools) if tools else "",
        at or TEXTS["time"].format(text=whole),
        TEXTS["moves"].format(count=f"{len(scene.toolpath):,}".replace(",", " ")),
        TEXTS["stock"].format(x=size[0], y=size[1], z=size[2]),
        TEXTS["volume"].format(volume=scene.part.removed_volume_mm3 / 1000),
    ]


def _fitted(bounds: np.ndarray, width_inch: float) -> tuple[float, float]:
    """Return the largest size in inches in which both directions have one scale."""
    width_mm, height_mm = bounds[1] - bounds[0]
    scale = min(width_inch / width_mm, MOST_INCH / height_mm)
    return scale * width_mm, scale * height_mm


def _box(
    figure: Figure, left: float, width: float, size: tuple[float, float], content: float
) -> tuple[float, float, float, float]:
    """Return where a view of that size lies, in shares of the figure: in the middle of its place."""
    whole = figure.get_size_inches()
    foot = FOOT_INCH + (content - size[1]) / 2
    x, y, w, h = np.array([left + (width - size[0]) / 2, foot, *size]) / np.tile(whole, 2)
    return float(x), float(y), float(w), float(h)


def _heading(figure: Figure, box: tuple[float, float, float, float], text: str) -> None:
    height = figure.get_size_inches()[1]
    figure.text(box[0] + box[2] / 2, 1 - 1.17 / height, text, fontsize=12.5, ha="center")


def _draw_isometric(figure: Figure, scene: Scene, bounds: np.ndarray, box: tuple[float, float, float, float]) -> None:
    axes = figure.add_axes(box)
    isometric_view.draw_part(axes, scene.part, heights_scale(scene.part))
    isometric_view.draw_free(axes, scene)
    isometric_view.draw_axes(axes, isometric_view.frame_of(scene.part))
    axes.set(xlim=bounds[:, 0], ylim=bounds[:, 1])
    _heading(figure, box, TEXTS["isometric"])


def _draw_plan(
    figure: Figure, scene: Scene, path: DrawnPath, bounds: np.ndarray, box: tuple[float, float, float, float]
) -> None:
    axes = figure.add_axes(box)
    image = draw_depths(axes, scene.part, heights_scale(scene.part))
    names = draw_fallen(axes, scene.fallen, scene.part.stock.top_mm, lambda points: points[:, :2])
    names += draw_path(axes, path, lambda points: points[:, :2], plunge_lines=False)
    axes.plot(0, 0, "+", color=COLOURS["zero"], ms=14, mew=2.0, clip_on=False)
    axes.set(xlabel=TEXTS["axis"].format(name="X"), ylabel=TEXTS["axis"].format(name="Y"))
    axes.set(xlim=bounds[:, 0], ylim=bounds[:, 1])
    _heading(figure, box, TEXTS["plan"])
    scale = figure.colorbar(image, cax=figure.add_axes((box[0] + box[2] + 0.014, box[1], 0.011, box[3])))
    scale.set_label(TEXTS["height"])
    legend(figure, [*names, "zero"], box[0] + box[2] / 2, 0.25)


def _plan_bounds(part: HeightMap, path: DrawnPath) -> np.ndarray:
    """Return the corners of the plan view: the stock, and the path beside it up to half the stock's length."""
    low, high = np.array(part.stock.low_mm[:2]), np.array(part.stock.high_mm[:2])
    span = float(max(high - low))
    points = np.vstack([path.points_mm[:, :2], low, high])
    margin = np.where((points < low).any(axis=0) | (points > high).any(axis=0), 0.03 * span, 0.0)
    return np.array(
        [
            np.maximum(points.min(axis=0) - margin, low - span / 2),
            np.minimum(points.max(axis=0) + margin, high + span / 2),
        ]
    )
