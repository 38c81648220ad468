# SPDX-License-Identifier: LGPL-2.1-or-later
"""The values with which new objects begin: they fit the selection, the stock and the tool."""

from __future__ import annotations

import math
from typing import Any

from CNCStepper.machine.processes import MILLING
from CNCStepper.workbench.document.preferred_values import THICKNESS_MM
from CNCStepper.workbench.features.base import entry_of, value_of

MARGIN_MM = 10.0  # of stock around a drawing
SHARE_OF_STOCK = 0.4  # of its length and width: the half axes of a pocket without a drawing
SHARE_OF_TOOL = 0.4  # of its diameter: the stepover
DEPTH_MM = 10.0
STEPDOWN_MM = 2.0
ENGRAVING_MM = 1.0
FACED_MM = 0.5
SHARE_BORED = 2.0  # of the tool's diameter: a bore
SHARE_FACING = 0.6  # of the tool's diameter: the stepover of a facing
FEEDS = ("feed_mm_min", "plunge_mm_min", "spindle_rpm")


def stock_of_solid(box: Any) -> dict[str, Any]:
    """Return the job's values for a stock that is a solid's bounding box, the work zero on top in the middle."""
    return _stock(box, (box.XLength, box.YLength, box.ZLength))


def stock_of_drawing(box: Any, thickness_mm: float = THICKNESS_MM) -> dict[str, Any]:
    """Return the job's values for a stock with a margin around a drawing, which lies on its top."""
    return _stock(box, (box.XLength + 2 * MARGIN_MM, box.YLength + 2 * MARGIN_MM, thickness_mm))


def stock_around(box: Any, job: Any) -> dict[str, Any]:
    """Return the job's values for a box of stock around a drawing: as thick as its stock is, its zero where it was."""
    x_mm, y_mm = box.Center.x, box.Center.y
    if job.StockOrigin != "top-centre":
        x_mm, y_mm = box.XMin - MARGIN_MM, box.YMin - MARGIN_MM
    size_mm = (box.XLength + 2 * MARGIN_MM, box.YLength + 2 * MARGIN_MM, job.StockSize[2])
    origin_mm = (x_mm, y_mm, job.WorkOrigin[2])
    return {"stock_form": "box", "stock_size_mm": _rounded(size_mm), "work_origin_mm": _rounded(origin_mm)}


def pocket(stock_mm: tuple[float, float, float], origin: str, diameter_mm: float, drawn: bool) -> dict[str, Any]:
    """Return the values of a pocket in the middle of the stock, or of one whose ellipse a drawing gives."""
    values = area(stock_mm, diameter_mm)
    return values if drawn else {**values, **_middle(stock_mm, origin)}


def area(stock_mm: tuple[float, float, float], diameter_mm: float) -> dict[str, Any]:
    """Return the depths and the stepover of any pocket."""
    return {**half_deep(stock_mm), "stepover_mm": round(SHARE_OF_TOOL * diameter_mm, 3)}


def circle(stock_mm: tuple[float, float, float], origin: str, diameter_mm: float, drawn: bool) -> dict[str, Any]:
    """Return the values of a circular pocket in the middle of the stock, or of one that a drawing gives."""
    middle = {"centre_mm": _centre(stock_mm, origin), "radius_mm": round(SHARE_OF_STOCK * min(stock_mm[:2]), 3)}
    return {**area(stock_mm, diameter_mm), **({} if drawn else middle)}


def rectangle(stock_mm: tuple[float, float, float], origin: str, diameter_mm: float, drawn: bool) -> dict[str, Any]:
    """Return the values of a rectangular pocket in the middle of the stock, or of one that a drawing gives."""
    (x, y), (length, width, _) = _centre(stock_mm, origin), stock_mm
    half_x, half_y = round(SHARE_OF_STOCK * length, 3), round(SHARE_OF_STOCK * width, 3)
    corners = {"corner_a_mm": (x - half_x, y - half_y), "corner_b_mm": (x + half_x, y + half_y)}
    return {**area(stock_mm, diameter_mm), **({} if drawn else corners)}


