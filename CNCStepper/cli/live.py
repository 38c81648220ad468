# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a terminal says of a moment of a job, beside its progress bar."""

from __future__ import annotations

from datetime import timedelta

from CNCStepper.control.grbl_report import Vector
from CNCStepper.control.outcome import SenderStatus

AXES = "XYZABC"


def live(status: SenderStatus) -> str:
    """Return the line done and sent, both positions, speeds, buffer, overrides, outputs and the time still to go.

    What the controller has not reported is left out.
    """
    parts = []
    if status.remaining_s is not None:
        parts.append(f"{timedelta(seconds=round(status.remaining_s))} to go")
    if status.file_line_sent:
        parts.append(f"line {status.file_line}, sent {status.file_line_sent}")
    parts += [f"{name} {_position(mm)}" for name, mm in (("work", status.wpos_mm), ("machine", status.mpos_mm)) if mm]
    if status.feed_mm_min is not None:
        parts.append(f"F{status.feed_mm_min:.0f} S{status.spindle_rpm or 0:.0f}")
    if status.buffer:
        parts.append("free {} blocks {} bytes".format(*status.buffer))
    if status.overrides:
        parts.append("/".join(map(str, status.overrides)) + " %" + (f" {status.outputs}" if status.outputs else ""))
    return "  ".join(parts)


def _position(position_mm: Vector) -> str:
    return " ".join(f"{axis}{value:.3f}" for axis, value in zip(AXES, position_mm, strict=False))
