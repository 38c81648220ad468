# SPDX-License-Identifier: LGPL-2.1-or-later
"""Thirty parallels of a 10 000-vertex outline: ours, in lines and arcs, beside shapely's buffer, in the same run."""

from __future__ import annotations

import time
from collections.abc import Callable

import numpy as np
from shapely import Polygon

from CNCStepper.geometry.curve import from_points
from CNCStepper.geometry.region import Region

VERTICES, TIMES, STEP_MM = 10_000, 30, 0.5
TOLERANCE_MM = 0.01
QUARTER = 64  # chords in a quarter turn: 0.01 mm at 15 mm is 43


def outline(rough_mm: float) -> np.ndarray:
    """Return a five-lobed outline, its points off it by `rough_mm` (one standard deviation)."""
    angles = np.linspace(0.0, 2.0 * np.pi, VERTICES, endpoint=False)
    radii = 50.0 + 10.0 * np.sin(5.0 * angles) + np.random.default_rng(1).normal(0.0, rough_mm, VERTICES)
    return np.column_stack([radii * np.cos(angles), radii * np.sin(angles)])


def seconds(offset: Callable[[float], object]) -> tuple[float, float]:
    """Return wall and processor seconds for all distances."""
    wall, cpu = time.perf_counter(), time.process_time()
    for number in range(TIMES):
        offset(-STEP_MM * (number + 1))
    return time.perf_counter() - wall, time.process_time() - cpu


def guarded() -> dict[str, float]:
    """Print both sides for a smooth and for a rough outline; return how many times as fast as shapely we are."""
    ratios = {}
    for rough_mm in (0.0, 0.001):
        points = outline(rough_mm)
        begun = time.perf_counter()
        region, polygon = Region.of([from_points(points, closed=True)]), Polygon(points)
        region.offset(-STEP_MM, TOLERANCE_MM)
        first = time.perf_counter() - begun
        ours, ours_cpu = seconds(lambda distance_mm, region=region: region.offset(distance_mm, TOLERANCE_MM))
        theirs, theirs_cpu = seconds(lambda distance_mm, polygon=polygon: polygon.buffer(distance_mm, QUARTER))
        print(f"offset: {VERTICES} vertices, {rough_mm:g} mm rough, {TIMES} times: ours {ours:.2f} s ", end="")
        print(f"(processor {ours_cpu:.2f}, first call {first:.2f} s), shapely {theirs:.2f} s ", end="")
        print(f"(processor {theirs_cpu:.2f}), ratio {theirs_cpu / ours_cpu:.2f}")
        ratios[f"offset, {rough_mm:g} mm rough"] = theirs_cpu / ours_cpu
    return ratios


if __name__ == "__main__":
    guarded()
