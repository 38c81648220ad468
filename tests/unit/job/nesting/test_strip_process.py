# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the time of a strip is divided: as spyrrow alone divides it, and never more than there is."""

from __future__ import annotations

import pytest
import spyrrow

from CNCStepper.job.nesting.strip_process import LATE_S, phases_s
from CNCStepper.nesting.nest import STRIP_LAST_SHARE


@pytest.mark.parametrize("time_s", [10, 30, 60, 600])
def test_spyrrow_s_own_phases_are_asked_for(time_s: int) -> None:
    alone = spyrrow.StripPackingConfig(early_termination=False, total_computation_time=time_s)
    assert phases_s(time_s) == (alone.exploration_time.total_seconds(), alone.compression_time.total_seconds())


def test_a_minute_of_nest_explores_as_long_as_a_minute_of_spyrrow_alone() -> None:
    left_s = 60.0 * (1.0 - STRIP_LAST_SHARE) - LATE_S
    assert phases_s(left_s)[0] == phases_s(60.0)[0]


@pytest.mark.parametrize("time_s", [2.0, 2.9, 5.7, 11.3, 59.1])
def test_both_phases_end_within_their_time(time_s: float) -> None:
    explore_s, compress_s = phases_s(time_s)
    assert explore_s >= 1 and compress_s >= 1 and time_s - 1.0 < explore_s + compress_s <= time_s
