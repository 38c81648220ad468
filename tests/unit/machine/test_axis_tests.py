# SPDX-License-Identifier: LGPL-2.1-or-later
"""The machine test's arithmetic: against machines whose errors are known."""

from __future__ import annotations

import math
import random
import statistics

import pytest

from CNCStepper.errors import JobError
from CNCStepper.machine.axis_tests import (
    Readings,
    axis_of,
    backlash_mm,
    check_reading,
    corrected_steps_per_mm,
    is_within_noise,
    length_of_pulses_mm,
    room_around_mm,
    skew_mm_m,
    squareness_of_diagonals,
    squareness_of_triangle,
)
from CNCStepper.machine.profile import load_machine


def test_ten_readings_by_hand() -> None:
    readings = Readings((99.8, 99.9, 100.0, 99.7, 99.8, 99.9, 99.8, 99.8, 99.7, 99.9))
    assert readings.mean_mm == pytest.approx(99.83)
    assert readings.deviation_mm == pytest.approx(0.0948683, abs=1e-6)
    assert readings.mean_deviation_mm == pytest.approx(0.03, abs=1e-6)
    assert readings.range_mm == pytest.approx(0.3)
    assert corrected_steps_per_mm(80.0, 100.0, readings) == pytest.approx(80.13623, abs=1e-5)
    assert not is_within_noise(100.0, readings) and is_within_noise(99.85, readings)


def test_a_single_reading_has_no_scatter() -> None:
    assert Readings((50.0,)).deviation_mm == 0.0 == Readings((50.0,)).range_mm


def test_the_correction_finds_the_true_steps_of_random_machines() -> None:
    seed = random.SystemRandom().randrange(2**32)
    print("seed", seed)
    dice = random.Random(seed)
    up = down = 0
    for _ in range(200):
        true, believed = dice.uniform(5, 3200), 0.0
        believed = true * dice.uniform(0.9, 1.1)
        up, down = up + (believed < true), down + (believed > true)
        commanded = dice.uniform(10, 1000)
        moved = commanded * believed / true
        values = tuple(moved + dice.gauss(0, 0.01) for _ in range(10))
        readings = Readings(values)
        assert readings.deviation_mm == pytest.approx(statistics.stdev(values))
        corrected = corrected_steps_per_mm(believed, commanded, readings)
        assert corrected == pytest.approx(true, rel=6 * 0.01 / math.sqrt(10) / commanded + 1e-12)
    assert up > 20 and down > 20


@pytest.mark.parametrize("measured", [float("nan"), 10.0, 79.9, 120.1, 1000.0])
def test_a_reading_that_is_a_mistake_is_refused(measured: float) -> None:
    with pytest.raises(JobError) as refused:
        check_reading(measured, 100.0)
    assert refused.value.code == "reading-far" and "80 to 120 mm" in refused.value.limit
    check_reading(81.0, 100.0)


def test_backlash_is_what_lies_between_the_two_sides() -> None:
    below, above = Readings((0.01, 0.0, 0.02)), Readings((0.13, 0.12, 0.14))
    assert backlash_mm(below, above) == pytest.approx(0.12)
    assert backlash_mm(below, below) == 0.0
    assert backlash_mm(Readings((0.01, 0.02)), Readings((0.012, 0.013))) == 0.0
    with pytest.raises(JobError, match="from above"):
        backlash_mm(above, below)


def corners(side_x: float, side_y: float, angle_deg: float) -> tuple[float, float]:
    """Return the rising and the falling diagonal of axes that stand at an angle."""
    lean_x, lean_y = side_y * math.cos(math.radians(angle_deg)), side_y * math.sin(math.radians(angle_deg))
    return math.hypot(side_x + lean_x, lean_y), math.hypot(side_x - lean_x, lean_y)


def test_squareness_comes_out_of_random_skewed_tables() -> None:
    seed = random.SystemRandom().randrange(2**32)
    print("seed", seed)
    dice = random.Random(seed)
    signs = set()
    for _ in range(200):
        side_x, side_y, off = dice.uniform(50, 2000), dice.uniform(50, 2000), dice.uniform(-2, 2)
        rising, falling = corners(side_x, side_y, 90 + off)
        signs.add((off > 0, side_x > side_y))
        assert squareness_of_diagonals(side_x, side_y, rising, falling) == pytest.approx(off, abs=1e-9)
        assert squareness_of_triangle(side_x, side_y, falling) == pytest.approx(off, abs=1e-7)
    assert len(signs) == 4


def test_three_four_five() -> None:
    assert squareness_of_triangle(300, 400, 500) == pytest.approx(0.0, abs=1e-12)
    assert squareness_of_triangle(300, 400, 501) == pytest.approx(0.239, abs=1e-3)
    assert skew_mm_m(0.239) == pytest.approx(4.171, abs=1e-3)


def test_two_diagonals_need_no_right_steps_per_mm() -> None:
    rising, falling = (1.01 * one for one in corners(300, 400, 91))
    assert squareness_of_diagonals(300, 400, rising, falling) == pytest.approx(1.0, abs=0.03)


@pytest.mark.parametrize("diagonals", [(500.0, 300.0), (590.0, 590.0), (float("nan"), 500.0)])
def test_diagonals_of_no_rectangle_are_refused(diagonals: tuple[float, float]) -> None:
    with pytest.raises(JobError):
        squareness_of_diagonals(300, 400, *diagonals)


def test_pulses_travel_and_room_of_an_axis() -> None:
    machine = load_machine("table-a")
    assert length_of_pulses_mm(machine, "x", -200) * machine.axis["x"].steps_per_mm == pytest.approx(-200)
    assert room_around_mm(machine, (-100.0, 0.0, -80.0), "x") == (300.0, 100.0)
    with pytest.raises(JobError) as refused:
        axis_of(load_machine("thesis-table"), "z")
    assert refused.value.code == "no-axis" and refused.value.advice == "there are: X, Y"
