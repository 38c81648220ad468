# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a process that gets no time is told from a computer that slept."""

from __future__ import annotations

from CNCStepper.control.pulses.player_process import MOST_LOOK_S, StallWatch


def test_a_counter_that_stands_is_seen_and_one_that_rises_is_not() -> None:
    watch = StallWatch(1.0)
    assert max(watch.still_s(beat, 10.0 + beat * 0.05) for beat in range(100)) == 0.0
    still_s = [watch.still_s(99, 15.0 + look * 0.05) for look in range(30)]
    assert still_s == sorted(still_s) and still_s[-1] > 1.4


def test_where_both_processes_stood_the_counter_has_time_to_go_on() -> None:
    watch = StallWatch(1.0)
    watch.still_s(5, 10.0)
    assert watch.still_s(5, 4000.0) <= MOST_LOOK_S
    assert watch.still_s(6, 4000.05) == 0.0
