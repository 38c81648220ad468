# SPDX-License-Identifier: LGPL-2.1-or-later
"""Time estimates beside recordings of real grbl 1.1 firmware, and what the estimate costs."""

from __future__ import annotations

import json
import time
from pathlib import Path

import numpy as np

from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.machine.profile import load_machine
from CNCStepper.motion.planner.plan import duration_s, step_events
from CNCStepper.state import Start
from CNCStepper.toolpath import Toolpath

RECORDINGS = Path(__file__).parents[1] / "tests" / "data" / "firmware"
BLOCKS = 200_000


def stepping_s(toolpath: Toolpath, machine) -> float:
    """Return the time from the first to the last step, as the recordings count it."""
    times = np.concatenate([times_s for times_s, _ in step_events(toolpath, machine)])
    return float(times[-1] - times[0])


def planner_speed() -> float:
    """Return blocks a second on a spiral of short lines."""
    angle = np.arange(BLOCKS) * 0.01
    radius = 5 + np.arange(BLOCKS) * 2e-4
    points = zip(radius * np.cos(angle), radius * np.sin(angle), strict=True)
    text = "G21 G90\nF1200\n" + "".join(f"G1 X{x:.3f} Y{y:.3f}\n" for x, y in points)
    toolpath, machine = interpret(text, Start.at_zero()), load_machine("table-a")
    begun = time.perf_counter()
    duration_s(toolpath, machine)
    return BLOCKS / (time.perf_counter() - begun)


def main() -> None:
    """Print each recording beside our planner, and the planner's speed."""
    for path in sorted(RECORDINGS.glob("*.json")):
        recording = json.loads(path.read_text("utf-8"))
        beside = path.with_name(f"{recording['machine']}.toml")  # of a machine that is not shipped
        machine = load_machine(beside if beside.exists() else recording["machine"])
        ours = stepping_s(interpret("\n".join(recording["program"]), Start.at_zero()), machine)
        theirs = recording["duration_s"]
        print(f"{path.stem:20} firmware {theirs:8.3f} s, ours {ours:8.3f} s, ratio {ours / theirs:.5f}")
    print(f"planner: {planner_speed():,.0f} blocks/s on {BLOCKS} short lines")


if __name__ == "__main__":
    main()
