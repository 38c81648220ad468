# SPDX-License-Identifier: LGPL-2.1-or-later
"""The settings of a controller ($$) against those of the machine profile."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from CNCStepper.errors import MachineRefusal, Text, joined

if TYPE_CHECKING:
    from CNCStepper.machine.profile import Machine

STEPS_PER_MM, MAX_RATE, ACCELERATION = 100, 110, 120  # of the first axis; the next axes follow
MAX_RPM, LASER_MODE = 30, 32
IN_WORDS = {
    MAX_RPM: "the highest spindle speed, which every S is scaled by",
    LASER_MODE: "laser mode: 1 is on, 0 off",
}
TOLERANCE = 0.0005  # grbl prints three decimals


@dataclass(frozen=True)
class Difference:
    """A controller setting that differs from the machine profile."""

    number: int
    value: float
    wanted: float

    def __str__(self) -> str:
        return str(self.text)

    @property
    def text(self) -> Text:
        """The difference in words."""
        told = Text(
            "${number} is {value:g}, wanted {wanted:g}", number=self.number, value=self.value, wanted=self.wanted
        )
        words = IN_WORDS.get(self.number)
        return Text("{difference} ({words})", difference=told, words=words) if words else told


def expected_settings(machine: Machine) -> dict[int, float]:
    """Return the settings that a machine's profile fixes: steps/mm, mm/min, mm/s2, top spindle speed, laser mode."""
    wanted: dict[int, float] = {LASER_MODE: float(machine.spindle.laser)}
    if machine.has_spindle:
        wanted[MAX_RPM] = machine.spindle.max_rpm
    for number, _, axis in machine.numbered_axes:
        wanted[STEPS_PER_MM + number] = axis.steps_per_mm
        wanted[MAX_RATE + number] = axis.max_rate_mm_min
        wanted[ACCELERATION + number] = axis.acceleration_mm_s2
    return dict(sorted(wanted.items()))


def differences(settings: Mapping[int, float], wanted: Mapping[int, float]) -> list[Difference]:
    """Return the settings that differ; those that the controller does not report are left out."""
    return [
        Difference(number, settings[number], value)
        for number, value in wanted.items()
        if number in settings and abs(settings[number] - value) > TOLERANCE + 1e-6 * abs(value)
    ]


def check_settings(settings: Mapping[int, float], wanted: Mapping[int, float]) -> None:
    """Refuse a controller whose settings differ from the profile's; raises MachineRefusal naming each."""
    if found := differences(settings, wanted):
        raise MachineRefusal(
            "settings-differ",
            Text(
                "the controller is set up for another machine: {differences}",
                differences=joined("; ", (each.text for each in found)),
            ),
            value=f"${found[0].number}={found[0].value:g}",
            limit=f"${found[0].number}={found[0].wanted:g}",
            advice="choose the right machine profile, or correct the settings",
        )
