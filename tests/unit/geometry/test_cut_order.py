# SPDX-License-Identifier: LGPL-2.1-or-later
"""The order of cuts: nothing lost, the order that was asked for, and rapids near the shortest there are."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest

from CNCStepper.errors import GeometryError
from CNCStepper.geometry.curve import Curve, circle, from_points
from CNCStepper.geometry.cut_order.cut_order import (
    MOST_STARTS,
    Stop,
    Visit,
    inside_before_outside,
    ordered,
    parents,
    rapids_mm,
    spread,
)


def random_stops(rng: np.random.Generator, count: int) -> list[Stop]:
    """Return holes, lines that may turn and that may not, and circles."""
    stops = []
    for kind in rng.integers(0, 4, count):
        x, y = rng.uniform(0, 100, 2)
        line = from_points([(x, y), tuple(rng.uniform(0, 100, 2))])
        stops.append(
            [
                Stop.at_point(x, y),
                Stop.of_curve(line),
                Stop.of_curve(line, turns=True),
                Stop.of_curve(circle((x, y), rng.uniform(1, 9))),
            ][kind]
        )
    return stops


def shortest_mm(stops: list[Stop], pairs: list[tuple[int, int]]) -> float:
    """Return the shortest rapids by trying every order and every way."""
    ways = []
    for stop in stops:
        forth = list(zip(stop.begins.tolist(), stop.ends.tolist(), strict=True))
        ways.append(forth + ([(end, begin) for begin, end in forth] if stop.turns else []))
    best = np.inf
    for order in itertools.permutations(range(len(stops))):
        if any(order.index(a) > order.index(b) for a, b in pairs):
            continue
        reached = [(0.0, [0.0, 0.0])]  # the best way to stand at each end of the item before
        for item in order:
            reached = [(min(cost + math.dist(begin, at) for cost, at in reached), end) for begin, end in ways[item]]
        best = min(best, min(cost for cost, _ in reached))
    return best


@pytest.mark.slow
def test_small_tours_are_near_the_shortest() -> None:
    rng, ratios = np.random.default_rng(5), []
    for case in range(30):
        stops = random_stops(rng, 6)
        pairs = [(0, 1), (2, 3)] if case % 2 else []
        visits = ordered(stops, before=pairs)
        assert sorted(visit.item for visit in visits) == list(range(6))
        ratios.append(rapids_mm(stops, visits) / shortest_mm(stops, pairs))
    assert min(ratios) > 1 - 1e-9, "shorter than the shortest: something is not counted"
    assert np.mean(ratios) < 1.03 and max(ratios) < 1.35, f"mean {np.mean(ratios):.3f}, worst {max(ratios):.3f}"


@pytest.mark.slow
def test_a_tour_is_never_longer_than_the_order_it_was_given() -> None:
    """One-way lines, given in their shortest order: from the nearest to the next a tour stays longer here and there."""
    rng = np.random.default_rng(7)
    for _ in range(30):
        stops = [Stop.of_curve(from_points(list(map(tuple, line)))) for line in rng.uniform(0, 100, (6, 2, 2))]
        visits = [Visit(item, 0, False) for item in range(6)]
        shortest = min(itertools.permutations(visits), key=lambda order: rapids_mm(stops, order))
        given = [stops[visit.item] for visit in shortest]
        assert rapids_mm(given, ordered(given)) <= rapids_mm(given, visits) + 1e-9


@pytest.mark.slow
def test_a_thousand_holes_come_near_the_known_shortest_tour() -> None:
    """The shortest tour of n random points in an area A tends to 0.7124 sqrt(n A) (Johnson and McGeoch 1996)."""
    places = np.random.default_rng(6).uniform(0, 100, (1000, 2))
    stops = [Stop.at_point(*place) for place in places]
    visits = ordered(stops)
    assert sorted(visit.item for visit in visits) == list(range(1000))
    assert rapids_mm(stops, visits) < 1.12 * 0.7124 * np.sqrt(1000 * 100**2)
    assert visits == ordered(stops), "not the same a second time"


@pytest.mark.parametrize("seed", range(25))
def test_locks_and_pairs_hold(seed: int) -> None:
    rng = np.random.default_rng(seed)
    stops = random_stops(rng, 40)
    shuffled = rng.permutation(40)
    pairs = [tuple(sorted(rng.choice(40, 2, replace=False), key=lambda i: int(shuffled[i]))) for _ in range(30)]
    lock = sorted(rng.choice(40, 6, replace=False).tolist(), key=lambda i: int(shuffled[i]))
    visits = ordered(stops, (50.0, 50.0), before=pairs, locks=[lock])
    place = {visit.item: index for index, visit in enumerate(visits)}
    assert sorted(place) == list(range(40)), f"seed {seed}"
    assert all(place[a] < place[b] for a, b in pairs), f"seed {seed}"
    assert [place[item] for item in lock] == sorted(place[item] for item in lock), f"seed {seed}"
    assert not any(visit.turned and not stops[visit.item].turns for visit in visits), f"seed {seed}"


def test_a_fixed_line_is_not_turned_and_a_free_one_is() -> None:
    line = from_points([(10, 0), (0, 0)])
    assert ordered([Stop.of_curve(line)])[0].turned is False
    free = Stop.of_curve(line, turns=True)
    assert ordered([free])[0].turned is True and rapids_mm([free], ordered([free])) == 0


def test_a_closed_curve_starts_where_the_tool_comes_from() -> None:
    square = from_points([(0, 0), (10, 0), (10, 10), (0, 10)], closed=True)
    assert ordered([Stop.of_curve(square)], (11, 11))[0].start == 2
    fixed = Stop.of_curve(square, starts=[1])
    assert rapids_mm([fixed], ordered([fixed], (11, 11)), (11, 11)) == pytest.approx(np.hypot(1, 11))
    assert spread(3) == [0, 1, 2] and len(spread(1000)) == MOST_STARTS == len(set(spread(1000)))


def test_inside_comes_before_outside_as_a_tree() -> None:
    outline, pocket = circle((0, 0), 50), circle((10, 0), 20)
    hole, slot = circle((12, 0), 3), from_points([(-40, 0), (-30, 5)])
    apart, crossing = circle((200, 0), 5), circle((50, 0), 10)
    curves = [outline, pocket, hole, slot, apart, crossing]
    assert parents(curves) == [-1, 0, 1, 0, -1, -1]
    assert sorted(inside_before_outside(curves)) == [(1, 0), (2, 1), (3, 0)]
    visits = ordered([Stop.of_curve(curve) for curve in curves], (50, 0), before=inside_before_outside(curves))
    place = {visit.item: index for index, visit in enumerate(visits)}
    assert place[2] < place[1] < place[0] and place[3] < place[0]


def test_odd_outlines_hold_nothing_and_do_no_harm() -> None:
    stroke = Curve(np.array([(0.0, 0), (10, 0), (0, 0)]), np.zeros(2))
    bow = from_points([(0, 0), (10, 10), (10, 0), (0, 10)], closed=True)
    twins = [circle((100, 0), 5), circle((100, 0), 5), circle((100, 0), 1)]
    found = parents([stroke, bow, *twins])
    assert found[:4] == [-1, -1, -1, -1] and found[4] in (2, 3)


def test_nothing_to_cut_is_no_tour() -> None:
    assert ordered([]) == [] and parents([]) == []
    assert parents([from_points([(0, 0), (1, 0)]), from_points([(0, 1), (1, 1)])]) == [-1, -1]


def test_orders_that_contradict_each_other_are_refused() -> None:
    stops = [Stop.at_point(x, 0) for x in range(4)]
    with pytest.raises(GeometryError, match=r"contradict.*\[0, 1\]"):
        ordered(stops, before=[(0, 1)], locks=[(1, 0)])
    with pytest.raises(GeometryError, match="not there"):
        ordered(stops, before=[(0, 4)])
