# SPDX-License-Identifier: LGPL-2.1-or-later
"""The picture of a turned part: its half section over the axis, mirrored below it, with chuck, path and tool.

X  |  chuck   ____________            above the axis: the section, the path, the tool, the profile that is wanted
   |  |####|=|____________|--.        below it: the part as it is seen from the side
---+--|####|-------------------- Z
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import shapely
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.patches import PathPatch
from matplotlib.path import Path as Outline
from matplotlib.ticker import FuncFormatter
from shapely.geometry.base import BaseGeometry

from CNCStepper.simulation.turning.half_section import HalfSection
from CNCStepper.simulation.turning.swept_outline import Moves
from CNCStepper.simulation.turning.tool_section import ToolSection
from CNCStepper.simulation.views.picture_style import (
    COLOURS,
    GREY,
    GROUND,
    INK,
    TEXTS,
    head,
    legend,
    new_figure,
    number_text,
    save_figure,
)

WIDTH_INCH = 16.0
HEAD_INCH, FOOT_INCH, LEFT_INCH, RIGHT_INCH = 1.2, 1.25, 1.0, 0.5
MOST_INCH, LEAST_INCH = 7.5, 2.4  # height of the view itself
MARGIN = 0.04  # about everything, in shares of its longest side
HATCH_COLOUR = "#c9b78c"
PATH_SHARE = 0.6  # how far from the stock the path is shown, in shares of the bar's radius


@dataclass(frozen=True)
class TurnedScene:
    """A turned part at one time; lengths in the part's coordinates, mm.

    wanted: chains of points (z, r), float64[n, 2] each. obstacles: chuck, jaws, tailstock. tool: None for none to draw;
    tip_mm: its control point. x_factor: 2 where X is shown as diameter.
    """

    stock: HalfSection
    part: HalfSection
    moves: Moves
    wanted: Sequence[np.ndarray] = ()
    obstacles: Mapping[str, BaseGeometry] = field(default_factory=dict)
    tool: ToolSection | None = None
    tip_mm: tuple[float, float] | None = None
    x_factor: float = 1.0


def save_half_section(file: Path, scene: TurnedScene, title: str = "", facts: Sequence[str] = ()) -> None:
    """Write the picture as PNG or SVG, 1600 pixels wide; raises JobError for another kind of file."""
    low, high = _bounds(scene)
    width_inch = WIDTH_INCH - LEFT_INCH - RIGHT_INCH
    scale = min(width_inch / (high[0] - low[0]), MOST_INCH / (high[1] - low[1]))
    size = scale * (high[0] - low[0]), max(scale * (high[1] - low[1]), LEAST_INCH)
    figure = new_figure(WIDTH_INCH, HEAD_INCH + size[1] + FOOT_INCH)
    left = LEFT_INCH + (width_inch - size[0]) / 2
    whole = np.tile(figure.get_size_inches(), 2)
    axes = figure.add_axes(tuple(np.array([left, FOOT_INCH, *size]) / whole))
    names = _draw(axes, scene)
    axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), aspect="equal")
    head(figure, title, facts)
    legend(figure, names, 0.5, 0.18)
    save_figure(figure, file)


def turned_facts(part: HalfSection, stock: HalfSection, tools: str, time: str, moves: int) -> list[str]:
    """Return the lines of a picture's head."""
    low, _, high, radius = stock.region.bounds
    removed = (stock.volume_mm3 - part.volume_mm3) / 1000
    return [
        TEXTS["tool"].format(text=tools) if tools else "",
        TEXTS["time"].format(text=time) if time else "",
        TEXTS["moves"].format(count=f"{moves:,}".replace(",", " ")),
        TEXTS["bar"].format(diameter=2 * radius, length=high - low),
        TEXTS["volume"].format(volume=removed),
    ]


def _bounds(scene: TurnedScene) -> tuple[np.ndarray, np.ndarray]:
    """Return low and high corner: stock, obstacles near it, and the path as far as it is near."""
    z_first, _, z_last, radius = scene.stock.region.bounds
    reach = PATH_SHARE * radius + 2.0
    shown = shapely.box(z_first - reach, -radius, z_last + reach, radius + reach)
    points = np.vstack([scene.moves.begin, scene.moves.end])
    inside = points[shapely.contains_xy(shown, *points.T)]
    stock = np.array([(z_first - reach / 2, -radius), (z_last, radius)])
    corners = np.vstack([inside, stock])
    margin = MARGIN * float((corners.max(axis=0) - corners.min(axis=0)).max())
    return corners.min(axis=0) - margin, corners.max(axis=0) + margin


