# SPDX-License-Identifier: LGPL-2.1-or-later
"""The flat views, along one axis: XY and the depth map from above, ZY from the side."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import Normalize
from matplotlib.image import AxesImage
from matplotlib.patches import Circle, Polygon, Rectangle

from CNCStepper.simulation.removal.heightmap import HeightMap
from CNCStepper.simulation.views.fallen_pieces import draw_fallen
from CNCStepper.simulation.views.path_lines import FROM_ABOVE
from CNCStepper.simulation.views.picture_style import COLOURS, GROUND, INK, MATERIAL_MAP, STOCK_COLOUR, TEXTS, draw_path
from CNCStepper.simulation.views.scene import Scene

FROM_SIDE = (1, 2)
REST_COLOUR = "#e0cfa6"
MARGIN = 0.03  # round everything, in shares of its longest side


def bounds(box_mm: np.ndarray, seen: tuple[int, int]) -> np.ndarray:
    """Return low and high corner of the visible part of a box, float64[2, 2]."""
    flat = box_mm[:, list(seen)]
    margin = MARGIN * (flat[1] - flat[0]).max()
    return np.array([flat[0] - margin, flat[1] + margin])


def draw_from_above(axes: Axes, scene: Scene) -> list[str]:
    """Draw the XY view: stock, path, tool; return the names of what there is, for the legend."""
    _ground(axes, scene, FROM_ABOVE)
    axes.add_patch(
        Polygon(np.asarray(scene.part.stock.outline.exterior.coords), fc=STOCK_COLOUR, ec=INK, lw=1.0, zorder=1)
    )
    names = draw_fallen(axes, scene.fallen, scene.part.stock.top_mm, _from_above)
    names += draw_path(axes, scene.path(FROM_ABOVE), _from_above, plunge_lines=False)
    return names + _tool_from_above(axes, scene) + _marks(axes, scene, FROM_ABOVE)


def draw_from_side(axes: Axes, scene: Scene) -> list[str]:
    """Draw the ZY view: the part's outline and its deepest cuts, path, tool; return the names of what there is."""
    _ground(axes, scene, FROM_SIDE)
    part, bottom = scene.part, scene.part.stock.bottom_mm
    heights = np.clip(part.heights_mm, bottom, None)
    edges = np.linspace(part.stock.low_mm[1], part.stock.high_mm[1], len(part.y_mm) + 1)
    for profile, colour in ((heights.max(axis=1), STOCK_COLOUR), (_deepest(part, heights), REST_COLOUR)):
        axes.stairs(profile, edges, baseline=bottom, fill=True, color=colour, zorder=1)
    corner, size = part.stock.low_mm[1:], part.stock.size_mm[1:]
    axes.add_patch(Rectangle(corner, *size, fill=False, ec=INK, lw=1.0, zorder=1))
    names = draw_path(axes, scene.path(FROM_SIDE), lambda points: points[:, 1:], plunge_lines=True)
    return names + _tool_from_side(axes, scene) + _marks(axes, scene, FROM_SIDE)


def draw_depths(axes: Axes, part: HeightMap, heights: Normalize) -> AxesImage:
    """Draw the part's heights by their colours; cells that hold no stock are left empty."""
    low, high = part.stock.low_mm, part.stock.high_mm
    beside = part.stock.shares(part.x_mm, part.y_mm, part.cell_mm) <= 0.0
    axes.set_facecolor(GROUND)
    return axes.imshow(
        np.ma.masked_array(part.heights_mm, beside),
        extent=(low[0], high[0], low[1], high[1]),
        origin="lower",
        cmap=MATERIAL_MAP,
        norm=heights,
        interpolation="none" if beside.any() else "bilinear",
        aspect="auto",
    )


def draw_depth_map(axes: Axes, scene: Scene, heights: Normalize) -> tuple[AxesImage, list[str]]:
    """Draw the depth map with the tool on it; return the image, for its scale, and the names of what there is."""
    image = draw_depths(axes, scene.part, heights)
    _names(axes, FROM_ABOVE)
    names = draw_fallen(axes, scene.fallen, scene.part.stock.top_mm, _from_above)
    names += _tool_from_above(axes, scene) + _marks(axes, scene, FROM_ABOVE)
    return image, names if _limits_cross(scene) else [name for name in names if name != "limits"]


def _from_above(points: np.ndarray) -> np.ndarray:
    return points[:, :2]


def _limits_cross(scene: Scene) -> bool:
    """Return whether a limit of travel lies within the depth map."""
    if scene.limits_mm is None:
        return False
    stock = scene.part.stock
    low, high = bounds(np.array([stock.low_mm, stock.high_mm]), FROM_ABOVE)
    return bool((scene.limits_mm[0, :2] > low).any() or (scene.limits_mm[1, :2] < high).any())


def _deepest(part: HeightMap, heights: np.ndarray) -> np.ndarray:
    """Return the lowest height over each y, of the cells that hold stock."""
    shares = part.stock.shares(part.x_mm, part.y_mm, part.cell_mm)
    return np.where(shares > 0.0, heights, np.inf).min(axis=1, initial=part.stock.top_mm)


def _ground(axes: Axes, scene: Scene, seen: tuple[int, int]) -> None:
    axes.set_facecolor(GROUND)
    axes.grid(color="white", lw=0.8)
    axes.set_axisbelow(True)
    _names(axes, seen)


def _names(axes: Axes, seen: tuple[int, int]) -> None:
    horizontal, vertical = (TEXTS["axis"].format(name="XYZ"[axis]) for axis in seen)
    axes.set(xlabel=horizontal, ylabel=vertical)


def _marks(axes: Axes, scene: Scene, seen: tuple[int, int]) -> list[str]:
    """Mark the work zero and the limits of travel."""
    axes.plot(0, 0, "+", color=COLOURS["zero"], ms=14, mew=2.0, clip_on=False, zorder=5)
    if scene.limits_mm is None:
        return ["zero"]
    low, high = scene.limits_mm[:, list(seen)]
    axes.add_patch(Rectangle(tuple(low), *(high - low), fill=False, ec=COLOURS["limits"], ls=(0, (6, 3)), lw=1.2))
    return ["zero", "limits"]


def _tool_from_above(axes: Axes, scene: Scene) -> list[str]:
    if scene.outlines is None or scene.tip_mm is None:
        return []
    radius = float(scene.outlines[0][:, 0].max())
    x, y, _ = scene.tip_mm.tolist()
    axes.add_patch(
        Circle(
            (x, y),
            radius,
            fc=COLOURS["cutter"],
            ec=INK,
            lw=0.8,
            alpha=0.75,
            zorder=4,
        )
    )
    return ["cutter"]


def _tool_from_side(axes: Axes, scene: Scene) -> list[str]:
    if scene.outlines is None or scene.tip_mm is None:
        return []
    for outline, colour in zip(scene.outlines, ("cutter", "shank"), strict=True):
        both = np.vstack([outline, outline[::-1] * (-1, 1)]) + scene.tip_mm[1:]
        axes.add_patch(Polygon(both, fc=COLOURS[colour], ec=INK, lw=0.8, alpha=0.85, zorder=4))
    return ["cutter"]
