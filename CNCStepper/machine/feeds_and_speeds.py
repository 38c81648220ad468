# SPDX-License-Identifier: LGPL-2.1-or-later
"""Feeds and speeds of a tool in a material on a machine, and values out of range in those that are given.

    speed of the rim ──► rpm ──► not above what the spindle turns, nor so fast that the axes could not follow with
    the middle of          │     the wanted chip; not below what the spindle turns
    the range              ▼
    chip load ──────► feed = rpm · flutes · chip load ──► plunge = feed · plunge_factor (a drill's is its feed)

What the tool has already (feed, plunge, speed) stays as it is, and the rest follows from it.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal

from CNCStepper.errors import JobError, Text
from CNCStepper.machine.materials import Material, Range
from CNCStepper.machine.profile import Machine
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.machine.tools.tool_shapes import BEAMS, POINTED

USUAL_FLUTES = 2  # where the tool does not say
SLACK = 1.02  # values rounded for the program are no faults


@dataclass(frozen=True)
class Remark:
    """A value outside the range of tool or material, or a cutter that is not for it.

    severity: "info" where the machine can do no better. value, limit: in `unit`, or None where there are none.
    """

    severity: Literal["warning", "info"]
    text: str
    value: float | None
    limit: float | None
    unit: str
    advice: str


@dataclass(frozen=True)
class Feeds:
    """The worked answer: a tool's feeds and speed, what they mean at its edge, and the ranges of the material."""

    spindle_rpm: float
    feed_mm_min: float
    plunge_mm_min: float
    flutes: int
    speed_m_min: float
    speed_range_m_min: Range
    chip_load_mm: float
    chip_range_mm: Range
    stepdown_mm: float
    stepover_mm: float
    remarks: tuple[Remark, ...]


def feeds_of(tool: Tool, material: Material, machine: Machine | None = None) -> Feeds:
    """Return feeds and speed for `tool`: its own, where it has them, else those of the material.

    machine: bounds them by its spindle and the rates of its axes. Raises JobError for a cutter that is of no use in
    the material.
    """
    diameter_mm, flutes = _cutting_diameter_mm(tool), tool.flutes or USUAL_FLUTES
    speeds = material.speed_m_min(tool.made_of)
    chips = _chips_mm(tool, material.chip_load_mm(diameter_mm, tool.made_of))
    rate, plunge_rate = _rates_mm_min(tool, machine)
    chip_mm = math.sqrt(chips[0] * chips[1])
    rpm = tool.spindle_rpm or _rpm(speeds, diameter_mm, rate / (flutes * chip_mm), machine)
    feed = tool.feed_mm_min or float(math.floor(min(rpm * flutes * chip_mm, rate)))
    share = 1.0 if tool.shape == "drill" else material.plunge_factor
    plunge = tool.plunge_mm_min or float(math.floor(min(feed * share, plunge_rate)))
    speed_m_min, chip_mm = rpm * math.pi * diameter_mm / 1000.0, feed / (rpm * flutes)
    remarks = (
        *_flute_remarks(tool),
        *_speed_remarks(tool, speed_m_min, speeds, rpm, machine),
        *_chip_remarks(tool, chip_mm, chips, feed, rate),
    )
    stepdown_mm, stepover_mm = material.stepdown * tool.diameter_mm, material.stepover * tool.diameter_mm
    return Feeds(rpm, feed, plunge, flutes, speed_m_min, speeds, chip_mm, chips, stepdown_mm, stepover_mm, remarks)


def remarks_on(tool: Tool, material: Material, machine: Machine | None = None) -> tuple[Remark, ...]:
    """Return the remarks on a tool in a material, also where it is of no use there."""
    try:
        return () if tool.shape in BEAMS else feeds_of(tool, material, machine).remarks
    except JobError as error:
        return (Remark("warning", error.what, None, None, "", error.advice),)


