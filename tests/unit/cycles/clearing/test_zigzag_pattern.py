# SPDX-License-Identifier: LGPL-2.1-or-later
"""Zigzag over random regions with islands: nothing gouged, nothing left, one run a part, links over cut ground only."""

from __future__ import annotations

import math
import time

import numpy as np
import pytest
import shapely

from CNCStepper.cycles.clearing.pattern import Area, Run
from CNCStepper.cycles.clearing.zigzag_pattern import zigzag
from CNCStepper.errors import CycleError
from CNCStepper.geometry.curve import Curve, circle, from_points
from CNCStepper.geometry.region import Region
from helpers.cycles.random_areas import DEEP_MM, TOLERANCE_MM, Drawn, path_of, random_area
from helpers.cycles.seeds import SEEDS
from helpers.cycles.sweep_judge import Wanted, gouge_mm, left_mm, reachable, swept

BOX = from_points([(0, 0), (60, 0), (60, 40), (0, 40)], closed=True)


def stepover_mm(drawn: Drawn, seed: int) -> float:
    """Return a stepover up to all of the tool's width."""
    return 2.0 * drawn.tool_mm * float(np.random.default_rng(seed).choice([0.2, 0.4, 0.7, 1.0]))


def angle_deg(seed: int) -> float:
    return float(np.random.default_rng(seed + 1000).choice([0.0, 45.0, 90.0, 17.0]))


def links_are_over_cut_ground(runs: list[Run], tool_mm: float) -> bool:
    """Whether every link runs where passes of the same run have been."""
    for run in runs:
        been: list[shapely.LineString] = []
        for one in run.passes:
            line = shapely.LineString(one.curve.points(1e-4))
            if one.name == "link":
                ground = shapely.union_all(shapely.buffer(been, 1e-3))
                if not ground.covers(line):
                    return False
            been.append(line)
    return True


@pytest.mark.slow
@pytest.mark.parametrize("seed", SEEDS)
def test_a_random_area_is_cleared(seed: int) -> None:
    drawn = random_area(seed)
    area = drawn.area(stepover_mm(drawn, seed), climb=bool(seed % 2))
    runs = zigzag(area, angle_deg(seed))
    assert len(runs) == len(area.room.parts())
    if not runs:
        return
    path = path_of(runs, drawn.tool_mm)
    assert gouge_mm(path, drawn.tool_mm, [Wanted(drawn.region, -DEEP_MM)]) <= TOLERANCE_MM
    must_go = reachable(drawn.region, drawn.tool_mm)
    assert left_mm(must_go, swept(path, drawn.tool_mm, -DEEP_MM)) <= TOLERANCE_MM
    assert links_are_over_cut_ground(runs, drawn.tool_mm)


@pytest.mark.slow
def test_the_cases_have_their_shares() -> None:
    cases = [random_area(seed) for seed in SEEDS]
    rooms = [drawn.area(drawn.tool_mm).room for drawn in cases]
    regions = [Region.of(drawn.outlines, drawn.islands) for drawn in cases]
    tenth = len(cases) / 10
    assert sum(any(loop.area_mm2 < 0 for loop in region.loops) for region in regions) >= tenth
    assert sum(len(room.loops) != len(region.loops) for room, region in zip(rooms, regions, strict=True)) >= tenth
    assert sum(drawn.sliver for drawn in cases) >= tenth
    assert sum(room.empty for room in rooms) <= 0.3 * len(cases)


def area_of(outline: Curve, islands: tuple[Curve, ...] = (), tool_mm: float = 3.0, step_mm: float = 4.0) -> Area:
    room = Region.of([outline], islands).offset(-tool_mm, 0.001)
    return Area(room, tool_mm, step_mm, TOLERANCE_MM, True)


def test_lines_are_at_most_the_stepover_apart_and_evenly() -> None:
    (run,) = zigzag(area_of(BOX), 0.0)
    lines = run.passes[0].curve
    way = np.diff(lines.xy, axis=0)
    long_ = np.flatnonzero(np.abs(way[:, 0]) > 50)
    heights = lines.xy[long_, 1]
    assert np.diff(heights) == pytest.approx(34 / 9) and 34 / 9 <= 4.0  # the room is 54 by 34 mm
    assert (np.sign(way[long_, 0][1:]) == -np.sign(way[long_, 0][:-1])).all()
    assert run.passes[-1].curve.area_mm2 == pytest.approx(54 * 34)  # the wall last, counter-clockwise: climb


def test_one_run_reaches_round_many_islands() -> None:
    islands = tuple(circle((x, y), 3.0) for x in (12, 28, 44) for y in (12, 28))
    runs = zigzag(area_of(BOX, islands, tool_mm=1.5, step_mm=1.2), 30.0)
    assert len(runs) == 1
    linked = sum(one.curve.length_mm for one in runs[0].passes if one.name == "link")
    assert linked < 0.2 * sum(one.curve.length_mm for one in runs[0].passes)


@pytest.mark.parametrize("climb", [True, False])
def test_walls_are_run_in_the_direction_asked_for(climb: bool) -> None:
    area = area_of(BOX, (circle((30, 20), 5.0),))
    (run,) = zigzag(Area(area.room, 3.0, 4.0, TOLERANCE_MM, climb), 90.0)
    rounds = [one.curve for one in run.passes if one.curve.closed and one.name != "link"]
    sizes = sorted(curve.area_mm2 for curve in rounds)
    assert [math.copysign(1.0, size) for size in sizes] == [-1.0, 1.0]
    assert sizes[1 if climb else 0] == pytest.approx(54 * 34 if climb else -54 * 34)


def test_a_tool_as_wide_as_the_slot_runs_along_it() -> None:
    slot = Curve(np.array([(0, -3), (40, -3), (40, 3), (0, 3), (0, -3.0)]), np.array([0, 1, 0, 1.0]))
    area = area_of(slot, tool_mm=2.9995)
    (run,) = zigzag(area, 20.0)
    assert (
        left_mm(reachable(shapely.box(0, -2.99, 40, 2.99), 2.98), swept(path_of([run], 2.9995), 2.9995, -DEEP_MM))
        < 0.01
    )


@pytest.mark.slow
def test_a_coarse_outline_of_many_points_is_walked_quickly() -> None:
    angle = np.linspace(0, 2 * math.pi, 50_001)[:-1]
    radius = 30 + np.sin(40 * angle)
    area = area_of(from_points(radius[:, None] * np.column_stack([np.cos(angle), np.sin(angle)]), closed=True))
    assert len(zigzag(area, 10.0)) == 1


def test_the_lines_are_as_far_apart_as_is_told() -> None:
    (run,) = zigzag(area_of(BOX, step_mm=4.0), 0.0)
    assert run.apart_mm == pytest.approx(34 / 9)


def test_lines_without_number_are_refused_before_any_is_drawn() -> None:
    began_s = time.process_time()
    with pytest.raises(CycleError) as refused:
        zigzag(area_of(BOX, step_mm=1e-3))
    assert refused.value.code == "passes-many" and "0.0034 mm" in refused.value.limit
    assert time.process_time() - began_s < 2.0
