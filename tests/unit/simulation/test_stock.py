# SPDX-License-Identifier: LGPL-2.1-or-later
import math

import pytest

from CNCStepper.errors import JobError
from CNCStepper.simulation.stock import Stock


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
