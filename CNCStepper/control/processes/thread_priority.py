# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lets a thread run as soon as it wakes up, as far as the system permits: a hold must not wait for other programs.

A thread that wakes up while other programs keep all cores busy waits until the system looks again who is to run: up to
4 ms on a Linux with 250 ticks a second, and longer with more programs. A hold needs two such wakings, of the thread
that hears of it and of the one that writes it.

    real time    Linux, by root or within `ulimit -r`: before all other programs
    short slice  Linux 6.12 and later, by everybody: it may go before a program that wants a longer slice of the time
    neither      as every other thread
"""

from __future__ import annotations

import os
import platform
import struct
import sys
from typing import Literal

Priority = Literal["real time", "short slice", "neither"]

LEAST_PRIORITY = 1  # of those of real time: before all that is not of real time, behind all that is
SLICE_NS = 100_000  # the shortest that Linux takes
SCHED_SETATTR = {"x86_64": 314, "aarch64": 274, "riscv64": 274}  # the system call, where Python has 64 bits
ATTRIBUTES = "=IIQiIQQQII"  # size, policy, flags, nice, priority, runtime, deadline, period, least and most of a core


def go_first() -> Priority:
    """Let the calling thread go before others and return how; what it starts is not of real time; never fails."""
    if not sys.platform.startswith("linux"):
        return "neither"
    if _takes_real_time():
        return "real time"
    return "short slice" if _takes_short_slice() else "neither"


def _takes_real_time() -> bool:
    """Ask for real time, unless the system would kill a thread for using it long."""
    import resource

    if resource.getrlimit(resource.RLIMIT_RTTIME)[0] != resource.RLIM_INFINITY:
        return False
    try:
        os.sched_setscheduler(0, os.SCHED_RR | os.SCHED_RESET_ON_FORK, os.sched_param(LEAST_PRIORITY))
    except OSError:
        return False
    return True


def _takes_short_slice() -> bool:
    """Ask for a short slice of the processor's time; an older Linux takes the question and changes nothing."""
    import ctypes

    number = SCHED_SETATTR.get(platform.machine())
    if number is None or sys.maxsize < 2**32:  # a 32-bit Python has other numbers
        return False
    nice = os.getpriority(os.PRIO_PROCESS, 0)
    size = struct.calcsize(ATTRIBUTES)
    wanted = struct.pack(ATTRIBUTES, size, os.SCHED_OTHER, 0, nice, 0, SLICE_NS, 0, 0, 0, 0)
    return bool(ctypes.CDLL(None).syscall(number, 0, wanted, 0) == 0)
