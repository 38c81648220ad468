# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a machine is ready for a program: its state, and its work offsets against the proven ones."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence

from CNCStepper.control.protocol.grbl.status_reports import Status
from CNCStepper.errors import MachineRefusal, Text, joined

OFFSET_TOLERANCE_MM = 0.002  # grbl prints four decimals of an inch

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
UNLOCK_OR_CONNECT = "unlock it ($X); where it stays locked, disconnect and connect again; then set its zero"


def check_state(status: Status | None, cannot: Collection[str] = ()) -> None:
    """Refuse a machine that is not idle, with what to do; raises MachineRefusal.

    cannot: what the machine cannot do, as words of `capabilities.py`.
    """
    if status is None or status.state != "Idle":
        raise state_refusal(status, cannot)


def state_refusal(status: Status | None, cannot: Collection[str] = ()) -> MachineRefusal:
    """Return the error and the remedy of a state in which no program can be cut."""
    state = status.state if status else "silent"
    advice = WHAT_TO_DO.get(state, "bring it to Idle first")
    if state == "Alarm" and "home" in cannot:
        advice = UNLOCK_OR_CONNECT
    return MachineRefusal(
        f"machine-{state.lower()}",
        IN_A_JOB.get(state, "the machine is not idle"),
        value=status.name if status else state,
        advice=advice,
    )


def check_zero(confirmed: bool) -> None:
    """Refuse to send before the operator has confirmed the work zero."""
    if not confirmed:
        raise MachineRefusal(
            "zero-not-confirmed",
            "the work zero is not confirmed",
            advice="set the zero on the stock, then confirm it (--zero-confirmed)",
        )


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
            Text("the work zero is not where the program was proven: {differences}", differences=joined("; ", found)),
            advice="set the zero there, or check the program again with the zero that is set (--work-zero)",
        )
