# SPDX-License-Identifier: LGPL-2.1-or-later
"""Clearing at bounded engagement: the worst angle and the length, beside the bound and the offset pattern's length.

The plate's pocket as whole programs, then its pattern alone and those of five random areas; angles by the independent
judge of the tests.
"""

from __future__ import annotations

import math
import sys
import time
from dataclasses import replace
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "tests"))

import numpy as np

from CNCStepper.cycles.clearing.engagement.bounded_engagement_pattern import engagement_pattern
from CNCStepper.cycles.clearing.engagement.cut_length import parallels_mm
from CNCStepper.cycles.clearing.pattern import Area
from CNCStepper.cycles.pockets.pocket import Pocket
from CNCStepper.geometry.curve import circle, from_points
from CNCStepper.geometry.region import Region
from CNCStepper.simulation.checks.program_report import report
from helpers.cycles.engagement_judge import met_by
from helpers.cycles.product_verdict import cut, tool
from helpers.cycles.random_areas import random_area

TOLERANCE_MM = 0.01
PLATE = [(30, 25), (70, 22), (85, 40), (120, 30), (130, 60), (100, 85), (60, 70), (35, 85)]
BOSS = [(90, 50), (104, 48), (106, 62), (92, 64)]


def plate_room() -> Region:
    """Return where the centre of a 6 mm tool may be in the plate's pocket."""
    islands = [circle((60, 48), 7), from_points(BOSS, closed=True)]
    return Region.of([from_points(PLATE, closed=True)], islands).offset(-3.0, TOLERANCE_MM / 4)


def show(name: str, room: Region, tool_mm: float, max_deg: float) -> None:
    """Print one row."""
    stepover_mm = tool_mm * (1.0 - math.cos(math.radians(max_deg)))
    area = Area(room, tool_mm, stepover_mm, TOLERANCE_MM, True)
    begun, cpu = time.perf_counter(), time.process_time()
    runs = engagement_pattern(max_deg)(area)
    wall_s, cpu_s = time.perf_counter() - begun, time.process_time() - cpu
    met = [met_by(run, tool_mm) for run in runs]
    offset_mm = parallels_mm(room, stepover_mm, TOLERANCE_MM)
    cut_mm = sum(one.cut_mm for one in met)
    feed_mm = sum(one.feed_mm for one in met)
    blocks = sum(len(one.curve) for run in runs for one in run.passes)
    print(f"{name}: bound {max_deg:g}, worst {max(one.angle_deg.max() for one in met):.0f} degrees; ", end="")
    print(
        f"in material {cut_mm / offset_mm:.2f}, all feed {feed_mm / offset_mm:.2f} times the offset pattern's length; ",
        end="",
    )
    print(f"{blocks} blocks; {wall_s:.2f} s (processor {cpu_s:.2f})", flush=True)


def show_program(max_deg: float) -> None:
    """Print how much the plate's pocket feeds below the stock's top, beside the same pocket with parallels."""
    outlines = (from_points(PLATE, closed=True),)
    islands = (circle((60, 48), 7), from_points(BOSS, closed=True))
    stepover_mm = 3.0 * (1.0 - math.cos(math.radians(max_deg)))
    keys = {"tool": 1, "depth_mm": 2.0, "stepdown_mm": 2.0, "stepover_mm": stepover_mm}
    lengths = []
    for pattern in ({"pattern": "engagement", "engagement_max_deg": max_deg}, {"pattern": "offset"}):
        path, _ = cut(Pocket(outlines=outlines, islands=islands, **keys, **pattern), tool(6.0))
        lengths.append(report(path, np.zeros(len(path)))["cut_length_mm"])
    ratio = lengths[0] / lengths[1]
    print(f"plate, whole program: bound {max_deg:g}, {lengths[0]:.0f} mm to {lengths[1]:.0f} mm, {ratio:.2f} times")


def main() -> None:
    """Print all rows; the first one is done twice, for its first call."""
    for max_deg in (45.0, 60.0, 75.0, 90.0):
        show_program(max_deg)
    for max_deg in (60.0, 60.0, 30.0, 90.0):
        show("plate", plate_room(), 3.0, max_deg)
    for seed in (2, 8, 11, 19, 21):
        drawn = random_area(seed)
        drawn = replace(drawn, tool_mm=round(0.5 * drawn.tool_mm, 3))
        show(f"random area {seed}", drawn.area(1.0).room, drawn.tool_mm, 75.0)


if __name__ == "__main__":
    main()
