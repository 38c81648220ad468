# SPDX-License-Identifier: LGPL-2.1-or-later
"""Depth and width of cut, recalculated to whole passes."""

from __future__ import annotations

import math

from CNCStepper.errors import CycleError

MOST_PASSES = 10_000
MOST_BLOCKS = 1_000_000  # of one operation
THINNEST_MM = 1e-6  # what is left to rough below this is rounding


def whole_passes(total_mm: float, step_mm: float, finish_mm: float, name: str) -> list[float]:
    """Return the steps that fill `total_mm`: equal ones not above `step_mm`, then the finishing one where there is one.

    I = ceil((R - d_finish) / d), part C. Raises CycleError when the finishing step leaves nothing to rough, or
    for more than MOST_PASSES; `name` is that of the step's key.
    """
    rough_mm = total_mm - finish_mm
    if rough_mm < THINNEST_MM:
        raise CycleError(
            "finish-large",
            f"finish_{name} leaves nothing to rough",
            value=f"{finish_mm:g} mm",
            limit=f"below {total_mm:g} mm",
            advice=f"make finish_{name} smaller",
        )
    if rough_mm > MOST_PASSES * step_mm:
        raise CycleError(
            "passes-many",
            f"{name} asks for more than {MOST_PASSES} passes",
            value=f"{step_mm:g} mm",
            limit=f"at least {rough_mm / MOST_PASSES:.3g} mm",
            advice=f"make {name} larger",
        )
    return equal_passes(rough_mm, max(math.ceil(rough_mm / step_mm - 1e-9), 1), finish_mm)


def equal_passes(rough_mm: float, count: int, finish_mm: float) -> list[float]:
    """Return `count` equal steps that fill `rough_mm`, then the finishing one where there is one."""
    return [rough_mm / count] * count + ([finish_mm] if finish_mm else [])


def require_few_blocks(blocks: int) -> None:
    """Raise CycleError when an operation would have more than MOST_BLOCKS blocks."""
    if blocks > MOST_BLOCKS:
        raise CycleError(
            "blocks-many",
            "the operation is too long for one program",
            value=f"{blocks} blocks",
            limit=f"{MOST_BLOCKS} blocks",
            advice="make the passes, the levels, the resolution or the entry angle larger",
        )
