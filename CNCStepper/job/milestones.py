# SPDX-License-Identifier: LGPL-2.1-or-later
"""The planned times that a sender is given: enough to tell what remains, however long the program is."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

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
    kept = last[np.unique(np.linspace(0, len(last) - 1, min(len(last), MOST)).round().astype(int))]
    return [[int(line), round(float(end_s), 3)] for line, end_s in zip(lines[order][kept], risen_s[kept], strict=True)]


class Milestones:
    """Those of a program that is planned piece by piece and whose lines come in their order."""

    def __init__(self) -> None:
        self._lines, self._ends_s = np.zeros(0, np.int64), np.zeros(0)
        self._every, self._seen = 1, 0  # of so many lines one is kept; lines so far
        self._last: tuple[int, float] | None = None

    def see(self, lines: np.ndarray, ends_s: np.ndarray) -> None:
        """Take the lines of further rows, and when these end."""
        if not len(lines):
            return
        last = np.flatnonzero(np.append(np.diff(lines) != 0, True))
        kept = last[(-self._seen) % self._every :: self._every]
        self._seen += len(last)
        self._lines, self._ends_s = np.append(self._lines, lines[kept]), np.append(self._ends_s, ends_s[kept])
        self._last = int(lines[-1]), float(ends_s[-1])
        while len(self._lines) > KEPT:
            self._lines, self._ends_s, self._every = self._lines[::2], self._ends_s[::2], 2 * self._every

    def all(self) -> list[list[float]]:
        """Return them as `milestones` does."""
        if self._last is None:
            return []
        return milestones(np.append(self._lines, self._last[0]), np.append(self._ends_s, self._last[1]))
