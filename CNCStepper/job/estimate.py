# SPDX-License-Identifier: LGPL-2.1-or-later
"""How long the cuts of a job will be, from its numbers alone, so that a long wait is announced before it begins.

clearing   area / stepover for each level          along curves   their length for each level
holes      the turns of the helix, or the depth    levels         depth / stepdown; one where the cycle has no depth
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Any

from CNCStepper.cycles.cycle import Cycle
from CNCStepper.errors import Text
from CNCStepper.geometry.curve import Curve
from CNCStepper.job.make import numbered
from CNCStepper.job.model import Job

LONG_MM = 1_000_000.0  # of cut in one operation: more takes minutes to make, to prove and to draw
MM_PER_M = 1000.0


def long_work(job: Job) -> list[str]:
    """Return a sentence for each operation whose cut is longer than LONG_MM, which will take minutes to make."""
    told: list[str] = []
    for number, operation in enumerate(job.operation, start=1):
        length_mm, levels = cut_length_mm(operation, job)
        if length_mm > LONG_MM:
            told.append(
                Text(
                    "{operation} will take long: about {length_mm:.0f} m of cut in {levels} levels",
                    operation=numbered(number, operation.cycle),
                    length_mm=length_mm / MM_PER_M,
                    levels=levels,
                )
            )
    return told


def cut_length_mm(operation: Cycle, job: Job) -> tuple[float, int]:
    """Return about how long the cut of an operation is, and in how many levels; holes count as one level."""
    values: Any = operation
    if not (hasattr(values, "stepdown_mm") or hasattr(values, "pattern")):  # a wire or beam cuts through at once
        passes = getattr(values, "passes", 1)
        return sum(curve.length_mm for curve in values.curves) * passes, passes
    depth_mm = values.depth_mm
    if hasattr(values, "pattern") and not isinstance(values.pattern, str):
        holes = len(values.pattern.holes())
        turns = depth_mm / values.pitch_mm if hasattr(values, "pitch_mm") else 0.0
        diameter_mm = getattr(values, "diameter_mm", 0.0) or getattr(values, "major_diameter_mm", 0.0)
        return holes * (depth_mm + turns * math.pi * diameter_mm), 1
    levels = max(math.ceil(depth_mm / (values.stepdown_mm or depth_mm) - 1e-9), 1)
    if hasattr(values, "stepover_mm"):
        return _area_mm2(values, job) / values.stepover_mm * levels, levels
    return sum(curve.length_mm for curve in values.curves) * levels, levels


def _area_mm2(values: Any, job: Job) -> float:
    """Return about what area a clearing cycle clears; islands are not taken out."""
    if hasattr(values, "radius_x_mm"):
        return math.pi * values.radius_x_mm * values.radius_y_mm
    if hasattr(values, "radius_mm"):
        return math.pi * values.radius_mm**2
    if hasattr(values, "corner_a_mm"):
        (left, front), (right, back) = values.corner_a_mm, values.corner_b_mm
        return abs((right - left) * (back - front))
    return _enclosed_mm2(values.outlines or (job.stock.outline(),))


def _enclosed_mm2(curves: Iterable[Curve]) -> float:
    """Return the area of circles as long as the curves: no curve encloses more."""
    return sum(curve.length_mm**2 for curve in curves) / (4.0 * math.pi)
