# SPDX-License-Identifier: LGPL-2.1-or-later
"""The time limits of a sender, in seconds."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Timing:
    """The waits of one session.

    poll_s: between two `?`. quick_poll_s: the same while holding, stopping and finishing.
    wake_s: a board that was reset by the opening of its port runs its boot loader first.
    quiet_s: silence that ends the chatter after a greeting. answer_s: a line or a `?` without answer.
    silent_s: nothing heard of a machine that is to stop; still_s: it does not get slower. reset_s: from a reset to the
    greeting. So a stop is over within 5 s unless the machine is seen to slow down for longer.
    hold_s: from a feed hold to standstill, on slow axes too. homing_s: a whole homing cycle, in which grbl is silent.
    service_poll_s: between two `?` of a service without a job. alone_s: a service without clients and work ends then.
    """

    poll_s: float = 0.2
    quick_poll_s: float = 0.05
    wake_s: float = 6.0
    quiet_s: float = 0.1
    answer_s: float = 10.0
    silent_s: float = 1.0
    still_s: float = 1.5
    reset_s: float = 0.8
    hold_s: float = 15.0
    homing_s: float = 300.0
    service_poll_s: float = 0.12
    alone_s: float = 10.0
