# SPDX-License-Identifier: LGPL-2.1-or-later
"""Homes a machine that was just met, before its job: what a board forgets when its port is opened it finds anew."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import replace

from CNCStepper.control.connect import ask, discard_half_line, wake_up
from CNCStepper.control.grbl import RESET, Grbl
from CNCStepper.control.timing import Timing
from CNCStepper.errors import LinkError

HOME = "$H"


def home(driver: Grbl, timing: Timing) -> None:
    """Let the machine find its own zero and wait for it; whatever ends that otherwise stops the axes.

    Raises MachineRefusal where the machine cannot home, or has not found its switches, LinkError when it is silent.
    """
    discard_half_line(driver, timing)
    driver.status = None  # whoever stops it here does not know where it stands
    is_home = False
    try:
        ask(driver, HOME, replace(timing, answer_s=timing.homing_s))
        is_home = True
    finally:
        if not is_home:
            with suppress(LinkError):
                driver.realtime(RESET)
    driver.status = None
    wake_up(driver, timing)
