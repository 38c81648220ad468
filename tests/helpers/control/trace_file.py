# SPDX-License-Identifier: LGPL-2.1-or-later
"""The trace that `cncstepper virtual --trace` writes, and a program's places, as rows for the judge of faults."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import islice
from pathlib import Path

from helpers.control.fault_judge import Row

STEPS_PER_MM = (80, 80, 400)  # of the table a
UNTOLD = (5, 0.0)  # the trace tells of no spindle


def rows_of_file(path: Path) -> list[Row]:
    """Return the path of a trace."""
    with path.open(encoding="ascii") as lines:
        numbers = [[float(text) for text in line.split(",")] for line in islice(lines, 1, None)]
    return [row_at(place, t_s) for t_s, *place in numbers]


def rows_at(places_mm: Iterable[Sequence[float]]) -> list[Row]:
    """Return straight ways from place to place."""
    return [row_at(place_mm) for place_mm in places_mm]


def row_at(place_mm: Sequence[float], t_s: float = 0.0) -> Row:
    """Return one place."""
    return Row(t_s, tuple(mm * steps for mm, steps in zip(place_mm, STEPS_PER_MM, strict=True)), UNTOLD)
