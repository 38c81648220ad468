# SPDX-License-Identifier: LGPL-2.1-or-later
import math

import numpy as np
import pytest

from CNCStepper.errors import JobError
from CNCStepper.simulation.stock import Cylinder, HeightField, Stock


def test_top_centre_lies_about_the_zero():
    stock = Stock((100, 70, 20), "top-centre")
    assert stock.low_mm == (-50, -35, -20)
    assert stock.high_mm == (50, 35, 0)
    assert stock.outline.area == 7000


def test_top_left_front_lies_right_of_and_behind_the_zero():
    stock = Stock((200, 150, 6), "top-left-front")
    assert stock.low_mm == (0, 0, -6)
    assert stock.high_mm == (200, 150, 0)


@pytest.mark.parametrize("size", [(0, 1, 1), (1, -1, 1), (1, 1, math.nan), (1, 1, math.inf), (1, 1)])
def test_a_size_that_is_none_is_refused(size):
    with pytest.raises(JobError, match="three lengths above zero"):
        Stock(size, "top-centre")


def test_an_unknown_origin_is_refused_with_the_names_there_are():
    with pytest.raises(JobError, match="top-centre, top-left-front"):
        Stock((1, 1, 1), "middle")


def test_a_cylinder_is_round_and_has_shares_of_cells_at_its_rim():
    stock = Cylinder((40, 40, 10), "top-left-front")
    x = y = (np.arange(80) + 0.5) / 2
    assert stock.shares(x, y, (0.5, 0.5)).sum() / 4 == pytest.approx(np.pi * 400, rel=1e-4)
    assert stock.outline.area == pytest.approx(np.pi * 400, rel=1e-3)
    assert stock.tops_mm(x, y)[0, 0] == -10 and stock.tops_mm(x, y)[40, 40] == 0
    with pytest.raises(JobError, match="as long in X as in Y"):
        Cylinder((40, 30, 10))


def test_a_height_field_is_bilinear_between_its_points():
    stock = HeightField((20, 10, 6), "top-left-front", heights_mm=np.array([[0.0, 6.0], [0.0, 6.0]]))
    assert stock.tops_mm(np.array([5.0, 15.0]), np.array([2.0]))[0] == pytest.approx([-4.5, -1.5])


@pytest.mark.parametrize("heights", [None, [[1, 2]], [[1, 2], [3, math.nan]], [[1, 2], [3, 4]], [[-1, 2], [3, 6]]])
def test_heights_that_do_not_fit_are_refused(heights):
    with pytest.raises(JobError, match="height"):
        HeightField((20, 10, 6), heights_mm=heights)
