# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bringing a machine to rest: hold, wait for standstill, then reset, so that outputs go off and no step is lost.

running --!--> Hold:1 (slowing down) ---> Hold:0 --0x18--> greeting, Idle    position kept
                    `- too late, or another state ------>  ALARM:3 or so     position lost
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager

from CNCStepper.control.protocol.grbl.driver import HOLD, Grbl, Received
from CNCStepper.control.protocol.grbl.readiness import CHECK
from CNCStepper.control.protocol.grbl.status_reports import Alarm, Greeting, Status
from CNCStepper.control.protocol.grbl.timeouts import Timing

RESETS = 3  # one may be lost on its way, and then the outputs are still on
MOST_HEARD = 1000  # alarms and greetings of a flood
SLOWING = ("Hold", "Door", "Jog")  # states of a machine before it is at rest
AT_REST = {("Hold", 0), ("Door", 0), ("Door", 1), ("Idle", None), ("Tool", None), (CHECK, None)}


class _Slowing:
    """A machine after `!`: `is_over` once waiting for its standstill is of no use."""

    def __init__(self, driver: Grbl, timing: Timing):
        self._driver = driver
        self._timing = timing
        self._asked_s = self._heard_s = self._moved_s = driver.clock()
        self._seen: object = None

    def is_over(self) -> bool:
        """Return whether the machine is silent, does not move while it reports deceleration, or does not slow down."""
        driver, now_s = self._driver, self._driver.clock()
        if driver.status is not self._seen and driver.status_asked_s > self._asked_s:
            self._take(now_s)
        silent_s, still_s = now_s - self._heard_s, now_s - self._moved_s
        return silent_s > self._timing.silent_s or still_s > self._timing.still_s

    def is_at_rest(self) -> bool:
        """Return whether the machine is at rest, by a status asked for since."""
        status, fresh = self._driver.status, self._driver.status_asked_s > self._asked_s
        return fresh and status is not None and (status.state, status.substate) in AT_REST

    def _take(self, now_s: float) -> None:
        status = self._driver.status
        assert status
        before, self._seen, self._heard_s = self._seen, status, now_s
        if status.state not in SLOWING:  # the `!` was lost on its way, or is refused
            self._driver.realtime(HOLD)
        elif not isinstance(before, Status) or (before.mpos, before.wpos) != (status.mpos, status.wpos):
            self._moved_s = now_s


def hold_and_reset(driver: Grbl, timing: Timing) -> bool:
    """Stop the machine and switch its outputs off; return whether its position is kept.

    Raises LinkError when the link breaks meanwhile: then nothing is known.
    """
    heard: list[Received] = []
    slowing = _Slowing(driver, timing)
    driver.realtime(HOLD)
    with _stopping(driver):
        _wait(
            driver,
            timing.hold_s,
            timing,
            heard,
            lambda: slowing.is_at_rest() or _disturbed(heard) or slowing.is_over(),
        )
    at_rest = slowing.is_at_rest() or _disturbed(heard)
    return reset(driver, timing, heard) and at_rest


def reset(driver: Grbl, timing: Timing, heard: list[Received] | None = None) -> bool:
    """Reset at once; return whether the controller comes back with its position kept.

    heard: the text received since the error; an alarm or a greeting in it counts.
    """
    heard = [] if heard is None else heard
    before, within_s = _greetings(heard), min(timing.reset_s, timing.wake_s)
    with _stopping(driver):
        resets = next((count for count in range(1, RESETS + 1) if _comes_back(driver, within_s, timing, heard)), 0)
        back_s = driver.clock()
        if not resets or not _wait(driver, within_s, timing, heard, lambda: driver.status_asked_s > back_s):
            return False
    alarms = [report.code for report in heard if isinstance(report, Alarm)]
    locked = driver.status is not None and driver.status.state in ("Alarm", "Sleep")
    kept = all(driver.firmware.alarm(code).position_kept for code in alarms)
    restarted = before > 0 or _greetings(heard) > resets  # once more than requested
    return not restarted and bool(alarms or not locked) and kept


def _comes_back(driver: Grbl, limit_s: float, timing: Timing, heard: list[Received]) -> bool:
    """Reset, and return whether a greeting follows."""
    before = _greetings(heard)
    driver.reset()
    return _wait(driver, limit_s, timing, heard, lambda: _greetings(heard) > before)


@contextmanager
def _stopping(driver: Grbl) -> Iterator[None]:
    """Let noise, floods and stray answers pass: they have been said, or do not matter any more."""
    before, driver.is_stopping = driver.is_stopping, True
    try:
        yield
    finally:
        driver.is_stopping = before


def _disturbed(heard: list[Received]) -> bool:
    return any(isinstance(report, (Alarm, Greeting)) for report in heard)


def _greetings(heard: list[Received]) -> int:
    return sum(isinstance(report, Greeting) for report in heard)


def _wait(driver: Grbl, limit_s: float, timing: Timing, heard: list[Received], reached: Callable[[], bool]) -> bool:
    """Ask and listen until `reached` or the time is over; return whether it was reached."""
    begin_s = asked_s = driver.clock()
    driver.ask_status()
    while True:
        told = [report for report in driver.receive(timing.quick_poll_s) if isinstance(report, (Alarm, Greeting))]
        heard += told[: MOST_HEARD - len(heard)]
        if reached():
            return True
        if driver.clock() - begin_s > limit_s:
            return False
        if driver.clock() - asked_s >= timing.quick_poll_s:
            driver.ask_status()
            asked_s = driver.clock()
