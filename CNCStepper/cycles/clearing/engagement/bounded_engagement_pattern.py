# SPDX-License-Identifier: LGPL-2.1-or-later
"""Clearing at bounded engagement: nowhere does more of the tool's rim than an angle meet material.

Along a straight front the angle t makes the stepover r (1 - cos t). So the bound is the smaller of the given angle and
that of the given stepover.

In narrow channels the walks are arcs hardly wider than the tool; at the same engagement these are far less deep than a
straight way, and many. A room whose walks come to be so long is planned again in finer steps and with a little more
engagement in such bends: as much as is no deeper than the stepover where the front runs along the way. A pocket for
which that is still too long is refused.
"""

from __future__ import annotations

from contextlib import suppress
from dataclasses import dataclass, replace

from CNCStepper.cycles.clearing.engagement.adaptive_clearing import Plan, narrow
from CNCStepper.cycles.clearing.engagement.clearing_map import inset_mm
from CNCStepper.cycles.clearing.engagement.cut_length import Length, parallels_mm, require_short
from CNCStepper.cycles.clearing.pattern import Area, Opening, Run
from CNCStepper.errors import CycleError
from CNCStepper.geometry.region import Region

LONG = 1.58  # times the length of parallels: rooms in which more is cut are planned anew


@dataclass(frozen=True)
class EngagementPattern:
    """A clearing pattern that keeps the engagement at `max_deg` or below, in degrees; see the module's text."""

    max_deg: float

    def __call__(self, area: Area) -> list[Run]:
        """Return the runs, one for each part of the room.

        Raises CycleError where the room is too narrow for the bound, or so narrow that the way would be too long.
        """
        if not area.climb:
            return [_mirrored_run(run) for run in self(replace(area, room=_mirrored(area.room), climb=True))]
        planned = [self._part(replace(area, room=part)) for part in area.room.parts()]
        require_short(area, [length for _, length in planned])
        return [run for run, _ in planned]

    def _part(self, area: Area) -> tuple[Run, Length]:
        rooms = area.room.offset(-inset_mm(area), inset_mm(area) / 4.0).parts()
        if len(rooms) != 1:
            raise narrow(area.room.loops[0].xy[0])
        run, length = _planned(Plan(area, rooms[0], self.max_deg))
        if length.times > LONG:
            with suppress(CycleError):  # there is a run within the bound at least
                run, length = _planned(Plan(area, rooms[0], self.max_deg, channels=True))
        return run, length


def engagement_pattern(max_deg: float) -> EngagementPattern:
    """Return the pattern that clears at an engagement of at most `max_deg`, LEAST_DEG to 180 degrees.

    Along straight fronts the passes are never farther apart than the area's stepover.
    """
    return EngagementPattern(max_deg)


def _planned(plan: Plan) -> tuple[Run, Length]:
    run = plan.run()
    beside_mm = parallels_mm(plan.area.room, run.apart_mm, plan.area.tolerance_mm)
    cut_mm = plan.cut_mm if plan.cut_mm <= LONG * beside_mm else plan.in_material_mm(run)
    return run, Length(cut_mm, beside_mm, run.apart_mm)


def _mirrored(room: Region) -> Region:
    return Region(tuple(loop.mirrored_x().reversed() for loop in room.loops))


def _mirrored_run(run: Run) -> Run:
    passes = tuple(replace(one, curve=one.curve.mirrored_x()) for one in run.passes)
    assert run.opening is not None
    x, y = run.opening.centre_mm
    return Run(passes, run.apart_mm, Opening((-x, y), run.opening.radius_mm))
