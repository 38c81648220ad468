# SPDX-License-Identifier: LGPL-2.1-or-later
"""The planned times that a sender is given: enough to tell what remains, however long the program is."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

MOST = 1000


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
