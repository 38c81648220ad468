# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all pictures share: words, colours, the head, the legend, and how a figure becomes a file.

Only figures with their own canvas are used, never pyplot: several pictures may be made at once, inside FreeCAD too.
"""

from __future__ import annotations

from collections.abc import Iterable
from io import BytesIO
from itertools import product
from pathlib import Path
from typing import Any

import matplotlib
import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import LineCollection
from matplotlib.colors import LinearSegmentedColormap, Normalize
from matplotlib.figure import Figure
from matplotlib.image import imsave
from matplotlib.lines import Line2D

from CNCStepper.atomic_file import write_whole
from CNCStepper.errors import JobError, Text
from CNCStepper.simulation.removal.heightmap import HeightMap
from CNCStepper.simulation.views.depth_colours import MATERIAL, deepest_shown_mm
from CNCStepper.simulation.views.path_lines import DrawnPath

TEXTS = {
    "isometric": "Isometric view",
    "xy": "XY view, seen from above",
    "zy": "ZY view, seen along the X axis",
    "depth": "Depth map",
    "plan": "Depth and tool path, seen from above",
    "axis": "{name} (mm)",
    "height": "height above the stock's top face (mm)",
    "rapids": "rapid",
    "feeds": "feed",
    "arcs": "arc",
    "plunges": "plunge",
    "zero": "work zero",
    "cutter": "tool",
    "limits": "limits of travel",
    "workpiece": "stock",
    "fallen": "piece cut free",
    "tool": "tool {text}",
    "time": "time {text}",
    "moment": "at {text} of {whole}, line {line}",
    "moves": "{count} moves",
    "stock": "stock {x:g} × {y:g} × {z:g} mm",
    "volume": "removed {volume:.4g} cm³",
    "bar": "stock ø{diameter:g} × {length:g} mm",
    "raw": "raw stock",
    "part": "part as cut",
    "wanted": "wanted profile",
    "chuck": "chuck",
    "diameter": "X as diameter (mm)",
    "radius": "X as radius (mm)",
}
DPI = 100
FINER = 2  # drawn that many times larger, then averaged: the surface's quads are not antialiased
MATERIAL_MAP = LinearSegmentedColormap.from_list("material", MATERIAL)
GREY, INK, GROUND, STOCK_COLOUR = "#4a5460", "#20262e", "#f1f3f5", "#f3ead7"
COLOURS = {
    "rapids": "#d6166f",
    "feeds": INK,
    "arcs": "#ff8a1f",
    "plunges": "#5b1fa6",
    "zero": "#7a1010",
    "cutter": "#8fa3b5",
    "shank": "#c3ccd4",
    "limits": "#0072b2",
    "workpiece": STOCK_COLOUR,
    "fallen": "#cfd6dc",
    "raw": "#fbf6e9",
    "part": "#eddcb5",
    "wanted": "#1668b8",
    "chuck": "#aab4bd",
}
STYLES: dict[str, dict[str, Any]] = {
    "rapids": {"ls": "--"},
    "feeds": {"ls": "-"},
    "arcs": {"ls": "-"},
    "plunges": {"ls": "", "marker": "v", "mec": "white"},
    "zero": {"ls": "", "marker": "+", "mew": 1.8},
    "cutter": {"ls": "", "marker": "s"},
    "limits": {"ls": (0, (6, 3))},
    "workpiece": {"ls": "", "marker": "s", "mec": INK},
    "fallen": {"ls": "", "marker": "s", "mec": INK},
    "raw": {"ls": "", "marker": "s", "mec": GREY},
    "part": {"ls": "", "marker": "s", "mec": INK},
    "wanted": {"ls": "-"},
    "chuck": {"ls": "", "marker": "s", "mec": INK},
}


def heights_scale(part: HeightMap, deepest_mm: float = 0.0) -> Normalize:
    """Return the scale of a part's colours, from its deepest cut, or that of a later time, to its top."""
    lowest = deepest_shown_mm(min(float(part.heights_mm.min()), deepest_mm), part.stock.bottom_mm, part.stock.top_mm)
    return Normalize(lowest, part.stock.top_mm)


