# SPDX-License-Identifier: LGPL-2.1-or-later
"""The lines of the machine test: motion of one axis, a square and a circle in air, and relays.

Straight moves are jogs ($J=), which leave the controller's modes as they are. A circle needs G2, so the modes that it
changes are put back by a line made of what `$G` said before. A relay is switched by the program's own words.
"""

from __future__ import annotations

from CNCStepper.control.operator.jog import JogMove
from CNCStepper.control.session.status import SenderStatus
from CNCStepper.errors import JobError, MachineRefusal, Text
from CNCStepper.machine.axis_tests import room_around_mm
from CNCStepper.machine.profile import AXIS_NAMES, Machine
from CNCStepper.machine.wiring import Device, Input

COOLANTS = {"mist": ("M7", "M"), "flood": ("M8", "F")}  # the word that switches it on, its letter in a status
SPINDLES = {"spindle_cw": ("M3", "S"), "spindle_ccw": ("M4", "C")}
MODES = ("G17", "G18", "G19", "G20", "G21", "G90", "G91", "G93", "G94")  # of `$G`, that a line alone restores
ASK_MODES = "$G"
LEAD_MM = 2.0  # beyond an axis' play: how far it comes from, so that it always arrives in one sense

Position = tuple[float, ...]


def way(axis: str, length_mm: float, feed_mm_min: float) -> str:
    """Return the jog of one axis by so much."""
    parts = {f"{name}_mm": length_mm if name == axis else 0.0 for name in AXIS_NAMES}
    return JogMove(**parts, feed_mm_min=feed_mm_min).line()


def check_room(machine: Machine, mpos_mm: Position | None, axis: str, low_mm: float, high_mm: float) -> None:
    """Raise JobError where an axis would leave its travel by going `low_mm` (below 0) down or `high_mm` up.

    mpos_mm: the machine position, None where it is unknown: then nothing can be said.
    """
    if mpos_mm is None:
        return
    down_mm, up_mm = room_around_mm(machine, mpos_mm, axis)
    if -low_mm > down_mm or high_mm > up_mm:
        raise JobError(
            "test-travel",
            "the test leaves the travel of the axis",
            value=f"{axis.upper()} by {low_mm:g} to {high_mm:g} mm",
            limit=f"{-down_mm:.3f} to {up_mm:.3f} mm from here",
            advice="jog to a place with more room, or test a shorter length",
        )


def check_plane(machine: Machine) -> None:
    """Raise JobError where a machine has not both X and Y, in which square, circle and diagonals lie."""
    if not {"x", "y"} <= machine.own_axes.keys():
        axes = ", ".join(axis.upper() for axis in machine.own_axes)
        raise JobError(
            "test-axes",
            "square, circle and squareness need the axes X and Y",
            value=Text("this machine has {axes}", axes=axes),
            advice="test its axes one by one",
        )


def inputs_on(machine: Machine, status: SenderStatus) -> list[Input]:
    """Return the inputs of the machine's own parallel port that are on; none where the status has no levels of it."""
    high = status.port_inputs
    own = [entry for entry in machine.input if isinstance(entry.pin, int) and not entry.port]
    return [entry for entry in own if high is not None and (entry.pin in high) == (entry.level == "high")]


def arrivals(axis: str, length_mm: float, play_mm: float, feed_mm_min: float) -> tuple[list[str], list[str], list[str]]:
    """Return the lines to the start of a measured length, along it, and back to where it all began.

    The start is approached in the direction of the length, so that the axis has no backlash left when it is measured.
    """
    lead_mm = (play_mm + LEAD_MM) * (1 if length_mm > 0 else -1)
    start = [way(axis, -lead_mm, feed_mm_min), way(axis, lead_mm, feed_mm_min)]
    return start, [way(axis, length_mm, feed_mm_min)], [way(axis, -length_mm, feed_mm_min)]


def both_sides(axis: str, distance_mm: float, feed_mm_min: float) -> tuple[list[str], list[str]]:
    """Return the lines that come to this place from below, and then from above."""
    down, up = way(axis, -distance_mm, feed_mm_min), way(axis, distance_mm, feed_mm_min)
    return [down, up], [up, down]


def square(side_mm: float, feed_mm_min: float) -> list[str]:
    """Return the lines of a square from its lower left corner, anticlockwise."""
    sides = (("x", side_mm), ("y", side_mm), ("x", -side_mm), ("y", -side_mm))
    return [way(axis, length, feed_mm_min) for axis, length in sides]


def circle(diameter_mm: float, feed_mm_min: float) -> str:
    """Return the line of a full circle, clockwise, from its leftmost place; its modes are to be put back."""
    return f"G17G21G91G94G2X0Y0I{diameter_mm / 2:.4f}J0F{feed_mm_min:.1f}"


def modes_back(modes: str) -> str:
    """Return the line that puts back what `circle` changes, from the words of `$G`; motion becomes G0.

    Raises MachineRefusal where they are no modes.
    """
    words = _words(modes)
    kept = [word for word in words if word in MODES]
    if len(kept) < 4:
        raise MachineRefusal(
            "modes-unknown",
            "the controller does not report its modes",
            value=modes[:60],
            advice="test with the square, which changes none",
        )
    feed = next((word for word in words if word.startswith("F")), "")
    return "G0" + "".join(kept) + ("" if "G93" in kept else feed)


def outputs_of(modes: str) -> str:
    """Return the letters of what is on (S, C, F, M), as a status has them, from the words of `$G`."""
    words = _words(modes)
    return "".join(letter for word, letter in (*SPINDLES.values(), *COOLANTS.values()) if word in words)


def check_no_power(modes: str) -> None:
    """Raise MachineRefusal while the spindle's output is on: a circle is a feed, in which a beam cuts."""
    if set(outputs_of(modes)) & set("SC"):
        raise MachineRefusal("test-power", "spindle, torch or beam is on", advice="switch it off first: M5")


def switching(machine: Machine, device: Device, on: bool, outputs: str = "") -> list[str]:
    """Return the lines that switch a device.

    outputs: the letters of what is on, as a status has them (S, C, F, M): M9 takes both coolants off, so the other one
    is switched on again.
    """
    if device in COOLANTS:
        still_on = [word for other, (word, letter) in COOLANTS.items() if other != device and letter in outputs]
        return [COOLANTS[device][0]] if on else ["M9", *still_on]
    if device in SPINDLES:
        speed = f"S{machine.spindle.max_rpm:.10g}" if machine.has_spindle else ""
        return [SPINDLES[device][0] + speed] if on else ["M5"]
    return [f"M{64 if on else 65}P{device.rpartition('_')[2]}"]


def is_on(device: str, outputs: str | None) -> bool | None:
    """Return whether a status reports a device as on; None where it does not report it."""
    letter = {**COOLANTS, **SPINDLES}.get(device, ("", ""))[1]
    return None if outputs is None or not letter else letter in outputs


def _words(modes: str) -> list[str]:
    return modes.upper().removeprefix("[GC:").rstrip("]").split()
