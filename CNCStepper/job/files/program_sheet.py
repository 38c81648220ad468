# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sheet of a job's program: the facts that are given, a line an operation with its planned time, path and text.

{"file": path, "title": text, "text": program, "facts": [[name, value]], "operations": [[name, words]],
 "most": 20, "together": word}           most: operations that have a line; together: the name of the whole time
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from CNCStepper.job.cut_transfer import read_back
from CNCStepper.job.model import Job
from CNCStepper.machine.profile import Machine
from CNCStepper.simulation.views.paper_sheet import Sheet, save_sheet
from CNCStepper.simulation.views.picture_style import duration_text


def write_program_sheet(asked: dict[str, Any], job: Job, machine: Machine, times_s: Sequence[float]) -> str:
    """Write the sheet as PDF or HTML and return its path; raises JobError for another ending, or a bad program.

    times_s: the planned time of each operation of the job.
    """
    facts = (*map(tuple, asked["facts"]), *operation_facts(asked, times_s))
    toolpath = read_back(job, machine, asked["text"], asked["title"])
    sheet = Sheet(asked["title"], facts, asked["text"], toolpath, job.stock.stock())
    save_sheet(Path(asked["file"]), sheet)
    return str(asked["file"])


def operation_facts(asked: dict[str, Any], times_s: Sequence[float]) -> list[tuple[str, str]]:
    """Return a fact for each operation up to the most that are asked for, and the time of all."""
    rows = list(zip(asked["operations"], times_s, strict=True))
    shown = [(name, f"{words} · {duration_text(time_s)}") for (name, words), time_s in rows[: asked["most"]]]
    left = len(rows) - len(shown)
    more = [("…", f"+ {left}")] if left else []
    return [*shown, *more, (asked["together"], duration_text(sum(times_s)))]
