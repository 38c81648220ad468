# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a job says of its own program: notes of its files, feeds out of range, warnings of its cycles."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from CNCStepper.cycles.form import Answer
from CNCStepper.errors import Place
from CNCStepper.job.loose import cuts_into_loose, wanted_area
from CNCStepper.job.model import Job
from CNCStepper.job.stock_fit import ON_EDGE_MM
from CNCStepper.machine.profile import Machine
from CNCStepper.simulation.finding import Finding
from CNCStepper.simulation.stock import Stock
from CNCStepper.toolpath import Toolpath


def findings_of(
    job: Job, machine: Machine, toolpath: Toolpath, answers: Sequence[Answer], file: str, first: int = 0
) -> Iterator[Finding]:
    """Yield all that a job says of its program, read back as `toolpath`; `answers` are those of its operations.

    first: how many of the job's operations the programs before this one hold.
    """
    yield from _notes(job, machine, file)
    yield from _warnings(toolpath, answers, job.stock.stock(), file)
    yield from _loose(job, first, toolpath, answers, file)
    yield from _feeds(toolpath, job, machine, file)


def _notes(job: Job, machine: Machine, file: str) -> Iterator[Finding]:
    """Yield what readers of drawings and tools left out or guessed, and tools whose length offset is not known."""
    for note in job.notes:
        yield Finding(
            "warning", "note", Place(file), note, "mend the file that it was read from, where that is not meant"
        )
    if machine.tool_length == "table":
        for tool in (tool for tool in job.tool if tool.length_offset_mm is None):
            text = f"the length offset of tool {tool.number} is not known, it is taken as 0"
            yield Finding("info", "tool-length", Place(file), text, "give the tool its length_offset_mm")


def _feeds(toolpath: Toolpath, job: Job, machine: Machine, file: str) -> Iterator[Finding]:
    """Yield feeds and speeds out of the range of tool or material, each at the first line on which its tool is used."""
    states, table = toolpath.states, toolpath.table()
    tools = np.array([state.tool for state in states], int)[table.state]
    for number, remarks in job.remarks(machine).items():
        rows = np.flatnonzero(tools == number)
        for remark in remarks if len(rows) else ():
            place = Place(file, int(table.line[rows[0]]), 1)
            numbers = {"value": remark.value, "limit": remark.limit, "unit": remark.unit}
            yield Finding(remark.severity, "feeds", place, remark.text, remark.advice, **numbers)  # type: ignore[arg-type]


def _loose(job: Job, first: int, toolpath: Toolpath, answers: Sequence[Answer], file: str) -> Iterator[Finding]:
    """Yield cuts into pieces that nothing holds any more, each at the first line of its operation."""
    places = _places(toolpath, file)
    for index, text, place_mm in cuts_into_loose(job, first, answers):
        if index < len(places):
            advice = "cut it before, or hold the piece by tabs"
            yield Finding("warning", "piece-loose", places[index], text, advice, place_mm=place_mm)


def _warnings(toolpath: Toolpath, answers: Sequence[Answer], stock: Stock, file: str) -> Iterator[Finding]:
    """Yield what the cycles warn of, and shapes beside the stock, each at the first line of its operation."""
    for place, answer in zip(_places(toolpath, file), answers, strict=False):
        for warning in answer.warnings:
            yield Finding("warning", "not-exact", place, warning)
        if stock.outline.buffer(ON_EDGE_MM).covers(wanted_area(answer)):
            continue
        advice = "move the shape or the work zero, or take larger stock"
        yield Finding("warning", "beside-stock", place, "part of the drawn shape lies beside the stock", advice)


def _places(toolpath: Toolpath, file: str) -> list[Place]:
    """Return the first line of each operation."""
    lines = toolpath.table().line
    return [Place(file, int(lines[span.first]), 1) for span in toolpath.spans if span.kind == "operation"]
