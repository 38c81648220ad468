# SPDX-License-Identifier: LGPL-2.1-or-later
"""The planned times that go with a job to its sender."""

from __future__ import annotations

import numpy as np

from CNCStepper.job.planned_times import MOST, milestones


def test_short_programs_keep_every_line():
    assert milestones([2, 3, 3, 5], [1.0, 2.0, 2.5, 4.0]) == [[2, 1.0], [3, 2.5], [5, 4.0]]


def test_lines_that_are_run_again_count_with_their_last_time():
    assert milestones([4, 2, 3, 2], [1.0, 2.0, 3.0, 4.0]) == [[2, 4.0], [3, 4.0], [4, 4.0]]


def test_long_programs_keep_few_lines_and_their_end():
    found = milestones(np.arange(1, 100_001), np.arange(1, 100_001) * 0.01)
    assert len(found) == MOST and found[0] == [1, 0.01] and found[-1] == [100_000, 1000.0]


def test_program_without_moves_has_none():
    assert milestones([], []) == []
