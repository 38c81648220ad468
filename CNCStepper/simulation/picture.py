# SPDX-License-Identifier: LGPL-2.1-or-later
"""The picture of a program: the cut part in isometric view, and its depth with the tool's path from above.

Only the Agg canvas and Figure objects are used, never pyplot: several pictures may be made at once,
inside FreeCAD too.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import LineCollection
from matplotlib.colors import LinearSegmentedColormap, Normalize
from matplotlib.figure import Figure
from matplotlib.image import imsave
from matplotlib.lines import Line2D
from matplotlib.ticker import MaxNLocator

from CNCStepper.simulation.depth_colours import MATERIAL, deepest_shown_mm
from CNCStepper.simulation.heightmap import HeightMap
from CNCStepper.simulation.isometric import projected, surface
from CNCStepper.simulation.paths import DrawnPath, drawn_path
from CNCStepper.toolpath import Toolpath

TEXTS = {
    "isometric": "Isometric view",
    "plan": "Depth and tool path, seen from above",
    "axis": "{name} (mm)",
    "height": "height above the stock's top face (mm)",
    "rapids": "rapid",
    "feeds": "feed",
    "arcs": "arc",
    "plunges": "plunge",
    "zero": "work zero",
    "tool": "tool {text}",
    "time": "time {text}",
    "moves": "{count} moves",
    "stock": "stock {x:g} × {y:g} × {z:g} mm",
    "volume": "removed {volume:.4g} cm³",
}
SIZE_INCH = (16.0, 8.6)
DPI = 100
FINER = 2  # drawn that many times larger, then averaged: the surface's quads are not antialiased
LEFT_BOX = (0.02, 0.06, 0.46, 0.78)  # left, bottom, width, height in shares of the picture
RIGHT_BOX = (0.55, 0.17, 0.36, 0.67)
MATERIAL_MAP = LinearSegmentedColormap.from_list("material", MATERIAL)
SIDE = (0.84, 0.76, 0.62, 1.0)
GREY = "#4a5460"
COLOURS = {"rapids": "#d6166f", "feeds": "#20262e", "arcs": "#ff8a1f", "plunges": "#5b1fa6", "zero": "#107a3b"}


def save_picture(
    file: Path,
    toolpath: Toolpath,
    part: HeightMap,
    *,
    title: str = "",
    tools: str = "",
    time_s: float | None = None,
) -> None:
    """Write the picture of a program and the part it leaves as a PNG of 1600 × 860 pixels.

    title: the program's name. tools: words for the tools, for example "flat 6 mm". time_s: of the program.
    """
    figure = Figure(figsize=SIZE_INCH, dpi=DPI * FINER, facecolor="white")
    canvas = FigureCanvasAgg(figure)
    _head(figure, toolpath, part, title, tools, time_s)
    lowest = deepest_shown_mm(float(part.heights_mm.min()), part.stock.bottom_mm, part.stock.top_mm)
    heights = Normalize(lowest, part.stock.top_mm)
    _draw_isometric(figure, part, heights)
    _draw_plan(figure, part, heights, drawn_path(toolpath))
    canvas.draw()
    pixels = np.asarray(canvas.buffer_rgba())[..., :3].astype(np.uint16)
    rows, columns = pixels.shape[0] // FINER, pixels.shape[1] // FINER
    averaged = pixels.reshape(rows, FINER, columns, FINER, 3).sum(axis=(1, 3)) // FINER**2
    imsave(str(file), averaged.astype(np.uint8))


def _head(figure: Figure, toolpath: Toolpath, part: HeightMap, title: str, tools: str, time_s: float | None) -> None:
    size = part.stock.size_mm
    facts = [
        TEXTS["tool"].format(text=tools) if tools else "",
        TEXTS["time"].format(text=duration_text(time_s)) if time_s is not None else "",
        TEXTS["moves"].format(count=f"{len(toolpath):,}".replace(",", " ")),
        TEXTS["stock"].format(x=size[0], y=size[1], z=size[2]),
        TEXTS["volume"].format(volume=part.removed_volume_mm3 / 1000),
    ]
    figure.text(0.02, 0.945, title, fontsize=17, fontweight="bold", color="#20262e")
    figure.text(0.02, 0.907, "   ·   ".join(fact for fact in facts if fact), fontsize=11.5, color=GREY)


def duration_text(time_s: float) -> str:
    """Return a time as people read it, for example "1 h 02 min 05 s"."""
    whole = round(time_s)
    hours, minutes, seconds = whole // 3600, whole // 60 % 60, whole % 60
    if hours:
        return f"{hours} h {minutes:02d} min {seconds:02d} s"
    return f"{minutes} min {seconds:02d} s" if minutes else f"{time_s:.1f} s"


def _draw_isometric(figure: Figure, part: HeightMap, heights: Normalize) -> None:
    axes = figure.add_axes(LEFT_BOX)
    u, v, colours = surface(part, lambda z: MATERIAL_MAP(heights(z)), SIDE)
    axes.pcolormesh(u, v, colours, edgecolors="none", antialiased=False)
    low, high = np.array(part.stock.low_mm), np.array(part.stock.high_mm)
    span = float(max(high - low))
    right_foot = np.array([high[0], low[1], low[2]])
    for name, corner, axis, out in (
        ("X", low, 0, (0.0, -1.0, -0.5)),
        ("Y", right_foot, 1, (1.0, 0.0, -0.5)),
        ("Z", low, 2, (-0.75, -0.75, 0.0)),
    ):
        _iso_axis(axes, name, corner, axis, float(high[axis]), span * np.array(out))
    _heading(figure, LEFT_BOX, TEXTS["isometric"])
    axes.set(xlim=(u.min() - 0.23 * span, u.max() + 0.05 * span), ylim=(v.min() - 0.12 * span, v.max() + 0.02 * span))
    axes.set_aspect("equal")
    axes.set_axis_off()


def _iso_axis(axes: Axes, name: str, corner: np.ndarray, axis: int, end: float, out: np.ndarray) -> None:
    """Draw the scale along an edge of the block: ticks and numbers in mm towards `out`, and the axis' name."""
    for value in _ticks(float(corner[axis]), end, float(np.abs(out).max())):
        start = corner.copy()
        start[axis] = value
        axes.plot(*projected(*np.stack([start, start + 0.015 * out], axis=1)), color=GREY, lw=0.8)
        _iso_text(axes, start + 0.042 * out, number_text(value), 9.0, GREY)
    middle = corner + 0.13 * out
    middle[axis] = (corner[axis] + end) / 2
    _iso_text(axes, middle, TEXTS["axis"].format(name=name), 10.5, "black")


