# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finds the place of a held machine on its path, though passes may lie on top of each other.

    rows      | finished |  in the planner, at most its blocks  | read, not acknowledged | not sent
                         ^--- only here the position is looked for ---^

Where several places fit, two things tell them apart: how many blocks the controller says it still holds, and the
reports of the way there, between which no machine goes faster than it was told. What is uncertain all the same is told
as an interval; a resume from its begin cuts a little twice and leaves nothing out.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from math import ceil, hypot
from typing import NamedTuple

import numpy as np

from CNCStepper.errors import ProgramError
from CNCStepper.recovery.retract.move_curve import chords_of
from CNCStepper.recovery.retract.places_on_path import Place, RetractPath

ROUNDING_MM = 0.002  # of a report
LATE_S, FASTER = 0.02, 1.02  # by which a report may be late, and clocks may differ
SAME_PLACE = 4.0  # tolerances along the path
AHEAD_S = 0.12  # of motion at most that a step generator has taken out of the planner: six segments of 10 ms, or twelve


class PositionReport(NamedTuple):
    """One report of the machine.

    asked_s, last_line_s: between which it was taken. sent, acknowledged: lines of the text by then. blocks: which the
    planner held, or -1. feed_percent: the override.
    """

    asked_s: float
    last_line_s: float
    sent: int
    acknowledged: int
    position_mm: tuple[float, float, float]
    blocks: int = -1
    feed_percent: float = 100.0


@dataclass(frozen=True)
class Controller:
    """What is known of it: the planner's most blocks, steps a mm, the chords' arc tolerance, its fastest rapid."""

    blocks: int
    steps_per_mm: tuple[float, float, float]
    arc_tolerance_mm: float
    rapid_mm_min: float

    @property
    def tolerance_mm(self) -> float:
        """How far from its way a machine may be."""
        return hypot(*(1.0 / steps for steps in self.steps_per_mm)) + self.arc_tolerance_mm + ROUNDING_MM

    def on_step(self, position_mm: Sequence[float]) -> tuple[float, float, float]:
        """Return the position of whole steps that was rounded to the one reported."""
        x, y, z = (round(value * steps) / steps for value, steps in zip(position_mm, self.steps_per_mm, strict=True))
        return x, y, z


class PossiblePlaces(NamedTuple):
    """early: the place to resume from. late: how far the machine may have come; nearly always the same place."""

    early: Place
    late: Place


def find(way: RetractPath, reports: Sequence[PositionReport], controller: Controller) -> PossiblePlaces:
    """Return the machine's place by its last report; raises ProgramError where that is not on its path."""
    if not len(way):
        what = "nothing has been cut yet, so there is no way back"
        raise ProgramError("retreat-begin", what, advice="resume, and hold once the machine moves")
    search, last = _Search(way, controller), reports[-1]
    places = search.places(last)
    if not places:
        raise ProgramError(
            "retreat-off-path",
            "the machine is not on the path of the lines that it has",
            value=" ".join(f"{axis}{value:.3f}" for axis, value in zip("XYZ", last.position_mm, strict=True)),
            limit=f"{controller.tolerance_mm:.3f} mm",
            advice="stop the job: steps may be lost, or the machine was moved by hand",
        )
    if len(places) > 1:
        places = search.of_blocks(places, last) or places
    if len(places) > 1:
        places = search.of_reports(reports, places)
    return PossiblePlaces(min(places), max(places))


