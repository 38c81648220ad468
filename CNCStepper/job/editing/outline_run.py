# SPDX-License-Identifier: LGPL-2.1-or-later
"""A program that drives round another one in air: the rectangle about all that it cuts, at its own safe height.

    program ──► table of moves ──► corners of its feeds, greatest height of its path ──► program of the outline

Nothing cuts while it runs: spindle, torch and laser are switched off first. It is proven and sent like any other.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from CNCStepper.errors import JobError
from CNCStepper.gcode.dialects import dialect_named
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.machine.processes import PROCESSES
from CNCStepper.machine.profile import Machine
from CNCStepper.output_files import MADE_BY
from CNCStepper.simulation.tip_segments import segments
from CNCStepper.state import Start
from CNCStepper.toolpath import RAPID, Toolpath

FEED_MM_MIN = 2000.0  # slow enough for the eye to follow
MODES = ("G21", "G17", "G90", "G94")  # as far as the dialect has them
POWER_OFF = "M5"
ARC_MM = 0.01  # how far a chord may leave its arc


def outline_program(
    text: str, machine: Machine, process: str, language: str = "", start: Start | None = None, file: str = ""
) -> str:
    """Return the program that drives round the feeds of a program's text, in mm and in the same dialect.

    process: of `PROCESSES`. language: the dialect, "" for the machine's own. start: from which the text is read.
    Raises ProgramError for a text that cannot be read, JobError where nothing can be driven in air: a wire, a program
    that cuts nothing.
    """
    if PROCESSES[process].power == "always":
        what, advice = "a wire has no height above the part at which it could drive round it", "look at the simulation"
        raise JobError("outline-wire", what, advice=advice)
    dialect = dialect_named(language or machine.language())
    low, high, height_mm = _extent(interpret(text, start, dialect, file))
    lines = [f"({MADE_BY}: outline)", " ".join(mode for mode in MODES if mode in dialect.codes)]
    lines += [POWER_OFF] if POWER_OFF in dialect.codes else []
    lines += [f"G0 Z{height_mm:.3f}"] if machine.has_z and np.isfinite(height_mm) else []
    lines += _round(low, high, _motion(machine, process))
    return "\n".join([*lines, "M2", ""])


def _extent(moves: Toolpath) -> tuple[np.ndarray, np.ndarray, float]:
    """Return the low and the high corner of all feeds in X and Y, and the greatest height of the path, mm.

    Raises JobError for a path without feeds at known places.
    """
    path = segments(moves, ARC_MM)
    places = np.concatenate([path.begin, path.end])
    heights = places[np.isfinite(places[:, 2]), 2]
    feeds = path[moves.table().kind[path.row] != RAPID].known_in((0, 1))
    corners = np.concatenate([feeds.begin, feeds.end])[:, :2]
    if not len(corners):
        raise JobError("outline-empty", "the program cuts nothing", advice="choose another program")
    return corners.min(axis=0), corners.max(axis=0), float(heights.max()) if len(heights) else float("nan")


def _round(low: np.ndarray, high: np.ndarray, motion: str) -> Iterator[str]:
    """Yield the blocks from the low corner round to it."""
    (x0, y0), (x1, y1) = low, high
    yield f"G0 X{x0:.3f} Y{y0:.3f}"
    yield f"{motion} X{x1:.3f}"
    yield f"Y{y1:.3f}"
    yield f"X{x0:.3f}"
    yield f"Y{y0:.3f}"


def _motion(machine: Machine, process: str) -> str:
    """Return the words of the outline's moves: feeds of a spindle, no faster than both axes can, else rapids.

    A feed without power would be a fault of a torch or laser, and its checks say so.
    """
    if PROCESSES[process].power != "operation":
        return "G0"
    return f"G1 F{min(FEED_MM_MIN, *(axis.max_rate_mm_min for axis in machine.axes[:2])):g}"
