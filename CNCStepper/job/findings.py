# SPDX-License-Identifier: LGPL-2.1-or-later
"""Findings of a job about its own program: notes of its files, feeds out of range, warnings of its cycles.

Cuts into a piece that an earlier contour has set free: nothing holds it any more.
The contour that is to be cut last, so that there are none.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import Any

import shapely
from shapely.geometry.base import BaseGeometry

from CNCStepper.cycles.contours.contour_model import ContourModel
from CNCStepper.cycles.contours.scrap_side import enclosed
from CNCStepper.cycles.cycle import Answer, Cycle
from CNCStepper.errors import Place, Text
from CNCStepper.geometry.shapely_polygons import polygons_of
from CNCStepper.job.make import numbered
from CNCStepper.job.model import Job
from CNCStepper.job.stock_fit import drawn
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
    free = list(freed_pieces(job).items())
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


def freed_pieces(job: Job) -> dict[int, BaseGeometry]:
    """Return the pieces that fall out of contours, by the number of the operation, from 1."""
    found = {number: _freed(operation, job) for number, operation in enumerate(job.operation, 1)}
    return {number: piece for number, piece in found.items() if piece is not None}


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


def safely_last(job: Job) -> int | None:
    """Return the number from 1 of the contour that, cut last, leaves no cut near a piece that is free.

    None where there is no such contour, or the last operation is it already.
    """
    pieces = freed_pieces(job)
    for last in sorted(pieces, key=lambda number: -pieces[number].area):
        order = [number for number in range(1, len(job.operation) + 1) if number != last] + [last]
        if last != len(job.operation) and _is_safe(job, order, pieces):
            return last
    return None


def _is_safe(job: Job, order: list[int], pieces: dict[int, BaseGeometry]) -> bool:
    """Return whether, in an order, no operation comes near a piece that one before has set free."""
    for place, number in enumerate(order):
        behind = order[place + 1 :] if number in pieces else []
        if any(_is_near(job, job.operation[each - 1], pieces[number]) for each in behind):
            return False
    return True


def _is_near(job: Job, operation: Cycle, piece: BaseGeometry) -> bool:
    """Return whether an operation may cut into a piece: it counts with the width of its tool around what is drawn."""
    reach_mm = job.tools[operation.tool].diameter_mm + float(getattr(operation, "stock_to_leave_mm", 0.0))
    lines: list[Any] = [_shape(points) for points in drawn(operation)]
    if not lines:
        return True
    shape = shapely.union_all(lines)
    shape = shape if isinstance(operation, ContourModel) else shape.convex_hull
    return bool(shape.distance(piece) <= reach_mm)


def _shape(points: Any) -> BaseGeometry:
    return shapely.Point(points[0]) if len(points) < 2 else shapely.LineString(points)
