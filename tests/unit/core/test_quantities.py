# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of quantities: its bounds make sense, pydantic keeps them, and a refusal says value, limit and why."""

from __future__ import annotations

import math
import subprocess
import sys
from typing import Annotated, Any

import numpy as np
import pytest
from pydantic import BaseModel, ValidationError

from CNCStepper.errors import JobError
from CNCStepper.quantities import QUANTITIES, Bounds, Feed, FeedOr0, ToolNumber, shown, with_unit


class Numbers(BaseModel):
    feed: Feed = 1.0
    finish: FeedOr0 = 0.0
    tool: ToolNumber = 0
    slope: Annotated[float, Bounds("slope", 1.0, 45.0)] | None = None


def test_every_kind_is_ordered_and_says_why() -> None:
    for kind, quantity in QUANTITIES.items():
        assert -math.inf < quantity.least < quantity.most < math.inf, kind
        assert quantity.why and not quantity.why.endswith("."), kind


@pytest.mark.parametrize("value", [1, 2.5, np.float64(3.0), 0.001, 1_000_000])
def test_a_number_within_the_bounds_is_taken_as_a_float(value: Any) -> None:
    assert Numbers(feed=value).feed == float(value)
    assert isinstance(Numbers(feed=value).feed, float)
    assert Bounds("feed").require(value, "--feed") == float(value)


@pytest.mark.parametrize(
    "value",
    [True, "1.5", [1.0], None, 0, 1e-9, -1, 1e18, math.nan, math.inf, 10**400, 10**5000, 1 << 40_000],
    ids=lambda value: shown(value, 20),
)
def test_what_is_no_number_within_the_bounds_is_refused(value: Any) -> None:
    with pytest.raises(ValidationError) as refused:
        Numbers(feed=value)
    problem = refused.value.errors()[0]
    assert (problem["type"], problem["loc"]) == ("quantity", ("feed",))
    assert problem["msg"] == "must be a number from 0.001 to 1000000 mm/min"
    with pytest.raises(JobError, match="--feed") as error:
        Bounds("feed").require(value, "--feed")
    assert error.value.value and error.value.limit == "0.001 to 1000000 mm/min"
    assert "no axis runs faster than 16 m/s" in error.value.advice


def test_zero_is_taken_only_where_it_means_none() -> None:
    assert Numbers(finish=0).finish == 0.0
    assert Bounds("feed", zero=True).words == "0.001 to 1000000 mm/min, or 0"
    for rounded in (0.1 + 0.2 - 0.3, -4e-16, 5e-324, 1e-9):
        assert Numbers(finish=rounded).finish == 0.0 == Bounds("width", zero=True).require(rounded, "--finish")
    for between in (1e-8, -1e-8, -0.001):
        with pytest.raises(ValidationError, match="or 0"):
            Numbers(finish=between)


def test_whole_numbers_are_whole_and_narrower_bounds_are_kept() -> None:
    for refused in (1.0, True, "1", 256, -1, 10**5000):
        with pytest.raises(ValidationError, match="must be a whole number from 0 to 255"):
            Numbers(tool=refused)
    with pytest.raises(ValidationError, match="from 1 to 45 deg"):
        Numbers(slope=46.0)
    assert Numbers(slope=None).slope is None


@pytest.mark.slow
def test_any_value_is_shown_in_few_words() -> None:
    deep: Any = []
    for _ in range(100_000):
        deep = [deep]
    for value in (deep, "x" * 10**6, 1 << 100_000, {1: 1 << 100_000}, list(range(10**6)), "\x1b]0;t\x07"):
        assert len(shown(value)) < 80
        assert shown(value).isprintable()
    assert with_unit(1e18, "mm") == "1e+18 mm"


def test_the_table_needs_no_pydantic() -> None:
    code = "import sys; sys.modules['pydantic'] = sys.modules['pydantic_core'] = None; import CNCStepper.quantities"
    assert subprocess.run([sys.executable, "-c", code], timeout=60).returncode == 0
