# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a window asks about two programs, and the answer, both plain data.

    {"programs": [{"name": "Job", "file": PATH, "dialect": "grbl", "kind": "mill", "lathe": null}, {...}],
     "machine": {...}, "job": PATH or "", "tolerance_mm": 0.02, "picture": PATH, "words": {"common": "in both", ...}}

    {"same": false, "sentences": [TEXT, ...], "rows": [[TEXT, "12", "13"], ...], "report": {...}}

job: a file of `job/model.py` with the stock and the tools, "" where they are not known; those of a lathe's program are
in its own "lathe", as `turning_transfer.content_of` gives job and machine, with "part", which of the job's programs it
is, and "tools", all that there are; null where they are not known. kind: of whose job it is, "mill" or "lathe", or "".
words: those of the picture.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

from CNCStepper.gcode.syntax.text_format import decoded
from CNCStepper.input_file import read_input
from CNCStepper.job.comparison.compare_programs import (
    ComparedProgram,
    compare_programs,
    report_of,
    rows,
    sentences,
)
from CNCStepper.job.comparison.comparison_picture_file import save_picture
from CNCStepper.job.comparison.lathe_setup import LatheSetup, setup_of_job
from CNCStepper.job.model import Job, read_job
from CNCStepper.job.prove import tools_of
from CNCStepper.job.turning.make_turning import is_split_turning
from CNCStepper.job.turning.turning_transfer import job_from
from CNCStepper.machine.profile import Machine, validated
from CNCStepper.machine.tools.turning_tool import TurningTool
from CNCStepper.simulation.removal.heightmap import height_map
from CNCStepper.state import Start

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
    save_picture(Path(asked["picture"]), found, words=asked["words"])
    return {
        "same": found.paths.same,
        "sentences": list(sentences(found)),
        "rows": [list(row) for row in rows(found)],
        "report": report_of(found),
    }


def _program(told: dict[str, Any], job: Job | None, machine: Machine | None) -> ComparedProgram:
    text = decoded(read_input(Path(told["file"]), MOST_BYTES))[0]
    start = job.started(None, machine) if job and machine else None
    lathe = None
    if told["lathe"]:
        lathe, start = _lathe(told["lathe"], text)
    return ComparedProgram(told["name"], text, told["dialect"], start, lathe, told["kind"] == "mill")


def _lathe(told: dict[str, Any], text: str) -> tuple[LatheSetup, Start | None]:
    """Return what cuts a lathe's program, with the tools that its job's operations do not use too."""
    job, machine = job_from(told)
    part = told["part"] if is_split_turning(job, machine) else None
    setup, start = setup_of_job(job, machine, [text], part, None)
    tools = [validated(TurningTool, raw, "tool") for raw in told["tools"]]
    return replace(setup, tools={tool.number: tool for tool in tools}), start


def _part_of(job: Job, machine: Machine) -> Any:
    """Return what cuts the job's stock with its tools by a path."""
    stock, tools = job.stock.stock(), tools_of(job.on(machine))
    return lambda program, path: height_map(path, tools, stock)