def with_feeds(tool: Tool, material: Material, machine: Machine | None = None) -> Tool:
    """Return the tool with feed, plunge feed and speed from the material, where it has none of its own."""
    if tool.shape in BEAMS or (tool.feed_mm_min and tool.plunge_mm_min and tool.spindle_rpm):
        return tool
    found = feeds_of(tool, material, machine)
    names = ("spindle_rpm", "feed_mm_min", "plunge_mm_min")
    return tool.model_copy(update={name: getattr(found, name) for name in names})


def _cutting_diameter_mm(tool: Tool) -> float:
    if tool.shape in POINTED:  # half their diameter is what cuts, on an average
        return max(tool.diameter_mm / 2.0, tool.tip_diameter_mm or 0.0)
    return tool.diameter_mm


def _chips_mm(tool: Tool, chips: Range) -> Range:
    """Return the range that both material and tool allow; the tool's own where they have none in common."""
    least, most = max(chips[0], tool.chip_load_min_mm), min(chips[1], tool.chip_load_max_mm or math.inf)
    return (min(least, most), most) if tool.chip_load_max_mm and least > most else (least, max(least, most))


def _rates_mm_min(tool: Tool, machine: Machine | None) -> tuple[float, float]:
    """Return the fastest feed and plunge of the machine; a drill feeds along Z."""
    if machine is None:
        return math.inf, math.inf
    x, y, z = (axis.max_rate_mm_min for axis in machine.axes)
    return (z if tool.shape == "drill" else min(x, y)), z


def _rpm(speeds: Range, diameter_mm: float, rpm_of_rate: float, machine: Machine | None) -> float:
    """Return the speed of the range's middle, whole tens, bounded by the axes' rate and the spindle."""
    rpm = min(1000.0 * math.sqrt(speeds[0] * speeds[1]) / (math.pi * diameter_mm), rpm_of_rate)
    rpm = max(math.floor(rpm / 10.0) * 10.0, 10.0)
    return (
        rpm
        if machine is None or not machine.has_spindle
        else min(max(rpm, machine.spindle.min_rpm), machine.spindle.max_rpm)
    )


def _flute_remarks(tool: Tool) -> Iterator[Remark]:
    """Yield that the flutes are guessed, where the feed or the speed comes of them."""
    if not tool.flutes and not (tool.feed_mm_min and tool.spindle_rpm):
        text = Text(
            "the {tool} tool has no number of flutes; its feed is calculated with {usual_flutes}",
            tool=tool.words,
            usual_flutes=USUAL_FLUTES,
        )
        yield Remark("info", text, None, None, "", "give the tool its flutes")


def _speed_remarks(
    tool: Tool, speed_m_min: float, speeds: Range, rpm: float, machine: Machine | None
) -> Iterator[Remark]:
    if speed_m_min > speeds[1] * SLACK:
        text = Text("the rim of the {tool} tool is too fast for the material", tool=tool.words)
        yield Remark("warning", text, speed_m_min, speeds[1], "m/min", "turn the spindle slower")
    if speed_m_min * SLACK < speeds[0] and tool.shape != "drill":  # drills may turn slowly, in wood above all
        bounded = not tool.spindle_rpm or (machine is not None and rpm >= machine.spindle.max_rpm)
        text = Text("the rim of the {tool} tool is slow for the material", tool=tool.words)
        advice = "the machine can do no better with this tool" if bounded else "turn the spindle faster"
        yield Remark("info" if bounded else "warning", text, speed_m_min, speeds[0], "m/min", advice)


def _chip_remarks(tool: Tool, chip_mm: float, chips: Range, feed: float, rate: float) -> Iterator[Remark]:
    if chip_mm > chips[1] * SLACK:
        text = Text("a tooth of the {tool} tool takes too thick a chip for tool and material", tool=tool.words)
        yield Remark("warning", text, chip_mm, chips[1], "mm", "lower the feed, or turn the spindle faster")
    if chip_mm * SLACK < chips[0]:
        text = Text("a tooth of the {tool} tool takes too thin a chip: it rubs and grows hot", tool=tool.words)
        advice = "turn the spindle slower" if feed >= rate else "raise the feed, or turn the spindle slower"
        yield Remark("warning", text, chip_mm, chips[0], "mm", advice)
