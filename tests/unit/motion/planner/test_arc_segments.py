# SPDX-License-Identifier: LGPL-2.1-or-later
"""Arcs split as the firmware splits them."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from CNCStepper.motion.planner.arc_segments import arc_points
from CNCStepper.toolpath import ARC_CCW, ARC_CW, PLANE_AXES

TOLERANCE_MM = 0.002


def split(begin, end, centre, kind=ARC_CCW, plane=0, turns=1):
    return arc_points(np.array(begin), np.array(end), np.array(centre), kind, plane, turns, TOLERANCE_MM)


def chords(radius, angle):
    return math.floor(0.5 * angle * radius / math.sqrt(TOLERANCE_MM * (2 * radius - TOLERANCE_MM)))


@pytest.mark.slow
@settings(deadline=None)
@given(
    st.floats(0.05, 2000), st.floats(0, 2 * math.pi), st.floats(0.01, 6.27), st.sampled_from([0, 1, 2]), st.booleans()
)
def test_points_lie_on_the_arc_and_go_the_right_way(radius, begin_angle, sweep, plane, clockwise):
    first, second, normal = PLANE_AXES[plane]
    angles = begin_angle + np.array([0, -sweep if clockwise else sweep])
    ends = np.zeros((2, 3))
    ends[:, first], ends[:, second] = radius * np.cos(angles), radius * np.sin(angles)
    ends[1, normal] = 3.0
    points = split(*ends, np.zeros(3), ARC_CW if clockwise else ARC_CCW, plane)
    assert len(points) == pytest.approx(max(1, chords(radius, sweep)), abs=1)
    assert points[-1] == pytest.approx(ends[1])
    assert np.hypot(points[:, first], points[:, second]) == pytest.approx(radius, abs=3e-3)
    assert points[:, normal] == pytest.approx(3.0 * np.arange(1, len(points) + 1) / len(points))
    turned = np.unwrap([begin_angle, *np.arctan2(points[:, second], points[:, first])])
    assert abs(turned[-1] - turned[0]) == pytest.approx(sweep, abs=1e-3)


@pytest.mark.parametrize("kind", [ARC_CW, ARC_CCW])
def test_a_closed_arc_is_a_whole_circle(kind):
    points = split((10, 0, 0), (10, 0, -1), (0, 0, 0), kind)
    assert len(points) == chords(10, 2 * math.pi)
    assert np.unwrap(np.arctan2(points[:, 1], points[:, 0]))[-1] == pytest.approx(
        (1 if kind == ARC_CCW else -1) * (2 * math.pi - 2 * math.pi / len(points))
        + math.atan2(points[0, 1], points[0, 0]),
        abs=1e-2,
    )


def test_a_tiny_arc_of_a_huge_radius_runs_the_circle_that_the_firmware_would_run():
    assert len(split((0, 0, 0), (0.0004, 0, 0), (0, 1000, 0))) > 1000
    assert len(split((0, 0, 0), (0.01, 0, 0), (0, 1000, 0))) == 1


def test_further_turns_are_run():
    assert len(split((10, 0, 0), (10, 0, -3), (0, 0, 0), turns=3)) == chords(10, 6 * math.pi)


def test_an_arc_smaller_than_the_tolerance_is_one_line():
    assert split((0.0005, 0, 0), (-0.0005, 0, 0), (0, 0, 0)).tolist() == [[-0.0005, 0, 0]]


def test_an_arc_from_an_unknown_place_is_one_line():
    assert len(split((math.nan, 0, 0), (5, 0, 0), (0, 0, 0))) == 1
