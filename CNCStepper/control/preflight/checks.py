# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compares a connected machine with its job's proof: settings, work zero, modes, line lengths.

Checks that the controller reads the lines of a job as the proof did: they are sent unchanged.

G90 X40 Y0 F300      a cut at F300 in the language of thesis A, a rapid to grbl that has just begun

The modes that a program takes for granted: it was proven with those of a fresh controller.

    $G                 G1 G54 G17 G20 G91 G94 M3 ... S9000      what an earlier program, or somebody's hand, has left
    program            G90 / X10 / ... G1 ...                   says G90 before it moves, but not G21: 10 inches,
                                                                and no M3 before it cuts: the spindle still turns

A soft reset brings the fresh modes back, but M2 leaves the units, the tool's length and S as they are. The motion is
not among them: what is sent names it (`gcode/wire/wire_text.py`).

The first move of a restart goes straight up to its height; a tool above that height would dive.

{"system": "G54", "z_mm": 5.0, "height_mm": 5.0}    z_mm: of the machine from that system's zero, the tool's length with
                                                    it; height_mm: the same as --height tells it

A controller that restarted when its port was opened: its position is unknown, and a word for its zero seldom counts.

It counts from where it stands: that place is its machine position 0, wherever it was before, while its work offsets are
the stored ones. So the work zero is where it was set only if the tool stands on it and all offsets are 0, as they are
when it was set right after a restart like this one (`cncstepper zero`). That nothing has moved the machine since only a
person can say; whether the numbers fit that word is seen here.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import filterfalse

from CNCStepper.control.program.send_job import SendJob
from CNCStepper.control.program.wire_line import is_move
from CNCStepper.control.protocol.grbl import connect
from CNCStepper.control.protocol.grbl.capabilities import OF_PROGRAMS, reason
from CNCStepper.control.protocol.grbl.connect import ControllerInfo, check_units, offsets_of
from CNCStepper.control.protocol.grbl.driver import Grbl
from CNCStepper.control.protocol.grbl.firmware import (
    BOARD_FIRMWARES,
    PULSE_FIRMWARES,
    Firmware,
    firmware_of_controller,
)
from CNCStepper.control.protocol.grbl.motion_interlock import UNKNOWN
from CNCStepper.control.protocol.grbl.readiness import OFFSET_TOLERANCE_MM, check_offsets, offset_differences
from CNCStepper.control.protocol.grbl.settings import check_settings, differences
from CNCStepper.control.protocol.grbl.status_reports import Vector
from CNCStepper.control.protocol.grbl.timeouts import Timing
from CNCStepper.errors import MachineRefusal, Text, joined, one_of
from CNCStepper.gcode.syntax.words import code_pattern, packed_wire, scanned_codes
from CNCStepper.state import WORK_SYSTEMS


def check_dialect(dialect: str, firmware: Firmware) -> None:
    """Refuse a program that was read in another language than a controller's; raises MachineRefusal.

    dialect: "" is that of a job that nobody has read; its lines are the controller's own.
    """
    if dialect and _without_settings(dialect) not in firmware.dialects:
        what = Text(
            "the program was read as {dialect}: to {firmware} its lines may mean other moves, or nothing",
            dialect=dialect,
            firmware=firmware.name,
        )
        raise _dialect_refusal(dialect, what, firmware)


def check_sendable(dialect: str, controller: str) -> None:
    """Refuse a job for a controller that cannot read its lines, or that takes no lines.

    controller: as the profile names it; "" where there is none. Raises MachineRefusal.
    """
    named = firmware_of_controller(controller)
    if named:
        check_dialect(dialect, named)
    elif not any(_without_settings(dialect) in firmware.dialects for firmware in BOARD_FIRMWARES):
        what = Text(
            "the program was read as {dialect}, which no controller understands that lines are sent to", dialect=dialect
        )
        raise _dialect_refusal(dialect, what, BOARD_FIRMWARES[0])


def _without_settings(dialect: str) -> str:
    """Return the language itself: a feature that a machine lacks is a setting of its dialect."""
    return dialect.partition(":")[0]


def _dialect_refusal(dialect: str, what: str, firmware: Firmware) -> MachineRefusal:
    own = firmware.dialects[0]
    return MachineRefusal(
        "dialect-differs",
        what,
        value=dialect,
        limit=one_of(firmware.dialects),
        advice=Text(
            "write it in the controller's own: cncstepper convert PROGRAM --dialect {dialect} --to {own} -o NEW",
            dialect=dialect,
            own=own,
        ),
    )


