# SPDX-License-Identifier: LGPL-2.1-or-later
"""Steps through a program's time by move or by line: from any moment to the next end of one, and back."""

from __future__ import annotations

import numpy as np


def end_after(ends_s: np.ndarray, time_s: float) -> float:
    """Return the first of the rising `ends_s` that is later than a moment, else the last; 0 where there is none."""
    place = int(np.searchsorted(ends_s, time_s, side="right"))
    return float(ends_s[min(place, len(ends_s) - 1)]) if len(ends_s) else 0.0


def end_before(ends_s: np.ndarray, time_s: float) -> float:
    """Return the last of the rising `ends_s` that is earlier than a moment, else 0, the begin."""
    place = int(np.searchsorted(ends_s, time_s, side="left"))
    return float(ends_s[place - 1]) if place else 0.0


def ends_of_lines_s(ends_s: np.ndarray, lines: np.ndarray) -> np.ndarray:
    """Return when each line is done, from the ends and the lines of all moves in the order in which they are run."""
    return ends_s[np.r_[lines[1:] != lines[:-1], True]] if len(lines) else ends_s
