# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a profile says of an axis' play and motors, and where motors must stand."""

from __future__ import annotations

import math

import pytest

from CNCStepper.errors import JobError
from CNCStepper.geometry.quadrant_points import turning_points
from CNCStepper.machine.backlash import Backlash, Motors
from CNCStepper.machine.profile import Axis, load_machine, validated

AXIS = {
    "steps_per_mm": 80,
    "max_rate_mm_min": 3000,
    "acceleration_mm_s2": 100,
    "travel_min_mm": -200,
    "travel_max_mm": 0,
}
PLAY = Backlash((0.1, 0.0, 0.2), (-1, -1, 1), (80.0, 80.0, 400.0))


def test_shipped_profiles_have_no_play() -> None:
    assert not Backlash.of(load_machine("table-a"))


@pytest.mark.parametrize("backlash_mm", [-0.1, 200, math.inf])
def test_a_value_that_cannot_be_is_refused_by_its_key(backlash_mm: float) -> None:
    with pytest.raises(JobError, match="backlash_mm"):
        validated(Axis, AXIS | {"backlash_mm": backlash_mm}, "m.toml")


def test_motors_stand_ahead_in_the_sense_that_is_not_true() -> None:
    motors = Motors(PLAY, (0.0, 0.0, 0.0))
    assert motors.go((0.0, 0.0, 0.0), (5.0, 5.0, 5.0)) == (0.1, 0.0, 0.0)
    assert motors.at_mm == pytest.approx([5.1, 5.0, 5.0])
    assert motors.go((5.0, 5.0, 5.0), (6.0, 5.0, 4.0)) == pytest.approx((5.1, 5.0, 4.8))
    assert motors.at_mm == pytest.approx([6.1, 5.0, 3.8])
    assert motors.go((6.0, 5.0, 4.0), (6.0, 5.0, 4.0)) is None


@pytest.mark.parametrize("sign", [1, -1])
def test_an_arc_turns_back_at_its_quarters(sign: int) -> None:
    whole = turning_points((5.0, 0.0), (0.0, 0.0), sign * math.tau, (0.01, 0.01))
    assert whole == pytest.approx([math.pi / 2, math.pi, 3 * math.pi / 2])
    near = (5.0 * math.cos(0.02), 5.0 * math.sin(0.02) * -sign)  # a thousandth of a millimetre before X turns back
    assert turning_points(near, (0.0, 0.0), sign * 1.0, (0.01, 0.01)) == []
    assert turning_points(near, (0.0, 0.0), sign * 1.0, (0.0005, 0.01)) == pytest.approx([0.02])
