# SPDX-License-Identifier: LGPL-2.1-or-later
"""The walk at bounded engagement: in bends the angle grows, the depth does not; along straight fronts neither does."""

from __future__ import annotations

import math
from functools import cache

import numpy as np
import pytest

from CNCStepper.cycles.clearing.engagement.clearing_map import ClearingMap, clearing_map_of
from CNCStepper.cycles.clearing.engagement.walk_kernels import walk, widened
from CNCStepper.cycles.clearing.pattern import Area
from CNCStepper.geometry.curve import from_points
from CNCStepper.geometry.region import Region

TOOL_MM = 3.0
FREE = math.pi


@cache  # made by the first test, not at collection, where every worker would compile the kernels of regions
def _room() -> Region:
    return Region.of([from_points([(0, 0), (40, 0), (40, 20), (0, 20)], closed=True)])


def _depth(angle_rad: float, bend: float) -> float:
    """Return how deep a rim is behind a front that it meets at an angle from the bend's outward line, in radii."""
    away = 1.0 / bend
    rim = np.array([away + math.cos(angle_rad), math.sin(angle_rad)])
    return away + 1.0 - float(np.hypot(*rim))


@pytest.mark.parametrize("bend", [0.05, 0.5, 1.0, 4.0])
@pytest.mark.parametrize("most_deg", [20.0, 45.0, 90.0, 135.0])
def test_a_bent_way_cuts_as_deep_as_a_straight_one(most_deg, bend):
    most = math.radians(most_deg)
    angle = widened(most, FREE, bend)
    assert angle > most
    assert angle == pytest.approx(math.pi) or _depth(angle, bend) == pytest.approx(1.0 - math.cos(most))


def test_bends_may_have_no_more_than_is_said_and_straight_ways_nothing():
    assert widened(1.0, 0.05, 2.0) == 1.05
    assert widened(1.0, 0.05, 0.0) == pytest.approx(1.0)
    assert widened(1.0, 0.05, -2.0) == pytest.approx(1.0)


def _fronted() -> ClearingMap:
    """Return a room where the tool has gone along the middle, so that there are straight fronts on both sides."""
    chart = clearing_map_of(_room(), Area(_room(), TOOL_MM, 0.9, 0.01, True), 0.9)
    chart.add(np.column_stack([np.linspace(2.0, 38.0, 145), np.full(145, 10.0)]))
    chart.cut(0, chart.count)
    return chart


@pytest.mark.parametrize("most_deg", [45.0, 60.0, 90.0])
def test_a_straight_front_is_cut_no_deeper_for_what_bends_may_have(most_deg):
    chart, most = _fronted(), math.radians(most_deg)
    chart.branch(10)
    longest = 0.08 * TOOL_MM
    count, cleared, cut_mm = walk(
        chart.map, chart.way, chart.count, 0.0, 0.1, longest, 4.0 * longest, most, math.radians(4.0), chart.front,
        chart.met,
    )  # fmt: skip
    way = chart.way[chart.count : count]
    begin, end = np.searchsorted(np.maximum.accumulate(way[:, 0]), [12.0, 34.0])
    depths_mm = 10.0 - way[begin:end, 1]
    assert cleared and len(depths_mm) > 50 and cut_mm > 22.0
    stepover_mm = TOOL_MM * (1.0 - math.cos(most))
    assert 0.8 * stepover_mm < depths_mm.mean() and depths_mm.max() <= 1.03 * stepover_mm
