# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cuts into a piece that an earlier contour has set free: nothing holds it any more."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import shapely
from shapely.geometry.base import BaseGeometry

from CNCStepper.cycles.contours.contour import Contour
from CNCStepper.cycles.contours.sides import enclosed
from CNCStepper.cycles.cycle import Answer, Cycle
from CNCStepper.errors import Text
from CNCStepper.geometry.shapely_polygons import polygons_of
from CNCStepper.job.make import operation_name
from CNCStepper.job.model import Job
from CNCStepper.machine.tools.tool_shapes import BEAMS

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
    if not isinstance(operation, Contour) or operation.tabs is not None or tool.shape in BEAMS:
        return None
    curves = [curve for curve in operation.kept() if curve.closed]
    if not curves or operation.depth_mm < job.stock.size_mm[2]:
        return None
    part = enclosed(curves)
    if operation.side == "inside":
        part = part.offset(-(operation.kerf_mm or tool.diameter_mm), operation.tolerance_mm)
    return None if part.empty else polygons_of(part)


def _words(operations: Sequence[Cycle], before: int, number: int) -> str:
    one, other = (f"operation {place} ({operation_name(operations[place - 1])})" for place in (number, before))
    return Text("{one} cuts into a piece that {other} has set free: nothing holds it", one=one, other=other)
