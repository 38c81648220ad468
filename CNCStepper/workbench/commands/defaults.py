# SPDX-License-Identifier: LGPL-2.1-or-later
"""The values with which new objects begin: they fit the selection, the stock and the tool."""

from __future__ import annotations

from typing import Any

MARGIN_MM = 10.0  # of stock around a drawing
HEIGHT_MM = 20.0
SHARE_OF_STOCK = 0.4  # of its length and width: the half axes of a pocket without a drawing
SHARE_OF_TOOL = 0.4  # of its diameter: the stepover
DEPTH_MM = 10.0
STEPDOWN_MM = 2.0
ENGRAVING_MM = 1.0


def stock_of_solid(box: Any) -> dict[str, Any]:
    """Return the job's values for a stock that is a solid's bounding box, the work zero on top in the middle."""
    return _stock(box, (box.XLength, box.YLength, box.ZLength))


def stock_of_drawing(box: Any) -> dict[str, Any]:
    """Return the job's values for a stock with a margin around a drawing, which lies on its top."""
    return _stock(box, (box.XLength + 2 * MARGIN_MM, box.YLength + 2 * MARGIN_MM, HEIGHT_MM))


def pocket(stock_mm: tuple[float, float, float], origin: str, diameter_mm: float, drawn: bool) -> dict[str, Any]:
    """Return the values of a pocket in the middle of the stock, or of one whose ellipse a drawing gives."""
    depth_mm = min(DEPTH_MM, stock_mm[2] / 2)
    values = {
        "depth_mm": depth_mm,
        "stepdown_mm": min(STEPDOWN_MM, depth_mm),
        "stepover_mm": round(SHARE_OF_TOOL * diameter_mm, 3),
    }
    return values if drawn else {**values, **_middle(stock_mm, origin)}


def engraving(stock_mm: tuple[float, float, float]) -> dict[str, Any]:
    """Return the values of an engraving that stays within the stock."""
    return {"depth_mm": min(ENGRAVING_MM, stock_mm[2] / 2)}


def _stock(box: Any, size_mm: tuple[float, float, float]) -> dict[str, Any]:
    top = (box.Center.x, box.Center.y, box.ZMax)
    return {"stock_size_mm": _rounded(size_mm), "stock_origin": "top-centre", "work_origin_mm": _rounded(top)}


def _rounded(numbers_mm: tuple[float, ...]) -> tuple[float, ...]:
    """Return lengths without the noise that a modelled shape has."""
    return tuple(round(number, 4) for number in numbers_mm)


def _middle(stock_mm: tuple[float, float, float], origin: str) -> dict[str, Any]:
    centre = (0.0, 0.0) if origin == "top-centre" else (stock_mm[0] / 2, stock_mm[1] / 2)
    return {
        "centre_mm": centre,
        "radius_x_mm": round(SHARE_OF_STOCK * stock_mm[0], 3),
        "radius_y_mm": round(SHARE_OF_STOCK * stock_mm[1], 3),
    }
