# SPDX-License-Identifier: LGPL-2.1-or-later
"""How slow this machine's processor is at the moment: limits of processor time are those of a usual one."""

from __future__ import annotations

import time

ROUNDS = 100_000
USUAL_S = 0.008  # of one core of an EPYC at 2.4 GHz that nobody else uses, Python 3.11
TRIES = 5


def slowness() -> float:
    """Return how many times as long as usual a loop of plain Python takes, 1 where it is quicker.

    A core that others share, on this machine or on its host, takes two or three times as much processor time for the
    same work.
    """
    return max(1.0, sum(_loop_s() for _ in range(TRIES)) / TRIES / USUAL_S)


def _loop_s() -> float:
    begun_s, total = time.thread_time(), 0
    for number in range(ROUNDS):
        total += number * number
    return time.thread_time() - begun_s
