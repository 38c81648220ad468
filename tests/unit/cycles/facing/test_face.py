# SPDX-License-Identifier: LGPL-2.1-or-later
"""Facing random stocks and regions: nothing left, nothing cut farther out than promised, down beside the stock."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import pytest
import shapely
from shapely import Point, Polygon

from CNCStepper.cycles.cycle import Setup
from CNCStepper.cycles.facing.face import Face
from CNCStepper.errors import CycleError
from CNCStepper.geometry.curve import Curve, circle, from_points
from CNCStepper.geometry.shapes.rectangle import rectangle
from CNCStepper.simulation.stock import Stock
from CNCStepper.state import Start
from CNCStepper.toolpath import RAPID, TableBuilder, Toolpath
from helpers.cycles.product_verdict import cut, judged, tool
from helpers.cycles.random_areas import polygon
from helpers.cycles.seeds import SEEDS
from helpers.cycles.sweep_judge import DEEP_MM, Wanted, band, gouge_mm, left_mm, swept

PLACES = ("stock", "inside", "across", "sliver", "two")
STOCK = Stock((80, 50, 10))


@dataclass(frozen=True)
class Case:
    """What is faced, where it lies, and by what."""

    place: str
    operation: Face
    tool_mm: float


def random_case(seed: int) -> Case:
    """Return a facing of the whole stock, or of regions within it, across its edge, thin, or two of them."""
    rng, place = np.random.default_rng(seed), PLACES[seed % len(PLACES)]
    tool_mm = round(float(rng.uniform(1.5, 8)), 3)
    pattern = str(rng.choice(["zigzag", "oneway", "spiral"]))
    operation = Face(
        tool=1,
        outlines=tuple(_outlines(place, rng, pattern)),
        depth_mm=1.5,
        stepdown_mm=float(rng.choice([0.8, 2.0])),
        finish_stepdown_mm=float(rng.choice([0.0, 0.2])),
        stepover_mm=2 * tool_mm * float(rng.choice([0.3, 0.6, 1.0])),
        overhang_mm=float(rng.choice([0.0, rng.uniform(0, 10)])),
        pattern=pattern,
        angle_deg=float(rng.choice([0, 90, rng.uniform(0, 180)])),
        direction=str(rng.choice(["climb", "conventional"])),
    )
    return Case(place, operation, tool_mm)


def _outlines(place: str, rng: np.random.Generator, pattern: str) -> list[Curve]:
    turn, at = rng.uniform(0, 360), rng.uniform(-8, 8, 2)
    if place == "stock":
        return []
    if place == "sliver":
        return [from_points([(0, 0), (30, rng.uniform(0.05, 1.5)), (30, 0)], closed=True).rotated(turn).moved(*at)]
    if place == "across":
        return [circle((40 * rng.choice([-1, 1]), at[1]), rng.uniform(5, 15))]
    if place == "two":
        return [circle((-25, at[1]), rng.uniform(3, 9)), rectangle((10, 0), (25, 15)).moved(*at)]
    if pattern == "spiral":
        return [rectangle((-15, -8), (15, 8)).rotated(turn).moved(*at)]
    count = int(rng.integers(3, 9))
    angle = (np.arange(count) + rng.uniform(0, 0.8, count)) * 2 * math.pi / count
    star = rng.uniform(5, 15, count)[:, None] * np.column_stack([np.cos(angle), np.sin(angle)])
    return [from_points(star, closed=True).moved(*at)]


def faced(operation: Face) -> shapely.geometry.base.BaseGeometry:
    """Return what is to be faced of the stock."""
    drawn = shapely.union_all([polygon(curve) for curve in operation.outlines])
    return drawn.intersection(outline()) if operation.outlines else outline()


def outline() -> Polygon:
    return shapely.box(-40, -25, 40, 25)


def plunges(path: Toolpath) -> list[np.ndarray]:
    """Return where the tool goes straight down below the top."""
    begin, end, kind = path.begins(), path.table().end, path.table().kind
    down = (
        (kind != RAPID)
        & (end[:, 2] < -DEEP_MM)
        & (np.hypot(*(end - begin)[:, :2].T) < 1e-9)
        & (end[:, 2] < begin[:, 2])
    )
    return list(end[down])


@pytest.mark.slow
@pytest.mark.parametrize("seed", SEEDS)
def test_a_random_facing_is_level_and_nowhere_too_wide(seed: int) -> None:
    case = random_case(seed)
    operation, tool_mm = case.operation, case.tool_mm
    found = judged(operation, tool(2 * tool_mm), stock=STOCK)
    assert found.clean, found.faults
    region, path = faced(operation), found.toolpath
    assert left_mm(region, swept(path, tool_mm, -operation.depth_mm)) <= operation.tolerance_mm
    out_mm = tool_mm + math.hypot(operation.overhang_mm, found.answer.figures["ae_mm"] / 2)
    drawn = shapely.union_all([polygon(curve) for curve in operation.outlines]) if operation.outlines else region
    air = shapely.box(-200, -200, 200, 200).difference(outline())
    wanted = [Wanted(shapely.union_all([drawn, band(drawn, out_mm), air]), -operation.depth_mm)]
    assert gouge_mm(path, tool_mm, wanted) <= operation.tolerance_mm
    if case.place == "stock":
        assert found.answer.figures["entries_from_the_side"] == found.answer.figures["passes"]
        assert all(outline().distance(Point(xyz[:2])) > tool_mm for xyz in plunges(path))


def test_the_cases_have_their_shares() -> None:
    cases = [random_case(seed) for seed in SEEDS]
    for pattern in ("zigzag", "oneway", "spiral"):
        assert sum(case.operation.pattern == pattern for case in cases) >= len(cases) / 10
    for place in PLACES:
        assert sum(case.place == place for case in cases) >= len(cases) / 10


def test_the_whole_stock_is_faced_from_beside_it() -> None:
    found = judged(Face(tool=1, depth_mm=1, stepdown_mm=1, stepover_mm=4), tool(6.0), stock=STOCK)
    assert found.clean and found.left_mm <= 0.01
    assert found.answer.figures == {
        "ap_mm": 1.0, "levels": 1, "ae_mm": pytest.approx(50 / 13), "passes": 1, "entries_from_the_side": 1
    }  # fmt: skip
    (down,) = plunges(found.toolpath)
    assert outline().distance(Point(down[:2])) > 3.0


@pytest.mark.parametrize(("direction", "uncut"), [("climb", -1), ("conventional", 1)])
def test_one_way_keeps_the_uncut_stock_on_one_side(direction: str, uncut: int) -> None:
    operation = Face(tool=1, depth_mm=1, stepdown_mm=1, stepover_mm=4, pattern="oneway", direction=direction)
    path = judged(operation, tool(6.0), stock=STOCK).toolpath
    begin, end = path.begins(), path.table().end
    lines = np.flatnonzero((end[:, 2] < 0) & (np.abs(end - begin)[:, 0] > 60))
    ways, heights = np.sign((end - begin)[lines, 0]), end[lines, 1]
    assert len(set(ways)) == 1 and len(lines) == 13
    left = ways[0] * np.sign(np.diff(heights))  # 1: the next line lies to the left
    assert set(left) == {uncut}


def test_the_finishing_depth_has_its_own_feed() -> None:
    keys = {"finish_stepdown_mm": 0.2, "finish_feed_mm_min": 300}
    path = judged(Face(tool=1, depth_mm=1, stepdown_mm=1, stepover_mm=4, **keys), tool(6.0), stock=STOCK).toolpath
    table, begin = path.table(), path.begins()
    long_ = np.abs(table.end - begin)[:, 0] > 60
    assert set(table.feed[long_ & (np.abs(table.end[:, 2] + 1.0) < 1e-6)]) == {300.0}
    assert set(table.feed[long_ & (np.abs(table.end[:, 2] + 0.8) < 1e-6)]) == {800.0}


@pytest.mark.parametrize(
    ("operation", "code"),
    [
        (Face(tool=1, depth_mm=1, stepdown_mm=1, stepover_mm=4), "stock-missing"),
        (Face(tool=1, depth_mm=1, stepdown_mm=1, stepover_mm=7, outlines=(circle((0, 0), 9),)), "stepover-wide"),
        (
            Face(tool=1, depth_mm=1, stepdown_mm=1, stepover_mm=4, outlines=(from_points([(0, 0), (9, 0), (0, 0)]),)),
            "face-empty",
        ),
    ],
)
def test_what_cannot_be_faced_is_refused(operation: Face, code: str) -> None:
    table = TableBuilder(Start())
    with pytest.raises(CycleError) as caught:
        operation.cut(Setup(tool(6.0), 10.0, 2.0), table)
    assert caught.value.code == code and table.index == 0


def test_outlines_beside_the_stock_are_refused() -> None:
    operation = Face(tool=1, depth_mm=1, stepdown_mm=1, stepover_mm=4, outlines=(circle((90, 0), 9),))
    with pytest.raises(CycleError, match="beside the stock"):
        judged(operation, tool(6.0), stock=STOCK)


ANGLE = np.linspace(0, 2 * math.pi, 50_001)[:-1]
ODD = {
    "bow tie": from_points([(-20, -15), (20, 15), (20, -15), (-20, 15)], closed=True),
    "doubled points": Curve(np.array([(0, 0), (0, 0), (20, 0), (20, 0), (20, 10), (0, 10), (0, 0.0)]), np.zeros(6)),
    "50 000 points": from_points(20 * np.column_stack([np.cos(ANGLE), np.sin(ANGLE)]), closed=True),
}


@pytest.mark.slow
@pytest.mark.parametrize("pattern", ["zigzag", "oneway", "spiral"])
@pytest.mark.parametrize("name", ODD)
def test_odd_outlines_are_faced(name: str, pattern: str) -> None:
    operation = Face(tool=1, outlines=(ODD[name],), depth_mm=1, stepdown_mm=1, stepover_mm=4, pattern=pattern)
    found = judged(operation, tool(6.0), stock=STOCK)
    assert found.clean, found.faults
    assert left_mm(faced(operation), swept(found.toolpath, 3.0, -1.0)) <= operation.tolerance_mm
    assert len(found.lines) < 150


def test_without_a_stock_a_region_is_entered_as_a_pocket_is() -> None:
    _, answer = cut(Face(tool=1, depth_mm=1, stepdown_mm=1, stepover_mm=4, outlines=(circle((0, 0), 20),)), tool(6.0))
    assert answer.figures["entries_from_the_side"] == 0 and "helix" in answer.warnings[0]


@pytest.mark.parametrize("angle_deg", range(0, 90, 7))
@pytest.mark.parametrize("pattern", ["zigzag", "oneway"])
def test_runs_that_begin_just_beside_the_stock_are_come_to(pattern: str, angle_deg: float) -> None:
    operation = Face(
        tool=1, depth_mm=1, stepdown_mm=1, stepover_mm=4, overhang_mm=3.92, angle_deg=angle_deg, pattern=pattern
    )
    setup = Setup(tool(6.0), 10.0, 2.0, stock=rectangle((0, 0), (30, 20)))
    figures = operation.cut(setup, TableBuilder(Start())).figures
    assert figures["entries_from_the_side"] == figures["passes"]


def test_the_spirals_own_stepover_is_told() -> None:
    spiral = Face(tool=1, depth_mm=1, stepdown_mm=1, stepover_mm=2.9, pattern="spiral")
    found = judged(spiral, tool(6.0), stock=STOCK).answer.figures["ae_mm"]
    assert found <= 2.9 and found != pytest.approx(50 / 18)  # 50/18: of lines
