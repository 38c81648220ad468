# SPDX-License-Identifier: LGPL-2.1-or-later
"""Clearing at bounded engagement: the angle and the length in random areas, nothing left, never out of the room."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, replace
from functools import cache

import numpy as np
import pytest
import shapely

from CNCStepper.cycles.clearing.engagement import clearing_map
from CNCStepper.cycles.clearing.engagement.bounded_engagement_pattern import engagement_pattern
from CNCStepper.cycles.clearing.pattern import Area, Run
from CNCStepper.cycles.pockets.pocket import Pocket
from CNCStepper.errors import CycleError
from CNCStepper.geometry.curve import circle, from_points
from CNCStepper.geometry.region import Region
from CNCStepper.simulation.checks.program_report import report
from CNCStepper.simulation.removal.engagement import engagement
from CNCStepper.simulation.stock import Stock
from helpers.cycles.engagement_judge import met_by
from helpers.cycles.product_verdict import cut, judged, tool
from helpers.cycles.random_areas import Drawn, path_of, random_area
from helpers.cycles.seeds import SEEDS
from helpers.cycles.sweep_judge import Wanted, gouge_mm, left_mm, reachable, swept

TOLERANCE_MM = 0.01
MARGIN_DEG = 5.0
HARD = (42, 49, 185, 356)  # seeds: narrow channels, and bites close together in a neck
ROUND = (183, 215, 404, 432)  # seeds: no walk comes near the middle of an island's longest arc
LONG = 410  # the seed of a room that is all channels
LONGER = 1.6  # than the offset pattern, at most
ROOMIEST = 1.8  # of the radius: no entry opens a wider disc
ANGLES_DEG = (45.0, 60.0, 75.0, 90.0, 120.0)
PLATE = [(30, 25), (70, 22), (85, 40), (120, 30), (130, 60), (100, 85), (60, 70), (35, 85)]
BOSS = [(90, 50), (104, 48), (106, 62), (92, 64)]


@dataclass(frozen=True)
class Case:
    """A random area with a tool 0.05 to 0.5 of its widest place, so that there is room for a bound, and the bound."""

    drawn: Drawn
    max_deg: float

    @property
    def stepover_mm(self) -> float:
        """The stepover at which a straight front is met at the bound."""
        return self.drawn.tool_mm * (1.0 - math.cos(math.radians(self.max_deg)))


@cache
def _case(seed: int) -> Case:
    drawn = random_area(seed)
    max_deg = float(np.random.default_rng(seed).choice(ANGLES_DEG))
    return Case(replace(drawn, tool_mm=round(0.5 * drawn.tool_mm, 3)), max_deg)


@cache
def _runs(seed: int) -> list[Run] | CycleError:
    case = _case(seed)
    try:
        return engagement_pattern(case.max_deg)(case.drawn.area(case.stepover_mm))
    except CycleError as refusal:
        assert refusal.code in ("engagement-narrow", "engagement-long")
        return refusal


def _offset_length_mm(room: Region, stepover_mm: float) -> float:
    """Return the length of the room's loops and of all its parallels, a stepover apart."""
    length_mm, step, ring = 0.0, 0, room
    while not ring.empty:
        length_mm, step = length_mm + ring.length_mm, step + 1
        ring = room.offset(-step * stepover_mm, TOLERANCE_MM)
    return length_mm


def _least_length_mm(case: Case) -> float:
    """Return below which length no way can be: a straight front at the bound gives a stepover's area a millimetre."""
    drawn = case.drawn
    parts = len(drawn.area(case.stepover_mm).room.parts())
    opened_mm2 = parts * math.pi * (ROOMIEST * drawn.tool_mm) ** 2
    return (reachable(drawn.region, drawn.tool_mm).area - opened_mm2) / case.stepover_mm


def _plate(**keys: object) -> Pocket:
    values = {"tool": 1, "depth_mm": 2.0, "stepdown_mm": 2.0, "stepover_mm": 1.5, "pattern": "engagement"}
    outline, boss = from_points(PLATE, closed=True), from_points(BOSS, closed=True)
    return Pocket(**{"outlines": (outline,), "islands": (circle((60, 48), 7), boss)} | values | keys)


@pytest.mark.slow
@pytest.mark.parametrize("seed", dict.fromkeys([*SEEDS, *HARD, *ROUND]))
def test_random_areas_are_cleared_within_the_bound(seed):
    runs, case = _runs(seed), _case(seed)
    if isinstance(runs, CycleError):
        return
    area = case.drawn.area(case.stepover_mm)
    met = [met_by(run, area.tool_mm) for run in runs]
    assert all(one.angle_deg.max() <= case.max_deg + MARGIN_DEG for one in met), [one.worst for one in met]
    offset_mm = _offset_length_mm(area.room, case.stepover_mm)
    assert sum(one.cut_mm for one in met) <= LONGER * offset_mm
    assert not any(one.angle_deg[one.lifted].any() for one in met)


