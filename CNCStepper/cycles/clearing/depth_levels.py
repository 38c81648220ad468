# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cuts the parts of a room level by level, with the links between runs and the lifts.

part    level 1   entry, run · entry or link, run · ...
        level 2   over the floor just cut to the entry, where a straight way leads there; else up and over
        ...
lift to clearance, next part
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from CNCStepper.cycles.clearing.pattern import Pass
from CNCStepper.cycles.clearing.region_stages import Part, Stage
from CNCStepper.cycles.clearing.straight_links import LinkRegion
from CNCStepper.cycles.cycle import Setup
from CNCStepper.cycles.moves import Moves, Point
from CNCStepper.cycles.passes import require_few_blocks
from CNCStepper.geometry.curve import Curve, straight
from CNCStepper.toolpath import TableBuilder

LIFT_MM = 0.3  # above the floor go rapids over ground that is cut: so the tool does not rub on it


def require_short(parts: Sequence[Part], floors_mm: Sequence[float], retract_mm: float) -> None:
    """Raise CycleError when the parts in all levels have more blocks than a program may have."""
    fall_mm = retract_mm - floors_mm[-1]
    stages = [stage for part in parts for stage in part.stages]
    blocks = sum(len(one.curve) + 2 * one.lifted for stage in stages for one in stage.run.passes)
    require_few_blocks(len(floors_mm) * blocks + sum(stage.entry.blocks(fall_mm) for stage in stages))


def cut_parts(parts: Sequence[Part], floors_mm: Sequence[float], setup: Setup, table: TableBuilder) -> None:
    """Append all parts at all levels to `table` and leave the tool at clearance height."""
    moves = Moves(table, setup)
    for part in parts:
        top_mm = setup.retract_mm
        for number, floor_mm in enumerate(floors_mm, start=1):
            table.open_span("level", f"level {number}", floor_mm=floor_mm)
            _level(part, moves, table, setup, top_mm, floor_mm)
            table.close_span()
            top_mm = floor_mm
        moves.retract()


def _level(part: Part, moves: Moves, table: TableBuilder, setup: Setup, top_mm: float, floor_mm: float) -> None:
    feed_mm_min = setup.tool.feed_mm_min
    for stage in part.stages:
        if stage.cut is not None:
            _come(moves, table, stage.entry.begin, stage.cut, floor_mm, feed_mm_min)
        else:
            if len(part.stages) == 1 and stage.run.back is not None and moves.z_mm == top_mm:
                _link(moves, table, stage.run.back, feed_mm_min)
            _come(moves, table, stage.entry.begin, part.ground, top_mm, feed_mm_min)
            table.open_span("entry", stage.entry.kind)
            stage.entry.descend(moves, top_mm, floor_mm, feed_mm_min)
            table.close_span()
        _run(stage, moves, table)


def _come(moves: Moves, table: TableBuilder, begin: Point, ground: LinkRegion, z_mm: float, feed_mm_min: float) -> None:
    """Come to `begin` at a height at which `ground` is free: straight over it, or by rapids from above."""
    if moves.z_mm == z_mm and ground.sees(moves.position[:2], begin):
        _link(moves, table, straight(moves.position[:2], begin), feed_mm_min)
        return
    if not math.isnan(moves.z_mm):
        moves.retract()
    moves.approach(begin)
    moves.plunge(z_mm)


def _link(moves: Moves, table: TableBuilder, way: Curve, feed_mm_min: float) -> None:
    table.open_span("link", "link")
    moves.follow(way, feed_mm_min)
    table.close_span()


def _run(stage: Stage, moves: Moves, table: TableBuilder) -> None:
    floor_mm = moves.z_mm
    for passes, track in stage.stretches:
        begin = table.index
        if track is None:
            _lifted(passes[0], moves, floor_mm, stage.feed_mm_min)
            table.add_span("link", passes[0].name, begin, table.index)
            continue
        if moves.z_mm > floor_mm:
            moves.plunge(floor_mm)
            begin = table.index
        moves.run(track, stage.feed_mm_min)
        lasts = [begin + rows for rows in track.rows]
        for one, first, last in zip(passes, [begin, *lasts], lasts, strict=False):
            table.add_span("link" if one.name == "link" else "pass", one.name, first, last)


def _lifted(one: Pass, moves: Moves, floor_mm: float, feed_mm_min: float) -> None:
    """Go up and along by rapids, or from there down to the floor along a link."""
    if one.lifted:
        moves.hop(one.curve, LIFT_MM)
    else:
        moves.slope(one.curve, floor_mm, feed_mm_min)
