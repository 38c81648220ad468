# SPDX-License-Identifier: LGPL-2.1-or-later
"""The debouncer: what bounces, what was held at the begin, and that nothing steady is lost."""

from __future__ import annotations

from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from CNCStepper.control.operator.debounce import Debouncer

DEBOUNCE_S = 0.03


def edges(looks, debounce_s=DEBOUNCE_S):
    """Return (time, level) of each edge for looks (time, level)."""
    contact = Debouncer(debounce_s)
    found = [(now_s, contact.look(level, now_s)) for now_s, level in looks]
    return [(now_s, edge) for now_s, edge in found if edge is not None]


def samples(levels: str, step_s: float = 0.01):
    return [(number * step_s, letter == "1") for number, letter in enumerate(levels)]


def test_press_and_release_are_one_edge_each_however_they_bounce():
    assert [level for _, level in edges(samples("00000" + "1011011111" + "0100000"))] == [True, False]


def test_edge_comes_when_the_level_has_lasted():
    assert edges(samples("00000" + "1111111")) == [(0.08, True)]


def test_glitch_is_no_edge():
    assert edges(samples("000001100000011100000")) == []


def test_button_held_at_the_begin_does_nothing_until_it_was_released():
    assert edges(samples("111111")) == []
    assert [level for _, level in edges(samples("111111" + "00000" + "11111"))] == [False, True]


def test_without_debouncing_every_look_counts():
    assert [level for _, level in edges(samples("0101"), 0.0)] == [True, False, True]
    assert edges(samples("11"), 0.0) == []


@pytest.mark.slow
@given(st.lists(st.tuples(st.booleans(), st.floats(0.001, 0.2)), max_size=60))
def test_edges_alternate_and_each_level_had_lasted(steps):
    looks, now_s = [], 0.0
    for level, wait_s in steps:
        now_s += wait_s
        looks.append((now_s, level))
    found = edges(looks)
    assert all(one[1] != other[1] for one, other in pairwise(found))
    for time_s, level in found:
        recent = [seen for seen_s, seen in looks if time_s - DEBOUNCE_S < seen_s <= time_s]
        assert set(recent) == {level}
