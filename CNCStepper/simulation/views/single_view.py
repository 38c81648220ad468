# SPDX-License-Identifier: LGPL-2.1-or-later
"""One view of a program as a picture of its own."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

from CNCStepper.simulation.views import flat_views, isometric_view
from CNCStepper.simulation.views.path_lines import FROM_ABOVE
from CNCStepper.simulation.views.picture_style import TEXTS, head, heights_scale, legend, new_figure, save_figure
from CNCStepper.simulation.views.scene import Scene

VIEWS = ("isometric", "xy", "zy", "depth")
WIDTH_INCH = 11.0
HEAD_INCH, FOOT_INCH = 1.45, {"isometric": 0.6, "xy": 1.05, "zy": 1.05, "depth": 1.05}
LEFT_INCH, RIGHT_INCH, SCALE_INCH = 0.9, 0.45, 0.9  # SCALE: what the colours' scale needs more on the right
MOST_INCH, LEAST_INCH = 7.5, 1.0  # height of the view itself


def save_view(file: Path, view: str, scene: Scene, title: str, facts: Iterable[str]) -> None:
    """Write one of VIEWS as PNG or SVG, with a title and facts above it; raises JobError for another kind of file."""
    figure = view_figure(view, scene)
    draw_view(figure, view, scene, title, facts)
    save_figure(figure, file)


def _bounds(view: str, scene: Scene) -> np.ndarray:
    """Return low and high corner of the view, float64[2, 2]: the same at every time of a program."""
    if view == "isometric":
        return isometric_view.bounds(scene.box_mm, isometric_view.frame_of(scene.part, scene.limits_mm))
    stock = scene.part.stock
    box = np.array([stock.low_mm, stock.high_mm]) if view == "depth" else scene.box_mm.copy()
    box[1, 2] += scene.tallest_mm  # seen from the side a cutter is shown whole, wherever it stands
    if scene.limits_mm is not None and view != "depth":
        box = np.array([np.minimum(box[0], scene.limits_mm[0]), np.maximum(box[1], scene.limits_mm[1])])
    return flat_views.bounds(box, flat_views.FROM_SIDE if view == "zy" else FROM_ABOVE)


def _size_inch(view: str, scene: Scene) -> tuple[float, float]:
    """Return how large the view itself is drawn."""
    low, high = _bounds(view, scene)
    width = WIDTH_INCH - LEFT_INCH - RIGHT_INCH - (SCALE_INCH if view == "depth" else 0.0)
    scale = min(width / (high[0] - low[0]), MOST_INCH / (high[1] - low[1]))
    return scale * (high[0] - low[0]), scale * (high[1] - low[1])


def view_figure(view: str, scene: Scene) -> Figure:
    """Return an empty figure in which the view fits exactly between head and foot."""
    return new_figure(WIDTH_INCH, HEAD_INCH + max(_size_inch(view, scene)[1], LEAST_INCH) + FOOT_INCH[view])


def draw_view(figure: Figure, view: str, scene: Scene, title: str, facts: Iterable[str]) -> None:
    """Draw one of VIEWS into a figure of `view_figure`, with a title and facts above it."""
    size, whole = np.array(_size_inch(view, scene)), figure.get_size_inches()
    free = (WIDTH_INCH - LEFT_INCH - RIGHT_INCH - (SCALE_INCH if view == "depth" else 0.0)) - size[0]
    middle = FOOT_INCH[view] + (whole[1] - HEAD_INCH - FOOT_INCH[view] - size[1]) / 2
    left, foot, width, height = np.array([LEFT_INCH + free / 2, middle, *size]) / np.tile(whole, 2)
    axes = figure.add_axes((left, foot, width, height))
    heights = heights_scale(scene.part, scene.deepest_mm)
    if view == "isometric":
        names = isometric_view.draw_scene(axes, scene, heights)
    elif view == "depth":
        image, names = flat_views.draw_depth_map(axes, scene, heights)
        box = (left + width + 0.2 / whole[0], foot, 0.18 / whole[0], height)
        figure.colorbar(image, cax=figure.add_axes(box)).set_label(TEXTS["height"])
    else:
        names = (flat_views.draw_from_side if view == "zy" else flat_views.draw_from_above)(axes, scene)
    low, high = _bounds(view, scene)
    axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]))
    head(figure, title, facts)
    figure.text(left + width / 2, 1 - 1.2 / whole[1], TEXTS[view], fontsize=12.5, ha="center")
    legend(figure, names, 0.5, 0.18)
