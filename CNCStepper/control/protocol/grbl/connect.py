# SPDX-License-Identifier: LGPL-2.1-or-later
"""Connects to a controller: waits until it is awake, reads its version and settings, changes nothing."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

from CNCStepper.control.protocol.grbl.driver import REPORT_INCHES, Answered, Grbl, Received
from CNCStepper.control.protocol.grbl.firmware import GRBL, Firmware
from CNCStepper.control.protocol.grbl.readiness import check_state
from CNCStepper.control.protocol.grbl.status_reports import (
    Alarm,
    Feedback,
    Greeting,
    NamedSetting,
    Unknown,
    Vector,
    vector,
)
from CNCStepper.control.protocol.grbl.timeouts import Timing
from CNCStepper.control.transport.link import Link
from CNCStepper.errors import LinkError, MachineRefusal, Text
from CNCStepper.machine.controller_family import OWN
from CNCStepper.safe_text import printable

ASK_AGAIN_S = 0.25
OFFSETS = ("G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3", "G28", "G30", "G92", "TLO")
MODE = re.compile(r"[A-Z](?:[0-9]{1,9}\.?[0-9]{0,9}|\.[0-9]{1,9})")
RESTARTED = "controller-restarted"
OLD_VERSIONS = ("0.", "1.0")


@dataclass(frozen=True)
class ControllerInfo:
    """What answered: firmware, version ("1.1h.20190830"), settings by number, offsets by name, `$G` words.

    greeted: it restarted when the port was opened, so its position counts from where it stood then, and nobody has
    homed it or set its zero since.
    """

    version: str
    firmware: Firmware = GRBL
    settings: dict[int, float] = field(default_factory=dict)
    offsets: dict[str, Vector] = field(default_factory=dict)
    modes: str = ""
    greeted: bool = False


def handshake(driver: Grbl, timing: Timing) -> ControllerInfo:
    """Wake the controller up, refuse it unless it is idle, and read what it is (`$I $$ $# $G`).

    Raises LinkError when no grbl 1.1 answers, MachineRefusal when it is not idle.
    """
    woken = wake_up(driver, timing)
    check_state(driver.status, driver.cannot)
    return learn(driver, timing, has_greeting(woken))


def learn(driver: Grbl, timing: Timing, greeted: bool = False) -> ControllerInfo:
    """Ask a controller that is idle or locked what it is and how it is set."""
    discard_half_line(driver, timing)
    version = _version(driver, ask(driver, "$I", timing))
    ask(driver, "$$", timing)
    learn_units(driver, timing)
    offsets, modes = read_offsets(driver, timing), read_modes(driver, timing)
    return ControllerInfo(version, driver.firmware, dict(driver.settings), offsets, modes, greeted)


def look_again(driver: Grbl, timing: Timing) -> ControllerInfo:
    """Read the offsets and modes of an idle controller, which may have changed since the connection."""
    offsets, modes = read_offsets(driver, timing), read_modes(driver, timing)
    return ControllerInfo("", driver.firmware, dict(driver.settings), offsets, modes)


def offsets_of(driver: Grbl, found: ControllerInfo) -> dict[str, Vector | None]:
    """Return the offsets of `$#` by name, in mm; None while the units are not known."""
    return {name: driver.mm(offset) for name, offset in found.offsets.items()}


def learn_units(driver: Grbl, timing: Timing) -> None:
    """Find out whether a firmware without $13 reports in inches; raises MachineRefusal when that is not shown."""
    question = driver.firmware.inches_question
    if not question or REPORT_INCHES in driver.settings:
        return
    driver.send(question)
    said = {report.text.lower() for report in _answer(driver, timing) if isinstance(report, NamedSetting)}
    if not said & {"true", "false"}:
        raise _units_unknown()
    driver.settings[REPORT_INCHES] = float("true" in said)


def check_units(driver: Grbl) -> None:
    """Refuse a controller whose positions mean nothing, as its $13 was not reported; raises MachineRefusal."""
    if REPORT_INCHES not in driver.settings:
        raise _units_unknown()


def read_offsets(driver: Grbl, timing: Timing) -> dict[str, Vector]:
    """Return the offsets of `$#` by name, in the controller's own units; raises LinkError on a damaged one."""
    said = ask(driver, "$#", timing)
    try:
        _check_whole(said)
        return {report.tag: vector(report.text) for report in _feedback(said) if report.tag in OFFSETS}
    except ValueError as error:
        raise LinkError(
            "link-noise", Text("an offset came damaged: {error}", error=error), advice="check cable and baud rate"
        ) from error


def read_modes(driver: Grbl, timing: Timing) -> str:
    """Return the words of `$G`: "G0 G54 G17 ..."; raises LinkError where they do not come, or come damaged."""
    modes = " ".join(report.text for report in _feedback(ask(driver, "$G", timing)) if report.tag == "GC")
    if not modes or not all(map(MODE.fullmatch, modes.split())):
        raise LinkError(
            "modes-unknown",
            Text("{link} does not report its modes: question or answer was damaged", link=driver.link.name),
            advice="check the cable, and look that the controller is not in check mode ($C leaves it); then send again",
        )
    return modes


def has_greeting(said: Sequence[Received]) -> bool:
    """Return whether received messages hold a greeting."""
    return any(isinstance(report, Greeting) for report in said)


