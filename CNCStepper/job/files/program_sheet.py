# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sheet of a job's program: the facts that are given, a line an operation with its planned time, path and text.

{"file": path, "title": text, "text": program, "facts": [[name, value]], "operations": [[name, words]],
 "most": 20, "together": word}           most: operations that have a line; together: the name of the whole time
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from CNCStepper.job import cut_transfer
from CNCStepper.job.model import Job
from CNCStepper.job.turning import turning_transfer
from CNCStepper.job.turning.turning_job import TurnedStock, TurningJob
from CNCStepper.machine.profile import Machine
from CNCStepper.quantities import duration_text
from CNCStepper.simulation.views.paper_sheet import Sheet, save_sheet


def write_program_sheet(asked: dict[str, Any], job: Job, machine: Machine, times_s: Sequence[float]) -> str:
    """Write the sheet as PDF or HTML and return its path; raises JobError for another ending, or a bad program.

    times_s: the planned time of each operation of the job.
    """
    toolpath = cut_transfer.read_back(job, machine, asked["text"], asked["title"])
    facts = _facts(asked, times_s)
    return _save(asked, Sheet(asked["title"], facts, asked["text"], toolpath, job.stock.stock()))


def write_turned_sheet(asked: dict[str, Any], job: TurningJob, machine: Machine) -> str:
    """Write the sheet of a lathe's program, its path beside the bar in half section; see `write_program_sheet`."""
    toolpath = turning_transfer.read_back(job, machine, asked["text"], asked["title"])
    facts = _facts(asked, turning_transfer.operation_times_s(job, machine))
    return _save(asked, Sheet(asked["title"], facts, asked["text"], toolpath, bar_mm=_bar_mm(job.stock)))


def _save(asked: dict[str, Any], sheet: Sheet) -> str:
    save_sheet(Path(asked["file"]), sheet)
    return str(asked["file"])


def _bar_mm(stock: TurnedStock) -> np.ndarray:
    """Return low and high corner of the raw bar's half section, X the radius, float64[2, 3]."""
    low = (stock.bore_mm / 2, np.nan, -stock.length_mm)
    return np.array([low, (stock.diameter_mm / 2, np.nan, stock.face_mm)], float)


def _facts(asked: dict[str, Any], times_s: Sequence[float]) -> tuple[tuple[str, str], ...]:
    """Return the given facts, one for each operation up to the most that are asked for, and the time of all."""
    rows = list(zip(asked["operations"], times_s, strict=True))
    shown = [(name, f"{words} · {duration_text(time_s)}") for (name, words), time_s in rows[: asked["most"]]]
    left = len(rows) - len(shown)
    more = [("…", f"+ {left}")] if left else []
    return (*map(tuple, asked["facts"]), *shown, *more, (asked["together"], duration_text(sum(times_s))))