def head(figure: Figure, title: str, facts: Iterable[str], left_inch: float = 0.32) -> None:
    """Write the title and, below it, the figures."""
    width, height = figure.get_size_inches()
    figure.text(left_inch / width, 1 - 0.42 / height, title, fontsize=17, fontweight="bold", color=INK)
    line = "   ·   ".join(fact for fact in facts if fact)
    figure.text(left_inch / width, 1 - 0.75 / height, line, fontsize=11.5, color=GREY)


def legend(figure: Figure, names: Iterable[str], centre: float, bottom_inch: float) -> None:
    """Write the legend of the shown elements around `centre` (a share of the width) above `bottom_inch`."""
    handles = [
        Line2D([], [], color=COLOURS[name], lw=1.4, ms=9, label=TEXTS[name], **STYLES[name])
        for name in STYLES
        if name in set(names)
    ]
    foot = bottom_inch / figure.get_size_inches()[1]
    figure.legend(
        handles=handles,
        loc="lower center",
        bbox_to_anchor=(centre, foot),
        ncols=max(len(handles), 1),
        frameon=False,
        fontsize=11,
        columnspacing=1.4,
        borderpad=0.0,
    )


def draw_path(axes: Axes, path: DrawnPath, project: Any, *, plunge_lines: bool) -> list[str]:
    """Draw the lines in their colours and return the names of the kinds that there are.

    project: from points float64[n, 3] to the picture's float64[n, 2]. plunge_lines: whether plunges are seen as lines.
    """
    for name, lines in path.kinds().items():
        flat = [project(line) for line in lines]
        if name == "plunges" and flat:
            axes.plot(*np.array([line[-1] for line in flat]).T, "v", color=COLOURS[name], ms=7, mec="white", mew=0.7)
        if name != "plunges" or plunge_lines:
            style = "--" if name == "rapids" else "-"
            axes.add_collection(LineCollection(flat, colors=COLOURS[name], linewidths=0.8, linestyles=style))
    return [name for name, lines in path.kinds().items() if lines]


def number_text(value: float) -> str:
    """Return a number with a true minus sign."""
    return f"{value:g}".replace("-", "\N{MINUS SIGN}")


def new_figure(width_inch: float, height_inch: float) -> Figure:
    """Return an empty white figure whose height is a whole number of pixels."""
    rows = round(height_inch * DPI)
    height_inch = rows / DPI
    while int(height_inch * DPI * FINER) < rows * FINER:  # 4.89 inches are 977.99 pixels, which are cut off
        height_inch = float(np.nextafter(height_inch, np.inf))
    return Figure(figsize=(width_inch, height_inch), dpi=DPI * FINER, facecolor="white")


def pixels_of(figure: Figure) -> np.ndarray:
    """Return the figure as it is seen, uint8[rows, columns, 3]."""
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    pixels = np.asarray(canvas.buffer_rgba())[..., :3]
    total = np.zeros((pixels.shape[0] // FINER, pixels.shape[1] // FINER, 3), np.uint16)
    for row, column in product(range(FINER), repeat=2):
        total += pixels[row::FINER, column::FINER]
    return (total // FINER**2).astype(np.uint8)


def save_figure(figure: Figure, file: Path) -> None:
    """Write a figure as PNG or SVG, as the file's name ends; raises JobError for another ending."""
    buffer = BytesIO()
    if file.suffix.lower() == ".png":
        imsave(buffer, pixels_of(figure), format="png", metadata={"Software": "CNCStepper"})
    elif file.suffix.lower() == ".svg":
        with matplotlib.rc_context({"svg.hashsalt": "CNCStepper"}):  # the same picture is the same bytes
            about = {"Date": None, "Creator": "CNCStepper"}
            figure.savefig(buffer, format="svg", dpi=DPI * FINER, metadata=about)
    else:
        raise JobError(
            "picture-kind",
            Text("'{file}' is no picture that can be drawn", file=file.name),
            advice="end it in .png or .svg",
        )
    write_whole(file, buffer.getvalue())
