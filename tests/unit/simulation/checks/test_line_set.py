# SPDX-License-Identifier: LGPL-2.1-or-later
"""The lines of a file that move are counted as a set of them counts."""

from __future__ import annotations

import random

import numpy as np
import pytest

from CNCStepper.simulation.checks import program_report
from CNCStepper.simulation.checks.program_report import LineSet


@pytest.mark.parametrize("seed", range(5))
def test_lines_are_counted_once_in_any_order(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(program_report, "BLOCK", 16)
    chance, lines, expected = random.Random(seed), LineSet(), set[int]()
    assert lines.count() == 0
    for _ in range(20):
        first = chance.randint(0, 3000)
        some = [first + chance.randint(0, 90) for _ in range(chance.choice([0, 1, 40]))]
        lines.add(np.array(some, np.int32))
        expected.update(some)
        assert lines.count() == len(expected - {0})


def test_a_line_takes_a_bit() -> None:
    lines = LineSet()
    lines.add(np.arange(1, 8_000_000, dtype=np.int32))
    assert lines.count() == 7_999_999 and lines._bits.nbytes <= 1_000_001
