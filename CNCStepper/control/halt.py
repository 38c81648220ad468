# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bringing a machine to rest: hold, wait for standstill, then reset, so that outputs go off and no step is lost.

running --!--> Hold:1 (slowing down) ---> Hold:0 --0x18--> greeting, Idle    position kept
                    `- too late, or another state ------>  ALARM:3 or so     position lost
"""

from __future__ import annotations

from collections.abc import Callable

from CNCStepper.control.grbl import HOLD, Grbl, Received
from CNCStepper.control.grbl_report import Alarm, Greeting
from CNCStepper.control.readiness import CHECK
from CNCStepper.control.timing import Timing

RESETS = 3  # one may be lost on its way, and then the outputs are still on
AT_REST = {("Hold", 0), ("Door", 0), ("Door", 1), ("Idle", None), ("Tool", None), (CHECK, None)}


def hold_and_reset(driver: Grbl, timing: Timing) -> bool:
    """Stop the machine and switch its outputs off; return whether its position is kept.

    Raises LinkError when the link breaks meanwhile: then nothing is known.
    """
    heard: list[Received] = []
    asked_s = driver.clock()
    driver.realtime(HOLD)
    at_rest = _wait(driver, timing, timing.hold_s, heard, lambda: _at_rest(driver, asked_s) or _disturbed(heard))
    return reset(driver, timing, heard) and at_rest


def reset(driver: Grbl, timing: Timing, heard: list[Received] | None = None) -> bool:
    """Reset at once; return whether the controller comes back with its position kept.

    heard: what it said since the trouble began; an alarm or a greeting in it counts.
    """
    heard = [] if heard is None else heard
    before = _greetings(heard)
    resets = next((count for count in range(1, RESETS + 1) if _comes_back(driver, timing, heard)), 0)
    if not resets:
        return False
    back_s = driver.clock()
    if not _wait(driver, timing, timing.wake_s, heard, lambda: driver.status_asked_s > back_s):
        return False
    alarms = [report.code for report in heard if isinstance(report, Alarm)]
    locked = driver.status is not None and driver.status.state in ("Alarm", "Sleep")
    kept = all(driver.firmware.alarm(code).position_kept for code in alarms)
    restarted = before > 0 or _greetings(heard) > resets  # once more than it was told to
    return not restarted and bool(alarms or not locked) and kept


def _comes_back(driver: Grbl, timing: Timing, heard: list[Received]) -> bool:
    """Reset, and return whether a greeting follows."""
    before = _greetings(heard)
    driver.reset()
    return _wait(driver, timing, timing.wake_s, heard, lambda: _greetings(heard) > before)


def _at_rest(driver: Grbl, since_s: float) -> bool:
    status = driver.status
    fresh = driver.status_asked_s > since_s
    return fresh and status is not None and (status.state, status.substate) in AT_REST


def _disturbed(heard: list[Received]) -> bool:
    return any(isinstance(report, (Alarm, Greeting)) for report in heard)


def _greetings(heard: list[Received]) -> int:
    return sum(isinstance(report, Greeting) for report in heard)


def _wait(driver: Grbl, timing: Timing, limit_s: float, heard: list[Received], reached: Callable[[], bool]) -> bool:
    """Ask and listen until `reached` or the time is over; return whether it was reached."""
    begin_s = asked_s = driver.clock()
    driver.ask_status()
    while True:
        heard += driver.receive(timing.quick_poll_s)
        if reached():
            return True
        if driver.clock() - begin_s > limit_s:
            return False
        if driver.clock() - asked_s >= timing.quick_poll_s:
            driver.ask_status()
            asked_s = driver.clock()
