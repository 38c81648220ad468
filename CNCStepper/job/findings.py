# SPDX-License-Identifier: LGPL-2.1-or-later
"""Findings of a job about its own program: notes of its files, feeds out of range, warnings of its cycles."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from CNCStepper.cycles.cycle import Answer
from CNCStepper.errors import Place, Text
from CNCStepper.job.detached_parts import cuts_into_detached, wanted_area
from CNCStepper.job.first_lines import FirstLines
from CNCStepper.job.model import Job
from CNCStepper.job.stock_fit import ON_EDGE_MM
from CNCStepper.machine.profile import Machine
from CNCStepper.simulation.finding import Finding
from CNCStepper.simulation.stock import Stock
from CNCStepper.toolpath import Span


def findings_of(
    job: Job,
    machine: Machine,
    lines: FirstLines,
    spans: Iterable[Span],
    answers: Sequence[Answer],
    file: str,
    first: int = 0,
) -> Iterator[Finding]:
    """Yield all findings of a job on its program, of which `lines` and `spans` were read back.

    answers: those of its operations. first: how many of the job's operations the programs before this one hold.
    """
    places = [Place(file, line, 1) for line in lines.of_operations(spans)]
    yield from _notes(job, machine, file)
    yield from _warnings(places, answers, job.stock.stock())
    yield from _loose(job, first, places, answers)
    yield from _feeds(lines, job, machine, file)


def _notes(job: Job, machine: Machine, file: str) -> Iterator[Finding]:
    """Yield what readers of drawings and tools left out or guessed, and tools whose length offset is not known."""
    for note in job.notes:
        yield Finding(
            "warning", "note", Place(file), note, "mend the file that it was read from, where that is not meant"
        )
    if machine.tool_length == "table":
        for tool in (tool for tool in job.tool if tool.length_offset_mm is None):
            text = Text(
                "the length offset of tool {tool_number} is not known, it is taken as 0", tool_number=tool.number
            )
            yield Finding("info", "tool-length", Place(file), text, "give the tool its length_offset_mm")


def _feeds(lines: FirstLines, job: Job, machine: Machine, file: str) -> Iterator[Finding]:
    """Yield feeds and speeds out of the range of tool or material, each at the first line on which its tool is used."""
    for number, remarks in job.remarks(machine).items():
        for remark in remarks if number in lines.of_tool else ():
            place = Place(file, lines.of_tool[number], 1)
            numbers = {"value": remark.value, "limit": remark.limit, "unit": remark.unit}
            yield Finding(remark.severity, "feeds", place, remark.text, remark.advice, **numbers)  # type: ignore[arg-type]


def _loose(job: Job, first: int, places: Sequence[Place], answers: Sequence[Answer]) -> Iterator[Finding]:
    """Yield cuts into pieces that nothing holds any more, each at the first line of its operation."""
    for index, text, place_mm in cuts_into_detached(job, first, answers):
        if index < len(places):
            advice = "cut it before, or hold the piece by tabs"
            yield Finding("warning", "piece-loose", places[index], text, advice, place_mm=place_mm)


def _warnings(places: Sequence[Place], answers: Sequence[Answer], stock: Stock) -> Iterator[Finding]:
    """Yield what the cycles warn of, and shapes beside the stock, each at the first line of its operation."""
    for place, answer in zip(places, answers, strict=False):
        for warning in answer.warnings:
            yield Finding("warning", "not-exact", place, warning)
        if stock.outline.buffer(ON_EDGE_MM).covers(wanted_area(answer)):
            continue
        advice = "move the shape or the work zero, or take larger stock"
        yield Finding("warning", "beside-stock", place, "part of the drawn shape lies beside the stock", advice)
