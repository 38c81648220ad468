# SPDX-License-Identifier: LGPL-2.1-or-later
"""The arithmetic of the machine test: travel measured ten times, backlash, squareness, and the values they correct.

travel       steps_per_mm is right when a commanded length is the measured one:   new = old · commanded / mean
backlash     a place is approached from both sides at the same command; what the dial shows between them is the play
squareness   a parallelogram of sides a and b has the diagonals d1 and d2        d1² - d2² = 4 a b cos φ
             a triangle of two sides and the measured one between their ends     c² = a² + b² - 2 a b cos φ
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from CNCStepper.errors import JobError, Text
from CNCStepper.machine.profile import AXIS_NAMES, Axis, Machine

USUAL_REPEATS = 10
MOST_DIFFERENCE = 0.2  # of a measured length from the commanded one: beyond it the reading is a mistake, not an error


@dataclass(frozen=True)
class Readings:
    """Lengths measured one after the other, in mm."""

    values_mm: tuple[float, ...]

    @property
    def mean_mm(self) -> float:
        """The mean."""
        return math.fsum(self.values_mm) / len(self.values_mm)

    @property
    def deviation_mm(self) -> float:
        """The standard deviation of one reading (n - 1); 0 of a single one."""
        if len(self.values_mm) < 2:
            return 0.0
        mean = self.mean_mm
        return math.sqrt(math.fsum((value - mean) ** 2 for value in self.values_mm) / (len(self.values_mm) - 1))

    @property
    def mean_deviation_mm(self) -> float:
        """The standard deviation of the mean."""
        return self.deviation_mm / math.sqrt(len(self.values_mm))

    @property
    def range_mm(self) -> float:
        """From the least to the largest: the repeatability that was seen."""
        return max(self.values_mm) - min(self.values_mm)


def check_reading(measured_mm: float, commanded_mm: float) -> None:
    """Raise JobError where a reading cannot be the length that was commanded."""
    if not math.isfinite(measured_mm) or abs(measured_mm - commanded_mm) > MOST_DIFFERENCE * commanded_mm:
        raise JobError(
            "reading-far",
            "the measured length is far from the commanded one",
            value=f"{measured_mm:g} mm",
            limit=f"{(1 - MOST_DIFFERENCE) * commanded_mm:g} to {(1 + MOST_DIFFERENCE) * commanded_mm:g} mm",
            advice="measure again; where it is true, work steps_per_mm out with: cncstepper axis",
        )


def corrected_steps_per_mm(steps_per_mm: float, commanded_mm: float, readings: Readings) -> float:
    """Return the steps_per_mm with which the mean of the readings would have been the commanded length."""
    return steps_per_mm * commanded_mm / readings.mean_mm


def is_within_noise(commanded_mm: float, readings: Readings) -> bool:
    """Return whether the commanded length lies within two standard deviations of the mean: nothing to correct."""
    return abs(readings.mean_mm - commanded_mm) <= 2.0 * readings.mean_deviation_mm


def backlash_mm(from_below: Readings, from_above: Readings) -> float:
    """Return the play of an axis from the places that were measured when approached from both sides.

    Without play both are the same place; with it the axis stops short on each side. Raises JobError where the two
    overlap the wrong way by more than the readings scatter.
    """
    play_mm = from_above.mean_mm - from_below.mean_mm
    scatter_mm = 2.0 * math.hypot(from_below.mean_deviation_mm, from_above.mean_deviation_mm)
    if play_mm < -max(scatter_mm, 1e-9):
        raise JobError(
            "backlash-negative",
            "approached from above, the axis stands below where it stands when approached from below",
            value=f"{play_mm:.4f} mm",
            advice="see that the dial counts in the axis' sense, and measure again",
        )
    return max(play_mm, 0.0)


def skew_mm_m(deviation_deg: float) -> float:
    """Return by how many mm Y runs off over one metre."""
    return 1000.0 * math.tan(math.radians(deviation_deg))


def squareness_of_diagonals(side_x_mm: float, side_y_mm: float, rising_mm: float, falling_mm: float) -> float:
    """Return the angle between the axes less 90°, in degrees, from the diagonals of a rectangle that was driven.

    rising: from lower left to upper right; it is the longer one where the angle is below 90°. Raises JobError for
    diagonals that no such parallelogram has.
    """
    cosine = (rising_mm**2 - falling_mm**2) / (4.0 * side_x_mm * side_y_mm)
    _check_diagonals(side_x_mm, side_y_mm, rising_mm, falling_mm)
    return math.degrees(math.acos(max(-1.0, min(1.0, cosine)))) - 90.0


def squareness_of_triangle(side_x_mm: float, side_y_mm: float, between_mm: float) -> float:
    """Return the angle between the axes less 90°, in degrees, from two sides and the distance of their ends (3-4-5)."""
    check_reading(between_mm, math.hypot(side_x_mm, side_y_mm))
    cosine = (side_x_mm**2 + side_y_mm**2 - between_mm**2) / (2.0 * side_x_mm * side_y_mm)
    return math.degrees(math.acos(max(-1.0, min(1.0, cosine)))) - 90.0


def _check_diagonals(side_x_mm: float, side_y_mm: float, rising_mm: float, falling_mm: float) -> None:
    """Raise JobError unless the squares of the diagonals add up to those of the sides, within the reading error."""
    true_mm = math.hypot(side_x_mm, side_y_mm)
    for value in (rising_mm, falling_mm):
        check_reading(value, true_mm)
    mean_mm = math.sqrt((rising_mm**2 + falling_mm**2) / 2.0)
    if abs(mean_mm / true_mm - 1.0) > 0.05:
        raise JobError(
            "diagonals-wrong",
            "these diagonals belong to no rectangle of these sides",
            value=f"{rising_mm:g} and {falling_mm:g} mm",
            limit=f"{true_mm:.3f} mm each where the axes are square",
            advice="measure again, or correct steps_per_mm first",
        )


def axis_of(machine: Machine, name: str) -> Axis:
    """Return an axis by its name; raises JobError for one that the machine does not have."""
    found = machine.own_axes.get(name.lower())
    if found is None:
        raise JobError(
            "no-axis",
            Text("{machine} has no axis {axis}", machine=machine.name, axis=name.upper()),
            advice=Text("there are: {axes}", axes=", ".join(machine.own_axes).upper()),
        )
    return found


def length_of_pulses_mm(machine: Machine, name: str, pulses: int) -> float:
    """Return the travel of so many pulses, with their sign."""
    return pulses / axis_of(machine, name).steps_per_mm


def room_around_mm(machine: Machine, mpos_mm: Sequence[float], name: str) -> tuple[float, float]:
    """Return how far an axis can go down and up from a machine position within its travel."""
    axis, at_mm = axis_of(machine, name), mpos_mm[AXIS_NAMES.index(name)]
    return at_mm - axis.travel_min_mm, axis.travel_max_mm - at_mm
