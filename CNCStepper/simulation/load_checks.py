# SPDX-License-Identifier: LGPL-2.1-or-later
"""The load on the tool along the path: flutes, holder, engagement angle and chip load against what the tool allows."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import numpy as np

from CNCStepper.machine.tool import Tool
from CNCStepper.simulation.cutter import Tools, tool_numbered
from CNCStepper.simulation.finding import Finding, Severity
from CNCStepper.simulation.stock import Stock
from CNCStepper.simulation.subject import Subject

DEPTH_ERROR_MM = 0.01
ANGLE_ERROR_DEG = 15.0  # of the map in which the angle is measured
CHIP_SHARE = 1.001


def loads(subject: Subject, stock: Stock, tools: Tools) -> Iterator[Finding]:
    """Yield for each tool where it is loaded more than it may; what a tool does not say is not checked.

    Where a tool says something of the material that it may meet, the subject must be the whole program.
    """
    numbers = subject.tool_numbers
    known = {number: tool_numbered(tools, number) for number in np.unique(numbers).tolist()}
    for number, tool in known.items():
        if tool is not None:
            yield from _thin_chips(subject, number, tool, numbers == number, stock)
    if not needs_material(known.values()):
        return
    from CNCStepper.simulation.engagement import Engagement, engagement

    met: Engagement = engagement(subject.toolpath, tools, stock)
    for number, tool in known.items():
        mine = numbers[met.row] == number
        if tool is not None and _says_something(tool):
            yield from _along(subject, tool, met, mine)


def needs_material(tools: Iterable[Tool | None]) -> bool:
    """Whether one of the tools says how much material it may meet: that is measured along the whole program."""
    return any(tool is not None and _says_something(tool) for tool in tools)


def _says_something(tool: Tool) -> bool:
    holder = tool.length_mm and tool.holder_diameter_mm
    return bool(tool.flute_length_mm or holder or tool.engagement_max_deg or tool.chip_load_max_mm)


def _along(subject: Subject, tool: Tool, met, mine: np.ndarray) -> Iterator[Finding]:
    feed = mine & subject.is_feed[met.row]
    if tool.flute_length_mm:
        text = f"the {tool.words} tool cuts deeper than its flutes are long"
        advice = "cut in more levels, or take a longer tool"
        limit = tool.flute_length_mm
        cut = _worst(
            subject, met, feed, met.uncut_mm, limit, DEPTH_ERROR_MM, "error", "flute-length", text, advice, "mm"
        )
        yield from cut
        text = f"the shank of the {tool.words} tool rubs along the wall over its flutes"
        wall = _worst(subject, met, feed, met.beside_mm, limit, DEPTH_ERROR_MM, "warning", "shank", text, advice, "mm")
        yield from wall if not cut else ()
    if tool.length_mm and tool.holder_diameter_mm:
        text, advice = f"the holder of the {tool.words} tool goes into stock", "let the tool stick out farther"
        yield from _worst(
            subject, met, mine, met.holder_mm, tool.length_mm, DEPTH_ERROR_MM, "error", "holder", text, advice, "mm"
        )
    if (tool.engagement_max_deg or tool.chip_load_max_mm) and feed.any() and tool.radius_mm < met.least_radius_mm:
        text = f"the {tool.words} tool is too small against its path for its engagement to be measured"
        row = int(met.row[feed][0])
        yield subject.finding(row, "info", "engagement-unknown", text, advice="prove parts of the program alone")
    if tool.engagement_max_deg:
        text = f"more of the {tool.words} tool's rim is in the material than it may"
        advice = "lower the stepover, enter by a helix, or leave less in the corners"
        yield from _worst(
            subject, met, feed, met.angle_deg, tool.engagement_max_deg, ANGLE_ERROR_DEG, "warning", "engagement", text,
            advice, "deg",
        )  # fmt: skip
    if tool.chip_load_max_mm:
        text, advice = f"a tooth of the {tool.words} tool takes too thick a chip", "lower F, or turn the spindle faster"
        limit = tool.chip_load_max_mm
        chip = _chip_load_mm(subject, tool)[met.row] * np.sin(np.radians(np.minimum(np.nan_to_num(met.angle_deg), 90)))
        yield from _worst(
            subject, met, feed, chip, limit, limit * (CHIP_SHARE - 1), "warning", "chip-load", text, advice, "mm"
        )


def _worst(
    subject: Subject,
    met,
    where: np.ndarray,
    value: np.ndarray,
    limit: float,
    error: float,
    severity: Severity,
    code: str,
    text: str,
    advice: str,
    unit: str,
) -> list[Finding]:
    """Return one finding where the value is largest, if that is above the limit by more than the measuring error."""
    over = np.flatnonzero(where & (np.nan_to_num(value, nan=-np.inf) > limit + error))
    if not len(over):
        return []
    k = int(over[value[over].argmax()])
    return [
        subject.finding(
            int(met.row[k]),
            severity,
            code,
            text,
            advice=advice,
            place_mm=tuple(met.place_mm[k].tolist()),
            value=float(value[k]),
            limit=limit,
            unit=unit,
            count=len(np.unique(met.row[over])),
        )
    ]


def _thin_chips(subject: Subject, number: int, tool: Tool, mine: np.ndarray, stock: Stock) -> Iterator[Finding]:
    """Yield the cut that asks less of each tooth than it needs to cut instead of rub."""
    if not tool.chip_load_min_mm:
        return
    chip = _chip_load_mm(subject, tool)
    level = np.hypot(*(subject.end - subject.begin)[:, :2].T) > 0
    rows = mine & subject.is_feed & level & (subject.low_mm < stock.top_mm) & (chip > 0)
    thin = np.flatnonzero(rows & (chip * CHIP_SHARE < tool.chip_load_min_mm))
    if len(thin):
        k = int(thin[chip[thin].argmin()])
        yield subject.finding(
            k,
            "warning",
            "chip-load",
            f"the {tool.words} tool rubs: a tooth takes too thin a chip",
            advice="raise F, or turn the spindle slower",
            value=float(chip[k]),
            limit=tool.chip_load_min_mm,
            unit="mm",
            count=len(thin),
            group=f"thin-{number}",
            rank=-float(chip[k]),
            at_first=False,
        )


def _chip_load_mm(subject: Subject, tool: Tool) -> np.ndarray:
    """Return how far the tool goes on with each tooth on every row, 0 where nothing turns."""
    rpm = np.array([state.spindle_rpm if state.spindle_turns else 0.0 for state in subject.toolpath.states])
    teeth = rpm[subject.table.state] * tool.flutes
    return np.where(teeth > 0, subject.table.feed / np.where(teeth > 0, teeth, 1.0), 0.0)
