# SPDX-License-Identifier: LGPL-2.1-or-later
"""The states of a table are a sequence like a list, whether they are kept one by one or as feeds."""

from __future__ import annotations

import random
from dataclasses import replace

import numpy as np
import pytest

from CNCStepper.gcode.interpreter.fast_path.compiled_reader import CompiledReader
from CNCStepper.gcode.interpreter.line_interpreter import Interpreter
from CNCStepper.state import FEW, PIECE, Start, State, States

BASES = (State(), State(tool=2, spindle="cw"), State(plane="ZX", feed_mm_min=5.0))


def both(seed: int) -> tuple[States, list[State]]:
    """Return random states and the list that they must equal."""
    chance = random.Random(seed)
    states, expected = States(BASES[:1]), list(BASES[:1])
    for _ in range(30):
        base = chance.choice(BASES)
        if chance.random() < 0.5:
            states.append(base)
            expected.append(base)
        else:
            feeds = [float(chance.randint(1, 9)) for _ in range(chance.choice([0, 1, FEW - 1, FEW, 2 * FEW]))]
            states.append_feeds(base, np.array(feeds))
            expected += [replace(base, feed_mm_min=feed) for feed in feeds]
    return states, expected


@pytest.mark.parametrize("seed", range(5))
def test_states_are_what_a_list_of_them_is(seed: int) -> None:
    states, expected = both(seed)
    assert len(states) == len(expected) and list(states) == expected
    assert states == expected and expected == states and states == both(seed)[0]
    places = [0, -1, -len(expected), *range(0, len(expected), 17)]
    assert [states[place] for place in places] == [expected[place] for place in places]
    assert states[np.int32(len(expected) - 1)] == expected[-1]
    assert states[3:700:5] == expected[3:700:5] and states[-2:] == expected[-2:]
    assert states != expected[:-1] and states != [*expected[:-1], replace(expected[-1], tool=9)]
    for place in (len(expected), -len(expected) - 1):
        with pytest.raises(IndexError):
            states[place]


def test_states_with_the_same_feed_are_one() -> None:
    states = States()
    for first in (1.0, 2.0):
        states.append_feeds(State(feed_mm_min=first), np.tile([7.0, 8.0], FEW))
    assert len({id(state) for state in states}) == 2


def test_a_program_with_a_feed_on_each_line_names_a_state_on_each_row() -> None:
    feeds = [float(n + 2) for n in range(3 * FEW)]
    text = "G21 G90 G17\nG1 X0 F1\n" + "".join(f"G1 X{n} F{feed:.0f}\n" for n, feed in enumerate(feeds)) + "M2\n"
    reader = Interpreter(Start.at_zero(), "linuxcnc")
    assert CompiledReader(reader).read(text.encode())
    path = reader.toolpath()
    assert [path.states[state].feed_mm_min for state in path.table().state] == path.table().feed.tolist() == [1, *feeds]


@pytest.mark.parametrize("seed", range(5))
def test_forgotten_states_are_gone_and_the_others_stay(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("CNCStepper.state.PIECE", 5)
    states, expected = both(seed)
    half = len(expected) // 2
    for before in (3, half, half):  # a second time there is nothing to do
        states.forget(before)
    with pytest.raises(IndexError, match="forgotten"):
        states[0]
    assert states[half:] == expected[half:] and len(states) == len(expected)


def test_nothing_is_left_of_forgotten_states() -> None:
    states, sizes = States(), []
    for count in (5 * PIECE, 50 * PIECE):
        while len(states) < count:
            states.append(State(spindle_rpm=float(len(states))))
        states.forget(count - 1)
        sizes.append(sum(map(len, states._pieces)) + len(states._firsts))
        assert states[count - 1].spindle_rpm == count - 1
    assert sizes[0] == sizes[1] <= PIECE + 1


def test_equal_states_are_held_once(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("CNCStepper.state.MOST_SHARED", 20)
    powers = [float(number % 10) for number in range(100)] + [float(number) for number in range(100)]
    states = States()
    for power in powers:
        states.append(State(spindle_rpm=power))
    assert len({id(state) for state in states[:100]}) == 10
    assert [state.spindle_rpm for state in states] == powers and len(states._shared) <= 21
