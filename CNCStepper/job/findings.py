# SPDX-License-Identifier: LGPL-2.1-or-later
"""Findings of a job about its own program: notes of its files, feeds out of range, warnings of its cycles.

Cuts into a piece that an earlier contour has set free: nothing holds it any more.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

import shapely
from shapely.geometry.base import BaseGeometry

from CNCStepper.cycles.contours.contour_model import ContourModel
from CNCStepper.cycles.contours.scrap_side import enclosed
from CNCStepper.cycles.cycle import Answer, Cycle
from CNCStepper.errors import Place, Text
from CNCStepper.geometry.shapely_polygons import polygons_of
from CNCStepper.job.make import numbered
from CNCStepper.job.model import Job
from CNCStepper.machine.profile import Machine
from CNCStepper.machine.tools.tool_shapes import BEAMS
from CNCStepper.simulation.checks.stock_checks import ON_EDGE_MM
from CNCStepper.simulation.finding import Finding
from CNCStepper.simulation.first_lines import FirstLines
from CNCStepper.simulation.stock import Stock
from CNCStepper.toolpath import Span

SLACK_MM2 = 0.01  # a cut that touches a piece by rounding does not enter it


def cuts_into_detached(
    job: Job, first: int, answers: Sequence[Answer]
) -> Iterator[tuple[int, str, tuple[float, float]]]:
    """Yield cuts into detached pieces: the index of the answer, the warning, and a place within the cut.

    first: how many of the job's operations come before those that answered.
    """
    free = [(number, piece) for number, one in enumerate(job.operation, 1) if (piece := _freed(one, job)) is not None]
    for index, answer in enumerate(answers):
        number = first + index + 1
        wanted = wanted_area(answer)
        for before, piece in (each for each in free if each[0] < number):
            inside = piece.intersection(wanted)
            if inside.area > SLACK_MM2 or (wanted.area == 0.0 and inside.length > 0.0):
                place = inside.representative_point()
                yield index, _words(job.operation, before, number), (place.x, place.y)
                break


def wanted_area(answer: Answer) -> BaseGeometry:
    """Return what an operation is to cut, as far as its tool reaches, seen from above."""
    return shapely.union_all([one.region if one.reachable is None else one.reachable for one in answer.removals])


def _freed(operation: Cycle, job: Job) -> BaseGeometry | None:
    """Return the piece that falls out of a contour, None where all stays held."""
    tool = job.tools[operation.tool]
    if not isinstance(operation, ContourModel) or operation.tabs is not None or tool.shape in BEAMS:
        return None
    curves = [curve for curve in operation.kept() if curve.closed]
    if not curves or operation.depth_mm < job.stock.size_mm[2]:
        return None
    part = enclosed(curves)
    if operation.side == "inside":
        part = part.offset(-(operation.kerf_mm or tool.diameter_mm), operation.tolerance_mm)
    return None if part.empty else polygons_of(part)


def _words(operations: Sequence[Cycle], before: int, number: int) -> str:
    one, other = (numbered(place, operations[place - 1].cycle) for place in (number, before))
    return Text("{one} cuts into a piece that {other} has set free: nothing holds it", one=one, other=other)


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
            text = Text("the length offset of tool {tool_number} is unknown; 0 is assumed", tool_number=tool.number)
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
    """Yield the warnings of the cycles, and shapes outside the stock, each at the first line of its operation."""
    for place, answer in zip(places, answers, strict=False):
        for warning in answer.warnings:
            yield Finding("warning", "not-exact", place, warning)
        if stock.outline.buffer(ON_EDGE_MM).covers(wanted_area(answer)):
            continue
        advice = "move the shape or the work zero, or take larger stock"
        yield Finding("warning", "beside-stock", place, "part of the drawn shape is beside the stock", advice)
