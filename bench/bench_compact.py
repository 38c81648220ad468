# SPDX-License-Identifier: LGPL-2.1-or-later
"""The published elliptical pocket, point by point at 0.05 mm, before and after `compact`; how long edits take."""

from __future__ import annotations

import tempfile
import time
from collections.abc import Callable
from pathlib import Path

from CNCStepper.gcode.edit.compact import compact
from CNCStepper.gcode.edit.transform_verbs import offset, rotate
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.job.make import make_program
from CNCStepper.job.model import load_job

EXAMPLES = Path(__file__).resolve().parents[1] / "examples"
WANTED = 20  # times fewer blocks at 0.06 mm


def pocket() -> str:
    """Return the program of the example's pocket by the method `dda`."""
    text = (EXAMPLES / "jobs" / "elliptical-pocket.toml").read_text(encoding="utf-8")
    text = text.replace('method = "tolerance"', 'method = "dda"').replace(
        "../machines", f"{EXAMPLES.as_posix()}/machines"
    )
    with tempfile.TemporaryDirectory() as folder:
        job = Path(folder) / "dda.toml"
        job.write_text(text, encoding="utf-8")
        return make_program(*load_job(job)).program


def seconds(call: Callable[[], object]) -> float:
    """Return the processor seconds of a call."""
    begun = time.process_time()
    call()
    return time.process_time() - begun


def main() -> None:
    """Print the blocks at several tolerances, then the times."""
    text = pocket()
    blocks = len(interpret(text))
    compact(text[: text.index("\n", 5000)], 0.06)  # compiles
    for tolerance_mm in (0.03, 0.06, 0.1):
        begun = time.process_time()
        after = len(interpret(compact(text, tolerance_mm).text))
        spent = time.process_time() - begun
        wanted = f" ({WANTED} are wanted)" if tolerance_mm == 0.06 else ""
        print(
            f"compact {tolerance_mm:g} mm: {blocks} blocks become {after}, {blocks / after:.0f} times fewer{wanted}",
            end="",
        )
        print(f", {spent:.1f} s")
    print(f"interpret: {seconds(lambda: interpret(text)):.1f} s", end=", ")
    print(f"offset: {seconds(lambda: offset(text, 1.0)):.1f} s", end=", ")
    print(f"rotate: {seconds(lambda: rotate(text, 30.0)):.1f} s")


if __name__ == "__main__":
    main()
