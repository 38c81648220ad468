# SPDX-License-Identifier: LGPL-2.1-or-later
"""Homes a machine after connecting, before its job: a board that restarts when its port is opened loses its position.

grbl's link has no checksum: `$H` may arrive as `$X`, which unlocks, as `$I`, or as an empty line. All of these are
answered `ok`, and nothing was homed; but at once, while a homing backs off its switches twice at least.
"""

from __future__ import annotations

from contextlib import suppress
from dataclasses import replace

from CNCStepper.control.protocol.grbl.connect import ask, discard_half_line, wake_up
from CNCStepper.control.protocol.grbl.driver import RESET, Grbl
from CNCStepper.control.protocol.grbl.readiness import check_state
from CNCStepper.control.protocol.grbl.timeouts import Timing
from CNCStepper.errors import LinkError, MachineRefusal

HOME = "$H"
NOT_ENABLED = "-error-5"  # the end of that refusal's code
SHORTEST_S = 0.3  # of a homing: of four debounced switches and two ways back from them


def home(driver: Grbl, timing: Timing) -> None:
    """Let the machine find its own zero and wait for it; whatever ends that otherwise stops the axes.

    Raises MachineRefusal where the machine is busy, cannot home, or has not found its switches, LinkError when it is
    silent, or reports the end of homing too early.
    """
    if driver.status and driver.status.state != "Alarm":
        check_state(driver.status)
    discard_half_line(driver, timing)
    driver.status = None  # homing that is stopped here leaves the position unknown
    is_home = False
    try:
        begin_s = driver.clock()
        ask(driver, HOME, replace(timing, answer_s=timing.homing_s))
        check_took(driver.clock() - begin_s)
        is_home = True
    finally:
        if not is_home:
            with suppress(LinkError):
                driver.realtime(RESET)
    driver.status = None
    wake_up(driver, timing)


def has_begun(refusal: MachineRefusal) -> bool:
    """Return whether a machine that `home` refuses may have moved before."""
    return not (refusal.code.endswith(NOT_ENABLED) or refusal.code.startswith("machine-"))


def check_took(seconds: float) -> None:
    """Raise LinkError where `$H` was answered too soon for a homing."""
    if seconds < SHORTEST_S:
        raise LinkError(
            "homing-not-made",
            "the controller reports that it is homed, but too soon: another line than $H reached it",
            value=f"{seconds:.2f} s",
            limit=f"{SHORTEST_S:g} s",
            advice="make sure that the axes are at rest, check cable and grounding, and home again",
        )
