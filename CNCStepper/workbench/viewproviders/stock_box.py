# SPDX-License-Identifier: LGPL-2.1-or-later
"""The edges of a job's stock in the 3D view, where it lies round the work zero, and a small cross at that zero."""

from __future__ import annotations

from typing import Any

from CNCStepper.errors import JobError
from CNCStepper.workbench import packages

RGB = (0.72, 0.53, 0.20)  # of wood: seen on FreeCAD's blue and on white
CROSS_SHARE = 0.05  # of the stock's length: half an arm of the cross
SHAPED_BY = ("StockSize", "StockOrigin", "WorkOrigin")
RECTANGLE = ((0, 0), (1, 0), (1, 1), (0, 1))


class StockBox:
    """`node` is for the view; `update` follows the job."""

    def __init__(self) -> None:
        from pivy import coin

        self.node = coin.SoSeparator()
        self._points, self._lines = coin.SoCoordinate3(), coin.SoLineSet()
        colour, style, pick = coin.SoBaseColor(), coin.SoDrawStyle(), coin.SoPickStyle()
        colour.rgb = RGB
        style.lineWidth = 1.5
        pick.style = coin.SoPickStyle.UNPICKABLE  # what is drawn inside the stock stays within reach of the mouse
        for part in (pick, colour, style, self._points, self._lines):
            self.node.addChild(part)

    def update(self, job: Any) -> None:
        """Draw the stock as the job says it is; nothing where the job says nonsense, or shapely is missing."""
        strips = [] if packages.missing("numpy", "shapely") else _strips(job)
        points = [point for strip in strips for point in strip]
        self._points.point.setValues(0, len(points), points)
        self._points.point.setNum(len(points))
        self._lines.numVertices.setValues(0, len(strips), [len(strip) for strip in strips])
        self._lines.numVertices.setNum(len(strips))


def _strips(job: Any) -> list[list[Any]]:
    """Return the edges of the stock and the cross at the work zero, in the document's coordinates."""
    from CNCStepper.simulation.stock import Stock

    try:
        stock = Stock(tuple(job.StockSize), job.StockOrigin)
    except JobError:
        return []
    zero = tuple(job.WorkOrigin)
    (x0, y0, z0), (x1, y1, z1) = (
        tuple(at + shift for at, shift in zip(corner, zero, strict=True)) for corner in (stock.low_mm, stock.high_mm)
    )
    corners = [((x0, x1)[i], (y0, y1)[j]) for i, j in RECTANGLE]
    rims = [[(*corner, z) for corner in (*corners, corners[0])] for z in (z0, z1)]
    posts = [[(*corner, z0), (*corner, z1)] for corner in corners]
    arm = CROSS_SHARE * max(stock.size_mm[:2])
    cross = [[(zero[0] - arm, zero[1], zero[2]), (zero[0] + arm, zero[1], zero[2])]]
    cross += [[(zero[0], zero[1] - arm, zero[2]), (zero[0], zero[1] + arm, zero[2])]]
    return rims + posts + cross
