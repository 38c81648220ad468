# SPDX-License-Identifier: LGPL-2.1-or-later
"""How long a job still takes."""

from __future__ import annotations

from itertools import pairwise

import pytest

from CNCStepper.control.stream.remaining_time import Remaining

PLAN = ((2, 10.0), (3, 20.0), (5, 30.0), (6, 100.0))


def cut(clock: Remaining, *moments: tuple[str, float, int]) -> Remaining:
    for phase, elapsed_s, line in moments:
        clock.take(phase, elapsed_s, line, line, 6)
    return clock


def test_before_the_first_line_it_is_the_planned_time() -> None:
    clock = cut(Remaining(PLAN), ("running", 0.0, 0))
    assert clock.remaining_s == 100.0 and clock.done == 0.0


def test_a_machine_that_keeps_the_plan_takes_what_is_left_of_it() -> None:
    clock = cut(Remaining(PLAN), ("running", 0.0, 0), ("running", 20.0, 3))
    assert clock.remaining_s == pytest.approx(80.0) and clock.done == pytest.approx(0.2)


def test_a_line_without_a_move_counts_as_the_one_before_it() -> None:
    clock = cut(Remaining(PLAN), ("running", 0.0, 0), ("running", 20.0, 4))
    assert clock.remaining_s == pytest.approx(80.0)


def test_a_slower_machine_takes_longer_by_the_measured_ratio() -> None:
    clock = cut(Remaining(PLAN), ("running", 0.0, 0), ("running", 40.0, 3))
    assert clock.ratio == pytest.approx(2.0) and clock.remaining_s == pytest.approx(160.0)


def test_a_hold_is_not_cutting() -> None:
    clock = cut(Remaining(PLAN), ("running", 0.0, 0), ("running", 20.0, 3), ("held", 500.0, 3))
    clock = cut(clock, ("paused", 900.0, 3), ("running", 900.0, 3))
    assert clock.remaining_s == pytest.approx(80.0)


def test_the_first_moment_of_a_ratio_is_not_trusted() -> None:
    clock = Remaining([[1, 0.5], [2, 100.0]])
    clock.take("running", 0.0, 0, 0, 2)
    clock.take("running", 5.0, 1, 1, 2)  # ten times the plan, but after half a second of it
    assert clock.remaining_s == pytest.approx(99.5 * (0.9 * 1 + 0.1 * 10))


def test_without_planned_times_the_lines_are_counted() -> None:
    clock = Remaining()
    assert clock.remaining_s is None
    clock.take("running", 0.0, 0, 0, 400)
    clock.take("running", 30.0, 90, 100, 400)
    assert clock.done == 0.25 and clock.remaining_s == pytest.approx(90.0)


def test_a_job_that_another_window_began_is_timed_from_its_own_begin() -> None:
    clock = Remaining()
    clock.take("running", 60.0, 90, 100, 400)
    assert clock.remaining_s == pytest.approx(180.0)


def test_a_long_line_under_way_makes_no_machine_slow():
    clock = cut(Remaining(PLAN), ("running", 0.0, 0), ("running", 30.0, 5), ("running", 60.0, 5))
    assert clock.ratio == pytest.approx(1.0)
    assert clock.remaining_s == pytest.approx(40.0)  # 30 of the 70 s of its last line have gone


def test_a_line_that_takes_too_long_takes_no_time_of_the_others():
    clock = cut(Remaining(PLAN), ("running", 0.0, 0), ("running", 10.0, 2), ("running", 99.0, 2))
    assert clock.remaining_s == pytest.approx(80.0)


def test_lines_between_those_of_the_plan_change_no_ratio():
    clock = cut(Remaining(PLAN), ("running", 0.0, 0), ("running", 20.0, 3), ("running", 29.0, 4))
    assert clock.ratio == pytest.approx(1.0) and clock.remaining_s == pytest.approx(71.0)


@pytest.mark.parametrize("pace", [0.8, 1.05, 1.3])
def test_in_steady_cutting_it_never_rises_and_ends_at_nothing(pace: float) -> None:
    plan = [(line, 2.0 * line) for line in range(1, 101)]
    clock, shown = Remaining(plan), []
    for tenth in range(round(2000 * pace) + 1):
        elapsed_s = tenth / 10
        line = min(int(elapsed_s / (2.0 * pace)), 100)
        clock.take("running", elapsed_s, line, line, 100)
        shown.append(clock.remaining_s)
    assert all(later <= before + 1e-9 for before, later in pairwise(shown))
    assert shown[0] == 200.0 and shown[-1] == pytest.approx(0.0, abs=0.5)
    half = shown[len(shown) // 2]
    assert half == pytest.approx(100.0 * pace, rel=0.25)
