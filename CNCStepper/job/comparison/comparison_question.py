# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a window asks about two programs, and the answer, both plain data.

    {"programs": [{"name": "Job", "file": PATH, "dialect": "grbl"}, {...}], "machine": {...}, "job": PATH or "",
     "tolerance_mm": 0.02, "picture": PATH, "words": {"common": "in both", ...}}

    {"same": false, "sentences": [TEXT, ...], "rows": [[TEXT, "12", "13"], ...], "report": {...}}

job: a file of `job/model.py` with the stock and the tools, "" where they are not known. words: those of the picture.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from CNCStepper.gcode.syntax.text_format import decoded
from CNCStepper.input_file import read_input
from CNCStepper.job.comparison.compare_programs import ComparedProgram, compare_programs, report_of, rows, sentences
from CNCStepper.job.model import Job, read_job
from CNCStepper.job.prove import tools_of
from CNCStepper.machine.profile import Machine
from CNCStepper.simulation.removal.heightmap import height_map
from CNCStepper.simulation.views.comparison_picture import save_comparison

MOST_BYTES = 256_000_000


def answer_of(asked: dict[str, Any], share: Callable[[float], None] = lambda share: None) -> dict[str, Any]:
    """Compare two programs and draw their picture; raises CNCStepperError."""
    machine = Machine.model_validate(asked["machine"]) if asked["machine"] else None
    job = read_job(Path(asked["job"])) if asked["job"] else None
    programs = [_program(each, job, machine) for each in asked["programs"]]
    found = compare_programs(
        *programs,
        machine=machine,
        same_mm=asked["tolerance_mm"],
        part_of=_part_of(job, machine) if job and machine else None,
        share=share,
    )
    save_comparison(Path(asked["picture"]), found.paths, found.names, words=asked["words"])
    return {
        "same": found.paths.same,
        "sentences": list(sentences(found)),
        "rows": [list(row) for row in rows(found)],
        "report": report_of(found),
    }


def _program(told: dict[str, Any], job: Job | None, machine: Machine | None) -> ComparedProgram:
    text = decoded(read_input(Path(told["file"]), MOST_BYTES))[0]
    start = job.started(None, machine) if job and machine else None
    return ComparedProgram(told["name"], text, told["dialect"], start)


def _part_of(job: Job, machine: Machine) -> Any:
    """Return what cuts the job's stock with its tools by a path."""
    stock, tools = job.stock.stock(), tools_of(job.on(machine))
    return lambda program, path: height_map(path, tools, stock)