@pytest.mark.slow
@pytest.mark.parametrize("seed", dict.fromkeys([*SEEDS, *HARD, *ROUND]))
def test_random_areas_are_cleared_whole_and_walls_kept(seed):
    runs, case = _runs(seed), _case(seed)
    if isinstance(runs, CycleError):
        return
    path, drawn = path_of(runs, case.drawn.tool_mm), case.drawn
    wanted = reachable(drawn.region, drawn.tool_mm)
    opened = [shapely.Point(run.opening.centre_mm).buffer(run.opening.radius_mm - 1e-3) for run in runs]
    assert gouge_mm(path, drawn.tool_mm, [Wanted(drawn.region, -1.0)]) <= TOLERANCE_MM
    assert left_mm(wanted, shapely.union_all([swept(path, drawn.tool_mm, -1.0), *opened])) <= TOLERANCE_MM


@pytest.mark.slow
def test_the_random_areas_have_islands_and_slivers_and_few_are_refused():
    cases = [_case(seed) for seed in SEEDS]
    assert sum(bool(case.drawn.islands) for case in cases) >= 0.1 * len(cases)
    assert sum(case.drawn.sliver for case in cases) >= 0.1 * len(cases)
    assert sum(isinstance(_runs(seed), CycleError) for seed in SEEDS) <= 0.3 * len(cases)


@pytest.mark.slow
@pytest.mark.parametrize("seed", dict.fromkeys([*SEEDS, LONG]))
def test_areas_are_refused_as_too_long_only_where_no_way_at_the_bound_is_shorter(seed):
    refusal, case = _runs(seed), _case(seed)
    if not isinstance(refusal, CycleError) or refusal.code != "engagement-long":
        assert seed != LONG
        return
    offset_mm = _offset_length_mm(case.drawn.area(case.stepover_mm).room, case.stepover_mm)
    assert _least_length_mm(case) > LONGER * offset_mm


@pytest.mark.slow
def test_a_room_of_channels_is_cleared_at_the_engagement_that_its_refusal_names():
    refused = _runs(LONG)
    assert isinstance(refused, CycleError)
    told = re.fullmatch(
        r"use an engagement_max_deg of (\d+) or more with a stepover_mm of ([\d.]+) or .*", refused.advice
    )
    assert told
    case = replace(_case(LONG), max_deg=float(told[1]))
    assert case.stepover_mm <= float(told[2]) < case.stepover_mm + 0.01
    area = case.drawn.area(case.stepover_mm)
    met = [met_by(run, area.tool_mm) for run in engagement_pattern(case.max_deg)(area)]
    assert max(one.angle_deg.max() for one in met) <= case.max_deg + MARGIN_DEG
    assert sum(one.cut_mm for one in met) <= LONGER * _offset_length_mm(area.room, case.stepover_mm)


@pytest.mark.slow
@pytest.mark.parametrize("max_deg", [45.0, 60.0, 90.0])
def test_the_plates_pocket_keeps_both_numbers_with_all_ways_but_the_last_along_the_walls(max_deg):
    room = Region.of(_plate().outlines, _plate().islands).offset(-3.0, TOLERANCE_MM / 4)
    stepover_mm = 3.0 * (1.0 - math.cos(math.radians(max_deg)))
    (run,) = engagement_pattern(max_deg)(Area(room, 3.0, stepover_mm, TOLERANCE_MM, True))
    met = met_by(run, 3.0)
    assert met.angle_deg.max() <= max_deg + MARGIN_DEG, met.worst
    offset_mm = _offset_length_mm(room, stepover_mm)
    assert met.cut_mm <= LONGER * offset_mm
    assert met.feed_mm <= LONGER * offset_mm + sum(one.curve.length_mm for one in run.passes if "wall" in one.name)
    assert not met.angle_deg[met.lifted].any()


@pytest.mark.slow
@pytest.mark.parametrize("max_deg", [45.0, 60.0, 75.0, 90.0])
def test_the_plates_whole_program_is_not_much_longer_than_with_parallels(max_deg):
    """Every feed below the stock's top counts: the helix, links on the floor and the walls too."""
    stepover_mm = 3.0 * (1.0 - math.cos(math.radians(max_deg)))
    bounded, parallel = (
        report(path, np.zeros(len(path)))
        for keys in ({"engagement_max_deg": max_deg}, {"pattern": "offset"})
        for path in [cut(_plate(stepover_mm=stepover_mm, **keys), tool(6))[0]]
    )
    assert bounded["cut_length_mm"] <= LONGER * parallel["cut_length_mm"]
    assert bounded["plunges"] <= 40


