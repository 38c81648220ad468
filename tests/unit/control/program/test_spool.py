# SPDX-License-Identifier: LGPL-2.1-or-later
"""A job's lines in a file: the same as in memory, whatever is asked for, and never many at once."""

from __future__ import annotations

import os
import sys
import tracemalloc

import pytest
from hypothesis import given
from hypothesis import strategies as st

from CNCStepper.control.program.send_job import SendJob
from CNCStepper.control.program.spool import BLOCK, read_spool, write_spool
from CNCStepper.errors import ProgramError

LINES = [f"G1X{number}Y.5" for number in range(3 * BLOCK + 7)]
NUMBERS = [3 * number + 2 for number in range(len(LINES))]


@pytest.fixture(scope="module")
def spooled(tmp_path_factory):
    path = tmp_path_factory.mktemp("spool ç") / "job.wire"
    left = write_spool(path, SendJob("port", LINES, "part.nc", NUMBERS, baud=9600))
    assert not left.lines and left.baud == 9600
    if os.name == "posix":
        assert path.stat().st_mode & 0o077 == 0
    return read_spool(path, left)


def test_lines_and_their_places_are_the_same(spooled):
    assert list(spooled.lines) == LINES and list(spooled.file_lines) == NUMBERS
    assert len(spooled.lines) == len(LINES) and spooled.lines[5:8] == tuple(LINES[5:8])
    assert spooled.place(2 * BLOCK).line == NUMBERS[2 * BLOCK]
    spooled.check()


@given(places=st.lists(st.integers(-len(LINES), len(LINES) - 1), max_size=20))
def test_any_line_is_found_in_any_order(spooled, places):
    assert [spooled.lines[place] for place in places] == [LINES[place] for place in places]


@pytest.mark.parametrize("place", [len(LINES), -len(LINES) - 1])
def test_no_line_beyond_the_end(spooled, place):
    with pytest.raises(IndexError):
        spooled.lines[place]


def test_lines_without_a_map_are_the_files_own(tmp_path):
    path = tmp_path / "job.wire"
    job = read_spool(path, write_spool(path, SendJob("port", ["", "G1 X1", "é"])))
    assert list(job.lines) == ["", "G1 X1", "é"] and list(job.file_lines) == [1, 2, 3]


def test_line_that_holds_two_is_refused(tmp_path):
    with pytest.raises(ProgramError, match="act as a command"):
        write_spool(tmp_path / "job.wire", SendJob("port", ["G1X1", "G1X2\nM3"]))


def test_empty_job_stays_empty(tmp_path):
    path = tmp_path / "job.wire"
    job = read_spool(path, write_spool(path, SendJob("port", [])))
    assert not job.lines and not len(job.file_lines)


def test_memory_does_not_grow_with_the_program(tmp_path):
    def most_bytes(count: int) -> int:
        path = tmp_path / f"{count}.wire"
        left = write_spool(path, SendJob("port", [LINES[0]] * count))
        tracemalloc.start()
        for _ in read_spool(path, left).lines:
            pass
        most = tracemalloc.get_traced_memory()[1]
        tracemalloc.stop()
        return most

    few, many = most_bytes(10 * BLOCK), most_bytes(40 * BLOCK)
    assert many < few + 30 * 8 + sys.getsizeof(LINES[0]) * BLOCK / 4
