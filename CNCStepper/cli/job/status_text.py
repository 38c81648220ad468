# SPDX-License-Identifier: LGPL-2.1-or-later
"""The status lines of a job below its progress bar."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from datetime import timedelta

from CNCStepper.control.protocol.grbl.status_reports import Vector
from CNCStepper.control.session.status import SenderStatus

AXES = "XYZABC"
GAP = "  "
OVERRIDES_KNOWN_S = 3.0  # within which grbl reports them: with every 10th status at rest, every 20th in motion
OVERRIDES_CHANGED_S = 1.0  # within which it reports those that have changed


def live(status: SenderStatus, width: int) -> str:
    """Return the time still to go, the line done and sent, speeds, overrides with outputs, buffer and both positions.

    width: of the terminal; as many lines as that takes, broken between two of these. What the controller has not
    reported is left out.
    """
    lines: list[str] = []
    for part in _parts(status):
        if lines and len(lines[-1]) + len(GAP) + len(part) <= width:
            lines[-1] += GAP + part
        else:
            lines.append(part)
    return "\n".join(lines)


def overrides_in_words(status: SenderStatus) -> str:
    """Return the overrides and the outputs that are on, "" where the controller does not report them."""
    if not status.overrides:
        return ""
    return "/".join(map(str, status.overrides)) + " %" + (f" {status.outputs}" if status.outputs else "")


def overrides_known() -> Callable[[SenderStatus], bool]:
    """Return the test that a status tells the overrides at all, passed after OVERRIDES_KNOWN_S too.

    Wait for it before one is changed: the first report would else be taken for the change.
    """
    end_s = time.monotonic() + OVERRIDES_KNOWN_S
    return lambda status: bool(status.overrides) or time.monotonic() > end_s


def overrides_changed(before: SenderStatus) -> Callable[[SenderStatus], bool]:
    """Return the test that a status tells other overrides than `before`, passed after OVERRIDES_CHANGED_S too."""
    end_s = time.monotonic() + OVERRIDES_CHANGED_S
    return lambda status: overrides_in_words(status) != overrides_in_words(before) or time.monotonic() > end_s


def _parts(status: SenderStatus) -> Iterator[str]:
    """Yield the parts of the text, the most important first."""
    if status.remaining_s is not None:
        yield f"{timedelta(seconds=round(status.remaining_s))} to go"
    if status.file_line_sent:
        yield f"line {status.file_line}, sent {status.file_line_sent}"
    if status.feed_mm_min is not None:
        yield f"F{status.feed_mm_min:.0f} S{status.spindle_rpm or 0:.0f}"
    if status.overrides:
        yield overrides_in_words(status)
    if status.buffer:
        yield "free {} blocks {} bytes".format(*status.buffer)
    for name, position_mm in (("work", status.wpos_mm), ("machine", status.mpos_mm)):
        if position_mm:
            yield f"{name} {_position(position_mm)}"


def _position(position_mm: Vector) -> str:
    return " ".join(f"{axis}{value:.3f}" for axis, value in zip(AXES, position_mm, strict=False))
