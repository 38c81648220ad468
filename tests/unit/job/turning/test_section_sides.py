# SPDX-License-Identifier: LGPL-2.1-or-later
"""Outside and bore of a half section, and curves as the rows of a profile."""

from __future__ import annotations

import math

import numpy as np
import pytest

from CNCStepper.errors import JobError
from CNCStepper.geometry.curve import Curve, from_points, straight
from CNCStepper.job.turning.profile_form import ProfileForm
from CNCStepper.job.turning.section_sides import chained, from_front, profile_rows, side_of

TUBE = [(0, 6), (0, 20), (-40, 20), (-40, 9), (-25, 9), (-20, 6)]


@pytest.mark.parametrize("turn", range(6))
def test_the_sides_do_not_depend_on_where_the_boundary_begins(turn: int) -> None:
    for points in (TUBE, TUBE[::-1]):
        boundary = from_points(points[turn:] + points[:turn], closed=True)
        assert side_of(boundary, "outside").xy.tolist() == [[0, 6], [0, 20], [-40, 20]]
        assert side_of(boundary, "bore").xy.tolist() == [[0, 6], [-20, 6], [-25, 9], [-40, 9]]


def test_a_solid_part_has_no_bore_and_ends_before_its_back_face() -> None:
    boundary = from_points([(-50, 0), (-50, 20), (0, 8), (0, 0)])
    assert side_of(boundary, "outside").xy.tolist() == [[0, 0], [0, 8], [-50, 20]]
    with pytest.raises(JobError) as error:
        side_of(boundary, "bore")
    assert error.value.code == "profile-bore"


def test_an_arc_is_divided_where_it_is_upright() -> None:
    ring = Curve(np.array([(0.0, 35.0), (0.0, 25.0), (0.0, 35.0)]), np.ones(2))
    outside, bore = side_of(ring, "outside"), side_of(ring, "bore")
    assert outside.xy[[0, -1]] == pytest.approx(np.array([(5, 30), (-5, 30)]))
    assert bore.xy[[0, -1]] == pytest.approx(np.array([(5, 30), (-5, 30)]))
    assert outside.length_mm == pytest.approx(5 * math.pi)


def test_pieces_in_any_order_and_sense_are_chained() -> None:
    pieces = [straight((-5, 4), (-9, 4)), straight((0, 2), (0, 4)), straight((-5, 4), (0, 4))]
    (chain,) = chained(pieces)
    assert from_front(chain).xy.tolist() == [[0, 2], [0, 4], [-5, 4], [-9, 4]]
    assert len(chained([*pieces, straight((-20, 1), (-30, 1))])) == 2


@pytest.mark.parametrize("x_is", ["diameter", "radius"])
@pytest.mark.parametrize("bulge", [0.3, -0.7, 1.0, 1e-7, 1e-5])
def test_rows_draw_the_same_curve_again(x_is: str, bulge: float, tmp_path) -> None:
    chain = Curve(np.array([(0.0, 5.0), (0.0, 8.0), (-12.0, 9.0), (-30.0, 9.0)]), np.array([0.0, bulge, 0.0]))
    if bulge == 1.0:
        chain = Curve(np.array([(0.0, 0.0), (-20.0, 0.0)]), np.ones(1))
    again = ProfileForm(name="p", points=profile_rows(chain, x_is)).curve(x_is, tmp_path)
    points = again.points(1e-4)
    assert chain.distances_mm(points).max() <= 1.1e-4
    assert again.length_mm == pytest.approx(chain.length_mm, abs=1e-6)