def face(stock_mm: tuple[float, float, float], diameter_mm: float) -> dict[str, Any]:
    """Return the values of a thin facing."""
    depth_mm = min(FACED_MM, stock_mm[2] / 2)
    return {"depth_mm": depth_mm, "stepdown_mm": depth_mm, "stepover_mm": round(SHARE_FACING * diameter_mm, 3)}


def contour(stock_mm: tuple[float, float, float]) -> dict[str, Any]:
    """Return the depths of a contour that cuts through the stock."""
    return {"depth_mm": stock_mm[2], "stepdown_mm": min(STEPDOWN_MM, stock_mm[2])}


def holes(stock_mm: tuple[float, float, float], origin: str, drawn: bool) -> dict[str, Any]:
    """Return the values of holes round the middle of the stock, or of those that a drawing gives."""
    centre, radius_mm = _centre(stock_mm, origin), round(SHARE_OF_STOCK * min(stock_mm[:2]), 3)
    round_middle = {"pattern_centre_mm": centre, "pattern_radius_mm": radius_mm}
    places = {"pattern_kind": "drawing"} if drawn else round_middle
    return {"depth_mm": half_deep(stock_mm)["depth_mm"], **places}


def bored(diameter_mm: float) -> float:
    """Return the diameter of a bore or thread that a tool can cut."""
    return round(SHARE_BORED * diameter_mm, 3)


def half_deep(stock_mm: tuple[float, float, float]) -> dict[str, Any]:
    """Return the depths of what goes half through thin stock."""
    depth_mm = min(DEPTH_MM, stock_mm[2] / 2)
    return {"depth_mm": depth_mm, "stepdown_mm": min(STEPDOWN_MM, depth_mm)}


def engraving(stock_mm: tuple[float, float, float]) -> dict[str, Any]:
    """Return the values of an engraving that stays within the stock."""
    return {"depth_mm": min(ENGRAVING_MM, stock_mm[2] / 2), "order": "short"}


def tool(job: Any) -> dict[str, Any]:
    """Return the values of a new tool: its feeds are those of the job's material, where it has one."""
    return dict.fromkeys(FEEDS, 0.0) if job.Process == MILLING.name and job.Material else {}


def untyped_feeds(tool: Any, job: Any) -> dict[str, float]:
    """Return the feeds and speed to give to a tool whose job has got another material, or none.

    Nobody has typed a value that is 0 or a new tool's: the material gives it (0), without one a new tool's counts.
    """
    if job.Process != MILLING.name or tool.FromChart:
        return {}
    entries = [entry_of(tool.Proxy, key) for key in FEEDS]
    present = {entry.key: float(value_of(tool, entry)) for entry in entries}
    wanted = {entry.key: 0.0 if job.Material else float(entry.default) for entry in entries}
    untyped = (entry for entry in entries if any(math.isclose(present[entry.key], x) for x in (0.0, entry.default)))
    return {entry.key: wanted[entry.key] for entry in untyped if present[entry.key] != wanted[entry.key]}


def _stock(box: Any, size_mm: tuple[float, float, float]) -> dict[str, Any]:
    top = (box.Center.x, box.Center.y, box.ZMax)
    return {"stock_size_mm": _rounded(size_mm), "stock_origin": "top-centre", "work_origin_mm": _rounded(top)}


def _rounded(numbers_mm: tuple[float, ...]) -> tuple[float, ...]:
    """Return lengths without the noise that a modelled shape has."""
    return tuple(round(number, 4) for number in numbers_mm)


def _centre(stock_mm: tuple[float, float, float], origin: str) -> tuple[float, float]:
    return (0.0, 0.0) if origin == "top-centre" else (stock_mm[0] / 2, stock_mm[1] / 2)


def _middle(stock_mm: tuple[float, float, float], origin: str) -> dict[str, Any]:
    return {
        "centre_mm": _centre(stock_mm, origin),
        "radius_x_mm": round(SHARE_OF_STOCK * stock_mm[0], 3),
        "radius_y_mm": round(SHARE_OF_STOCK * stock_mm[1], 3),
    }
