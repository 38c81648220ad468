# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every interpolator ends on the point, keeps to the true path as its docstring says, and streams in bounded chunks."""

from __future__ import annotations

import math
import random
from itertools import pairwise

import numpy as np
import pytest

from CNCStepper.errors import GeometryError, MachineRefusal
from CNCStepper.motion.interpolation.bresenham import bresenham
from CNCStepper.motion.interpolation.circular_dda import circular_dda
from CNCStepper.motion.interpolation.elliptical_dda import elliptical_dda
from CNCStepper.motion.interpolation.iteration_stream import positions_of
from CNCStepper.motion.interpolation.linear_dda import linear_dda
from CNCStepper.motion.planner.machine_limits import Limits
from CNCStepper.motion.signals.pulse_stream import PulseStream, pulse_stream
from CNCStepper.state import Start
from CNCStepper.toolpath import TableBuilder

SEED = 20061
X_OF_A2 = [1, 1, 1, 1, 0, 1, 1, 1, 1, 1, 0, 1]
Y_OF_A2 = [1, 0, 1, 0, 1, 1, 0, 1, 0, 1, 0, 1]
LINES = {"linear_dda": linear_dda, "bresenham": bresenham}
SMALL = 7  # rows of a chunk, so that every test crosses many


def run(stream: PulseStream) -> tuple[np.ndarray, np.ndarray]:
    """Return all ticks and positions, the begin in front."""
    pieces = list(positions_of(stream))
    ticks = np.concatenate([np.zeros(1, np.int64), *(ticks for ticks, _ in pieces)])
    positions = np.concatenate([np.array([stream.begin_steps]), *(positions for _, positions in pieces)])
    assert np.all(np.diff(ticks) > 0)
    assert np.abs(np.diff(positions, axis=0)).max(initial=0) <= 1
    return ticks, positions


def off_line(positions: np.ndarray, end: np.ndarray) -> float:
    """Return how far the worst position is from the segment from 0 to `end`."""
    along = np.clip(positions @ end / (end @ end), 0.0, 1.0)
    return float(np.linalg.norm(positions - along[:, None] * end, axis=1).max())


def off_arc(
    positions: np.ndarray, begin: np.ndarray, end: np.ndarray, centre: np.ndarray, radius: float, way: int
) -> float:
    """Return how far the worst position is from the arc between the true points `begin` and `end`."""
    out = positions - centre
    begin_rad, end_rad = (math.atan2(*(point - centre)[::-1]) for point in (begin, end))
    sweep = (way * (end_rad - begin_rad)) % math.tau or math.tau
    within = (way * (np.arctan2(out[:, 1], out[:, 0]) - begin_rad)) % math.tau <= sweep
    off = np.abs(np.hypot(*out.T) - radius)
    ends = np.minimum(np.hypot(*(positions - begin).T), np.hypot(*(positions - end).T))
    return float(np.where(within, off, ends).max())


def test_the_published_table_of_the_linear_dda() -> None:
    ticks, positions = run(linear_dda((-10, 7), (35, 10)))
    pulses = np.zeros((12, 2), int)
    pulses[ticks[1:] - 1] = np.abs(np.diff(positions, axis=0))
    assert pulses[:, 0].tolist() == X_OF_A2
    assert pulses[:, 1].tolist() == Y_OF_A2
    assert positions[-1].tolist() == [25, 17]
    ticks, _ = run(linear_dda((20, 0)))
    assert ticks.tolist() == list(range(21))


@pytest.mark.parametrize("name", LINES)
@pytest.mark.parametrize("axes", [1, 2, 3, 6])
def test_lines_end_on_the_point_and_keep_near_the_true_line(name: str, axes: int) -> None:
    print("seed", SEED)
    rnd = random.Random(SEED + axes)
    bound = {"linear_dda": math.sqrt(max(axes - 1, 1)), "bresenham": 0.5 * math.sqrt(max(axes - 1, 0))}[name]
    for size in (3, 30, 900) * 25:
        steps = [rnd.randint(-size, size) for _ in range(axes)]
        _, positions = run(LINES[name](steps, rows=97))
        assert positions[-1].tolist() == steps
        if any(steps):
            assert off_line(positions, np.array(steps, float)) <= bound + 1e-9


def test_the_linear_dda_keeps_the_vector_speed_in_every_direction() -> None:
    for angle_deg in range(0, 360, 7):
        end = [round(1000 * math.cos(math.radians(angle_deg))), round(1000 * math.sin(math.radians(angle_deg)))]
        ticks, positions = run(linear_dda(end))
        along = positions @ np.array(end) / math.hypot(*end)
        assert np.abs(along - ticks * math.hypot(*end) / ticks[-1]).max() <= math.sqrt(2)
        assert ticks[-1] == math.isqrt(end[0] ** 2 + end[1] ** 2)


