# SPDX-License-Identifier: LGPL-2.1-or-later
"""How slow this processor is beside the one on which the tests' limits of processor time were set.

The same rented machine is up to twice as slow on another day, and each call of ours then takes twice its time. A
fixed piece of work beside the measured one tells that apart from a call that has become slower.
"""

from __future__ import annotations

import time
from statistics import median

LOOPS = 50_000
# What they took in CPython 3.11 on the machine of the limits (2 cores, November 2026). Measured there were 0.15 s for
# two million outside a function; in one, in FreeCAD's window, they take two thirds of that (measured on a slower one).
USUAL_S = 0.10 * LOOPS / 2e6
SAMPLES = 5


def slowness() -> float:
    """Return how often the usual time this thread needs at the moment for the same work, at least 1."""
    return max(1.0, median(_work_s() for _ in range(SAMPLES)) / USUAL_S)


def _work_s() -> float:
    begun_s, total = time.thread_time(), 0
    for number in range(LOOPS):
        total += number * number
    return time.thread_time() - begun_s
