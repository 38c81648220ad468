# SPDX-License-Identifier: LGPL-2.1-or-later
"""The elliptical pocket: part C's numbers, and exact sweeps of random pockets with all that is hard about them."""

from __future__ import annotations

import itertools
import math
import random
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache

import numpy as np
import pytest
from shapely import LinearRing, LineString, Point, Polygon, points, prepare

from CNCStepper.cycles.cycle import Answer
from CNCStepper.cycles.pockets.elliptical_pocket import EllipticalPocket
from CNCStepper.errors import CycleError
from CNCStepper.toolpath import RAPID, Toolpath
from helpers.cycles.ellipse_judge import OUTLINE_MM, runs, spans, unreachable_mm, wanted
from helpers.cycles.product_verdict import cut, judged, tool
from helpers.cycles.seeds import SEEDS
from helpers.cycles.sweep_judge import Wanted, band, gouge_mm, left_by_level

EXAMPLE = EllipticalPocket(
    tool=1,
    radius_x_mm=40,
    radius_y_mm=25,
    depth_mm=10,
    stepdown_mm=2,
    stepover_mm=2.4,
    finish_stepdown_mm=0.2,
    finish_stepover_mm=0.3,
)
JUDGE_MM = 1e-3  # to which the independent judge is good


@dataclass(frozen=True)
class Case:
    """One random pocket and the tool for it."""

    pocket: EllipticalPocket
    radius_mm: float
    share: float  # the tool's diameter of the narrowest width

    @property
    def tips_are_tighter(self) -> bool:
        long, short = sorted((self.pocket.radius_x_mm, self.pocket.radius_y_mm), reverse=True)
        return self.radius_mm > short**2 / long


def random_case(seed: int) -> Case:
    rng = random.Random(seed)
    method = "dda" if seed % 3 == 0 else "tolerance"
    short, aspect = rng.uniform(3, 25), rng.choice([1.0, 1.05, rng.uniform(1, 8), rng.uniform(1, 8)])
    share = rng.uniform(0.1, 0.98)
    if method == "dda":
        aspect = min(aspect, 3.0)
        share = min(max(share, 0.3), 0.95 / aspect)
    radius = share * short
    long = short * aspect
    radii = (long, short) if rng.random() < 0.5 else (short, long)
    room = min(radius, short - radius) / (2 * aspect if method == "dda" else 1)
    finish = rng.choice([0.0, 0.05, rng.uniform(0.1, 0.9)]) * room
    pocket = EllipticalPocket(
        tool=1,
        centre_mm=(rng.uniform(-50, 50), rng.uniform(-50, 50)),
        radius_x_mm=radii[0],
        radius_y_mm=radii[1],
        rotation_deg=rng.choice([0, 30, 90, rng.uniform(-180, 180)]),
        depth_mm=rng.uniform(1, 4),
        stepdown_mm=rng.uniform(1, 3),
        stepover_mm=rng.choice([2.0, 2.0, rng.uniform(1, 2), rng.uniform(0.5, 1)]) * radius,
        finish_stepdown_mm=rng.choice([0, 0.2]),
        finish_stepover_mm=finish,
        method=method,
        tolerance_mm=rng.choice([0.005, 0.01, 0.05]),
        resolution_mm=rng.uniform(0.2, 0.45) * radius * short / long,
        entry=rng.choice(["helix", "ramp", "plunge"]),
        entry_angle_deg=rng.choice([1.0, 3.0, 20.0]),
        direction=rng.choice(["climb", "conventional"]),
    )
    return Case(pocket, radius, share)


CASES = {seed: random_case(seed) for seed in SEEDS}


def gouge(path: Toolpath, pocket: EllipticalPocket, radius_mm: float) -> float:
    return gouge_mm(path, radius_mm, [Wanted(wanted(pocket), -pocket.depth_mm)])


def tip_slope(pocket: EllipticalPocket, radius_mm: float) -> float:
    """Return how far a disc goes into the tips for how much wider the ellipse is: its place there by its radius."""
    short, long = sorted((pocket.radius_x_mm, pocket.radius_y_mm))
    if radius_mm <= short**2 / long:
        return 1.0
    return math.sqrt((long**2 - short**2) / (short**2 - radius_mm**2)) * radius_mm / short


@cache
def made(case: Case) -> tuple[Case, Toolpath, Answer]:
    """Return the program of a case; where there is no room for its entry it plunges."""
    try:
        return case, *cut(case.pocket, tool(2 * case.radius_mm))
    except CycleError as error:
        assert error.code == "entry-room", error
        case = replace(case, pocket=case.pocket.model_copy(update={"entry": "plunge"}))
        return case, *cut(case.pocket, tool(2 * case.radius_mm))


