# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random engravings: never longer than the drawn points, never farther from them than asked for, rapids short."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import pytest
from shapely import MultiLineString, STRtree, get_coordinates, get_parts, points, segmentize

from CNCStepper.cycles.contours.engrave import Engrave
from CNCStepper.geometry.curve import Curve, circle, from_points
from CNCStepper.toolpath import RAPID, Toolpath
from helpers.cycles.product_verdict import cut, judged, tool
from helpers.cycles.seeds import SEEDS
from helpers.cycles.sweep_judge import flattened, rows_of

WRITTEN_MM = 0.002  # what three decimals add to a point, and to an arc's centre
APART_MM = 0.1
KINDS = ("freehand", "smooth", "noisy", "letter", "circle")


@dataclass(frozen=True)
class Case:
    """Some drawn curves, and how they are to be cut."""

    curves: tuple[Curve, ...]
    kinds: tuple[str, ...]
    simplify_mm: float
    levels: int


def random_case(seed: int) -> Case:
    """Return one to five curves of any kind, a simplification from a hundredth to half a millimetre."""
    rng = np.random.default_rng(seed)
    kinds = tuple(str(kind) for kind in rng.choice(KINDS, rng.integers(1, 6)))
    curves = tuple(_drawn(rng, kind).moved(*rng.uniform(-50, 50, 2)) for kind in kinds)
    return Case(curves, kinds, float(10.0 ** rng.uniform(-2, -0.3)), int(rng.integers(1, 3)))


def _drawn(rng: np.random.Generator, kind: str) -> Curve:
    count = int(rng.integers(3, 120))
    if kind == "circle":
        return circle((0, 0), rng.uniform(0.5, 10))
    if kind == "letter":
        return from_points(np.round(rng.uniform(-8, 8, (rng.integers(2, 9), 2))), bool(rng.random() < 0.5))
    if kind == "freehand":
        return from_points(np.cumsum(rng.normal(0, 0.3, (count, 2)), axis=0))
    angle = np.linspace(0, rng.uniform(1, 2 * math.pi), count)
    radius = 10 + 3 * np.sin(rng.integers(1, 5) * angle)
    noise = rng.normal(0, 0.02, (count, 2)) if kind == "noisy" else 0.0
    return from_points(radius[:, None] * np.column_stack([np.cos(angle), np.sin(angle)]) + noise)


def cut_line(path: Toolpath) -> MultiLineString:
    """Return what is cut, as chords."""
    table = path.table()
    chords = flattened(rows_of(path, -0.001).some(slice(None)))
    level = np.abs(chords.end_z - chords.begin_z) < 1e-9
    assert (table.kind[table.end[:, 2] < -0.001] != RAPID).all()
    ends = np.stack([chords.begin, chords.end], axis=1)[level]
    return MultiLineString(list(np.stack([ends.real, ends.imag], axis=-1)))


def blocks(path: Toolpath) -> int:
    """Return how many moves run level below the top."""
    begin, end = path.begins(), path.table().end
    return int(((np.abs(begin[:, 2] - end[:, 2]) < 1e-9) & (end[:, 2] < 0)).sum())


def rapids_mm(path: Toolpath) -> float:
    """Return how far the tool goes at clearance height, from over the work's zero on."""
    kind, begin, end = path.table().kind, np.nan_to_num(path.begins()), np.nan_to_num(path.table().end)
    return float(np.hypot(*(end - begin)[kind == RAPID, :2].T).sum())


def apart_mm(one: MultiLineString, other: MultiLineString) -> float:
    """Return how far places of the one, close together, are at most from the other."""
    places = points(get_coordinates(segmentize(one, APART_MM)))
    return float(STRtree(get_parts(other)).query_nearest(places, return_distance=True, all_matches=False)[1].max())


@pytest.mark.slow
@pytest.mark.parametrize("seed", SEEDS)
def test_a_random_engraving_is_short_and_near(seed: int) -> None:
    case = random_case(seed)
    keys = {"tool": 1, "depth_mm": 0.6, "stepdown_mm": 0.6 / case.levels, "simplify_mm": case.simplify_mm}
    short = judged(
        Engrave(curves=case.curves, order="short", **keys),
        tool(1.0, shape="engraver", tip_diameter_mm=0.1, tip_angle_deg=30),
    )
    drawn, _ = cut(Engrave(curves=case.curves, **keys))
    lines = MultiLineString([piece for curve in case.curves for piece in pairwise(curve.points(1e-4))])
    assert short.clean, short.faults
    for path in (short.toolpath, drawn):
        assert blocks(path) <= case.levels * sum(map(len, case.curves))
        line = cut_line(path)
        assert max(apart_mm(line, lines), apart_mm(lines, line)) <= case.simplify_mm + WRITTEN_MM
    assert rapids_mm(short.toolpath) <= rapids_mm(drawn) + 0.1


@pytest.mark.slow
def test_the_cases_are_of_all_kinds() -> None:
    cases = [random_case(seed) for seed in SEEDS]
    for kind in KINDS:
        assert sum(kind in case.kinds for case in cases) >= len(cases) / 10


def test_smooth_points_become_arcs_and_letters_stay() -> None:
    angle = np.linspace(0, math.pi, 300)
    bow = from_points(10 * np.column_stack([np.cos(angle), np.sin(angle)]))
    path = judged(Engrave(tool=1, curves=(bow,), depth_mm=1, simplify_mm=0.02), tool(2.0)).toolpath
    assert blocks(path) <= 2
    assert apart_mm(MultiLineString([bow.xy]), cut_line(path)) <= 0.02 + WRITTEN_MM


@pytest.mark.parametrize("levels", [1, 2])
def test_short_order_takes_the_nearest_end_and_turns_lines(levels: int) -> None:
    lines = tuple(Curve(np.array([(x, 0.0), (x, 20.0)]), np.zeros(1)) for x in (30.0, 10.0, 20.0, 0.0))
    keys = {"tool": 1, "curves": lines, "depth_mm": 1, "stepdown_mm": 1 / levels}
    short, drawn = (judged(Engrave(order=order, **keys), tool(2.0)).toolpath for order in ("short", "drawn"))
    cut_at = [float(x) for x in dict.fromkeys(np.round(short.table().end[short.table().end[:, 2] < 0, 0], 6).tolist())]
    assert cut_at == [0.0, 10.0, 20.0, 30.0]
    assert rapids_mm(short) == pytest.approx(30.0) and rapids_mm(drawn) >= 80.0
