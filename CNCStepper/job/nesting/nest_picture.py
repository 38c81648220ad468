# SPDX-License-Identifier: LGPL-2.1-or-later
"""The picture of a nested order: each sheet that is used, its parts coloured by item and numbered."""

from __future__ import annotations

import math
from collections.abc import Mapping
from pathlib import Path

import numpy as np
import shapely
from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.patches import PathPatch
from matplotlib.path import Path as Outline
from shapely import Polygon

from CNCStepper.job.nesting.order_file import Order
from CNCStepper.nesting.common_lines import CommonCuts
from CNCStepper.nesting.nesting_model import Layout, placed
from CNCStepper.simulation.views.picture_style import GREY, INK, STOCK_COLOUR, head, new_figure, save_figure

MOST_DRAWN = 12  # sheets
MOST_NAMED = 60  # parts of a sheet that carry their item's number
WIDTH_INCH, HEAD_INCH, SIDE_INCH = 12.0, 1.1, 0.45
COMMON_COLOUR = "#c00000"
LEAST_ASPECT, MOST_ASPECT = 0.12, 1.4


def save_nest_picture(
    file: Path, order: Order, layout: Layout, density: float, shared: Mapping[int, CommonCuts] | None = None
) -> None:
    """Draw the sheets as PNG or SVG, as the file's name ends; shared: the common lines of each sheet."""
    numbers = layout.sheets[:MOST_DRAWN]
    boxes = [_box(order, layout, number) for number in numbers] or [(0.0, 0.0, 1.0, 1.0)]
    columns = min(len(boxes), 1 if max(box[2] - box[0] for box in boxes) > 2.5 * boxes[0][3] else 3)
    rows = math.ceil(len(boxes) / columns)
    wide = (WIDTH_INCH - SIDE_INCH) / columns
    aspect = max((box[3] - box[1]) / (box[2] - box[0]) for box in boxes)
    high = wide * float(np.clip(aspect, LEAST_ASPECT, MOST_ASPECT)) + SIDE_INCH
    figure = new_figure(WIDTH_INCH, HEAD_INCH + rows * high + SIDE_INCH)
    head(figure, "Nested parts", _facts(order, layout, density))
    whole = float(figure.get_size_inches()[1])
    for place, number in enumerate(numbers):
        column, row = place % columns, place // columns
        left, bottom = SIDE_INCH + column * wide, whole - HEAD_INCH - (row + 1) * high + SIDE_INCH
        size = ((wide - SIDE_INCH) / WIDTH_INCH, (high - SIDE_INCH) / whole)
        axes = figure.add_axes((left / WIDTH_INCH, bottom / whole, *size))
        _draw(axes, order, layout, number, boxes[place])
        for block in shared[number].blocks if shared else ():
            for line in block.lines:
                axes.plot(*line.xy.T, color=COMMON_COLOUR, linewidth=1.4)
    save_figure(figure, file)


def _facts(order: Order, layout: Layout, density: float) -> list[str]:
    missing = sum(unplaced.count for unplaced in layout.unplaced)
    sheets = len(layout.sheets)
    return [
        f"{len(layout.placements)} parts",
        "a strip" if order.strip_height_mm else f"{sheets} sheet" + "s" * (sheets != 1),
        f"density {density:.1%}",
        f"{missing} parts without a place" if missing else "",
        f"the first {MOST_DRAWN} are drawn" if sheets > MOST_DRAWN else "",
    ]


def _box(order: Order, layout: Layout, number: int) -> tuple[float, float, float, float]:
    outline: Polygon = order.sheets[number].outline
    left, low, right, high = outline.bounds
    if order.strip_height_mm:
        right = max(placed(order.items[each.item].exact, each).bounds[2] for each in layout.placements)
    return left, low, right, high


def _draw(axes: Axes, order: Order, layout: Layout, number: int, box: tuple[float, float, float, float]) -> None:
    sheet = order.sheets[number].outline.intersection(shapely.box(*box))
    axes.add_patch(_patch(sheet, facecolor=STOCK_COLOUR, edgecolor=GREY, linewidth=0.8))
    on_sheet = [placement for placement in layout.placements if placement.sheet == number]
    colours = colormaps["tab20"]
    for placement in on_sheet:
        polygon = placed(order.items[placement.item].exact, placement)
        axes.add_patch(
            _patch(polygon, facecolor=colours(placement.item % 20), edgecolor=INK, linewidth=0.6, alpha=0.85)
        )
        if len(on_sheet) <= MOST_NAMED:
            place = polygon.representative_point()
            axes.annotate(f"{placement.item}", (place.x, place.y), ha="center", va="center", fontsize=7, color=INK)
    margin = 0.01 * max(box[2] - box[0], box[3] - box[1])
    axes.set(xlim=(box[0] - margin, box[2] + margin), ylim=(box[1] - margin, box[3] + margin), aspect="equal")
    axes.tick_params(labelsize=7, colors=GREY)
    for side in axes.spines.values():
        side.set_visible(False)
    axes.set_title(_title(order, number), fontsize=9, color=GREY, loc="left")


def _title(order: Order, number: int) -> str:
    """Return the number of a sheet, and its name where it says more."""
    name = order.sheets[number].name
    if order.strip_height_mm:
        return "strip"
    return f"sheet {number}" if name in ("sheet", f"sheet {number}") else f"sheet {number}: {name}"


def _patch(polygon: Polygon, **style: object) -> PathPatch:
    rings = [np.asarray(ring.coords) for ring in (polygon.exterior, *polygon.interiors)]
    codes = [[Outline.MOVETO, *[Outline.LINETO] * (len(ring) - 2), Outline.CLOSEPOLY] for ring in rings]
    return PathPatch(Outline(np.concatenate(rings), np.concatenate(codes)), **style)
