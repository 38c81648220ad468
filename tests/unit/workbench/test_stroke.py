# SPDX-License-Identifier: LGPL-2.1-or-later
"""A stroke of the mouse: free and straight parts, closing, and what a click draws."""

from __future__ import annotations

import math

import pytest

from CNCStepper.workbench.freehand.stroke import Stroke, rounded_down, snapped


def drawn(points: list[tuple[float, float]], straight: bool = False, pixel_mm: float = 0.1) -> Stroke:
    stroke = Stroke(points[0], pixel_mm)
    for point in points[1:]:
        stroke.move(point, straight)
    return stroke


def test_a_free_stroke_keeps_the_points_it_went_through() -> None:
    points = [(0.0, 0.0), (1.0, 0.5), (2.0, 0.0)]
    assert drawn(points).line() == (points, False)


def test_points_nearer_than_half_a_pixel_are_one() -> None:
    assert drawn([(0, 0), (1, 0), (1.04, 0), (1.06, 0)]).points == [(0, 0), (1, 0), (1.06, 0)]


def test_a_straight_part_has_two_ends_wherever_the_pointer_went() -> None:
    assert drawn([(0, 0), (3, 9), (5, 2), (10, 5)], straight=True).line() == ([(0, 0), (10, 5)], False)


def test_a_free_part_goes_on_where_the_straight_one_ended_and_turns_a_corner() -> None:
    stroke = drawn([(0, 0), (10, 5)], straight=True)
    stroke.move((10, 6), straight=False)
    stroke.move((20, 9), straight=True)
    stroke.move((22, 9.3), straight=True)
    assert stroke.line()[0][:3] == [(0, 0), (10, 5), (10, 6)]
    assert len(stroke.points) == 4


@pytest.mark.parametrize("angle_deg", range(-180, 181, 3))
def test_a_straight_part_snaps_only_near_a_multiple_of_45_degrees(angle_deg: int) -> None:
    pointer = (3 + 7 * math.cos(math.radians(angle_deg)), 2 + 7 * math.sin(math.radians(angle_deg)))
    x, y = snapped((3, 2), pointer)
    off_deg = abs((angle_deg + 22.5) % 45 - 22.5)
    if off_deg > 5:
        assert (x, y) == pointer
    else:
        assert math.degrees(math.atan2(y - 2, x - 3)) % 45 == pytest.approx(0, abs=1e-9) or (
            math.degrees(math.atan2(y - 2, x - 3)) % 45 == pytest.approx(45, abs=1e-9)
        )
        assert math.dist((x, y), pointer) <= 7 * math.sin(math.radians(5)) + 1e-9


def test_a_level_part_is_exactly_level() -> None:
    assert snapped((1.1, 2.3), (9.7, 2.35))[1] == 2.3
    assert snapped((1.1, 2.3), (1.15, -7.0))[0] == 1.1


def circle(upto_deg: int) -> list[tuple[float, float]]:
    return [(5 * math.cos(math.radians(a)), 5 * math.sin(math.radians(a))) for a in range(0, upto_deg, 3)]


def test_a_release_beside_the_start_closes_the_line_without_a_jag() -> None:
    stroke = drawn(circle(357))
    assert stroke.closing
    points, closed = stroke.line()
    assert closed
    assert all(math.dist(points[0], point) > 10 * 0.1 for point in points[len(points) // 2 :])


def test_a_release_far_from_the_start_does_not() -> None:
    assert not drawn(circle(330)).closing
    assert not drawn(circle(330)).line()[1]


def test_a_short_stroke_beside_its_start_is_not_closed() -> None:
    assert not drawn([(0, 0), (0.5, 0), (0.5, 0.5), (0, 0.5)]).closing


@pytest.mark.parametrize("points", [[(0, 0)], [(0, 0), (0.05, 0.1)], [(0, 0), (0.1, 0), (0, 0)]])
def test_a_click_draws_nothing(points: list[tuple[float, float]]) -> None:
    assert drawn(points).line() == ([], False)


@pytest.mark.parametrize("pixel_mm", [1e-6, 0.0071, 0.1, 0.2, 1 / 3, 1.0, 47.0, 1e5])
def test_the_tolerance_is_a_round_figure_and_no_more_than_can_be_seen(pixel_mm: float) -> None:
    tolerance_mm = Stroke((0, 0), pixel_mm).tolerance_mm
    assert 0.4 * 1.5 * pixel_mm <= tolerance_mm <= 1.5 * pixel_mm * (1 + 1e-9)
    assert f"{tolerance_mm:.0e}"[0] in "125"


def test_a_round_figure_stays_what_it_is() -> None:
    assert [rounded_down(size) for size in (0.1, 0.2, 0.5, 1.0, 0.3, 0.99)] == [0.1, 0.2, 0.5, 1.0, 0.2, 0.5]
