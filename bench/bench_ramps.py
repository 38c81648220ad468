# SPDX-License-Identifier: LGPL-2.1-or-later
"""The ramps beside one another: how long the same programs take by each, and what planning costs the processor."""

from __future__ import annotations

import math
import time
from dataclasses import replace

import numpy as np

from CNCStepper.machine.profile import load_machine
from CNCStepper.machine.step_wait_tables import accelerated_s
from CNCStepper.motion.planner.machine_limits import Limits
from CNCStepper.motion.planner.plan import duration_s
from CNCStepper.state import Start, State
from CNCStepper.toolpath import ARC_CCW, TableBuilder, Toolpath

FEED_MM_MIN = 3000.0
BLOCKS = 100_000
MODES = {
    "exact path": State(),
    "exact stop": State(path_mode="exact_stop"),
    "blend 0.2 mm": State(path_mode="blend", blend_mm=0.2),
}


def square(state: State) -> Toolpath:
    """Return a square of 40 mm."""
    table = TableBuilder(Start.at_zero(), state)
    for point in ((40, 0, 0), (40, 40, 0), (0, 40, 0), (0, 0, 0)):
        table.feed(point, FEED_MM_MIN)
    return table.toolpath()


def circle() -> Toolpath:
    """Return a circle of 20 mm, which is split into chords."""
    table = TableBuilder(Start.at_zero())
    table.arc(ARC_CCW, (0, 0, 0), (10, 0, 0), FEED_MM_MIN)
    return table.toolpath()


def spiral() -> Toolpath:
    """Return many short lines."""
    table = TableBuilder(Start.at_zero())
    angles = np.arange(BLOCKS) * 0.01
    for angle, radius in zip(angles, 5 + angles * 0.02, strict=True):
        table.feed((radius * math.cos(angle), radius * math.sin(angle), 0), FEED_MM_MIN)
    return table.toolpath()


def main() -> None:
    """Print durations and their ratio to the trapezoid's, and the blocks a second of processor time."""
    trapezoid = Limits.of(load_machine("table-a"))
    steps_s2 = min(a * s for a, s in zip(trapezoid.acceleration_mm_s2, trapezoid.steps_per_mm, strict=True))
    ramps = {
        "trapezoid": trapezoid,
        "s_curve": replace(trapezoid, ramp="s_curve", jerk_mm_s3=(5000.0,) * trapezoid.axes),
        "table": replace(trapezoid, ramp="table", waits_s=accelerated_s(steps_s2, 4000)),
    }
    programs = {f"square, {name}": square(state) for name, state in MODES.items()} | {"circle": circle()}
    for name, toolpath in programs.items():
        took = {ramp: duration_s(toolpath, limits) for ramp, limits in ramps.items()}
        print(f"{name:22}", "  ".join(f"{ramp} {s:7.3f} s ({s / took['trapezoid']:.2f})" for ramp, s in took.items()))
    lines = spiral()
    for ramp, limits in ramps.items():
        begun = time.process_time()
        duration_s(lines, limits)
        print(f"{ramp:10} {BLOCKS / (time.process_time() - begun):12,.0f} blocks/s of processor time")


if __name__ == "__main__":
    main()