FRESH = {
    "G17": ("G17", "G18", "G19"),
    "G21": ("G20", "G21"),
    "G90": ("G90", "G91"),
    "G94": ("G93", "G94", "G95"),
}
SWITCHED = {  # output -> the program's codes for it, and the state to be had without them
    "M3": (("M3", "M4", "M5"), "M5"),
    "M4": (("M3", "M4", "M5"), "M5"),
    "M7": (("M7", "M9"), "M9"),
    "M8": (("M8", "M9"), "M9"),
}
TURNS = {"M3", "M4"}
LENGTH_TOLERANCE_MM = 0.002
_CUT = re.compile(code_pattern("G", r"(?:[1235]|33|38|7[346]|8[1-9])(?:\.[0-9]+)?"))
_USES_MODES = re.compile(r"[XYZIJKRF][-+.0-9]")


def implied_modes(lines: Iterable[str]) -> tuple[str, ...]:
    """Return the fresh modes that wire lines do not name up to the first one with a length or a feed."""
    missing = dict(FRESH)
    for line in lines:
        said = scanned_codes(line)
        missing = {mode: group for mode, group in missing.items() if not said.intersection(group)}
        if _USES_MODES.search(line):
            return tuple(missing)
    return ()


def codes_before_cut(lines: Iterable[str]) -> set[str]:
    """Return the codes of wire lines up to the first that cuts, its own too."""
    said: set[str] = set()
    for line in lines:
        said |= scanned_codes(line)
        if _CUT.search(line):
            break
    return said


def cuts_at_implied_speed(lines: Iterable[str]) -> bool:
    """Return whether wire lines cut with the spindle switched on before any of them names S."""
    turns = False
    for line in lines:
        if "S" in line:
            return False
        turns = bool(TURNS & scanned_codes(line)) or (turns and "M5" not in scanned_codes(line))
        if turns and _CUT.search(line):
            return True
    return False


def mode_differences(modes: str, offsets_mm: Mapping[str, Sequence[float] | None], lines: Sequence[str]) -> list[str]:
    """Return a text on modes of the controller that differ from those that the program assumes.

    modes: the words of `$G`. offsets_mm: by name, as `$#` has them. What is not reported is left out.
    """
    held = modes.split()
    found: list[str] = [
        Text("{word} is in force, wanted {wanted}", word=word, wanted=wanted)
        for wanted in implied_modes(lines)
        for word in held
        if word in FRESH[wanted] and word != wanted
    ]
    found += [
        Text("{word} is in force, wanted {wanted}", word=word, wanted=wanted) for word, wanted in _left_on(held, lines)
    ]
    length = offsets_mm.get("TLO")
    if length and any(abs(value) > LENGTH_TOLERANCE_MM for value in length):
        found.append(Text("a tool length of {length:.3f} mm is in force, wanted none (G49)", length=length[-1]))
    return found


def _left_on(held: Sequence[str], lines: Sequence[str]) -> list[tuple[str, str]]:
    """Return outputs that are on and that the program does not set before it cuts, and the state to be had."""
    on = [word for word in held if word in SWITCHED]
    said = codes_before_cut(lines) if on else set()
    found = [(word, SWITCHED[word][1]) for word in on if not said.intersection(SWITCHED[word][0])]
    speed = next((word for word in held if word.startswith("S") and float(word[1:]) != 0), "")
    return [*found, (speed, "S0")] if speed and cuts_at_implied_speed(lines) else found


def check_modes(found: Sequence[str]) -> None:
    """Refuse a controller on which the program would mean something else; raises MachineRefusal."""
    if found:
        raise MachineRefusal(
            "modes-differ",
            Text("an earlier program has left modes that this one does not set: {modes}", modes=joined("; ", found)),
            advice="send the wanted words by hand or reset the controller, look at the work zero, and send again",
        )


ABOVE_MM = 0.01
HEIGHT_STEP_MM = 0.1  # in which another height is proposed


def check_restart_height(job: SendJob, driver: Grbl, found: ControllerInfo, tell: Callable[[str, str], None]) -> None:
    """Refuse a restart whose first move would go down from the tool's height; raises MachineRefusal.

    Where the machine homes first, the descent from there is only reported, since nobody has moved the tool.
    """
    above_mm = _above_mm(job, driver, found)
    if above_mm <= ABOVE_MM:
        return
    height_mm = job.lift["height_mm"]
    here_mm = math.ceil((height_mm + above_mm) / HEIGHT_STEP_MM - ABOVE_MM) * HEIGHT_STEP_MM
    high, low = f"{height_mm + above_mm:.3f}", f"{height_mm:.3f}"
    if job.home_first:
        tell(
            "warning",
            Text(
                "the restart goes straight down first, from Z {high}, where the machine has homed, to Z {low}",
                high=high,
                low=low,
            ),
        )
        return
    raise MachineRefusal(
        "restart-above",
        Text(
            "the tool is at Z {high}, and the restart first goes straight down to Z {low} as a rapid",
            high=high,
            low=low,
        ),
        advice=Text(
            "jog it down to that height where the way below is free, or restart with the height {here_mm:.1f} "
            "(--height), at which it moves over the place directly",
            here_mm=here_mm,
        ),
    )


