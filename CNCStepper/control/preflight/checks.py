# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a machine, as it was just met, is what its job was proven for: settings, work zero, modes, line lengths."""

from __future__ import annotations

from collections.abc import Callable

from CNCStepper.control.preflight.controller_restart import check_zero_here
from CNCStepper.control.preflight.dialect import check_dialect
from CNCStepper.control.preflight.modal_state import check_modes, mode_differences
from CNCStepper.control.preflight.restart_height import check_restart_height
from CNCStepper.control.program.send_job import SendJob
from CNCStepper.control.protocol.grbl.connect import ControllerInfo, check_units, offsets_of
from CNCStepper.control.protocol.grbl.driver import Grbl
from CNCStepper.control.protocol.grbl.readiness import check_offsets, check_settings, differences, offset_differences


def check_found(job: SendJob, driver: Grbl, found: ControllerInfo, tell: Callable[[str, str], None]) -> None:
    """Tell every difference as a warning, and refuse those that the job does not allow; raises MachineRefusal.

    A line that is too long for the firmware is refused in any case, as a ProgramError, and so are lines in another
    language than the controller's, a work zero that was lost when it restarted, and positions in unknown units.
    """
    check_dialect(job.dialect, found.firmware)
    check_units(driver)
    check_restart_height(job, driver, found, tell)
    job.check_lengths(found.firmware, driver.window)
    if found.greeted:
        check_zero_here(job.lines, driver, found)
    for number in sorted(set(job.expected) - set(found.settings)):
        tell("warning", f"the controller does not report ${number}: it was not compared")
    offsets_mm = offsets_of(driver, found)
    moved = offset_differences(offsets_mm, found.modes, job.work_offsets_mm, job.work_system)
    modes = mode_differences(found.modes, offsets_mm, job.lines)
    for difference in [*differences(found.settings, job.expected), *moved, *modes]:
        tell("warning", str(difference))
    if not job.allow_differences:
        check_settings(found.settings, job.expected)
        check_offsets(moved)
        check_modes(modes)
