# SPDX-License-Identifier: LGPL-2.1-or-later
"""Depth and width of cut, recalculated to whole passes."""

from __future__ import annotations

import math

from CNCStepper.errors import CycleError


def whole_passes(total_mm: float, step_mm: float, finish_mm: float, finish_name: str) -> list[float]:
    """Return the steps that fill `total_mm`: equal ones not above `step_mm`, then the finishing one where there is one.

    I = ceil((R - d_finish) / d), part C. Raises CycleError when the finishing step leaves nothing to rough.
    """
    rough_mm = total_mm - finish_mm
    if rough_mm <= 0:
        raise CycleError(
            "finish-large",
            f"{finish_name} leaves nothing to rough",
            value=f"{finish_mm:g} mm",
            limit=f"below {total_mm:g} mm",
            advice=f"make {finish_name} smaller",
        )
    passes = math.ceil(rough_mm / step_mm - 1e-9)
    return [rough_mm / passes] * passes + ([finish_mm] if finish_mm else [])