def _above_mm(job: SendJob, driver: Grbl, found: ControllerInfo) -> float:
    """Return how far above that height the tool is; minus infinity where that is not known."""
    zero_mm = offsets_of(driver, found).get(job.lift["system"]) if job.lift else None
    if zero_mm is None or driver.mpos_mm is None:
        return -math.inf
    return driver.mpos_mm[2] - zero_mm[2] - float(job.lift["z_mm"])


_SYSTEM = re.compile(code_pattern("G", r"(5[4-8]|59(?:\.[123])?)"))
_MACHINE_PLACE = re.compile(code_pattern("G", "28|30|53"))
WHAT_TO_DO = (
    "home the machine; or move the tool to the work zero, set the zero of all axes there, and send without moving it "
    "in between"
)


def counts_from_here(driver: Grbl) -> bool:
    """Return whether a freshly greeted controller has machine position 0 at its present place."""
    return driver.mpos_mm is not None and _is_zero(driver.mpos_mm)


def check_counts_from_here(driver: Grbl) -> None:
    """Refuse a controller whose reset kept its count: its zero is unknown; raises MachineRefusal."""
    if not counts_from_here(driver):
        raise _restart_refusal("its machine position is not 0", _words(driver.mpos_mm or ()))


def check_zero_here(lines: Iterable[str], driver: Grbl, found: ControllerInfo) -> None:
    """Refuse a program whose work zero was not at the position of the machine's restart; raises MachineRefusal."""
    in_force = next((word for word in found.modes.split() if word in WORK_SYSTEMS), "G54")
    systems = {in_force, *_systems(lines)}
    for name in sorted(systems | {"G92", "TLO"}):
        offset = driver.mm(found.offsets.get(name))
        if offset is None and name in systems:
            raise _restart_refusal(Text("{name} is not reported", name=name), "")
        if offset and not _is_zero(offset):
            raise _restart_refusal(Text("{name} was set before", name=name), _words(offset))


def _systems(lines: Iterable[str]) -> Iterator[str]:
    """Yield the work systems that a program names; raises MachineRefusal where it goes to a place of the machine."""
    for line in filterfalse(is_move, lines):
        plain = packed_wire(line)
        if place := _MACHINE_PLACE.search(plain):
            raise _restart_refusal(
                Text("the program has {place}, which goes by the machine's own zero", place=place[0]), line[:40]
            )
        yield from (f"G{number}" for number in _SYSTEM.findall(plain))


def _is_zero(vector: Vector) -> bool:
    return all(abs(value) <= OFFSET_TOLERANCE_MM for value in vector)


def _words(vector: Vector) -> str:
    return ",".join(f"{value:.3f}" for value in vector)


def _restart_refusal(why: str, value: str) -> MachineRefusal:
    what = Text(
        "the controller restarted when its port was opened, so the machine's position is unknown: {why}", why=why
    )
    return MachineRefusal(UNKNOWN, what, value=value, advice=WHAT_TO_DO)


def check_found(job: SendJob, driver: Grbl, found: ControllerInfo, tell: Callable[[str, str], None]) -> None:
    """Tell every difference as a warning, and refuse those that the job does not allow; raises MachineRefusal.

    A line that is too long for the firmware is refused in any case, as a ProgramError, and so are lines in another
    language than the controller's, a work zero that was lost when it restarted, and positions in unknown units.
    """
    check_dialect(job.dialect, found.firmware)
    check_units(driver)
    check_restart_height(job, driver, found, tell)
    job.check_lengths(found.firmware, driver.window)
    for word in sorted(driver.cannot.intersection(OF_PROGRAMS)):
        tell("warning", reason(word))
    if found.greeted:
        check_zero_here(job.lines, driver, found)
    for number in sorted(set(job.expected) - set(found.settings)):
        tell("warning", Text("the controller does not report ${number}: it was not compared", number=number))
    offsets_mm = offsets_of(driver, found)
    moved = offset_differences(offsets_mm, found.modes, job.work_offsets_mm, job.work_system)
    modes = mode_differences(found.modes, offsets_mm, job.lines)
    for difference in [*differences(found.settings, job.expected), *moved, *modes]:
        tell("warning", str(difference))
    if not job.allow_differences:
        check_settings(found.settings, job.expected)
        check_offsets(moved)
        check_modes(modes)


TRIAL_S = 3.0  # of the pulses that no machine gets


def try_rate(job: SendJob, driver: Grbl, timing: Timing) -> None:
    """Let a controller that makes the pulses on this computer try the job's fastest rate at rest (`$T=RATE`).

    Raises MachineRefusal where it cannot keep it.
    """
    if job.pulses_per_s and driver.firmware in PULSE_FIRMWARES:
        patient = replace(timing, answer_s=timing.answer_s + TRIAL_S)
        connect.ask(driver, f"$T={job.pulses_per_s:.0f}", patient)
