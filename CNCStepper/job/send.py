# SPDX-License-Identifier: LGPL-2.1-or-later
"""From wire text to what a sender is given, without a port: the one place where the two meet."""

from __future__ import annotations

from CNCStepper.control.readiness import expected_settings
from CNCStepper.control.send_job import SendJob
from CNCStepper.gcode.prepare import WireText
from CNCStepper.machine.profile import Machine


def send_job(wire: WireText, machine: Machine | None, file: str) -> SendJob:
    """Return the job of sending `wire`, whose port is still to be chosen and whose zero is not confirmed.

    machine: its settings must hold on the controller; None compares nothing.
    """
    return SendJob(
        port="",
        lines=wire.lines,
        file=file,
        file_lines=wire.file_lines.tolist(),
        messages=wire.messages,
        expected=expected_settings(machine) if machine else {},
    )