@pytest.mark.slow
@pytest.mark.parametrize("steps", [(800, 333, 41), (-7, 640, 399), (160, -160, 2), (1, 2, -1200)])
def test_bresenham_steps_as_the_firmware_does(steps: tuple[int, ...]) -> None:
    """So fast from the begin that the firmware does not smooth: it does that below 8000 events a second."""
    limits = Limits((80.0,) * 3, (120_000.0,) * 3, (1e9,) * 3, 0.01, 0.002)
    table = TableBuilder(Start.at_zero())
    table.feed([count / 80.0 for count in steps], 60_000.0)
    stream = pulse_stream(table.toolpath(), limits)
    assert np.array_equal(run(stream)[1], run(bresenham(steps))[1])


@pytest.mark.slow
def test_the_published_registers_of_the_circular_dda() -> None:
    ticks, positions = run(circular_dda((2, 11), (11, 2), (1, 1), clockwise=True, published=True))
    moved = np.diff(positions, axis=0)
    assert ticks[1:][moved[:, 0] != 0][:3].tolist() == [13, 26, 39]
    assert ticks[1:][moved[:, 1] != 0][0] == 44
    assert positions[-1].tolist() == [11, 2]
    back = run(circular_dda((11, 2), (2, 11), (1, 1), clockwise=False, published=True))[1]
    assert back[-1].tolist() == [2, 11]


def test_the_whole_table_of_figure_13_follows_from_the_published_registers() -> None:
    """Round by round, as the source states them; the end of an axis at its target is the one rule that is ours."""
    (x, y), (end_x, end_y), radius, rounds = (2, 11), (11, 2), 10, 0
    limit, sum_x, sum_y, wanted = (2 * radius**2) ** 0.5, 0.0, 0.0, []
    while (x, y) != (end_x, end_y):
        rounds += 1
        both = x != end_x and y != end_y
        sum_x += y / radius if both else x != end_x
        sum_y += x / radius if both else y != end_y
        pulses = (x != end_x and sum_x >= limit, y != end_y and sum_y >= limit)
        sum_x, sum_y = sum_x - limit * pulses[0], sum_y - limit * pulses[1]
        x, y = x + pulses[0], y - pulses[1]
        wanted += [(rounds, pulses[0] + 2 * pulses[1])] * any(pulses)
    (made,) = circular_dda((2, 11), (11, 2), (1, 1), clockwise=True, published=True)
    assert list(zip(made.ticks.tolist(), made.step.tolist(), strict=True)) == wanted
    assert [tick for tick, _ in wanted] == [
        13,
        26,
        39,
        44,
        53,
        67,
        69,
        82,
        89,
        99,
        105,
        118,
        121,
        135,
        142,
        149,
        163,
        177,
    ]


def test_the_published_registers_end_on_the_point_wherever_the_centre_is() -> None:
    rnd = random.Random(SEED)
    print("seed", SEED)
    for _ in range(100):
        centre = (rnd.randint(-40, 40), rnd.randint(-40, 40))
        begin, end = ((centre[0] + rnd.randint(1, 20), centre[1] + rnd.randint(-20, 20)) for _ in range(2))
        stream = circular_dda(begin, end, centre, rnd.random() < 0.5, published=True, rows=SMALL)
        assert tuple(run(stream)[1][-1].tolist()) == end


PART_1 = [(0, -80), (-80, 0), (-160, 0), (0, 160), (0, 80), (80, 0), (160, 0), (0, -160)]  # test part 1 of A1: its arcs
CASES = [
    *((PART_1[k], PART_1[k + 1], (0, 0), True) for k in range(0, 8, 2)),
    *((PART_1[k + 1], PART_1[k], (0, 0), False) for k in range(0, 8, 2)),
    ((24, 7), (15, 20), (0, 0), False),  # in one quadrant
    ((24, 7), (-15, 20), (0, 0), False),  # in adjacent ones
    ((24, 7), (-24, -7), (0, 0), False),  # in opposite ones
    ((24, 7), (-24, -7), (0, 0), True),
    ((160, 0), (-160, 0), (0, 0), False),  # on the axes, opposite
    ((0, 160), (0, -160), (0, 0), True),
    ((15, 20), (24, 7), (0, 0), False),  # nearly whole
    ((160, 0), (160, 0), (0, 0), True),  # whole
    ((2, 11), (11, 2), (1, 1), True),  # figure 13
    ((1025, 1020), (1020, 1025), (1000, 1000), False),  # a centre far from 0
]


@pytest.mark.parametrize(("begin", "end", "centre", "clockwise"), CASES)
def test_the_operating_cases_of_arcs(
    begin: tuple[int, int], end: tuple[int, int], centre: tuple[int, int], clockwise: bool
) -> None:
    for source, target, way in ((begin, end, clockwise), (end, begin, not clockwise)):
        positions = run(circular_dda(source, target, centre, way))[1]
        assert tuple(positions[-1].tolist()) == target
        points = [np.array(point, float) for point in (source, target, centre)]
        off = off_arc(positions, *points, math.dist(source, centre), -1 if way else 1)
        assert off <= 0.75
    if begin == end:
        assert positions[:, 0].min() == -160 and positions[:, 1].max() == 160


