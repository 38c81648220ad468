# SPDX-License-Identifier: LGPL-2.1-or-later
"""A `$J=` line as a jog by hand: one axis, at rapid or at a feed that the motors can begin with at once."""

from __future__ import annotations

from collections.abc import Sequence

from CNCStepper.controllers.lathe.manual import Jog
from CNCStepper.machine.profile import Machine
from CNCStepper.machine.step_wait_tables import pull_out_s
from CNCStepper.units import MM_PER_INCH
from CNCStepper.virtual.grbl.alarms_and_errors import refused
from CNCStepper.virtual.grbl.gcode.words import read_words

NO_FEED, NOT_A_JOG, REPEATED, NO_AXIS = 22, 16, 25, 26
G_WORDS = (20.0, 21.0, 53.0, 90.0, 91.0)
AXES = "XYZ"


def jog_of(line: str, machine: Machine, zero_mm: Sequence[float], place_mm: Sequence[float]) -> tuple[Jog | None, str]:
    """Return the jog of a line, None for no motion, and a note on it, or "".

    zero_mm, place_mm: work zero and place of X, Y, Z in machine coordinates. Raises MachineRefusal with grbl's error.
    """
    modes, words = _read(line.removeprefix("$J="))
    unit_mm = MM_PER_INCH if 20.0 in modes else 1.0
    if not words.keys() & set(AXES):
        raise refused(NO_AXIS)
    if not words.get("F"):
        raise refused(NO_FEED)
    ways_mm = [_way_mm(words.get(letter), axis, modes, unit_mm, zero_mm, place_mm) for axis, letter in enumerate(AXES)]
    per_mm = [axis.steps_per_mm for axis in machine.axes]
    steps = [round(way * each) for way, each in zip(ways_mm, per_mm, strict=True)]
    if not any(steps):
        return None, ""
    if steps[1] or (steps[0] and steps[2]):
        raise refused(NOT_A_JOG)
    axis = 0 if steps[0] else 2
    feed_mm_s, said = _feed(words["F"] * unit_mm / 60.0, machine, axis)
    return Jog(axis // 2, steps[axis], feed_mm_s), said


def _read(text: str) -> tuple[set[float], dict[str, float]]:
    """Return G words and the others; raises MachineRefusal for any that no jog takes."""
    modes: set[float] = set()
    words: dict[str, float] = {}
    for letter, value in read_words(text):
        if letter == "G" and value in G_WORDS:
            modes.add(value)
        elif letter in words:
            raise refused(REPEATED)
        elif letter in (*AXES, "F"):
            words[letter] = value
        elif letter != "N":
            raise refused(NOT_A_JOG)
    return modes, words


def _way_mm(
    value: float | None,
    axis: int,
    modes: set[float],
    unit_mm: float,
    zero_mm: Sequence[float],
    place_mm: Sequence[float],
) -> float:
    if value is None:
        return 0.0
    if 91.0 in modes:
        return value * unit_mm
    return value * unit_mm + (0.0 if 53.0 in modes else zero_mm[axis]) - place_mm[axis]


def _feed(feed_mm_s: float, machine: Machine, axis: int) -> tuple[float | None, str]:
    """Return the feed in mm/s, None for rapid, and a note where it differs from the requested one."""
    rapid_mm_s = 1.0 / (pull_out_s()[-1] * machine.axes[axis].steps_per_mm)
    if feed_mm_s >= 0.999 * rapid_mm_s:
        return None, ""
    waits = machine.planner.waits
    most_mm_s = 1.0 / ((waits.pull_in_s if waits else pull_out_s()[0]) * machine.axes[axis].steps_per_mm)
    if feed_mm_s <= most_mm_s:
        return round(feed_mm_s, 4) or 0.0001, ""
    told = f"the lathe jogs at up to {most_mm_s * 60:.0f} mm/min, or at {rapid_mm_s * 60:.0f}: it takes the slower one"
    return round(most_mm_s, 4), told
