# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes to a port at given moments, by waiting on the processor's clock, and how late each write was.

    due      |     |     |     |        a write is never early, and no nearer to the one before than it is to be, so
    written   |    |       | |   |      that pulses keep their width; lateness of less than a pulse is made good
    stall    |     |                    later than that: a motor has stood still, and would be asked to go on at full
                         ^ the end      rate. Nothing more is written: steps may be lost already

The difference is the jitter. The trial at the start paces pulses of no axis: where one of them comes as late as a
stall, or all together take longer than they should, this computer cannot keep the rate.
"""

from __future__ import annotations

import ctypes
import os
import time
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Protocol

from CNCStepper.errors import LinkError, Text

TRIAL_S = 3.0  # what comes between pulses once a second comes in it
MOST_LONGER = 1.02  # of the time that a trial should take
WRITES_A_PULSE = 2
LEAST_PULSES_PER_S = 500.0  # what is later than a pulse at this rate is a stall in the slowest program
BIN_NS = 1000
BINS = 10_000  # the last one holds all that is later
NS_PER_S = 1_000_000_000
NEVER_NS = 2**62
THROTTLE = Path("/proc/sys/kernel/sched_rt_runtime_us")
UNTHROTTLED = "-1"
FIRST_NICENESS = -20
SHARED_CORES = 2  # of so few none is one process's own
MCL_CURRENT = 1  # of Linux's and macOS's sys/mman.h
ZERO_AGAIN = "move the tool to the work zero and set it there before its next move"
Write = tuple[int, Any, int]  # due in ns from the begin, data, control; of a board: its bytes, their number


@dataclass(frozen=True)
class Jitter:
    """How late the writes were: their number, the time they took, and lateness in microseconds."""

    writes: int
    taken_s: float
    mean_us: float
    p99_us: float
    worst_us: float


def stall_ns(writes_per_s: float) -> int:
    """Return by how much a write may be late: as long as a pulse takes at the fastest rate."""
    return round(WRITES_A_PULSE * NS_PER_S / writes_per_s)


Bins = list[int] | memoryview


class Port(Protocol):
    """Two registers that are written together."""

    def write(self, data: int, control: int) -> None:
        """Set both registers."""

    def close(self) -> None:
        """Let go of the port."""


class Pacer:
    """Writes each when it is due, busy meanwhile, and counts how late each was.

    keep_ns: two writes that are due no farther apart are kept as far apart, however late the first is; they are the
    edges of a pulse. begin_ns: of the clock, from which moments count. bins: BINS + 1 counters of lateness.
    sleep_ns: for a write that is due later than this the process sleeps up to then.
    """

    def __init__(self, port: Port, keep_ns: int, begin_ns: int, bins: Bins, sleep_ns: int = NEVER_NS):
        self._port, self._keep_ns, self._begin_ns, self._sleep_ns = port, keep_ns, begin_ns, sleep_ns
        self._bins = bins
        self._now = begin_ns
        self._before = 0
        self.writes = self.late_ns = self.worst_ns = 0

    def now_ns(self) -> int:
        """Return the time since the begin."""
        return time.perf_counter_ns() - self._begin_ns

    def write(self, writes: Iterable[Write], most_late_ns: int = NEVER_NS) -> None:
        """Write all, none early. Lateness is counted until the port has been written.

        Raises LinkError where it is more than most_late_ns.
        """
        clock, write, bins, begin, keep_ns = (
            time.perf_counter_ns,
            self._port.write,
            self._bins,
            self._begin_ns,
            self._keep_ns,
        )
        now, before, count, total, worst = self._now, self._before, self.writes, self.late_ns, self.worst_ns
        try:
            for at, first, second in writes:
                due = begin + at
                apart = at - before
                earliest = max(due, now + (apart if apart < keep_ns else keep_ns))
                if earliest - now > self._sleep_ns:
                    _sleep_until(earliest - self._sleep_ns)
                while (now := clock()) < earliest:
                    pass
                if now - due <= most_late_ns:
                    write(first, second)
                    now = clock()  # not before: what comes between the clock and the port must not narrow a pulse
                late = now - due
                if late > most_late_ns:
                    raise _stalled(late, most_late_ns, count, at)
                before = at
                count += 1
                total += late
                if late > worst:
                    worst = late
                bins[late // BIN_NS if late < BINS * BIN_NS else BINS] += 1
        finally:
            self._now, self._before, self.writes, self.late_ns, self.worst_ns = now, before, count, total, worst


def jitter_of(writes: int, taken_s: float, late_ns: int, worst_ns: int, bins: Any) -> Jitter:
    """Return the jitter of so many writes that were late by so much together, and at worst."""
    return Jitter(writes, taken_s, late_ns / max(writes, 1) / 1000, _percentile_us(bins, writes), worst_ns / 1000)


def _sleep_until(moment_ns: int) -> None:
    if (left_ns := moment_ns - time.perf_counter_ns()) > 0:
        time.sleep(left_ns / NS_PER_S)


def _stalled(late_ns: int, most_ns: int, written: int, at_ns: int) -> LinkError:
    return LinkError(
        "pulses-late",
        Text(
            "the computer was late with a pulse and stopped after {written} writes, {at_ns:.3f} s from the begin; "
            "spindle, beam and drives are off, and steps may be lost",
            written=written,
            at_ns=at_ns / NS_PER_S,
        ),
        value=Text("{late_ns:.0f} µs late", late_ns=late_ns / 1000),
        limit=f"{most_ns / 1000:.0f} µs",
        advice=Text("{home}, and end other programs before the next try", home=ZERO_AGAIN),
    )


def _percentile_us(bins: Any, count: int) -> float:
    """Return the lateness that 99 of 100 writes do not pass."""
    left = count * 0.99
    for number, some in enumerate(bins):
        left -= some
        if left <= 0:
            return (number + 1) * BIN_NS / 1000
    return 0.0


def come_first() -> bool:
    """Keep other processes from coming between two pulses, as far as this one may; return whether it may.

    Linux takes 50 ms of every second from a busy process of real-time rank, unless its throttle is off: with the
    throttle on, this one asks for the least niceness only.
    """
    try:
        if THROTTLE.read_text("ascii").strip() == UNTHROTTLED:
            os.sched_setscheduler(0, os.SCHED_FIFO, os.sched_param(50))
        else:
            os.setpriority(os.PRIO_PROCESS, 0, FIRST_NICENESS)
    except (AttributeError, OSError):  # no such system, or not allowed: the trial tells whether it does without
        return False
    return True


def own_core() -> bool:
    """Keep this process on one core, the last one, where there are more than two; return whether it is so."""
    try:
        cores = os.sched_getaffinity(0)
        if len(cores) > SHARED_CORES:
            os.sched_setaffinity(0, {max(cores)})
            return True
    except (AttributeError, OSError):  # no such system, or not allowed
        pass
    return False


def lock_memory() -> bool:
    """Keep what this process has in memory now from being written to the disk, as far as it may; return whether it may.

    What it takes later is not locked: where there is a limit, it would get none then.
    """
    try:
        return ctypes.CDLL(None).mlockall(MCL_CURRENT) == 0
    except (AttributeError, OSError, TypeError):  # no such system
        return False
