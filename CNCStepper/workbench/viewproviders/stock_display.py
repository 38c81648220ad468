# SPDX-License-Identifier: LGPL-2.1-or-later
"""A job's stock and clamps in the 3D view: the edges of the stock round the work zero, a small cross at that zero.

Where cuts must stay within the stock's edge, the line that they stay within is drawn on its top. For a clamp it is the
area that the tool avoids: a block from its top down to the stock's bottom.
"""

from __future__ import annotations

from typing import Any

from CNCStepper.errors import JobError
from CNCStepper.workbench import packages
from CNCStepper.workbench.document.clamps import rings_of
from CNCStepper.workbench.document.stock_of_job import stock_of
from CNCStepper.workbench.services.view_colours import CLAMP_RGB, STOCK_RGB

CROSS_SHARE = 0.05  # of the stock's length: half an arm of the cross
POSTS = 4
SHAPED_BY = ("StockForm", "StockSize", "StockOrigin", "EdgeMargin", "WorkOrigin")
GLASS = 0.7  # of the top face: the solid itself stays to be seen


class StockBox:
    """`node` is for the view; `update` follows the job."""

    def __init__(self) -> None:
        from pivy import coin

        self.node = coin.SoSeparator()
        self._points, self._lines = coin.SoCoordinate3(), coin.SoLineSet()
        colour, style, pick = coin.SoBaseColor(), coin.SoDrawStyle(), coin.SoPickStyle()
        colour.rgb = STOCK_RGB
        style.lineWidth = 1.5
        pick.style = coin.SoPickStyle.UNPICKABLE  # what is drawn inside the stock stays within reach of the mouse
        for part in (pick, colour, style, self._points, self._lines):
            self.node.addChild(part)

    def update(self, job: Any) -> None:
        """Draw the stock as the job says it is; nothing where the job says nonsense, or shapely is missing."""
        show_strips(self._points, self._lines, [] if packages.missing("numpy", "shapely") else _strips(job))


def _strips(job: Any) -> list[list[Any]]:
    """Return the edges of the stock, the margin at its edge and the cross, in the document's coordinates."""
    try:
        stock = stock_of(job)
    except JobError:
        return []
    zero = tuple(job.WorkOrigin)
    arm = CROSS_SHARE * max(stock.size_mm[:2])
    cross = [[(-arm, 0.0, 0.0), (arm, 0.0, 0.0)], [(0.0, -arm, 0.0), (0.0, arm, 0.0)]]
    strips = _edges(stock) + _margin(stock, float(job.EdgeMargin)) + cross
    return [[tuple(at + shift for at, shift in zip(point, zero, strict=True)) for point in strip] for strip in strips]


def _edges(stock: Any) -> list[list[Any]]:
    """Return the rims of top and bottom, and four posts between them: at a cylinder's sides, at a box's corners."""
    rim = list(stock.outline.exterior.coords)
    heights = stock.bottom_mm, stock.top_mm
    posts = [[(*rim[i * (len(rim) - 1) // POSTS], z) for z in heights] for i in range(POSTS)]
    return [[(*point, z) for point in rim] for z in heights] + posts


def _margin(stock: Any, edge_mm: float) -> list[list[Any]]:
    """Return the line that cuts stay within, on the top; none where no margin is asked for or none is left."""
    inside = stock.outline.buffer(-edge_mm, join_style="mitre")
    return [[(*point, stock.top_mm) for point in inside.exterior.coords]] if edge_mm > 0 and not inside.is_empty else []


class ClampBlocks:
    """`node` is for the view; `update` follows the job."""

    def __init__(self) -> None:
        from pivy import coin

        self.node = coin.SoSeparator()
        self._points, self._lines, self._tops = coin.SoCoordinate3(), coin.SoLineSet(), coin.SoFaceSet()
        self._top_points = coin.SoCoordinate3()
        glass, solid = coin.SoMaterial(), coin.SoMaterial()
        glass.diffuseColor, glass.transparency = CLAMP_RGB, GLASS
        solid.diffuseColor = CLAMP_RGB
        style, light, pick = coin.SoDrawStyle(), coin.SoLightModel(), coin.SoPickStyle()
        style.lineWidth = 2.0
        light.model = coin.SoLightModel.BASE_COLOR
        pick.style = coin.SoPickStyle.UNPICKABLE  # the solid below stays within reach of the mouse
        for part in (pick, light, style, glass, self._top_points, self._tops, solid, self._points, self._lines):
            self.node.addChild(part)

    def update(self, job: Any) -> None:
        """Draw the clamps that the job keeps."""
        rings = list(rings_of(job))
        floor_mm = job.WorkOrigin.z - job.StockSize.z
        show_strips(self._top_points, self._tops, [ring[:-1] for ring in rings])
        show_strips(self._points, self._lines, [strip for ring in rings for strip in _block_edges(ring, floor_mm)])


class StockAndClamps:
    """Both; `node` is for the view, `update` follows the job."""

    def __init__(self) -> None:
        self.stock, self.clamps = StockBox(), ClampBlocks()
        self.node = self.stock.node
        self.node.addChild(self.clamps.node)

    def update(self, job: Any) -> None:
        """Draw stock and clamps."""
        self.stock.update(job)
        self.clamps.update(job)


def _block_edges(ring: list[Any], floor_mm: float) -> list[list[Any]]:
    """Return the edges of the block between a clamp's outline and the stock's bottom."""
    low = [(x, y, min(z, floor_mm)) for x, y, z in ring]
    return [ring, low, *([top, bottom] for top, bottom in zip(ring[:-1], low[:-1], strict=True))]


def show_strips(points: Any, shape: Any, strips: list[list[Any]]) -> None:
    """Let nodes of coordinates and of lines or faces show strips of points."""
    from CNCStepper.workbench.services.coin_fields import fill_points, fill_whole_numbers

    fill_points(points.point, [point for strip in strips for point in strip])
    fill_whole_numbers(shape.numVertices, [len(strip) for strip in strips])