@pytest.mark.slow
def test_the_products_own_simulation_sees_no_more_either():
    found = judged(_plate(), tool(6))
    assert found.clean, found.faults
    assert found.gouge_mm <= TOLERANCE_MM
    assert found.left_mm <= TOLERANCE_MM
    path = cut(_plate(), tool(6))[0]
    met = engagement(path, tool(6), Stock((160.0, 110.0, 8.0), "top-left-front"))
    (entry,) = [span for span in path.spans if span.kind == "entry"]
    assert np.nanmax(met.angle_deg[met.row >= entry.last]) <= 60.0 + MARGIN_DEG


@pytest.mark.slow
@pytest.mark.parametrize("climb", [True, pytest.param(False, marks=pytest.mark.slow)])
def test_the_material_is_on_the_side_asked_for(climb):
    room = Region.of([from_points([(0, 0), (14, 0), (14, 9), (0, 9)], closed=True)])
    (run,) = engagement_pattern(60.0)(Area(room, 3.0, 1.5, TOLERANCE_MM, climb))
    assert met_by(run, 3.0).angle_deg.max() <= 65.0
    wall = run.passes[-1]
    assert wall.name == "wall 1"
    assert (wall.curve.area_mm2 > 0) == climb


@pytest.mark.slow
def test_passes_hang_together_and_begin_in_the_opening():
    room = Region.of([from_points([(0, 0), (14, 0), (14, 9), (0, 9)], closed=True)])
    (run,) = engagement_pattern(60.0)(Area(room, 3.0, 1.5, TOLERANCE_MM, True))
    ends = [one.curve.xy[-1] for one in run.passes[:-1]]
    assert np.allclose(ends, [one.curve.xy[0] for one in run.passes[1:]], atol=1e-6)
    helix_mm = math.dist(run.opening.centre_mm, run.passes[0].curve.xy[0])
    assert helix_mm == pytest.approx(run.opening.radius_mm - 3.0, abs=0.01)
    assert met_by(run, 3.0).angle_deg.max() <= 65.0


@pytest.mark.parametrize("wide_mm", [0.0004, 0.02, 0.2])
def test_a_slot_hardly_wider_than_the_tool_is_refused_by_name(wide_mm):
    room = Region.of([from_points([(0, 0), (20, 0), (20, wide_mm), (0, wide_mm)], closed=True)])
    with pytest.raises(CycleError) as refused:
        engagement_pattern(60.0)(Area(room, 3.0, 1.5, TOLERANCE_MM, True))
    assert refused.value.code == "engagement-narrow"


def small() -> Region:
    return Region.of([from_points([(0, 0), (8, 0), (8, 5), (0, 5)], closed=True)])


@pytest.mark.parametrize(("stepover_mm", "max_deg", "apart_mm"), [(0.75, 120.0, 0.75), (4.0, 60.0, 1.5)])
def test_the_smaller_of_stepover_and_angle_bounds_the_engagement(stepover_mm, max_deg, apart_mm):
    (run,) = engagement_pattern(max_deg)(Area(small(), 3.0, stepover_mm, TOLERANCE_MM, True))
    bound_deg = math.degrees(math.acos(1.0 - apart_mm / 3.0))
    rough = Run(run.passes[:-1], run.apart_mm, run.opening)  # the wall's corners are bounded by max_deg
    assert met_by(rough, 3.0).angle_deg.max() <= bound_deg + MARGIN_DEG
    assert run.apart_mm == pytest.approx(apart_mm)


def test_the_engagements_stepover_is_told_as_it_is():
    box = from_points([(0, 0), (14, 0), (14, 11), (0, 11)], closed=True)
    pocket = _plate(stepover_mm=2.6, outlines=(box,), islands=())
    assert cut(pocket, tool(6))[1].figures["ae_mm"] == pytest.approx(1.5)


def test_a_stepover_that_no_chip_shows_is_refused():
    with pytest.raises(CycleError) as refused:
        engagement_pattern(60.0)(Area(small(), 3.0, 0.15, TOLERANCE_MM, True))
    assert refused.value.code == "stepover-small" and "0.181" in refused.value.limit


@pytest.mark.parametrize("most", [66, 300])
def test_a_way_that_is_too_long_is_refused(monkeypatch, most):
    monkeypatch.setattr(clearing_map, "LONGEST_WAY", most)
    with pytest.raises(CycleError) as refused:
        engagement_pattern(60.0)(Area(small(), 3.0, 1.5, TOLERANCE_MM, True))
    assert refused.value.code == "blocks-many" and refused.value.advice