def _iso_text(axes: Axes, point: np.ndarray, text: str, size: float, colour: str) -> None:
    u, v = projected(*point)
    axes.text(float(u), float(v), text, ha="center", va="center", fontsize=size, color=colour)


def _ticks(low: float, high: float, span: float) -> list[float]:
    """Return round values from low to high; an edge too short for several numbers gets its low end alone."""
    if high - low < 0.12 * span:
        return [low]
    count = max(2, min(6, int(8 * (high - low) / span)))
    values = MaxNLocator(count, steps=[1, 2, 2.5, 5, 10]).tick_values(low, high)
    return [float(value) for value in values if low - 1e-9 <= value <= high + 1e-9]


def number_text(value: float) -> str:
    """Return a number with a true minus sign."""
    return f"{value:g}".replace("-", "\N{MINUS SIGN}")


def _heading(figure: Figure, box: tuple[float, float, float, float], text: str) -> None:
    figure.text(box[0] + box[2] / 2, 0.858, text, fontsize=12.5, ha="center")


def _draw_plan(figure: Figure, part: HeightMap, heights: Normalize, path: DrawnPath) -> None:
    low, high = _plan_bounds(part, path)
    box = _fitted(RIGHT_BOX, high[0] - low[0], high[1] - low[1])
    axes = figure.add_axes(box, facecolor="#f1f3f5")
    stock_low, stock_high = part.stock.low_mm, part.stock.high_mm
    image = axes.imshow(
        part.heights_mm,
        extent=(stock_low[0], stock_high[0], stock_low[1], stock_high[1]),
        origin="lower",
        cmap=MATERIAL_MAP,
        norm=heights,
        interpolation="bilinear",
        aspect="auto",
    )
    for name, lines, style in (("feeds", path.feeds, "-"), ("arcs", path.arcs, "-"), ("rapids", path.rapids, "--")):
        flat = [line[:, :2] for line in lines]
        axes.add_collection(LineCollection(flat, colors=COLOURS[name], linewidths=0.8, linestyles=style))
    axes.plot(*path.plunges[:, :2].T, "v", color=COLOURS["plunges"], ms=7, mec="white", mew=0.7)
    axes.plot(0, 0, "+", color=COLOURS["zero"], ms=14, mew=2.0, clip_on=False)
    axes.set(xlabel=TEXTS["axis"].format(name="X"), ylabel=TEXTS["axis"].format(name="Y"))
    axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]))
    _heading(figure, RIGHT_BOX, TEXTS["plan"])
    scale = figure.colorbar(image, cax=figure.add_axes((box[0] + box[2] + 0.014, box[1], 0.011, box[3])))
    scale.set_label(TEXTS["height"])
    centre = (RIGHT_BOX[0] + RIGHT_BOX[2] / 2, box[1] - 0.075)
    figure.legend(handles=_legend(), loc="upper center", bbox_to_anchor=centre, ncols=5, frameon=False, fontsize=11)


def _plan_bounds(part: HeightMap, path: DrawnPath) -> tuple[np.ndarray, np.ndarray]:
    """Return the corners of what the plan shows: the stock, and the path beside it up to half the stock's length."""
    low, high = np.array(part.stock.low_mm[:2]), np.array(part.stock.high_mm[:2])
    span = float(max(high - low))
    points = np.vstack(
        [line[:, :2] for line in path.rapids + path.feeds + path.arcs] + [path.plunges[:, :2], [low, high]]
    )
    margin = np.where((points < low).any(axis=0) | (points > high).any(axis=0), 0.03 * span, 0.0)
    return np.maximum(points.min(axis=0) - margin, low - span / 2), np.minimum(
        points.max(axis=0) + margin, high + span / 2
    )


def _fitted(
    box: tuple[float, float, float, float], width_mm: float, height_mm: float
) -> tuple[float, float, float, float]:
    """Return the largest box within `box`, at its top and centred, in which x and y have one scale."""
    wide, high = box[2] * SIZE_INCH[0], box[3] * SIZE_INCH[1]
    scale = min(wide / width_mm, high / height_mm)
    width, height = scale * width_mm / SIZE_INCH[0], scale * height_mm / SIZE_INCH[1]
    return box[0] + (box[2] - width) / 2, box[1] + (box[3] - height) * 0.85, width, height


def _legend() -> list[Line2D]:
    styles: dict[str, dict[str, Any]] = {
        "rapids": {"ls": "--"},
        "feeds": {"ls": "-"},
        "arcs": {"ls": "-"},
        "plunges": {"ls": "", "marker": "v", "mec": "white"},
        "zero": {"ls": "", "marker": "+", "mew": 1.8},
    }
    return [
        Line2D([], [], color=COLOURS[name], lw=1.4, ms=9, label=TEXTS[name], **style) for name, style in styles.items()
    ]
