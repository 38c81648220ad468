# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sees whether the work zero changes while a program runs, and not by it: a pendant, another client, a fault."""

from __future__ import annotations

import re
from collections.abc import Sequence

from CNCStepper.control.protocol.grbl.report import Vector
from CNCStepper.errors import MachineRefusal, Place

SAME_MM = 0.006  # offsets are reported with three decimals, in inches with four
# What may change it: work systems (a program's end goes back to G54), G10, G92, lengths and changes of tools, `$`.
_CHANGES = re.compile(r"G(?:10|5[4-9]|92|43|49)|M0*(?:2|30|6)(?!\d)|T\d|\$", re.IGNORECASE)


class OffsetWatch:
    """Compares each reported offset (WCO), mm, with the one before.

    lines: of the program that runs. offset_mm: at its begin, None where it was not reported yet.
    """

    def __init__(self, lines: Sequence[str], offset_mm: Vector | None = None):
        self._lines = lines
        self._offset_mm = offset_mm
        self._first = 0  # the first line, from 0, that may not have been read when that was reported

    def take(self, offset_mm: Vector | None, acknowledged: int, sent: int) -> tuple[Vector, Vector] | None:
        """Return the offset before and the present one where no line that is on its way can have changed it."""
        if offset_mm is None:
            return None
        before, first = self._offset_mm, self._first
        self._offset_mm, self._first = offset_mm, max(0, acknowledged - 1)
        if before is None or len(before) != len(offset_mm):
            return None
        changed = any(abs(old - new) > SAME_MM for old, new in zip(before, offset_mm, strict=True))
        if not changed or any(_CHANGES.search(self._lines[index].replace(" ", "")) for index in range(first, sent)):
            return None
        return before, offset_mm


def zero_changed(before_mm: Vector, offset_mm: Vector, place: Place | None) -> MachineRefusal:
    """Return what a changed work zero means in the middle of a program."""
    return MachineRefusal(
        "zero-changed",
        "the work zero changed while the program ran, and not by the program",
        value=f"{_words(offset_mm)} mm",
        limit=f"{_words(before_mm)} mm",
        advice="look for a pendant or another program that is connected, set the zero again, then send again",
        place=place,
    )


def _words(vector: Vector) -> str:
    return ",".join(f"{value:.3f}" for value in vector)
