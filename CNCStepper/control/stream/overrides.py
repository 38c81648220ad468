# SPDX-License-Identifier: LGPL-2.1-or-later
"""The real-time bytes of grbl 1.1 that change feed, rapid, spindle speed and coolant while it moves.

Each sets a flag that the controller polls, so that two equal bytes between two polls count once:
a step is one byte.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from CNCStepper.control.operator.zero_and_unlock import fresh_status
from CNCStepper.control.protocol.grbl.driver import Grbl
from CNCStepper.control.protocol.grbl.timeouts import Timing
from CNCStepper.errors import MachineRefusal, Text

NORMAL = (100, 100, 100)  # feed, rapid, spindle: after every reset
TOLD_STATUSES = 30  # within which a controller reports its overrides; grbl does in about every tenth status
BYTES: dict[str, dict[str, bytes]] = {
    "feed": {"reset": b"\x90", "10": b"\x91", "-10": b"\x92", "1": b"\x93", "-1": b"\x94"},
    "rapid": {"100": b"\x95", "50": b"\x96", "25": b"\x97", "reset": b"\x95"},
    "spindle": {"reset": b"\x99", "10": b"\x9a", "-10": b"\x9b", "1": b"\x9c", "-1": b"\x9d", "stop": b"\x9e"},
    "coolant": {"flood": b"\xa0", "mist": b"\xa1"},  # each switches it on, or off
}


def override_byte(kind: str, step: str) -> bytes:
    """Return the byte for one step of a kind of `BYTES`; raises MachineRefusal naming the steps there are.

    step: percent to add ("10", "-1"), of rapid the percentage itself, "reset", "stop" for the spindle
    of a held machine, or of the coolant what is switched on or off.
    """
    try:
        return BYTES[kind][step]
    except KeyError as error:
        there = ", ".join(f"{name} {' '.join(steps)}" for name, steps in BYTES.items())
        what = Text("there is no override {kind} {step}", kind=kind, step=step)
        raise MachineRefusal("override", what, advice=Text("use one of: {there}", there=there)) from error


def restore(driver: Grbl, percents: Sequence[int], timing: Timing) -> None:
    """Bring feed, rapid and spindle of a controller that was just reset to these percentages.

    Raises MachineRefusal where the reports do not confirm them.
    """
    if tuple(percents) == NORMAL:
        return
    for step in _steps(percents):
        for byte in step:
            driver.realtime(byte)
        fresh_status(driver, timing)
    for _ in range(TOLD_STATUSES):
        if driver.overrides == tuple(percents):
            return
        fresh_status(driver, timing)
    told = "/".join(map(str, driver.overrides or ()))
    raise MachineRefusal(
        "overrides-lost",
        "the overrides differ from those before the reset",
        value=f"{told} %",
        limit=f"{'/'.join(map(str, percents))} %",
        advice="set them by hand, then try again",
    )


def _steps(percents: Sequence[int]) -> Iterator[list[bytes]]:
    """Yield the bytes that lead from NORMAL to these percentages; those of one step are all different."""
    columns = [*_changes("feed", percents[0]), [BYTES["rapid"][str(percents[1])]], *_changes("spindle", percents[2])]
    for number in range(max(map(len, columns))):
        yield [column[number] for column in columns if number < len(column)]


def _changes(kind: str, percent: int) -> Iterator[list[bytes]]:
    """Yield the tens and the ones that make a percentage of NORMAL."""
    sign = "-" if percent < 100 else ""
    for size, count in zip((10, 1), divmod(abs(percent - 100), 10), strict=True):
        yield [BYTES[kind][f"{sign}{size}"]] * count
