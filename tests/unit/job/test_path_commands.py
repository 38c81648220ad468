# SPDX-License-Identifier: LGPL-2.1-or-later
"""The preview's commands: the program's own moves, thinned above what a window can draw."""

from __future__ import annotations

import numpy as np
import pytest

from CNCStepper.job.path_commands import commands, kept_rows
from CNCStepper.state import Start
from CNCStepper.toolpath import ARC_CCW, ARC_CW, ZX, TableBuilder


def test_each_move_is_one_command_with_centres_from_its_start() -> None:
    table = TableBuilder(Start())
    nan = float("nan")
    table.rapid((nan, nan, 10))
    table.rapid((1, 2, 10))
    table.feed((1, 2, -1), 200)
    table.arc(ARC_CW, (3, 2, -1), (2, 2, 0), 800)
    table.arc(ARC_CCW, (1, 2, -2), (2, 2, 0), 800)
    assert commands(table.toolpath()) == [
        ("G0", {"Z": 10}),
        ("G0", {"X": 1, "Y": 2, "Z": 10}),
        ("G1", {"X": 1, "Y": 2, "Z": -1}),
        ("G2", {"X": 3, "Y": 2, "Z": -1, "I": 1, "J": 0}),
        ("G3", {"X": 1, "Y": 2, "Z": -2, "I": -1, "J": 0}),
    ]


def test_what_the_picture_cannot_show_is_straight() -> None:
    table = TableBuilder(Start.at_zero())
    table.arc(ARC_CW, (2, 0, 0), (1, 0, 0), 800, plane=ZX)
    table.arc(ARC_CW, (2, 0, -9), (1, 0, 0), 800, turns=3)
    assert [name for name, _ in commands(table.toolpath())] == ["G1", "G1"]


def zigzag(passes: int, moves: int) -> TableBuilder:
    table = TableBuilder(Start.at_zero())
    for number in range(passes):
        table.rapid((0, number, 5))
        for step in range(moves):
            table.feed((step, number, -1), 800)
    return table


@pytest.mark.slow
def test_a_long_program_is_thinned_and_keeps_the_ends_of_its_passes() -> None:
    toolpath = zigzag(100, 1000).toolpath()
    drawn = commands(toolpath)
    assert len(drawn) == 20_000
    assert sum(name == "G0" for name, _ in drawn) == 100
    assert {"X": 999.0, "Y": 37.0, "Z": -1.0} in [words for _, words in drawn]
    assert drawn[-1][1] == {"X": 999.0, "Y": 99.0, "Z": -1.0}


def test_an_arc_whose_start_was_thinned_away_is_straight() -> None:
    table = TableBuilder(Start.at_zero())
    for number in range(1000):
        table.arc(ARC_CCW, (number + 1, 0, 0), (number + 0.5, 0, 0), 800)
    names = [name for name, _ in commands(table.toolpath(), most=100)]
    assert set(names[:-1]) == {"G1"}


@pytest.mark.parametrize("count", [1, 99, 100, 101, 199, 1000, 12_345])
@pytest.mark.parametrize("rapids", ["none", "all", "every second", "random"])
def test_never_more_than_asked_for_and_always_the_last(count: int, rapids: str) -> None:
    random = np.random.default_rng(count)
    feed = {"none": np.ones, "all": np.zeros}.get(rapids, lambda n: np.arange(n) % 2)(count)
    kind = (random.integers(0, 2, count) if rapids == "random" else feed).astype(np.uint8)
    rows = kept_rows(kind, 100)
    assert len(rows) == min(count, 100)
    assert rows[-1] == count - 1
    assert (np.diff(rows) > 0).all()
