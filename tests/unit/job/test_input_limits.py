# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far values may go for a job's stock and machine: slips are refused, what is only unusual is not."""

from __future__ import annotations

from typing import Any

import pytest

from CNCStepper.job.input_limits import largest, reach_of
from CNCStepper.machine.profile import load_machine

STOCK_MM = (100.0, 70.0, 20.0)  # table-a travels 400, 400 and 80 mm; its fastest axis 5000 mm/min


@pytest.mark.parametrize(
    ("key", "value", "most"),
    [
        ("depth_mm", 10_000.0, 50.0),
        ("depth_mm", -51.0, 50.0),
        ("stepdown_mm", 1000.0, 50.0),
        ("clearance_mm", 81.0, 80.0),
        ("stepover_mm", 10_000.0, 1600.0),
        ("pattern_centre_mm", (0.0, 2000.0), 1600.0),
        ("finish_feed_mm_min", 60_000.0, 50_000.0),
    ],
)
def test_a_slip_is_refused_with_its_limit(key: str, value: Any, most: float) -> None:
    limit = reach_of(STOCK_MM, load_machine("table-a")).refusal(key, value)
    assert limit is not None and limit.most == pytest.approx(most)


@pytest.mark.parametrize(
    ("key", "value"),
    [("depth_mm", 25.0), ("clearance_mm", 80.0), ("radius_mm", 300.0), ("tool", "T1"), ("passes", 99), ("side", "on")],
)
def test_what_a_job_may_hold_is_not_refused(key: str, value: Any) -> None:
    assert reach_of(STOCK_MM, load_machine("table-a")).refusal(key, value) is None


def test_a_thick_stock_is_cut_no_deeper_than_the_machine_travels() -> None:
    limit = reach_of((100.0, 70.0, 200.0), load_machine("table-a")).refusal("depth_mm", 100.0)
    assert limit is not None and (limit.most, limit.reason) == (80.0, "travel")


def test_the_largest_of_each_kind_say_whether_any_value_goes_too_far() -> None:
    reach = reach_of(STOCK_MM, load_machine("table-a"))
    found = {
        "depth_mm": -20.0,
        "stepdown_mm": 2.0,
        "pattern_centre_mm": (0.0, -1600.0),
        "tolerance_mm": 1e6,
        "tool": "T1",
    }
    assert largest(found) == {"depth": 20.0, "width": 1600.0}
    assert reach.holds(largest(found))
    assert not reach.holds(largest({**found, "peck_mm": -51.0}))
