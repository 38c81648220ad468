# SPDX-License-Identifier: LGPL-2.1-or-later
"""Operator actions at an idle machine: set the zero, unlock. Each is sent, answered and verified."""

from __future__ import annotations

from collections.abc import Iterable

from CNCStepper.control.protocol.grbl.capabilities import check_axes, own_axes
from CNCStepper.control.protocol.grbl.connect import ask, has_greeting, read_modes, read_offsets
from CNCStepper.control.protocol.grbl.driver import Grbl
from CNCStepper.control.protocol.grbl.firmware import TOOL
from CNCStepper.control.protocol.grbl.readiness import check_state
from CNCStepper.control.protocol.grbl.status_reports import Status, Vector
from CNCStepper.control.protocol.grbl.timeouts import Timing
from CNCStepper.errors import LinkError, MachineRefusal, Text
from CNCStepper.tolerances import REPORTED_MM

AXES = "XYZ"
SYSTEMS = ("G54", "G55", "G56", "G57", "G58", "G59")  # P1 to P6 of G10


def set_zero(driver: Grbl, axes: str, timing: Timing) -> str:
    """Make this place the zero of `axes` ("XYZ") in the work system in force; return that system's name.

    Raises MachineRefusal when the machine is neither idle nor waits for a new tool, or reads back another zero than the
    one set.
    """
    wanted = axes_to_zero(axes, driver.cannot)
    if (status := fresh_status(driver, timing)).state != TOOL:
        check_state(status, driver.cannot)
    system = _system_in_force(driver, timing)
    words = "".join(f"{axis}0" for axis in wanted)
    ask(driver, f"G10L20P{SYSTEMS.index(system) + 1}{words}", timing)
    _check_zero_set(driver, system, wanted, timing)
    return system


def unlock(driver: Grbl, timing: Timing, asleep_or_critical: bool) -> None:
    """Take the lock of an alarm away; the position stays what it was, known or not.

    asleep_or_critical: the controller asked for a reset, which it then gets first.
    """
    if asleep_or_critical:
        soft_reset(driver, timing)
    status = fresh_status(driver, timing)
    if status.state != "Alarm":
        raise MachineRefusal(
            "not-locked", "the machine is not in alarm", value=status.name, advice="there is nothing to unlock"
        )
    ask(driver, "$X", timing)
    fresh_status(driver, timing)


def soft_reset(driver: Grbl, timing: Timing) -> None:
    """Reset a machine at rest and wait for its greeting; raises LinkError when none comes."""
    driver.reset()
    end_s = driver.clock() + timing.wake_s
    while not has_greeting(driver.receive(timing.quick_poll_s)):
        if driver.clock() > end_s:
            raise _silent("the controller does not come back from its reset")


def fresh_status(driver: Grbl, timing: Timing) -> Status:
    """Return a status that was asked for now; raises LinkError when none comes."""
    begin_s = driver.clock()
    while driver.status is None or driver.status_asked_s < begin_s:
        driver.ask_status()  # again and again: the first answer may be that to an earlier question
        driver.receive(timing.quick_poll_s)
        if driver.clock() - begin_s > timing.answer_s:
            raise _silent("the controller does not report its state")
    return driver.status


def _silent(what: str) -> LinkError:
    return LinkError("answer-missing", what, advice="check its supply and cable")


def axes_to_zero(axes: str, cannot: Iterable[str]) -> str:
    """Return the axes that are meant: of all, those that the machine has.

    Raises MachineRefusal for letters that are no axes, and for an axis that the machine lacks.
    """
    wanted = axes.upper()
    if not wanted or set(wanted) - set(AXES) or len(set(wanted)) < len(wanted):
        raise MachineRefusal(
            "axes", Text("'{axes}' names no axes", axes=axes[:20]), advice="write for example XYZ, or Z alone"
        )
    if wanted == AXES:
        return own_axes(cannot)
    check_axes(wanted, cannot)
    return wanted


def _system_in_force(driver: Grbl, timing: Timing) -> str:
    modes = read_modes(driver, timing)
    system = next((word for word in modes.split() if word in SYSTEMS), None)
    if system is None:
        raise LinkError(
            "link-noise",
            Text("the controller does not report its work system: {modes}", modes=modes),
            advice="check the cable",
        )
    return system


def _check_zero_set(driver: Grbl, system: str, axes: str, timing: Timing) -> None:
    """Read the offsets and the position back: work position must be 0 for these axes."""
    offsets = read_offsets(driver, timing)
    status = fresh_status(driver, timing)
    machine_mm, offset_mm, extra_mm = driver.mpos_mm, driver.mm(offsets.get(system)), driver.mm(offsets.get("G92"))
    if machine_mm is None or offset_mm is None:
        raise MachineRefusal(
            "zero-not-read",
            Text("the controller does not report its {system}", system=system),
            value=status.name,
            advice="set $10=1",
        )
    extra_mm = extra_mm or (0.0,) * len(machine_mm)
    for number, axis in enumerate(AXES):
        here_mm = _less_tool(machine_mm[number] - offset_mm[number] - extra_mm[number], axis, driver, offsets)
        if axis in axes and abs(here_mm) > REPORTED_MM:
            raise MachineRefusal(
                "zero-not-set",
                Text("the controller did not store the zero of {axis} in {system}", axis=axis, system=system),
                value=f"{here_mm:.3f} mm",
                limit="0 mm",
                advice="set it again, and do not start before it is right",
            )


def _less_tool(length_mm: float, axis: str, driver: Grbl, offsets: dict[str, Vector]) -> float:
    """Take the tool length off, which matters for Z only."""
    tool_mm = driver.mm(offsets.get("TLO"))
    return length_mm - tool_mm[-1] if tool_mm and axis == "Z" else length_mm
