# SPDX-License-Identifier: LGPL-2.1-or-later
"""The work zero of a connected machine, from its service's status, as the start state of a proof."""

from __future__ import annotations

from CNCStepper.control.session.status import SenderStatus
from CNCStepper.state import WORK_SYSTEMS, Start


def start_of(status: SenderStatus | None) -> Start | None:
    """Return the start state of a machine, its position left open; None while it is unknown.

    Work offsets are machine coordinates. Only a machine that was homed has these; one that counts from where it was
    switched on, or whose tool length stands in the offset, gives no place on the table.
    """
    if status is None or not status.homed or not status.work_system or not status.work_offsets_mm:
        return None
    offsets_mm = status.work_offsets_mm
    if any(offsets_mm.get("TLO", ())) or status.work_system not in offsets_mm:
        return None
    systems = {name: offsets_mm[name] for name in WORK_SYSTEMS if name in offsets_mm}
    g92_mm = offsets_mm.get("G92", (0.0,) * len(offsets_mm[status.work_system]))
    return Start(work_system=status.work_system, work_offsets_mm=systems, g92_mm=g92_mm, zero_known=True)
