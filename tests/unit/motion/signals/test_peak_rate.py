# SPDX-License-Identifier: LGPL-2.1-or-later
"""The fastest rate of pulses that come in chunks."""

from __future__ import annotations

import numpy as np
import pytest

from CNCStepper.motion.signals.peak_rate import BUSY_PULSES, PeakRate


@pytest.mark.parametrize("size", [1, 7, 10_000])
def test_the_busiest_stretch_is_found_over_chunks_of_any_size(size: int) -> None:
    ticks = np.cumsum(np.r_[np.full(300, 100), np.full(BUSY_PULSES, 10), np.full(300, 90)])
    busiest = PeakRate()
    for first in range(0, len(ticks), size):
        busiest.add(ticks[first : first + size])
    assert busiest.per_s(1000) == 100
    few = PeakRate()
    few.add(np.array([5, 15, 25]))
    assert few.per_s(1000) == 100 and PeakRate().per_s(1000) == 0
