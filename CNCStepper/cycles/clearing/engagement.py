# SPDX-License-Identifier: LGPL-2.1-or-later
"""Clearing at bounded engagement: nowhere does more of the tool's rim than an angle meet material.

Along a straight front the angle t makes the stepover r (1 - cos t). So the bound is the smaller of the given angle and
that of the given stepover.

In narrow channels the walks are arcs hardly wider than the tool; at the same engagement these are far less deep than a
straight way, and many. A room whose walks come to be so long is planned again in finer steps and with a little more
engagement in such bends: as much as is no deeper than the stepover where the front runs along the way.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass, replace

from CNCStepper.cycles.clearing.engagement_chart import inset_mm
from CNCStepper.cycles.clearing.engagement_plan import Plan, narrow
from CNCStepper.cycles.clearing.form import Area, Opening, Run
from CNCStepper.errors import CycleError
from CNCStepper.geometry.region import Region

LONG = 1.61  # times the length of parallels: rooms whose walks cut longer are planned anew


@dataclass(frozen=True)
class EngagementPattern:
    """A clearing pattern that keeps the engagement at `max_deg` or below, in degrees; see the module's text."""

    max_deg: float

    def __call__(self, area: Area) -> list[Run]:
        """Return the runs, one for each part of the room.

        Raises CycleError where the room is too narrow for the bound.
        """
        if not area.climb:
            return [_mirrored_run(run) for run in self(replace(area, room=_mirrored(area.room), climb=True))]
        return [run for part in area.room.parts() for run in self._part(replace(area, room=part))]

    def _part(self, area: Area) -> Iterator[Run]:
        rooms = area.room.offset(-inset_mm(area), inset_mm(area) / 4.0).parts()
        if len(rooms) != 1:
            raise narrow(area.room.loops[0].xy[0])
        plan = Plan(area, rooms[0], self.max_deg)
        run = plan.run()
        if plan.cut_mm > LONG * _parallels_mm(area.room, run.apart_mm):
            with suppress(CycleError):  # there is a run within the bound at least
                run = Plan(area, rooms[0], self.max_deg, channels=True).run()
        yield run


def engagement_pattern(max_deg: float) -> EngagementPattern:
    """Return the pattern that clears at an engagement of at most `max_deg`, LEAST_DEG to 180 degrees.

    Along straight fronts the passes are never farther apart than the area's stepover.
    """
    return EngagementPattern(max_deg)


def _parallels_mm(room: Region, apart_mm: float) -> float:
    """Return about how long a room's loops and all their parallels are: by the trapezoidal rule over the distance."""
    return room.area_mm2 / apart_mm + room.length_mm / 2.0


def _mirrored(room: Region) -> Region:
    return Region(tuple(loop.mirrored_x().reversed() for loop in room.loops))


def _mirrored_run(run: Run) -> Run:
    passes = tuple(replace(one, curve=one.curve.mirrored_x()) for one in run.passes)
    assert run.opening is not None
    x, y = run.opening.centre_mm
    return Run(passes, run.apart_mm, Opening((-x, y), run.opening.radius_mm))
