# SPDX-License-Identifier: LGPL-2.1-or-later
"""What costs the trust in a machine's position, and what gives it back."""

from __future__ import annotations

from CNCStepper.control.stream.position_trust import (
    AT_HOME,
    LOST,
    NOTHING_AGAINST,
    is_lost,
    trust_after_job,
    trust_after_sleep,
    trust_at_lost_link,
    trust_at_zero,
)


def test_a_lost_link_loses_the_position_also_of_a_homed_machine() -> None:
    assert trust_at_lost_link() == LOST and is_lost(trust_at_lost_link())
    assert not is_lost(AT_HOME)


def test_a_job_loses_the_position_unless_its_end_says_that_it_is_kept() -> None:
    for before in (AT_HOME, NOTHING_AGAINST, LOST):
        assert trust_after_job(before, position_known=True) == before
        assert trust_after_job(before, position_known=False) == LOST


def test_zeros_of_all_axes_give_a_lost_position_back() -> None:
    some = trust_at_zero(trust_at_zero(LOST, "x", "XYZ"), "Y", "XYZ")
    assert is_lost(some) and some.zeroed == {"X", "Y"}
    whole = trust_at_zero(some, "z", "XYZ")
    assert whole.position_known and not whole.homed
    assert trust_at_lost_link().zeroed == frozenset()


def test_sleep_costs_the_machine_position_only() -> None:
    assert trust_after_sleep(AT_HOME) == AT_HOME._replace(homed=False)
