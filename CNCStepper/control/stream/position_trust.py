# SPDX-License-Identifier: LGPL-2.1-or-later
"""Position trust: whether the machine's position is known, and which actions it allows.

nothing against it --alarm, greeting, lost link, a job that was killed--> unknown --homed, or all its zeros set--> known

    event                                             trust after it
    connected                                         trust_at_connect: a restart or an alarm loses the position
    link lost, or the sender ends with an error       trust_at_lost_link: the position is lost
    job ended                                         trust_after_job: lost, unless the job's end says that it is kept
    homing under way                                  lost until it is there: AT_HOME
    zeros set                                         trust_at_zero: known when all axes have theirs
    slept                                             trust_after_sleep: the motors had no power
"""

from __future__ import annotations

from typing import NamedTuple

from CNCStepper.control.preflight.checks import counts_from_here
from CNCStepper.control.protocol.grbl.driver import Grbl
from CNCStepper.control.protocol.grbl.firmware import TOOL
from CNCStepper.control.protocol.grbl.motion_interlock import position_unknown
from CNCStepper.control.protocol.grbl.readiness import CHECK

COUNTING = ("Idle", "Run", "Hold", "Jog", "Door", CHECK, TOOL)  # states in which a controller counts its steps
MOTORS_IN_DOUBT = ("Alarm", "Sleep")  # what brought a machine there may have cost steps


class PositionTrust(NamedTuple):
    """What is known of a machine's position.

    position_known: None while nothing speaks for or against it. homed: whether machine positions count from the zero
    that the machine has found itself. counts_from_here: it restarted as it was met, and was neither homed nor zeroed
    since. zeroed: the axes whose zeros were set since the position was lost.
    """

    position_known: bool | None = None
    homed: bool = False
    counts_from_here: bool = False
    zeroed: frozenset[str] = frozenset()


NOTHING_AGAINST = PositionTrust()
LOST = PositionTrust(position_known=False)
AT_HOME = PositionTrust(position_known=True, homed=True)


def trust_at_connect(before: PositionTrust, driver: Grbl, greeted: bool) -> PositionTrust:
    """Return the trust of a machine just connected; an alarm or restart never restores a lost position."""
    if driver.status is not None and driver.status.state in MOTORS_IN_DOUBT:
        return LOST
    if not greeted:
        return before
    was_lost = before.position_known is False and not before.counts_from_here
    return LOST._replace(counts_from_here=not was_lost and counts_from_here(driver))


def trust_at_lost_link() -> PositionTrust:
    """Return the trust after the link to the machine was lost: it may have moved on, or stopped with lost steps."""
    return LOST


def trust_after_job(before: PositionTrust, position_known: bool) -> PositionTrust:
    """Return the trust after a job that moved the machine; the reset at its end does not cost the position.

    position_known: of the job's outcome; False after a lost link, an alarm, a restart or a stop that lost steps.
    """
    return before if position_known else LOST


def trust_at_zero(before: PositionTrust, axes: str, all_axes: str) -> PositionTrust:
    """Return the trust after the zeros of `axes` were set: known once all have theirs since it was lost."""
    zeroed = before.zeroed | set(axes.upper())
    known = True if zeroed == set(all_axes) else before.position_known
    return before._replace(zeroed=zeroed, position_known=known)


def trust_after_sleep(before: PositionTrust) -> PositionTrust:
    """Return the trust after a sleep with unpowered motors: no machine position counts from home any more."""
    return before._replace(homed=False, counts_from_here=False)


def counts_steps(driver: Grbl | None) -> bool:
    """Return whether a controller's last state was one that counts steps; None: never connected."""
    return driver is not None and driver.status is not None and driver.status.state in COUNTING


def is_lost(trust: PositionTrust, restart_counts: bool = False) -> bool:
    """Return whether the position is lost, so that no program may move the machine.

    restart_counts: a machine that was restarted and not moved since may be trusted, where its zero was set in an
    earlier connection (`check_zero_here`). A connection that stays open asks for the zero instead.
    """
    return trust.position_known is False and not (restart_counts and trust.counts_from_here)


def check_program(trust: PositionTrust, restart_counts: bool = False) -> None:
    """Raise MachineRefusal when the position is lost (see `is_lost`)."""
    if is_lost(trust, restart_counts):
        raise position_unknown()
