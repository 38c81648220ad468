# SPDX-License-Identifier: LGPL-2.1-or-later
"""Depth and width of cut, recalculated to whole passes."""

from __future__ import annotations

import math

import numpy as np

from CNCStepper.errors import CycleError, Text
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.tolerances import NO_MATERIAL_MM

MOST_PASSES = 10_000
MOST_BLOCKS = 1_000_000  # of one operation
MOST_TOLD = 1e9  # larger numbers say no more to a person


def whole_passes(total_mm: float, step_mm: float, finish_mm: float, name: str) -> list[float]:
    """Return the steps that fill `total_mm`: equal ones not above `step_mm`, then the finishing one where there is one.

    I = ceil((R - d_finish) / d), part C. Raises CycleError when the finishing step leaves nothing to rough, or
    for more than MOST_PASSES; `name` is that of the step's key.
    """
    rough_mm = total_mm - finish_mm
    if rough_mm < NO_MATERIAL_MM:
        raise CycleError(
            "finish-large",
            Text("finish_{name} leaves nothing to rough", name=name),
            value=f"{finish_mm:g} mm",
            limit=Text("below {total_mm:g} mm", total_mm=total_mm),
            advice=Text("make finish_{name} smaller", name=name),
        )
    require_few_passes(rough_mm, step_mm, name)
    return equal_passes(rough_mm, max(math.ceil(rough_mm / step_mm - 1e-9), 1), finish_mm)


def require_few_passes(rough_mm: float, step_mm: float, name: str) -> None:
    """Raise CycleError when more than MOST_PASSES steps would fill `rough_mm`; `name` is that of the step's key."""
    if rough_mm > MOST_PASSES * step_mm:
        raise CycleError(
            "passes-many",
            Text("{name} asks for more than {most_passes} passes", name=name, most_passes=MOST_PASSES),
            value=f"{step_mm:g} mm",
            limit=Text("at least {rough_mm:.3g} mm", rough_mm=rough_mm / MOST_PASSES),
            advice=Text("make {name} larger", name=name),
        )


def equal_passes(rough_mm: float, count: int, finish_mm: float) -> list[float]:
    """Return `count` equal steps that fill `rough_mm`, then the finishing one where there is one."""
    return [rough_mm / count] * count + ([finish_mm] if finish_mm else [])


def whole_steps(total_mm: float, step_mm: float) -> float:
    """Return how many equal steps of at most `step_mm` fill `total_mm`: a whole number, or inf for a step too small."""
    return float(np.ceil(total_mm / step_mm - 1e-9))


def deep_pass_warnings(deepest_mm: float, tool: Tool) -> list[str]:
    """Return a warning when one pass is deeper than a rotating tool is wide."""
    if tool.shape in ("jet", "wire") or deepest_mm <= tool.diameter_mm * (1.0 + 1e-9):
        return []
    return [
        Text(
            "one pass is {deepest_mm:g} mm deep, deeper than the tool's diameter of "
            "{diameter_mm:g} mm; give stepdown_mm",
            deepest_mm=deepest_mm,
            diameter_mm=tool.diameter_mm,
        )
    ]


def require_few_blocks(blocks: float) -> None:
    """Raise CycleError when an operation would have more than MOST_BLOCKS blocks; they may be inf."""
    if blocks > MOST_BLOCKS:
        raise CycleError(
            "blocks-many",
            "the operation is too long for one program",
            value=f"{min(blocks, MOST_TOLD):.0f} blocks",
            limit=f"{MOST_BLOCKS} blocks",
            advice="make the passes, the levels, the resolution or the entry angle larger",
        )
