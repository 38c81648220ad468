# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measurements of the machine test in the window, and their results as sentences; no Qt."""

from __future__ import annotations

from dataclasses import dataclass, field

from CNCStepper.errors import CNCStepperError
from CNCStepper.machine.axis_tests import (
    Readings,
    backlash_mm,
    check_reading,
    corrected_steps_per_mm,
    is_within_noise,
    skew_mm_m,
    squareness_of_diagonals,
    squareness_of_triangle,
)
from CNCStepper.machine.profile import Machine
from CNCStepper.workbench.services.message_translation import translated
from CNCStepper.workbench.services.translation import tr

FIGURES = 4  # decimals of what is written into a profile


@dataclass
class Travel:
    """Readings of one commanded length of an axis."""

    axis: str = "x"
    length_mm: float = 100.0
    values_mm: list[float] = field(default_factory=list)

    def begin(self, axis: str, length_mm: float) -> None:
        """Forget the readings of another axis or length."""
        if (axis, length_mm) != (self.axis, self.length_mm):
            self.axis, self.length_mm, self.values_mm = axis, length_mm, []

    def take(self, measured_mm: float) -> None:
        """Take a reading; raises JobError for one that cannot be that length."""
        check_reading(measured_mm, self.length_mm)
        self.values_mm.append(measured_mm)

    @property
    def readings(self) -> Readings | None:
        """The readings, None before the first."""
        return Readings(tuple(self.values_mm)) if self.values_mm else None

    def correction(self, machine: Machine) -> tuple[tuple[str, ...], float] | None:
        """Return the key and value that correct the axis, None where there is nothing to correct."""
        readings = self.readings
        if readings is None or self.axis not in machine.own_axes or is_within_noise(self.length_mm, readings):
            return None
        steps = machine.own_axes[self.axis].steps_per_mm
        return ("axis", self.axis, "steps_per_mm"), round(
            corrected_steps_per_mm(steps, self.length_mm, readings), FIGURES
        )

    def words(self, machine: Machine) -> str:
        """Return mean and scatter, and what they mean for steps_per_mm."""
        readings = self.readings
        if readings is None:
            return ""
        said = tr("{0} readings: mean {1:.4f} mm, standard deviation {2:.4f} mm").format(
            len(self.values_mm), readings.mean_mm, readings.deviation_mm
        )
        correction = self.correction(machine)
        if correction is None:
            return said + " – " + tr("nothing to correct")
        old = machine.own_axes[self.axis].steps_per_mm
        return said + " – " + tr("steps per mm {0:g} becomes {1:g}").format(old, correction[1])


@dataclass
class Play:
    """Dial readings at one place, approached from below and from above."""

    axis: str = "x"
    below_mm: list[float] = field(default_factory=list)
    above_mm: list[float] = field(default_factory=list)

    def begin(self, axis: str) -> None:
        """Forget the readings of another axis."""
        if axis != self.axis:
            self.axis, self.below_mm, self.above_mm = axis, [], []

    def correction(self) -> tuple[tuple[str, ...], float] | None:
        """Return the key and value of the backlash, None before both sides; raises JobError for a wrong dial."""
        if not self.below_mm or not self.above_mm:
            return None
        found = backlash_mm(Readings(tuple(self.below_mm)), Readings(tuple(self.above_mm)))
        return ("axis", self.axis, "backlash_mm"), round(found, FIGURES)

    def words(self) -> str:
        """Return the backlash, or what is still to be measured."""
        try:
            correction = self.correction()
        except CNCStepperError as error:
            return f"{translated(error.what)}; {translated(error.advice)}"
        counts = tr("{0} from below, {1} from above").format(len(self.below_mm), len(self.above_mm))
        return counts if correction is None else f"{counts} – " + tr("backlash {0:g} mm").format(correction[1])


def squareness_words(x_mm: float, y_mm: float, falling_mm: float, rising_mm: float | None) -> str:
    """Return the angle between X and Y in words, from one diagonal (3-4-5) or from both."""
    try:
        if rising_mm is None:
            off_deg = squareness_of_triangle(x_mm, y_mm, falling_mm)
        else:
            off_deg = squareness_of_diagonals(x_mm, y_mm, rising_mm, falling_mm)
    except CNCStepperError as error:
        return f"{translated(error.what)}; {translated(error.advice)}"
    return tr("The angle between X and Y is {0:.4f}°: {1:.3f} mm over a metre.").format(
        90.0 + off_deg, abs(skew_mm_m(off_deg))
    )
