# SPDX-License-Identifier: LGPL-2.1-or-later
"""The peak rate of pulses: the rate of a trial, and the limit by which a stall is detected."""

from __future__ import annotations

import numpy as np

BUSY_PULSES = 32  # over which the fastest rate is taken


class PeakRate:
    """The fastest rate of pulses that come in chunks, over BUSY_PULSES of them."""

    def __init__(self) -> None:
        self._last = np.empty(0, np.int64)  # at most BUSY_PULSES
        self._least: int | None = None  # ticks

    def add(self, ticks: np.ndarray) -> None:
        """Take up the next moments, int64[k], rising."""
        ticks = np.concatenate([self._last, ticks])
        if len(ticks) > BUSY_PULSES:
            least = int((ticks[BUSY_PULSES:] - ticks[:-BUSY_PULSES]).min())
            self._least = least if self._least is None else min(self._least, least)
        self._last = ticks[-BUSY_PULSES:]

    def per_s(self, ticks_per_s: int) -> float:
        """Return how many there are in a second where they are closest; of fewer than that, by all of them."""
        if self._least is not None:
            return BUSY_PULSES * ticks_per_s / self._least
        return (len(self._last) - 1) * ticks_per_s / int(np.ptp(self._last)) if len(self._last) > 1 else 0.0