@pytest.mark.slow
def test_the_generator_makes_what_is_hard() -> None:
    cases, pockets = list(CASES.values()), [case.pocket for case in CASES.values()]
    aspects = [max(p.radius_x_mm, p.radius_y_mm) / min(p.radius_x_mm, p.radius_y_mm) for p in pockets]
    shares = {
        "tips tighter than the tool": sum(case.tips_are_tighter for case in cases),
        "ae of the whole tool": sum(math.isclose(c.pocket.stepover_mm, 2 * c.radius_mm) for c in cases),
        "Ry > Rx": sum(p.radius_y_mm > p.radius_x_mm for p in pockets),
        "turned": sum(p.rotation_deg != 0 for p in pockets),
        "aspect above 5": sum(aspect > 5 for aspect in aspects),
        "nearly round": sum(aspect < 1.1 for aspect in aspects),
        "thin tool": sum(case.share < 0.3 for case in cases),
        "tool almost as wide": sum(case.share > 0.8 for case in cases),
        **{name: sum(p.entry == name for p in pockets) for name in ("helix", "ramp", "plunge")},
        **{name: sum(p.method == name for p in pockets) for name in ("dda", "tolerance")},
        "no finishing": sum(p.finish_stepover_mm == 0 for p in pockets),
    }
    assert all(count >= len(cases) / 10 for count in shares.values()), shares
    refused = sum(made(case)[0] is not case for case in cases)
    assert refused <= 0.3 * len(cases)


@pytest.mark.slow
@pytest.mark.parametrize("seed", SEEDS)
def test_a_random_pocket_is_cut_exactly(seed: int) -> None:
    case, path, answer = made(CASES[seed])
    pocket, radius_mm = case.pocket, case.radius_mm
    promise_mm = answer.removals[0].tolerance_mm
    assert gouge(path, pocket, radius_mm) <= promise_mm + JUDGE_MM
    left = left_by_level(path, radius_mm, wanted(pocket))
    assert len(left) == answer.figures["levels"] and max(left.values()) <= promise_mm + JUDGE_MM, left
    found = judged(pocket, tool(2 * radius_mm))
    assert not found.faults and max(found.gouge_mm, found.left_mm) <= promise_mm
    if pocket.method == "tolerance":
        slack_mm = 4.0 * JUDGE_MM + OUTLINE_MM * tip_slope(pocket, radius_mm)
        assert answer.figures["unreachable_mm"] == pytest.approx(unreachable_mm(pocket, radius_mm), abs=slack_mm)
    check_recalculation(pocket, answer, radius_mm)
    check_motion(path, pocket)


def check_recalculation(pocket: EllipticalPocket, answer: Answer, radius_mm: float) -> None:
    """ap and ae as part C has them; only against islands there may be more passes."""
    figures, finish_z, finish_xy = answer.figures, pocket.finish_stepdown_mm, pocket.finish_stepover_mm
    levels = math.ceil((pocket.depth_mm - finish_z) / pocket.stepdown_mm - 1e-9)
    assert figures["levels"] == levels + bool(finish_z)
    assert figures["ap_mm"] == pytest.approx((pocket.depth_mm - finish_z) / levels)
    wide, high = pocket.radius_x_mm - radius_mm, pocket.radius_y_mm - radius_mm
    reach, stretch = (min(wide, high), 1.0) if pocket.method == "tolerance" else (high, max(wide / high, 1.0))
    fewest = math.ceil((reach - finish_xy) * stretch / pocket.stepover_mm - 1e-9)
    passes = figures["passes"] - bool(finish_xy)
    assert passes >= fewest and (passes == fewest or pocket.stepover_mm > 0.5 * radius_mm)
    assert figures["ae_mm"] == pytest.approx((reach - finish_xy) * stretch / passes)
    assert figures["ae_mm"] <= pocket.stepover_mm + 1e-9


def check_motion(path: Toolpath, pocket: EllipticalPocket) -> None:
    rows = path.table()
    rapids = rows.kind == RAPID
    assert rows.end[rapids, 2].min() >= 2.0 and rows.end[-1, 2] == 10.0
    assert np.flatnonzero(rapids).tolist() == [0, 1, len(path) - 1]  # one approach, one retract for all levels
    for run in runs(path, 2, len(path) - 1):
        if run.fall_mm > 1e-12:
            length_mm = math.hypot(run.run_mm, run.fall_mm)
            assert run.feed_mm_min * run.fall_mm / length_mm <= 200 * (1 + 1e-9)
            if pocket.entry != "plunge":
                assert run.fall_mm <= run.run_mm * math.tan(math.radians(pocket.entry_angle_deg)) * (1 + 1e-9)
    check_entries(path, pocket)
    check_steps(path, pocket)


