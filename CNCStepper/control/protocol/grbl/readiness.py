# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a machine is ready for a program: its state, and its settings against the profile."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from CNCStepper.control.protocol.grbl.status_reports import Status
from CNCStepper.errors import MachineRefusal, Text

if TYPE_CHECKING:
    from CNCStepper.machine.profile import Machine

STEPS_PER_MM, MAX_RATE, ACCELERATION = 100, 110, 120  # of the first axis; the next axes follow
MAX_RPM, LASER_MODE = 30, 32
IN_WORDS = {
    MAX_RPM: "the highest spindle speed, which every S is scaled by",
    LASER_MODE: "laser mode: 1 is on, 0 off",
}
TOLERANCE = 0.0005  # grbl prints three decimals
OFFSET_TOLERANCE_MM = 0.002  # and in inches four

CHECK = "Check"
NOTHING_MOVES = "the controller reads its lines without moving"
IN_A_JOB = {
    CHECK: NOTHING_MOVES,
    "Starting": "the controller is starting",
    "ConfigAlarm": "the controller's configuration is not valid",
    "Critical": "the controller stopped by a critical fault",
}
WHAT_TO_DO = {
    "Alarm": "home the machine ($H), or unlock it ($X) if its position is surely right",
    "Hold": "resume what it was doing, or reset it",
    "Door": "close the safety door and resume, or reset it",
    "Run": "wait until it has finished, or stop it",
    "Jog": "wait until the jog has ended",
    "Home": "wait until it is homed",
    CHECK: "leave the check mode with $C",
    "Sleep": "wake it up with a reset, then home it",
    "Tool": "end the tool change and resume, or reset it",
    "Starting": "wait until it has started",
    "ConfigAlarm": "correct its configuration, then restart it",
    "Critical": "reset it, then home it or set its zero again",
}


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


def check_state(status: Status | None) -> None:
    """Refuse a machine that is not idle, with what to do; raises MachineRefusal."""
    if status is None or status.state != "Idle":
        raise state_refusal(status)


def state_refusal(status: Status | None) -> MachineRefusal:
    """Return the error and the remedy of a state in which no program can be cut."""
    state = status.state if status else "silent"
    return MachineRefusal(
        f"machine-{state.lower()}",
        IN_A_JOB.get(state, "the machine is not idle"),
        value=status.name if status else state,
        advice=WHAT_TO_DO.get(state, "bring it to Idle first"),
    )


def check_zero(confirmed: bool) -> None:
    """Refuse to send before the operator has confirmed the work zero."""
    if not confirmed:
        raise MachineRefusal(
            "zero-not-confirmed",
            "nobody has confirmed the work zero",
            advice="set the zero on the stock, then confirm it (--zero-confirmed)",
        )


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


def offset_differences(
    offsets_mm: Mapping[str, Sequence[float] | None], modes: str, wanted_mm: Mapping[str, Sequence[float]], system: str
) -> list[str]:
    """Return in words where the controller's work offsets and system are not those wanted.

    offsets_mm: by name, in mm. modes: the words of `$G`. What the controller does not report is left out.
    """
    found: list[str] = []
    if system and modes and system not in modes.split():
        found.append(Text("{system} is not the work system in force", system=system))
    for name, wanted in wanted_mm.items():
        offset = offsets_mm.get(name)
        if offset and any(abs(a - b) > OFFSET_TOLERANCE_MM for a, b in zip(offset, wanted, strict=False)):
            found.append(
                Text(
                    "{name} is {offset}, wanted {wanted} mm", name=name, offset=_vector(offset), wanted=_vector(wanted)
                )
            )
    return found


def _vector(values: Sequence[float]) -> str:
    return ",".join(f"{value:.3f}" for value in values)


def check_offsets(found: Sequence[str]) -> None:
    """Refuse a controller whose work zero is not where the program was proven; raises MachineRefusal."""
    if found:
        raise MachineRefusal(
            "start-differs",
            "the work zero is not where the program was proven: " + "; ".join(found),
            advice="set the zero there, or check the program again with the zero that is set (--work-zero)",
        )


def check_settings(settings: Mapping[int, float], wanted: Mapping[int, float]) -> None:
    """Refuse a controller whose settings differ from the profile's; raises MachineRefusal naming each."""
    if found := differences(settings, wanted):
        raise MachineRefusal(
            "settings-differ",
            "the controller is set up for another machine: " + "; ".join(map(str, found)),
            value=f"${found[0].number}={found[0].value:g}",
            limit=f"${found[0].number}={found[0].wanted:g}",
            advice="choose the right machine profile, or correct the settings",
        )
