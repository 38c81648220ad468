# SPDX-License-Identifier: LGPL-2.1-or-later
"""The first move of a restart goes straight up to its height; a tool above that height would dive.

{"system": "G54", "z_mm": 5.0, "height_mm": 5.0}    z_mm: of the machine from that system's zero, the tool's length with
                                                    it; height_mm: the same as --height tells it
"""

from __future__ import annotations

import math
from collections.abc import Callable

from CNCStepper.control.program.send_job import SendJob
from CNCStepper.control.protocol.grbl.connect import ControllerInfo, offsets_of
from CNCStepper.control.protocol.grbl.driver import Grbl
from CNCStepper.errors import MachineRefusal, Text

ABOVE_MM = 0.01
HEIGHT_STEP_MM = 0.1  # in which another height is proposed


def check_restart_height(job: SendJob, driver: Grbl, found: ControllerInfo, tell: Callable[[str, str], None]) -> None:
    """Refuse a restart whose first move would go down from the tool's height; raises MachineRefusal.

    Where the machine homes itself first, its way down from there is told only: nobody has moved the tool since.
    """
    above_mm = _above_mm(job, driver, found)
    if above_mm <= ABOVE_MM:
        return
    height_mm = job.lift["height_mm"]
    here_mm = math.ceil((height_mm + above_mm) / HEIGHT_STEP_MM - ABOVE_MM) * HEIGHT_STEP_MM
    high, low = f"{height_mm + above_mm:.3f}", f"{height_mm:.3f}"
    if job.home_first:
        tell(
            "warning",
            Text(
                "the restart goes straight down first, from Z {high}, where the machine has homed, to Z {low}",
                high=high,
                low=low,
            ),
        )
        return
    raise MachineRefusal(
        "restart-above",
        Text(
            "the tool stands at Z {high}, and the restart goes straight down to Z {low} first, as a rapid",
            high=high,
            low=low,
        ),
        advice=Text(
            "jog it down to that height where you see what is below it, or restart with the "
            "height {here_mm:.1f} (--height), from which it goes over the place at once",
            here_mm=here_mm,
        ),
    )


def _above_mm(job: SendJob, driver: Grbl, found: ControllerInfo) -> float:
    """Return how far above that height the machine stands; minus infinity where it is not known."""
    zero_mm = offsets_of(driver, found).get(job.lift["system"]) if job.lift else None
    if zero_mm is None or driver.mpos_mm is None:
        return -math.inf
    return driver.mpos_mm[2] - zero_mm[2] - float(job.lift["z_mm"])
