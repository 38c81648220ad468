# SPDX-License-Identifier: LGPL-2.1-or-later
"""The last report of a driver as a status snapshot."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from CNCStepper.control.protocol.grbl.driver import Grbl, Received
from CNCStepper.control.protocol.grbl.status_reports import Damaged, Feedback, Unknown
from CNCStepper.control.session.status import SenderStatus
from CNCStepper.errors import Text

HOMING = 22  # the setting that switches homing on


def status_snapshot(driver: Grbl | None, phase: str, message: str = "") -> SenderStatus:
    """Return the present status; None is for a machine not connected yet."""
    if driver is None or driver.status is None:
        return SenderStatus(phase=phase, message=message)
    seen = driver.status
    return SenderStatus(
        phase=phase,
        message=message,
        machine_state=seen.name,
        mpos_mm=driver.mpos_mm,
        wpos_mm=driver.wpos_mm,
        feed_mm_min=driver.feed_mm_min,
        spindle_rpm=seen.spindle,
        overrides=driver.overrides,
        outputs=driver.outputs,
        buffer=seen.buffer,
        pins=seen.pins,
        port_inputs=seen.port_inputs,
        port_outputs=seen.port_outputs,
        cannot=tuple(sorted(driver.cannot)),
        homing=bool(driver.settings[HOMING]) if HOMING in driver.settings else None,
    )


def forward_messages(received: Iterable[Received], tell: Callable[[str, str], None]) -> None:
    """Pass on the controller's own messages; impossible ones become warnings."""
    for report in received:
        if isinstance(report, Feedback) and report.tag in ("MSG", "echo"):
            tell("message", report.text)
        elif isinstance(report, Damaged):
            tell(
                "warning",
                Text("a report of the controller is damaged and was not believed: {report}", report=report.text),
            )
        elif isinstance(report, Unknown):
            tell("warning", Text("the controller reported: {report}", report=report.text))
