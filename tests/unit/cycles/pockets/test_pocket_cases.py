# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random pockets, judged by the product through their program text and, apart from it, by shapely.

Independent of the cycle: the wanted region is drawn by shapely, the tool may nowhere leave it, and must have swept
all that its disc can reach; what the cycle says it cannot reach is compared with that.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import numpy as np
import pytest
from shapely.geometry.base import BaseGeometry

from CNCStepper.cycles.passes import whole_passes
from CNCStepper.cycles.pockets.pocket import Pocket
from CNCStepper.errors import CNCStepperError
from CNCStepper.geometry.region import Region
from helpers.cycles.product_verdict import Verdict, cut, judged, tool
from helpers.cycles.random_pockets import Shapes, random_shapes
from helpers.cycles.seeds import SEEDS
from helpers.cycles.sweep_judge import Wanted, band, gouge_mm, left_mm, reachable, swept

DEPTH_MM = 2.0
TOLERANCE_MM = 0.01
ERROR_MM = 0.0025  # of the judges, the writer's rounding included
REFUSALS = ("tool-wide", "finish-wide")


@dataclass(frozen=True)
class Case:
    shapes: Shapes
    leave_mm: float
    operation: Pocket

    @property
    def wanted(self) -> BaseGeometry:
        region = self.shapes.region
        return region.difference(band(region, self.leave_mm)) if self.leave_mm else region


@cache
def random_case(seed: int) -> Case:
    rng = np.random.default_rng(seed)
    shapes = random_shapes(seed, rng)
    radius_mm, exact = shapes.tool_mm / 2.0, shapes.tool_mm == shapes.narrowest_mm
    leave_mm = 0.0 if exact else float(rng.choice([0.0, 0.0, 0.0, 0.05 * radius_mm]))
    operation = Pocket(
        tool=1,
        outlines=shapes.outlines,
        islands=shapes.islands,
        depth_mm=DEPTH_MM,
        stepdown_mm=float(rng.choice([2.0, 1.2])),
        stepover_mm=float(rng.choice([0.8, 0.8, 1.0, rng.uniform(0.5, 1.0), rng.uniform(1.0, 2.0), 2.0])) * radius_mm,
        finish_stepdown_mm=float(rng.choice([0.0, 0.2])),
        finish_stepover_mm=float(rng.choice([0.0, 0.0, rng.uniform(0.05, 0.4)])) * radius_mm,
        stock_to_leave_mm=leave_mm,
        entry=str(rng.choice(["helix", "ramp", "plunge"])),
        entry_angle_deg=float(rng.choice([3.0, 20.0])),
        direction=str(rng.choice(["climb", "conventional"])),
        tolerance_mm=TOLERANCE_MM,
    )
    return Case(shapes, leave_mm, operation)


def tried(case: Case) -> Verdict | CNCStepperError:
    try:
        return judged(case.operation, tool(case.shapes.tool_mm))
    except CNCStepperError as error:
        return error


@pytest.mark.slow
@pytest.mark.parametrize("seed", SEEDS)
def test_a_random_pocket_is_cut_out_exactly(seed: int) -> None:
    case = random_case(seed)
    found = tried(case)
    if isinstance(found, CNCStepperError):
        assert found.code in REFUSALS and found.advice, found
        return
    check(case, found, corners=seed % 3 == 0)


def check(case: Case, found: Verdict, corners: bool) -> None:
    """Assert what both judges say of gouges and of what is left at every level; `corners`: that they are no larger."""
    radius_mm, wanted = case.shapes.tool_mm / 2.0, case.wanted
    assert found.faults == []
    assert max(found.gouge_mm, found.left_mm) <= TOLERANCE_MM + 0.001
    assert gouge_mm(found.toolpath, radius_mm, [Wanted(wanted, -DEPTH_MM)]) <= TOLERANCE_MM + ERROR_MM
    must_go = reachable(wanted, radius_mm)
    for floor_mm in floors_mm(case.operation):
        assert left_mm(must_go, swept(found.toolpath, radius_mm, floor_mm)) <= TOLERANCE_MM + ERROR_MM, floor_mm
    told = found.answer.removals[0].reachable
    assert left_mm(must_go, told) <= TOLERANCE_MM
    if corners:
        assert left_mm(told, reachable(wanted, radius_mm - TOLERANCE_MM)) <= TOLERANCE_MM


def floors_mm(operation: Pocket) -> list[float]:
    steps = whole_passes(operation.depth_mm, operation.stepdown_mm, operation.finish_stepdown_mm, "stepdown_mm")
    return [-sum(steps[:count]) for count in range(1, len(steps) + 1)]


@pytest.mark.slow
def test_the_generator_tries_what_is_hard() -> None:
    seeds = range(1, 101)
    cases = [random_case(seed) for seed in seeds]
    shares = [case.shapes.tool_mm / case.shapes.narrowest_mm for case in cases]
    assert min(shares) < 0.2 and shares.count(1.0) >= 10 and max(shares) <= 1.0
    layouts = [case.shapes.layout for case in cases]
    assert layouts.count("sliver") >= 10
    assert sum(bool(case.shapes.islands) for case in cases) >= 10
    assert sum(falls_apart(case) for case in cases) >= 10
    assert sum(case.operation.stepover_mm > case.shapes.tool_mm / 2 for case in cases) >= 10


@pytest.mark.slow
def test_few_random_pockets_are_refused() -> None:
    refused = 0
    for seed in SEEDS:
        case = random_case(seed)
        try:
            cut(case.operation, tool(case.shapes.tool_mm))
        except CNCStepperError:
            refused += 1
    assert refused <= 0.3 * len(SEEDS)


def falls_apart(case: Case) -> bool:
    """Return whether the passes come to lie in several rooms, or there is none for the tool at all."""
    region = Region.of(case.shapes.outlines, case.shapes.islands)
    pieces = [len(region.offset(-share * case.shapes.tool_mm, 0.01).parts()) for share in (0.6, 0.9, 1.3, 2.0)]
    return max(pieces) > len(region.parts()) or pieces[0] == 0


def test_a_pocket_with_islands_is_cut_out_exactly() -> None:
    case = random_case(8)
    found = tried(case)
    assert case.shapes.layout == "islands" and isinstance(found, Verdict)
    check(case, found, corners=True)
