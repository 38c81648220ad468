# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines of a restart as lines of the program that it goes on with."""

from __future__ import annotations

import json
import random
from itertools import pairwise

import pytest

from CNCStepper.control.journal.replay import FirstProgram, pairs_of

SEED = random.SystemRandom().randrange(10**9)


def first(file_lines: list[int]) -> FirstProgram:
    content = FirstProgram("part.nc", "12ab", tuple(pairs_of(file_lines))).to_content()
    found = FirstProgram.of(json.loads(json.dumps(content)))
    assert found
    return found


def test_lines_count_on_from_where_the_restart_enters():
    found = first([0, 0, 0, 12, 13, 14])
    assert found.pairs == [[4, 12]] and not found.goes_back
    assert [found.line(line) for line in (1, 3, 4, 6)] == [12, 12, 12, 14]


def test_a_restart_from_the_first_line_has_its_pair_too():
    assert first([1, 2, 3]).line(3) == 3


def test_loops_written_out_are_told_apart():
    found = first([0, 4, 5, 4, 5, 6])
    assert [found.line(line) for line in range(2, 7)] == [4, 5, 4, 5, 6] and found.goes_back
    assert not first([0, 4, 7, 8, 20]).goes_back


def test_every_line_of_any_restart_is_found():
    print(f"seed {SEED}")
    pick = random.Random(SEED)
    for _ in range(200):
        file_lines = [0] * pick.randint(0, 5) + [pick.randint(1, 9) for _ in range(pick.randint(1, 40))]
        found = first(file_lines)
        own = [line for line in file_lines if line]
        assert [found.line(here) for here, line in enumerate(file_lines, 1) if line] == own, file_lines
        goes_back = any(later < earlier + 1 for earlier, later in pairwise(own))
        assert found.goes_back == goes_back, file_lines


@pytest.mark.parametrize("content", [{}, None])
def test_a_job_that_is_no_restart_has_none(content):
    assert FirstProgram.of(content) is None