def wake_up(driver: Grbl, timing: Timing, locked: bool = False) -> list[Received]:
    """Send `?` until a status comes and the line is quiet; return all messages.

    Nothing but `?` is sent: a controller that still moves must not be disturbed. An alarm is refused
    unless `locked` says that it may be.
    """
    checked = (lambda driver, received: received) if locked else _checked
    said: list[Received] = []
    end_s = driver.clock() + timing.wake_s
    next_s = driver.clock()
    while driver.status is None:
        if driver.clock() >= next_s:
            driver.ask_status()
            next_s = driver.clock() + ASK_AGAIN_S
        said += checked(driver, driver.receive(ASK_AGAIN_S / 5))
        if driver.clock() > end_s and driver.status is None:
            raise _not_grbl(driver, timing, said)
    while received := driver.receive(timing.quiet_s):
        said += checked(driver, received)
        if driver.clock() > end_s:
            break
    return said


def discard_half_line(driver: Grbl, timing: Timing) -> None:
    """Make a line refused that an earlier sender left unfinished in the controller.

    A `$` at its end makes the whole line invalid, so that nothing of it runs; alone it requests help.
    """
    driver.send("$")
    _answer(driver, timing)


def ask(driver: Grbl, line: str, timing: Timing) -> list[Received]:
    """Send one line alone and return the messages up to its `ok`; an error is a MachineRefusal."""
    driver.send(line)
    said = _answer(driver, timing)
    error = next(report.error for report in said if isinstance(report, Answered))
    if error:
        code = driver.firmware.error(error)
        raise MachineRefusal(
            f"{driver.firmware.key}-error-{error}",
            Text(
                "the controller refused {line}: {meaning} (error:{error})", line=line, meaning=code.meaning, error=error
            ),
            advice=code.advice,
        )
    return said


def alarm_refusal(alarm: Alarm, firmware: Firmware, why: str = "") -> MachineRefusal:
    """Return the refusal for ALARM:n in words; -1 is an alarm without a number.

    why: what the controller said right before it. A CNCStepper controller says so why its output has ended.
    """
    code = firmware.alarm(alarm.code)
    number = str(alarm.code) if alarm.code >= 0 else "?"
    meaning = why if why and firmware.key in OWN else code.meaning
    return MachineRefusal(
        f"{firmware.key}-alarm-{number}",
        Text("{meaning} (ALARM:{number})", meaning=meaning, number=number),
        advice=code.advice,
    )


def restart_refusal(greeting: Greeting) -> MachineRefusal:
    """Return the error of a greeting in the middle of a job."""
    return MachineRefusal(
        RESTARTED,
        "the controller restarted in the middle of the job",
        value=greeting.text,
        advice="check its supply and the reset button; home the machine or set its zero before the next cut",
    )


def _answer(driver: Grbl, timing: Timing) -> list[Received]:
    """Return what was said until the one line under way was answered."""
    driver.flush()
    said: list[Received] = []
    end_s = driver.clock() + timing.answer_s
    while not any(isinstance(report, Answered) for report in said):
        if driver.clock() > end_s:
            line = driver.unanswered[0].text
            raise LinkError(
                "answer-missing",
                Text("{link} does not answer {line}", link=driver.link.name, line=line),
                value=f"{timing.answer_s:g} s",
                advice=_check_controller(
                    driver.link, "check that it is a grbl 1.1 controller and that the baud rate is right"
                ),
            )
        received = _checked(driver, driver.receive(ASK_AGAIN_S / 5))
        if any(isinstance(report, Greeting) for report in received):
            raise LinkError(
                RESTARTED,
                Text("{link} restarted while it was asked", link=driver.link.name),
                advice="check its supply and cable, then send again",
            )
        said += received
    return said


def _checked(driver: Grbl, received: Sequence[Received]) -> Sequence[Received]:
    """Return `received` unless an alarm is in it, which is refused in words."""
    for report in received:
        if isinstance(report, Alarm):
            raise alarm_refusal(report, driver.firmware)
    return received


def _not_grbl(driver: Grbl, timing: Timing, said: list[Received]) -> LinkError:
    heard = "something else than grbl answers at {port}" if said else "nothing answers at {port}"
    return LinkError(
        "not-grbl",
        Text(heard, port=driver.link.name),
        value=f"{timing.wake_s:g} s",
        advice=_check_controller(driver.link, "check power, cable, port and baud rate of the controller"),
    )


def _check_controller(link: Link, advice: str) -> str:
    """Return the advice for a controller with a firmware of its own, or what to do where it is a process of ours."""
    if not link.machine:
        return advice
    return Text(
        "check cable and power of the machine, then connect again: that starts the controller of {machine} anew",
        machine=printable(Path(link.machine).stem, 40),
    )


def _units_unknown() -> MachineRefusal:
    return MachineRefusal(
        "units-unknown",
        "the controller does not report whether it uses mm or inches",
        advice="update its firmware",
    )


def _check_whole(said: Sequence[Received]) -> None:
    """Raise ValueError where a line `[...` has lost its end: an offset that is not read would count as not reported."""
    if broken := [report.text for report in said if isinstance(report, Unknown) and report.text.startswith("[")]:
        raise ValueError(broken[0][:80])


def _feedback(said: Sequence[Received]) -> list[Feedback]:
    return [report for report in said if isinstance(report, Feedback)]


def _version(driver: Grbl, said: Sequence[Received]) -> str:
    version = next((report.text.rstrip(" :") for report in _feedback(said) if report.tag == "VER"), "")
    if version.startswith(OLD_VERSIONS):
        raise LinkError(
            "grbl-too-old",
            Text("{link} runs grbl {version}", link=driver.link.name, version=version),
            limit="1.1",
            advice="update its firmware",
        )
    return version
