# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sheet of a lathe's program: the facts that are given, a line an operation with its planned time, path and text.

It is asked for as that of a milling job is (job/files/program_sheet.py), and is seen in the half section.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from CNCStepper.job.files.program_sheet import operation_facts
from CNCStepper.job.turning.turning_job import TurnedStock, TurningJob
from CNCStepper.job.turning.turning_transfer import operation_times_s, read_back
from CNCStepper.machine.profile import Machine
from CNCStepper.simulation.views.paper_sheet import Sheet, save_sheet


def write_turned_sheet(asked: dict[str, Any], job: TurningJob, machine: Machine) -> str:
    """Write the sheet as PDF or HTML and return its path; raises JobError for another ending, or a bad program."""
    facts = (*map(tuple, asked["facts"]), *operation_facts(asked, operation_times_s(job, machine)))
    toolpath = read_back(job, machine, asked["text"], asked["title"])
    sheet = Sheet(asked["title"], facts, asked["text"], toolpath, bar_mm=_bar_mm(job.stock))
    save_sheet(Path(asked["file"]), sheet)
    return str(asked["file"])


def _bar_mm(stock: TurnedStock) -> np.ndarray:
    """Return low and high corner of the raw bar's half section, X the radius, float64[2, 3]."""
    return np.array(
        [(stock.bore_mm / 2, np.nan, -stock.length_mm), (stock.diameter_mm / 2, np.nan, stock.face_mm)], float
    )
