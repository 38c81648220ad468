# SPDX-License-Identifier: LGPL-2.1-or-later
"""The planned times for a sender: enough for the remaining time of a program of any length."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from CNCStepper.toolpath import distinct

MOST = 1000
KEPT = 16 * MOST  # lines from which they are chosen, while a program is read


def milestones(lines: ArrayLike, ends_s: ArrayLike) -> list[list[float]]:
    """Return lines of the file in rising order, each with the planned time by its end; MOST of them at most.

    lines, ends_s: of each row of a toolpath, the line that it stands for and its planned end, s. Lines that are run
    again count with their last time. The last row is always among them.
    """
    lines, ends_s = np.asarray(lines), np.asarray(ends_s, float)
    if not len(lines):
        return []
    order = np.argsort(lines, kind="stable")
    risen_s = np.maximum.accumulate(ends_s[order])
    last = np.flatnonzero(np.append(np.diff(lines[order]) != 0, True))  # rows after which another line begins
    kept = last[distinct(np.linspace(0, len(last) - 1, min(len(last), MOST)).round().astype(int))]
    return [[int(line), round(float(end_s), 3)] for line, end_s in zip(lines[order][kept], risen_s[kept], strict=True)]


class Milestones:
    """Those of a program that is planned piece by piece; its lines may be run in any order, and again.

    buckets    lines 1 to w | w+1 to 2w | ...     of each the last line that was run, and when its last run ends
    """

    def __init__(self) -> None:
        self._lines, self._ends_s = np.zeros(KEPT, np.int64), np.zeros(KEPT)
        self._width = 1

    def see(self, lines: np.ndarray, ends_s: np.ndarray) -> None:
        """Take the lines of further rows, and when these end."""
        while len(lines) and lines.max() >= KEPT * self._width:
            self._widen()
        np.maximum.at(self._lines, lines // self._width, lines)
        np.maximum.at(self._ends_s, lines // self._width, ends_s)

    def all(self) -> list[list[float]]:
        """Return them as `milestones` does."""
        used = self._lines > 0
        return milestones(self._lines[used], self._ends_s[used])

    def _widen(self) -> None:
        """Join each two buckets."""
        for column in (self._lines, self._ends_s):
            column[: KEPT // 2], column[KEPT // 2 :] = column.reshape(-1, 2).max(axis=1), 0
        self._width *= 2
