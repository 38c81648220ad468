# SPDX-License-Identifier: LGPL-2.1-or-later
"""The independent judge of cycles against formulas, and against shapely's buffers of single chords."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest
import shapely
from shapely import Point, box

from CNCStepper.state import Start
from CNCStepper.toolpath import ARC_CCW, ARC_CW, TableBuilder, Toolpath
from helpers.cycles.sweep_judge import (
    FLAT_MM,
    Wanted,
    flattened,
    gouge_mm,
    left_by_level,
    left_mm,
    reachable,
    rows_of,
    swept,
)

Z_MM = -2.0


def path_of(*moves: tuple, begin: tuple[float, float] = (0.0, 0.0), z_mm: float = Z_MM) -> Toolpath:
    """Return feed moves at one height, after a plunge: (x, y) is a line, (kind, x, y, centre x, centre y) an arc."""
    table = TableBuilder(Start())
    table.rapid((*begin, 5.0))
    table.feed((*begin, z_mm), 100)
    for move in moves:
        if len(move) == 2:
            table.feed((*move, z_mm), 100)
        else:
            table.arc(move[0], (*move[1:3], z_mm), (*move[3:], 0.0), 100)
    return table.toolpath()


def test_a_plunge_a_line_and_a_full_circle_cover_what_formulas_say() -> None:
    assert swept(path_of(), 3.0, Z_MM).area == pytest.approx(9 * math.pi, rel=2e-4)
    assert swept(path_of((10, 0)), 3.0, Z_MM).area == pytest.approx(9 * math.pi + 60, rel=2e-4)
    ring = swept(path_of((ARC_CCW, 0, 0, 20, 0)), 3.0, Z_MM)
    assert ring.area == pytest.approx(math.pi * (23**2 - 17**2), rel=2e-4)
    small = swept(path_of((ARC_CW, 0, 0, 2, 0)), 3.0, Z_MM)
    assert small.area == pytest.approx(math.pi * 25, rel=2e-4)
    assert swept(path_of((10, 0)), 3.0, Z_MM - 0.1).is_empty


@pytest.mark.parametrize("seed", [1, *(pytest.param(seed, marks=pytest.mark.slow) for seed in range(2, 9))])
def test_a_random_path_covers_what_its_chords_do(seed: int) -> None:
    rng = np.random.default_rng(seed)
    places, moves = rng.uniform(-20, 20, (12, 2)), []
    for (x, y), (to_x, to_y) in itertools.pairwise(places):
        if rng.random() < 0.6:
            half, aside = np.array([to_x - x, to_y - y]) / 2, rng.uniform(-2, 2)
            centre = np.array([x, y]) + half + aside * np.array([-half[1], half[0]])
            moves.append((int(rng.choice([ARC_CW, ARC_CCW])), to_x, to_y, *centre))
        else:
            moves.append((to_x, to_y))
    path, radius_mm = path_of(*moves, begin=tuple(places[0])), float(rng.uniform(0.5, 6))
    chords = flattened(rows_of(path))
    lines = shapely.linestrings(np.stack([chords.begin, chords.end], axis=1)[1:].view(float).reshape(-1, 2, 2))
    wanted = shapely.union_all(shapely.buffer(lines, radius_mm, quad_segs=100))
    differs = swept(path, radius_mm, Z_MM).symmetric_difference(wanted)
    assert shapely.buffer(differs, -2 * FLAT_MM).is_empty, f"seed {seed}"


def test_a_peg_in_the_middle_of_a_line_is_seen() -> None:
    room = box(-20, -20, 40, 20).difference(Point(10, 3.1).buffer(0.3, 64))
    assert gouge_mm(path_of((20, 0)), 3.0, [Wanted(room, Z_MM)]) == pytest.approx(0.2, abs=1e-3)
    assert gouge_mm(path_of((20, 0)), 2.7, [Wanted(room, Z_MM)]) == 0.0


def test_what_runs_through_a_wall_or_outside_is_as_deep_as_it_is() -> None:
    inside, outside = path_of((20, 0)), path_of((30, 4), begin=(30, 0))
    assert gouge_mm(inside, 3.0, [Wanted(box(-5, -5, 10, 5), Z_MM)]) == pytest.approx(13.0)
    assert gouge_mm(outside, 3.0, [Wanted(box(-5, -5, 10, 5), Z_MM)]) == pytest.approx(23.0)


def test_a_floor_is_not_cut_too_deep_and_a_step_keeps_its_ground() -> None:
    floor = Wanted(box(-20, -20, 40, 20), Z_MM)
    assert gouge_mm(path_of((20, 0), z_mm=Z_MM - 0.3), 3.0, [floor]) == pytest.approx(0.3)
    deep = Wanted(box(-4, -20, 40, 20), Z_MM - 1.0)
    assert gouge_mm(path_of((20, 0), z_mm=Z_MM - 1.0), 3.0, [floor, deep]) == 0.0
    assert gouge_mm(path_of((20, 0), begin=(-2, 0), z_mm=Z_MM - 1.0), 3.0, [floor, deep]) == pytest.approx(1.0)


def test_what_stays_is_as_thick_as_it_is() -> None:
    cut = box(0, 0, 10, 10)
    assert left_mm(cut, cut) == 0.0
    assert left_mm(box(0, 0, 10, 10.2), cut) == pytest.approx(0.2)
    assert left_mm(cut, cut.difference(box(4, 4, 5, 4.3))) == pytest.approx(0.3, abs=1e-3)
    assert left_mm(cut, shapely.Polygon()) == math.inf


def test_a_square_is_reachable_but_for_its_corners() -> None:
    square = box(0, 0, 20, 20)
    opened = reachable(square, 3.0, neck_mm=0.0)
    assert opened.area == pytest.approx(400 - (4 - math.pi) * 9, rel=1e-4)
    assert left_mm(square, opened) == pytest.approx(3 * (math.sqrt(2) - 1), abs=1e-3)
    assert reachable(box(0, 0, 20, 5.9), 3.0).is_empty


def test_every_level_counts_alone() -> None:
    table = TableBuilder(Start())
    table.rapid((0.0, 0.0, 5.0))
    for z_mm, length_mm in ((-1.0, 20.0), (-2.0, 18.0)):
        table.feed((0.0, 0.0, z_mm), 100)
        table.feed((length_mm, 0.0, z_mm), 100)
    slot = shapely.LineString([(0, 0), (20, 0)]).buffer(3.002, 128)
    left = left_by_level(table.toolpath(), 3.0, slot)
    assert left[-1.0] < 0.003 and left[-2.0] == pytest.approx(2.0, abs=0.01)
