# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is cut at every level in one piece of the room that hangs together: the pattern's runs, then the walls.

    walls     where the tool's centre may be                         the finishing passes run along its loops
    roughed   the same, less what the finishing passes take          the pattern clears it

A finishing pass is begun from roughed ground, where there is some beside it, so that the tool comes to the wall
sideways; where there is none, as in a slot, it goes down on the pass itself.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import groupby, pairwise

import numpy as np

from CNCStepper.cycles.clearing.helix_and_ramp_entry import Entry, Plunge, entry_for, opened
from CNCStepper.cycles.clearing.pattern import Area, Pass, Pattern, Run
from CNCStepper.cycles.clearing.straight_links import LinkRegion
from CNCStepper.cycles.moves import Point, Track, point_of
from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.cut_order.cut_order import Stop, ordered
from CNCStepper.geometry.region import Region
from CNCStepper.machine.tools.tool import Tool

BESIDE = 1.01  # of the finishing step: so near roughed ground is beside the wall
LOOKS_MM = 0.5  # how close together places on a wall are tried
MOST_LOOKS = 400


@dataclass(frozen=True)
class Stage:
    """A run, the feed it is cut at and the way down to it; `cut` is ground already at the level's floor, if any."""

    run: Run
    feed_mm_min: float
    entry: Entry
    cut: LinkRegion | None = None

    @cached_property
    def stretches(self) -> list[tuple[list[Pass], Track | None]]:
        """The run's passes, those on the floor together with their track, each that is up or leads down without one."""
        found: list[tuple[list[Pass], Track | None]] = []
        ways = self.run.passes
        lowers = [before.lifted and one.name == "link" for before, one in pairwise([ways[0], *ways])]
        for alone, some in groupby(zip(ways, lowers, strict=True), key=lambda pair: pair[0].lifted or pair[1]):
            passes = [one for one, _ in some]
            together = [(passes, Track([one.curve for one in passes]))] if not alone else []
            found += together or [([one], None) for one in passes]
        return found


@dataclass(frozen=True)
class Part:
    """One piece of the room: its stages in order, and its whole ground, free once a level is done."""

    stages: tuple[Stage, ...]
    ground: LinkRegion


@dataclass(frozen=True)
class ClearingOptions:
    """How a room is cut: the pattern and its area's values, the tool, the entry, the finishing pass."""

    pattern: Pattern
    area: Area  # its room is set for each piece
    tool: Tool
    entry: str
    entry_angle_deg: float
    finish_mm: float
    finish_feed_mm_min: float


def parts_of(walls: Region, roughed: Region, ways: ClearingOptions) -> list[Part]:
    """Return the pieces of a room in an order with short rapids between them."""
    rough = roughed.parts()
    parts = []
    for wall in walls.parts():
        inside = [one for one in rough if wall.contains(_place(one))[0]] if ways.finish_mm else [wall]
        parts.append(_part(wall, inside, ways))
    if len(parts) == 1:
        return parts
    stops = [Stop(_row(part.stages[0].entry.begin), _row(_end(part.stages[-1])), False) for part in parts]
    return [parts[visit.item] for visit in ordered(stops)]


def _part(wall: Region, rough: Sequence[Region], ways: ClearingOptions) -> Part:
    ground, stages = LinkRegion(wall), []
    for room in rough:
        here = LinkRegion(room) if ways.finish_mm else ground
        for run in ways.pattern(replace(ways.area, room=room)):
            stages.append(Stage(run, ways.tool.feed_mm_min, _entry(here, run, ways)))
    if ways.finish_mm:
        stages += _finishing(wall, rough, ways, _end(stages[-1]) if stages else None)
    return Part(tuple(stages), ground)


def _entry(ground: LinkRegion, run: Run, ways: ClearingOptions) -> Entry:
    first = run.passes[0].curve
    if run.opening is not None:
        return opened(run.opening, point_of(first.xy[0]), ways.tool, ways.entry_angle_deg)
    return entry_for(ways.entry, ground, first, ways.tool, ways.entry_angle_deg)


def _finishing(wall: Region, rough: Sequence[Region], ways: ClearingOptions, here: Point | None) -> list[Stage]:
    """Return the finishing passes along all loops of a wall, each time the nearest next one."""
    roughed = Region(tuple(loop for room in rough for loop in room.loops))
    cut = LinkRegion(roughed.offset(ways.finish_mm, ways.area.tolerance_mm)) if rough else None
    left = [loop if ways.area.climb else loop.reversed() for loop in wall.loops]
    feed = ways.finish_feed_mm_min or ways.tool.feed_mm_min
    stages: list[Stage] = []
    while left:
        chosen = 0 if here is None else int(np.argmin([loop.distances_mm(_row(here))[0] for loop in left]))
        begun, lead = _begun(left.pop(chosen), roughed, ways.finish_mm, here)
        passes = Pass(f"finishing {len(stages) + 1}", begun)
        if lead is None:
            run = Run((passes,))
            stages.append(Stage(run, feed, _entry(LinkRegion(wall), run, ways)))
        else:
            run = Run((Pass("link", lead), passes))
            stages.append(Stage(run, feed, Plunge(point_of(lead.xy[0])), cut))
        here = point_of(begun.xy[-1])
    return stages


def _begun(loop: Curve, roughed: Region, finish_mm: float, here: Point | None) -> tuple[Curve, Curve | None]:
    """Return a wall's loop from the place nearest to `here` with roughed ground beside it, and the way from there."""
    if roughed.empty:
        return loop, None
    count = min(max(int(loop.length_mm / LOOKS_MM), 16), MOST_LOOKS)
    places_mm = loop.length_mm * np.arange(count) / count
    places = loop.at_length(places_mm)[0]
    beside = np.flatnonzero(roughed.distances_mm(places) <= BESIDE * finish_mm)
    if not len(beside):
        return loop, None
    away = 0.0 if here is None else np.hypot(*(places[beside] - here).T)
    chosen = beside[int(np.argmin(away))]
    begun = loop.started_at_length(float(places_mm[chosen]))
    ground = [curve.nearest(begun.xy[:1]) for curve in roughed.loops]
    nearest = int(np.argmin([found[0][0] for found in ground]))
    from_ = roughed.loops[nearest].at_length(float(ground[nearest][1][0]))[0]
    return begun, Curve(np.vstack([from_, begun.xy[0]]), np.zeros(1))


def _place(room: Region) -> np.ndarray:
    return room.loops[0].xy[:1]


def _row(point: Point) -> np.ndarray:
    return np.array([point])


def _end(stage: Stage) -> Point:
    return point_of(stage.run.passes[-1].curve.xy[-1])
