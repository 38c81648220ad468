# SPDX-License-Identifier: LGPL-2.1-or-later
"""The ramp of a profile: tables of waits in their three forms, jerks, and what is refused."""

import math
from itertools import pairwise

import pytest
from pydantic import ValidationError

from CNCStepper.machine.profile import Machine, load_machine
from CNCStepper.machine.step_wait_tables import PULL_OUT, Waits, accelerated_s, counted_down_s, pull_out_s
from CNCStepper.motion.planner.machine_limits import Limits


def machine_with(jerk_mm_s3=None, **planner):
    content = load_machine("table-a").model_dump()
    content["planner"] |= planner
    for axis in content["axis"].values():
        axis["jerk_mm_s3"] = jerk_mm_s3
    return Machine.model_validate(content)


def test_the_published_table_has_23_entries_of_135_us():
    assert len(PULL_OUT) == 23
    assert pull_out_s()[0] == pytest.approx(0.013635) and pull_out_s()[-1] == pytest.approx(0.00054)


def test_counting_down_ends_at_the_least_wait():
    assert counted_down_s(0.010, 0.002, 0.003) == pytest.approx((0.010, 0.008, 0.006, 0.004, 0.003))
    assert counted_down_s(0.010, 0.001, 0.007) == pytest.approx((0.010, 0.009, 0.008, 0.007))
    assert counted_down_s(0.004, 0.001, 0.004) == (0.004,)


def test_the_waits_of_a_constant_acceleration_add_up_to_its_time():
    waits = accelerated_s(20000.0, 100)
    assert sum(waits) == pytest.approx(math.sqrt(2 * 100 / 20000)) and waits[0] == pytest.approx(0.01)
    assert all(one > after for one, after in pairwise(waits))


@pytest.mark.parametrize(
    ("keys", "count", "pull_in_s"),
    [
        ({"table_ms": (5, 3, 2, 2)}, 4, 0.005),
        ({"first_ms": 10, "change_ms": 2, "least_ms": 3, "pull_in_ms": 4}, 5, 0.004),
        ({"acceleration_steps_s2": 20000, "steps": 50}, 50, 0.01),
    ],
)
def test_each_form_reaches_the_planner(keys, count, pull_in_s):
    limits = Limits.of(machine_with(ramp="table", waits=keys))
    assert limits.ramp == "table" and len(limits.waits_s) == count and limits.pull_in_s == pytest.approx(pull_in_s)


@pytest.mark.parametrize(
    "keys",
    [
        {},
        {"pull_in_ms": 4},
        {"table_ms": (3, 4)},
        {"table_ms": (3, 0)},
        {"first_ms": 10, "change_ms": 2},
        {"first_ms": 2, "change_ms": 1, "least_ms": 3},
        {"table_ms": (3,), "acceleration_steps_s2": 20000, "steps": 50},
        {"table_ms": (math.nan,)},
        {"table_ms": (math.inf, 3)},
        {"table_ms": (3, 1e-6)},
        {"table_ms": (3,) * 100_001},
        {"table_ms": (3,), "pull_in_ms": math.inf},
        {"first_ms": 1000, "change_ms": 1e-9, "least_ms": 1},
        {"first_ms": math.inf, "change_ms": 1, "least_ms": 1},
        {"first_ms": 10, "change_ms": math.nan, "least_ms": 1},
        {"first_ms": 10, "change_ms": 1, "least_ms": 1e-5},
        {"acceleration_steps_s2": math.inf, "steps": 50},
        {"acceleration_steps_s2": 1e15, "steps": 50},
        {"acceleration_steps_s2": 1e-9, "steps": 50},
    ],
)
def test_what_is_no_table_is_refused(keys):
    with pytest.raises(ValidationError):
        Waits.model_validate(keys)


def test_a_ramp_without_what_it_needs_is_refused():
    with pytest.raises(ValidationError, match="belong together"):
        machine_with(ramp="table")
    with pytest.raises(ValidationError, match="belong together"):
        machine_with(waits={"table_ms": (3,)})
    with pytest.raises(ValidationError, match="jerk_mm_s3 is missing"):
        machine_with(ramp="s_curve")
    assert Limits.of(machine_with(5000.0, ramp="s_curve")).jerk_mm_s3 == (5000.0,) * 3


@pytest.mark.parametrize("key", ["junction_deviation_mm", "arc_tolerance_mm"])
def test_no_number_of_a_profile_is_endless(key):
    with pytest.raises(ValidationError, match="must be a number from"):
        machine_with(**{key: math.inf})