@pytest.mark.parametrize(("least", "most", "bound"), [(0.6, 5.0, 1.0), (5.0, 60.0, 0.8), (60.0, 4000.0, 0.8)])
def test_arcs_keep_within_a_step_of_the_true_arc(least: float, most: float, bound: float) -> None:
    print("seed", SEED)
    rnd = random.Random(SEED)
    for _ in range(150):
        radius, way = rnd.uniform(least, most), rnd.choice((-1, 1))
        centre = np.array([rnd.uniform(-50, 50), rnd.uniform(-50, 50)])
        true = [centre + radius * np.array([math.cos(a), math.sin(a)]) for a in (rnd.uniform(0, 7), rnd.uniform(0, 7))]
        begin, end = (tuple(np.rint(point).astype(int).tolist()) for point in true)
        if begin == end:
            continue
        positions = run(circular_dda(begin, end, tuple(centre), way < 0, radius_steps=radius, rows=997))[1]
        assert tuple(positions[-1].tolist()) == end
        assert off_arc(positions, *true, centre, radius, way) <= bound + 1e-9, (begin, end, centre, radius, way)


def test_arcs_of_several_turns_and_what_has_no_radius() -> None:
    once, twice = (run(circular_dda((50, 0), (50, 0), (0, 0), True, turns=turns))[1] for turns in (1, 2))
    assert len(twice) - 1 == 2 * (len(once) - 1)
    assert np.array_equal(twice[: len(once)], once)
    assert len(run(circular_dda((50, 0), (0, 50), (0, 0), False, turns=2))[1]) > len(once)
    with pytest.raises(GeometryError, match="radius"):
        circular_dda((5, 5), (5, 5), (5, 5), True)


@pytest.mark.slow
@pytest.mark.parametrize("radii_mm", [(40.0, 25.0), (25.0, 40.0), (3.3, 3.3), (0.7, 9.1)])
@pytest.mark.parametrize("steps_per_mm", [(80.0, 80.0), (80.0, 100.0), (160.0, 53.3)])
def test_ellipses_close_and_keep_near_the_true_one(
    radii_mm: tuple[float, float], steps_per_mm: tuple[float, float]
) -> None:
    for clockwise in (False, True):
        positions = run(elliptical_dda(*radii_mm, steps_per_mm, clockwise))[1]
        assert positions[-1].tolist() == positions[0].tolist() == [0, round(radii_mm[1] * steps_per_mm[1])]
        area = sum(a[0] * b[1] - a[1] * b[0] for a, b in pairwise(positions.tolist())) / 2
        assert (area < 0) == clockwise
        at_mm = positions / np.array(steps_per_mm)
        assert abs(area) == pytest.approx(math.pi * np.prod(radii_mm) * np.prod(steps_per_mm), rel=0.02)
        assert off_ellipse(at_mm, radii_mm) * min(steps_per_mm) <= 1.25


def test_the_published_ellipse_keeps_the_published_deviation() -> None:
    step_mm, resolution_mm = 1 / 80, 0.5
    positions = run(elliptical_dda(40, 25, (80, 80), resolution_mm=resolution_mm))[1]
    assert off_ellipse(positions * step_mm, (40, 25)) <= 1.6 * resolution_mm + 1.25 * step_mm


def off_ellipse(points: np.ndarray, radii: tuple[float, float]) -> float:
    """Return how far the worst point is from the ellipse: from the best of nine places about its own angle."""
    angles = np.arctan2(points[:, 1] / radii[1], points[:, 0] / radii[0])
    spread = 0.02
    for _ in range(12):  # the nearest place is found by looking ever closer about the best
        tried = angles + spread * np.linspace(-1, 1, 9)[:, None]
        off = np.hypot(radii[0] * np.cos(tried) - points[:, 0], radii[1] * np.sin(tried) - points[:, 1])
        angles = np.take_along_axis(tried, off.argmin(axis=0)[None], 0)[0]
        spread /= 3.0
    return float(off.min(axis=0).max())


def test_chunks_are_bounded_and_their_size_changes_nothing() -> None:
    cases = [
        lambda rows: linear_dda((-1000, 333, 7), rows=rows),
        lambda rows: bresenham((-1000, 333, 7), rows=rows),
        lambda rows: circular_dda((300, 0), (-21, 299), (0, 0), True, rows=rows),
        lambda rows: circular_dda((300, 0), (-21, 299), (0, 0), True, published=True, rows=rows),
        lambda rows: elliptical_dda(4, 2.5, (80, 80), rows=rows),
    ]
    for make in cases:
        assert max(len(chunk) for chunk in make(SMALL)) == SMALL
        for whole, small in zip(run(make(65_536)), run(make(SMALL)), strict=True):
            assert np.array_equal(whole, small)
    with pytest.raises(MachineRefusal, match="axes"):
        linear_dda([1] * 9)