def _draw(axes: Axes, scene: TurnedScene) -> list[str]:
    """Draw everything and return the names of what there is, for the legend."""
    axes.set_facecolor(GROUND)
    axes.grid(color="white", lw=0.8)
    axes.set_axisbelow(True)
    names = _obstacles(axes, scene) + _part(axes, scene) + _wanted(axes, scene) + _path(axes, scene)
    axes.axhline(0, color=INK, lw=0.8, ls=(0, (12, 3, 2, 3)), zorder=3)
    axes.plot(0, 0, "+", color=COLOURS["zero"], ms=14, mew=2.0, zorder=6)
    names += _tool(axes, scene)
    axes.yaxis.set_major_formatter(FuncFormatter(lambda r, _: number_text(abs(r) * scene.x_factor)))
    axes.xaxis.set_major_formatter(FuncFormatter(lambda z, _: number_text(z)))
    x_name = TEXTS["diameter"] if scene.x_factor == 2 else TEXTS["radius"]
    axes.set(xlabel=TEXTS["axis"].format(name="Z"), ylabel=x_name)
    return [*names, "zero"]


def _obstacles(axes: Axes, scene: TurnedScene) -> list[str]:
    for region in scene.obstacles.values():
        for both in (region, _mirrored(region)):
            axes.add_patch(_patch(both, fc=COLOURS["chuck"], ec=INK, lw=0.8, zorder=1))
    return ["chuck"] if scene.obstacles else []


def _part(axes: Axes, scene: TurnedScene) -> list[str]:
    """Draw the raw stock as an outline, the section above the axis, the part seen from the side below it."""
    raw, part = scene.stock.region, scene.part.region
    axes.add_patch(_patch(raw, fc=COLOURS["raw"], ec=GREY, lw=0.8, ls="--", zorder=1.2))
    axes.add_patch(_patch(_mirrored(raw), fc=COLOURS["raw"], ec=GREY, lw=0.8, ls="--", zorder=1.2))
    axes.add_patch(_patch(part, fc=COLOURS["part"], ec=HATCH_COLOUR, lw=0.0, zorder=2, hatch="//"))
    axes.add_patch(_patch(part, fill=False, ec=INK, lw=1.2, zorder=2.2))
    profile = np.array(scene.part.outer_profile)
    if len(profile):
        below = np.vstack([profile * (1, -0.5), [(profile[-1, 0], 0), (profile[0, 0], 0)]])
        axes.fill(*below.T, fc=COLOURS["part"], ec=INK, lw=1.2, zorder=2)
        for z, diameter in _edges_seen(profile):
            axes.plot([z, z], [-diameter / 2, 0], color=INK, lw=0.6, zorder=2.1)
    return ["raw", "part"]


def _edges_seen(profile: np.ndarray) -> list[tuple[float, float]]:
    """Return z and diameter of the edges that are seen from the side: where the profile bends by more than an arc's."""
    ways = np.diff(profile * (1, 0.5), axis=0)
    length = np.hypot(*ways.T)
    turned = np.abs(np.diff(np.unwrap(np.arctan2(ways[:, 1], ways[:, 0]))))
    sharp = (turned > np.radians(12)) & (np.minimum(length[1:], length[:-1]) > 1e-3)
    return [tuple(point) for point in profile[1:-1][sharp].tolist()]


def _wanted(axes: Axes, scene: TurnedScene) -> list[str]:
    for chain in scene.wanted:
        axes.plot(*chain.T, color=COLOURS["wanted"], lw=1.6, zorder=4)
    return ["wanted"] if len(scene.wanted) else []


def _path(axes: Axes, scene: TurnedScene) -> list[str]:
    names = []
    for name, mine in (("rapids", scene.moves.rapid), ("feeds", ~scene.moves.rapid)):
        if mine.any():
            lines = np.stack([scene.moves.begin[mine], scene.moves.end[mine]], axis=1)
            style = "--" if name == "rapids" else "-"
            shown = LineCollection(list(lines), colors=COLOURS[name], linewidths=0.7, linestyles=style, zorder=3)
            axes.add_collection(shown)
            names.append(name)
    return names


def _tool(axes: Axes, scene: TurnedScene) -> list[str]:
    if scene.tool is None or scene.tip_mm is None:
        return []
    for outline, name in ((scene.tool.holder, "shank"), (scene.tool.cutting, "cutter")):
        if outline is not None:
            placed = shapely.transform(outline, lambda points: points + scene.tip_mm)
            axes.add_patch(_patch(placed, fc=COLOURS[name], ec=INK, lw=0.8, alpha=0.85, zorder=5))
    return ["cutter"]


def _mirrored(region: BaseGeometry) -> BaseGeometry:
    return shapely.transform(region, lambda points: points * (1.0, -1.0))


def _patch(region: BaseGeometry, **style: object) -> PathPatch:
    """Return a region with its holes as a patch."""
    rings = [np.asarray(ring.coords) for ring in shapely.get_rings(shapely.get_parts(region))]
    outlines = [Outline(ring, closed=True) for ring in rings]
    empty = Outline(np.zeros((0, 2)))
    return PathPatch(Outline.make_compound_path(*outlines) if outlines else empty, **style)  # type: ignore[arg-type]