class _Search:
    """Looks for places on a way."""

    def __init__(self, way: RetractPath, controller: Controller):
        self._way = way
        self._controller = controller

    def places(self, seen: PositionReport) -> list[Place]:
        """Return the places, in their order, at which a report's position lies on the rows that may be cut."""
        first, last = self._window(seen)
        along_mm, found = 0.0, []
        for row in range(first, last):
            move = self._way.move(row)
            if move.is_known:
                near = [
                    (along_mm + move.length_mm * share, far, Place(row, share)) for share, far in self._near(row, seen)
                ]
                found += near
                along_mm += move.length_mm
        return list(self._apart(sorted(found)))

    def of_blocks(self, places: Iterable[Place], seen: PositionReport, ahead_s: float = 0.0) -> list[Place]:
        """Return the places that agree with the number of blocks that the planner holds.

        ahead_s: of the motion to come, which the planner may have given away already; nothing where the machine stands.
        """
        return [place for place in places if seen.blocks < 0 or self._agrees(place, seen, ahead_s)]

    def of_reports(self, reports: Sequence[PositionReport], places: list[Place]) -> list[Place]:
        """Return the places to which the machine can have come by way of all reports."""
        first = min(self._window(seen)[0] for seen in reports)
        times_s = self._way.times_s(first, self._window(reports[-1])[1], self._controller.rapid_mm_min)
        before: list[Place] = []
        for number, seen in enumerate(reports):
            every = places if number == len(reports) - 1 else self.places(seen)
            likely = places if number == len(reports) - 1 else self.of_blocks(every, seen, AHEAD_S)
            pair = reports[max(number - 1, 0) : number + 1]
            before = (
                self._reached(before, likely, pair, times_s, first)
                or self._reached(before, every, pair, times_s, first)
                or every
            )
        return before

    def _reached(
        self,
        before: Sequence[Place],
        places: list[Place],
        pair: Sequence[PositionReport],
        times_s: np.ndarray,
        first: int,
    ) -> list[Place]:
        """Return the places to which the machine can have come from one of `before` between a pair of reports."""
        if not before:
            return places
        return [one for one in places if any(self._reaches(a, one, pair, times_s, first) for a in before)]

    def _window(self, seen: PositionReport) -> tuple[int, int]:
        """Return the rows [first, last) of which none is certainly finished, and all may have been begun."""
        lines = self._way.lines
        acknowledged = int(np.searchsorted(lines, seen.acknowledged, side="right"))
        last = int(np.searchsorted(lines, min(seen.acknowledged + 1, seen.sent), side="right"))
        first, blocks = acknowledged, 0
        most = self._controller.blocks if seen.blocks < 0 else seen.blocks
        while first > 0 and blocks <= most:
            first -= 1
            blocks += self._blocks_of(first)
        return first, max(last, 1)  # before the first move the machine is at its begin

    def _near(self, row: int, seen: PositionReport) -> list[tuple[float, float]]:
        near = self._way.move(row).nearest(seen.position_mm)
        return [(share, far) for share, far in near if far <= self._controller.tolerance_mm]

    def _apart(self, found: list[tuple[float, float, Place]]) -> Iterator[Place]:
        """Yield the nearest of the places that adjoin each other along the path."""
        group: list[tuple[float, float, Place]] = []
        for one in found:
            if group and one[0] - group[-1][0] > SAME_PLACE * self._controller.tolerance_mm:
                yield _nearest(group)
                group = []
            group.append(one)
        if group:
            yield _nearest(group)

    def _agrees(self, place: Place, seen: PositionReport, ahead_s: float) -> bool:
        lines = self._way.lines
        acknowledged = int(np.searchsorted(lines, seen.acknowledged, side="right"))
        _, most = self._left(place)
        if place.row >= acknowledged:  # its line is still being cut into blocks
            return seen.blocks <= most
        ahead = self._ahead(place, ahead_s * seen.feed_percent / 100.0, acknowledged)
        least = self._left(ahead)[0] + self._blocks_between(ahead.row + 1, acknowledged)
        last = int(np.searchsorted(lines, min(seen.acknowledged + 1, seen.sent), side="right"))
        begun = sum(max(self._blocks_of(row) - 1, 0) for row in range(acknowledged, last))
        return least <= seen.blocks <= most + self._blocks_between(place.row + 1, acknowledged) + begun

    def _ahead(self, place: Place, left_s: float, end: int) -> Place:
        """Return where a machine is after some time at full speed, at the end of row `end` - 1 at most."""
        for row in range(place.row, end):
            move, share = self._way.move(row), place.share if row == place.row else 0.0
            whole_s = 60.0 * move.length_mm / (move.feed_mm_min or self._controller.rapid_mm_min)
            if whole_s * (1.0 - share) > left_s:
                return Place(row, share + left_s / whole_s)
            left_s -= whole_s * (1.0 - share)
        return Place(end - 1, 1.0)

    def _blocks_between(self, first: int, end: int) -> int:
        return sum(self._blocks_of(row) for row in range(first, end))

    def _left(self, place: Place) -> tuple[int, int]:
        """Return the least and the most blocks that are left of a place's row."""
        move, tolerance_mm = self._way.move(place.row), self._controller.tolerance_mm
        if not move.is_arc:
            at_end = move.length_mm * (1.0 - place.share) < tolerance_mm
            at_begin = move.length_mm * place.share < tolerance_mm
            return 1 - at_end, 1 + at_begin
        left = ceil(self._blocks_of(place.row) * (1.0 - place.share))
        return max(0, left - 1), left + 1

    def _blocks_of(self, row: int) -> int:
        """Return how many blocks of the planner a row becomes: none where no axis makes a step."""
        move = self._way.move(row)
        if move.is_arc:
            return chords_of(move, self._controller.arc_tolerance_mm)
        return int(not move.is_known or self._controller.on_step(move.begin) != self._controller.on_step(move.end))

    def _reaches(
        self, begin: Place, end: Place, reports: Sequence[PositionReport], times_s: np.ndarray, first: int
    ) -> bool:
        """Whether the machine can have come from one place to another between two reports."""
        before, after = reports
        most_s = (after.last_line_s - before.asked_s) * FASTER + LATE_S
        percent = max(before.feed_percent, after.feed_percent, 100.0)
        needed_s = _time_s(end, times_s, first) - _time_s(begin, times_s, first)
        return -LATE_S <= needed_s <= most_s * percent / 100.0


def _nearest(group: list[tuple[float, float, Place]]) -> Place:
    """Return the place of the smallest distance, of equal ones the first."""
    return min(group, key=lambda one: (round(one[1], 4), one[0]))[2]


def _time_s(place: Place, times_s: np.ndarray, first: int) -> float:
    row = place.row - first
    return float(times_s[row] + (times_s[row + 1] - times_s[row]) * place.share)
