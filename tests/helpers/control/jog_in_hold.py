# SPDX-License-Identifier: LGPL-2.1-or-later
"""Jogs and retract legs of an operator during a hold, and the stretches of a trace that are off the path."""

from __future__ import annotations

import numpy as np

from CNCStepper.control.session.command import Command
from helpers.control.retract_bench import ROUNDING_MM, STEP_MM, Cut, path_of, polyline, worst_distance_mm

NEAR_MM = STEP_MM + ROUNDING_MM
SAMPLE_MM = 0.1  # between two points of the trace, at the speed of a jog


def jogged(cut: Cut, **way_mm: float):
    """Jog once and wait for the end of it."""
    way = dict.fromkeys(("x_mm", "y_mm", "z_mm"), 0.0) | {"feed_mm_min": 2000.0} | way_mm
    cut.sender.ask(Command("jog", way))
    yield lambda: cut.sender.status().machine_state == "Jog"
    yield lambda: cut.sender.status().machine_state == "Idle"


def led(cut: Cut, kind: str, length_mm: float = 0.0):
    """Find the place and go along a leg from there: "aside", "back" by a length, or the "rest"."""
    found = []
    yield from cut.find(found)
    held = found[0]
    leg = held.along(held.back_by(length_mm)) if kind == "back" else getattr(held, kind)()
    yield from cut.go(leg)
    if kind != "rest":
        yield cut.arrived


def off_path(cut: Cut, program: str) -> list[np.ndarray]:
    """Return each stretch of the trace that is off the program's path, with the points around it that are on it."""
    line = polyline(path_of(program))
    off = np.array([worst_distance_mm(point[None], line) > NEAR_MM for point in cut.trace])
    begins, ends = (np.flatnonzero(np.diff(off.astype(int)) == sign) for sign in (1, -1))
    return [cut.trace[begin : end + 2] for begin, end in zip(begins, ends, strict=True)]
