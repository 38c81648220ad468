# SPDX-License-Identifier: LGPL-2.1-or-later
"""A plot of lengths that were measured one after the other, with their mean, scatter and the commanded length."""

from __future__ import annotations

from collections.abc import Sequence
from io import BytesIO
from pathlib import Path

from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from CNCStepper.atomic_file import write_whole
from CNCStepper.simulation.views.picture_style import COLOURS, DPI, INK

TEXTS = {
    "number": "reading",
    "error": "measured less commanded (mm)",
    "mean": "mean {mean:+.4f} mm",
    "scatter": "± standard deviation {deviation:.4f} mm",
    "true": "commanded {commanded:g} mm",
}
SIZE_INCH = (6.4, 4.0)


def readings_figure(
    title: str, commanded_mm: float, readings_mm: Sequence[float], mean_mm: float, deviation_mm: float
) -> Figure:
    """Return the figure, with a canvas of its own; `title` heads it."""
    figure = Figure(figsize=SIZE_INCH, dpi=DPI, layout="constrained")
    FigureCanvasAgg(figure)
    axes = figure.add_subplot()
    numbers = range(1, len(readings_mm) + 1)
    mean = mean_mm - commanded_mm
    axes.axhspan(mean - deviation_mm, mean + deviation_mm, color=COLOURS["cutter"], alpha=0.35,
                 label=TEXTS["scatter"].format(deviation=deviation_mm))  # fmt: skip
    axes.axhline(0.0, color=COLOURS["zero"], ls="--", label=TEXTS["true"].format(commanded=commanded_mm))
    axes.axhline(mean, color=INK, label=TEXTS["mean"].format(mean=mean))
    axes.plot(numbers, [value - commanded_mm for value in readings_mm], ls="", marker="o", color=COLOURS["rapids"])
    axes.set_title(title)
    axes.set_xlabel(TEXTS["number"])
    axes.set_ylabel(TEXTS["error"])
    axes.xaxis.set_major_locator(MaxNLocator(integer=True))
    axes.margins(y=0.15)
    axes.legend(fontsize="small")
    return figure


def save_readings(
    path: Path, title: str, commanded_mm: float, readings_mm: Sequence[float], mean_mm: float, deviation_mm: float
) -> None:
    """Write the plot; its format follows the suffix (.png, .svg, .pdf)."""
    data = BytesIO()
    figure = readings_figure(title, commanded_mm, readings_mm, mean_mm, deviation_mm)
    figure.savefig(data, format=path.suffix.lstrip(".").lower() or "png")
    write_whole(path, data.getvalue())
