# SPDX-License-Identifier: LGPL-2.1-or-later
"""Loose pieces become the chains they were cut from; near misses are gaps with their place."""

from __future__ import annotations

import math
from collections import Counter

import numpy as np
import pytest
import shapely

from CNCStepper.geometry.chain_joining import chained
from CNCStepper.geometry.curve import Curve, circle, from_points

CASES = 40


def line(*points: tuple[float, float]) -> Curve:
    return from_points(points)


def random_chain(rng: np.random.Generator, closed: bool) -> Curve:
    xy = rng.uniform(-50, 50, (int(rng.integers(3, 12)), 2))
    xy = np.vstack([xy, xy[:1]]) if closed else xy
    return Curve(xy, np.where(rng.random(len(xy) - 1) < 0.5, 0.0, rng.uniform(-2, 2, len(xy) - 1)))


def shaken(rng: np.random.Generator, pieces: list[Curve], by_mm: float) -> list[Curve]:
    some = [pieces[number] for number in rng.permutation(len(pieces))]
    some = [piece.reversed() if rng.random() < 0.5 else piece for piece in some]
    return [Curve(piece.xy + rng.uniform(-by_mm, by_mm, piece.xy.shape), piece.bulge) for piece in some]


@pytest.mark.slow
def test_cut_and_shuffled_chains_come_together_again() -> None:
    seen: Counter[str] = Counter()
    for seed in range(CASES):
        rng = np.random.default_rng(seed)
        chains = [random_chain(rng, closed=bool(number % 2)).moved(200.0 * number, 0) for number in range(5)]
        pieces = [part for chain in chains for part in chain.split(rng.uniform(0, chain.length_mm, 6))]
        found, gaps = chained(shaken(rng, pieces, 1e-6), same_mm=1e-5, near_mm=1e-4)
        seen["closed"] += sum(chain.closed for chain in found)
        seen["arcs"] += sum(bool(chain.bulge.any()) for chain in found)
        assert not gaps, f"seed {seed}: {gaps}"
        for chain in chains:
            (same,) = [other for other in found if chain.distances_mm(other.xy).max() < 1e-4]
            assert same.closed == chain.closed, f"seed {seed}"
            assert same.length_mm == pytest.approx(chain.length_mm, abs=1e-3), f"seed {seed}"
            assert chain.distances_mm(same.points(0.01)).max() < 1e-4, f"seed {seed}"
    assert seen["closed"] == 2 * CASES and seen["arcs"] > 2 * CASES, f"seeds 0 to {CASES - 1}: {seen}"


def test_shapely_merges_the_same_lines() -> None:
    rng = np.random.default_rng(7)
    points = rng.integers(0, 40, (60, 2)).astype(float)
    pieces = [line(tuple(a), tuple(b)) for a, b in zip(points[::2], points[1::2], strict=True) if tuple(a) != tuple(b)]
    chains, _ = chained(pieces, near_mm=1e-3)
    merged = shapely.line_merge(shapely.MultiLineString([piece.xy for piece in pieces]))
    assert sum(chain.length_mm for chain in chains) == pytest.approx(merged.length)
    assert len(chains) <= len(shapely.get_parts(merged))


def test_the_first_piece_sets_the_sense() -> None:
    (chain,), _ = chained([line((1, 0), (0, 0)), line((1, 0), (2, 0))])
    assert chain.xy.tolist() == [[2, 0], [1, 0], [0, 0]]


def test_a_gap_is_told_with_its_place_and_size() -> None:
    square = from_points([(0, 0), (10, 0), (10, 10), (0, 10), (0, 0.25)])
    (chain,), (gap,) = chained([square])
    assert not chain.closed and gap.place_mm == (0, 0.125) and gap.size_mm == 0.25
    assert chained([square], near_mm=0.2)[1] == ()
    (closed,), none = chained([square], same_mm=0.3)
    assert closed.closed and none == ()


def test_the_smallest_gap_comes_first_and_an_end_has_one_gap() -> None:
    pieces = [line((0, 0), (5, 0)), line((5.5, 0), (9, 0)), line((5, 0.1), (5, 9))]
    _, gaps = chained(pieces)
    assert [round(gap.size_mm, 3) for gap in gaps] == [0.1]


def test_a_short_piece_is_no_gap() -> None:
    assert chained([line((0, 0), (0.5, 0))])[1] == ()


def test_where_three_meet_the_straight_ones_go_on() -> None:
    pieces = [line((0, 0), (5, 0)), line((5, 0), (5, 5)), line((5, 0), (10, 0.5))]
    chains, gaps = chained(pieces)
    assert [chain.xy.tolist() for chain in chains] == [[[0, 0], [5, 0], [10, 0.5]], [[5, 0], [5, 5]]]
    assert gaps == ()


def test_where_four_meet_two_lines_cross() -> None:
    pieces = [line((0, 0), (5, 0)), line((5, 5), (5, 0)), line((5, 0), (10, 0)), line((5, 0), (5, -5))]
    assert [chain.xy[:, 0].tolist() for chain in chained(pieces)[0]] == [[0, 5, 10], [5, 5, 5]]


def test_closed_pieces_and_nothing_at_all_pass() -> None:
    ring = circle((0, 0), 5)
    assert chained([ring, line((5, 0), (9, 0))])[0][0] is ring
    assert chained([]) == ((), ())


def test_a_full_turn_of_two_arcs_closes() -> None:
    halves = circle((3, 3), 2).split([2 * math.pi])
    (chain,), _ = chained([halves[0], halves[1].reversed()])
    assert chain.closed and chain.area_mm2 == pytest.approx(4 * math.pi)


def test_two_pieces_with_the_same_ends_close_and_doubled_lines_do_no_harm() -> None:
    there = line((0, 0), (5, 0), (5, 5))
    (chain,), _ = chained([there, there])
    assert chain.closed and chain.area_mm2 == 0