def check_entries(path: Toolpath, pocket: EllipticalPocket) -> None:
    passes = spans(path, "pass")
    per_level = len(passes) // len(spans(path, "entry"))
    roughed = rings(path)[per_level - 2 if pocket.finish_stepover_mm else per_level - 1]
    region = Polygon(roughed).buffer(2e-3)
    for span in spans(path, "entry"):
        inside = [run.xyz[:, :2] for run in runs(path, span.first, span.last)[1:] if run.kind != RAPID]
        assert (
            region.covers(LineString(np.vstack(inside)))
            if len(np.unique(np.vstack(inside), axis=0)) > 1
            else (region.covers(Point(inside[0][0])))
        )


def rings(path: Toolpath) -> list[np.ndarray]:
    """Return each pass without the step to it, as points."""
    return [
        np.vstack([run.xyz[:, :2] for run in runs(path, span.first + 1, span.last)]) for span in spans(path, "pass")
    ]


def check_steps(path: Toolpath, pocket: EllipticalPocket) -> None:
    """The last step is the allowance in the plane and in depth; climb runs counter-clockwise."""
    floors = [-span.words["floor_mm"] for span in spans(path, "level")]
    assert floors[-1] == pocket.depth_mm
    if pocket.finish_stepdown_mm:
        assert floors[-1] - floors[-2] == pytest.approx(pocket.finish_stepdown_mm)
    level = rings(path)[: len(spans(path, "pass")) // len(floors)]
    assert all(LinearRing(ring).is_ccw == (pocket.direction == "climb") for ring in level)
    if pocket.finish_stepover_mm:
        assert math.dist(level[-1][0], level[-2][0]) == pytest.approx(pocket.finish_stepover_mm, abs=1e-6)


@pytest.mark.slow
@pytest.mark.parametrize("seed", [seed for seed in SEEDS if CASES[seed].pocket.method == "dda"])
def test_every_dda_ring_keeps_to_its_own_ellipse(seed: int) -> None:
    case, path, answer = made(CASES[seed])
    pocket, radius_mm = case.pocket, case.radius_mm
    wide, high = pocket.radius_x_mm - radius_mm, pocket.radius_y_mm - radius_mm
    allowed_mm = pocket.resolution_mm * max(1, pocket.radius_x_mm / pocket.radius_y_mm)
    turn, t = math.radians(-pocket.rotation_deg), np.linspace(0, 2 * math.pi, 4001)
    for ring in rings(path)[: int(answer.figures["passes"])]:
        own = (ring - pocket.centre_mm) @ np.array(
            [[math.cos(turn), math.sin(turn)], [-math.sin(turn), math.cos(turn)]]
        )
        share = own[0, 1] / high
        ellipse = LineString(np.column_stack([wide * share * np.cos(t), high * share * np.sin(t)]))
        prepare(ellipse)
        assert ellipse.distance(points(own)).max() <= allowed_mm + 1e-4
        assert ellipse.distance(points((own[1:] + own[:-1]) / 2)).max() <= allowed_mm + 1e-4


@pytest.mark.slow
def test_the_job_example_has_part_c_s_numbers() -> None:
    path, answer = cut(EXAMPLE)
    assert answer.figures == {
        "unreachable_mm": 0.0,
        "ap_mm": pytest.approx(9.8 / 5),  # I = ceil((10 - 0.2) / 2) = 5
        "levels": 6,
        "ae_mm": pytest.approx(21.7 / 10),  # I = ceil((25 - 3 - 0.3) / 2.4) = 10
        "passes": 11,
    }
    published = cut(EXAMPLE.model_copy(update={"method": "dda"}))[1].figures
    assert published["passes"] == 17 and published["ae_mm"] == pytest.approx(21.7 / 16 * 37 / 22)
    finishing = [span.last - span.first - 1 for span in spans(path, "pass") if span.name == "finishing"]
    assert len(finishing) == 6 and max(finishing) <= 32


@pytest.mark.slow
@pytest.mark.parametrize("units", ["mm", pytest.param("inch", marks=pytest.mark.slow)])
def test_the_job_example_is_clean_on_its_way_through_text(units: str) -> None:
    found = judged(EXAMPLE, units=units)
    assert not found.faults and max(found.gouge_mm, found.left_mm) <= 0.01


def test_an_ae_of_the_whole_tool_takes_more_passes_only_where_islands_would_stay() -> None:
    round_pocket = EXAMPLE.model_copy(update={"radius_x_mm": 25.0, "stepover_mm": 5.9, "finish_stepover_mm": 0.0})
    assert cut(round_pocket)[1].figures["passes"] == 4
    long_pocket = round_pocket.model_copy(update={"radius_x_mm": 100.0})
    assert cut(long_pocket)[1].figures["passes"] > 4


def test_the_finishing_pass_has_its_own_feed() -> None:
    path, _ = cut(EXAMPLE.model_copy(update={"finish_feed_mm_min": 333.0}))
    for span in spans(path, "pass"):
        feeds = {run.feed_mm_min for run in runs(path, span.first + 1, span.last)}
        assert feeds == ({333.0} if span.name == "finishing" else {800.0})


def changed(path: Toolpath, change: Callable[[np.ndarray, int, int], None], number: int) -> Toolpath:
    """Return the path with `change` done to the rows of one pass."""
    table = path.table()
    span = spans(path, "pass")[number]
    end, centre = table.end.copy(), table.centre.copy()
    for column in (end, centre):
        change(column, span.first, span.last)
    return replace(path, chunks=[replace(table, end=end, centre=centre)])


@pytest.mark.slow
def test_the_judge_sees_a_shifted_ring() -> None:
    path, _ = cut(EXAMPLE)

    def shift(column: np.ndarray, first: int, last: int) -> None:
        column[first:last, 0] += 0.03

    assert gouge(path, EXAMPLE, 3.0) <= 0.01 + JUDGE_MM
    assert gouge(changed(path, shift, -1), EXAMPLE, 3.0) > 0.02


def test_the_judge_sees_two_hundredths() -> None:
    path, _ = cut(EXAMPLE, tool(5.96))
    assert gouge(path, EXAMPLE, 3.0) > 0.01 + JUDGE_MM


@pytest.mark.slow
def test_the_judge_sees_a_missing_pass_and_a_missing_finish() -> None:
    path, _ = cut(EXAMPLE.model_copy(update={"stepover_mm": 5.0}))
    per_level = len(spans(path, "pass")) // 6
    assert max(left_by_level(path, 3.0, wanted(EXAMPLE)).values()) <= 0.01 + JUDGE_MM
    for number in (1, per_level - 1):
        rows, span = path.table(), spans(path, "pass")[number]
        keep = np.r_[0 : span.first, span.last : len(path)]
        columns = {
            name: getattr(rows, name)[keep]
            for name in ("kind", "end", "centre", "plane", "turns", "feed", "state", "line")
        }
        broken = replace(path, chunks=[replace(rows, **columns)])
        assert max(left_by_level(broken, 3.0, wanted(EXAMPLE)).values()) > 0.1


def test_levels_repeat_the_same_path() -> None:
    path, _ = cut(EXAMPLE)
    level = rings(path)
    for first, second in itertools.pairwise(range(0, len(level), 11)):
        assert np.array_equal(level[first], level[second])


@pytest.mark.slow
@pytest.mark.parametrize(("method", "stock_mm"), [("tolerance", 0.3), ("tolerance", 2.0), ("dda", 0.3)])
def test_stock_stays_on_the_wall_all_round(method: str, stock_mm: float) -> None:
    keys = {
        "stock_to_leave_mm": stock_mm,
        "method": method,
        "rotation_deg": 25.0,
        "depth_mm": 3.0,
        "resolution_mm": 0.2,
    }
    pocket = EXAMPLE.model_copy(update=keys)
    found = judged(pocket, tool(6.0))
    assert found.clean, found.faults
    inner = wanted(pocket).difference(band(wanted(pocket), stock_mm))
    promise_mm = found.answer.removals[0].tolerance_mm + JUDGE_MM
    assert gouge_mm(found.toolpath, 3.0, [Wanted(inner, -3.0)]) <= promise_mm
    assert max(left_by_level(found.toolpath, 3.0, inner).values()) <= promise_mm


def test_more_stock_than_the_pocket_is_wide_is_refused() -> None:
    with pytest.raises(CycleError, match="wider than the pocket"):
        cut(EXAMPLE.model_copy(update={"stock_to_leave_mm": 23.0}), tool(6.0))
