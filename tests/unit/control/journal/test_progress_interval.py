# SPDX-License-Identifier: LGPL-2.1-or-later
"""The interval of a killed job as places on its path, and where the machine was last seen beside it."""

from __future__ import annotations

from pathlib import Path

import pytest

from CNCStepper.control.journal.journal_records import Group
from CNCStepper.control.journal.progress_interval import PIECE_LINES, ProgressInterval, progress_interval
from CNCStepper.control.journal.replay import KILLED, JobReplay

TEXT = "(a part)\nG21 G90\nG0 X0 Y0\nG1 X10 F600\nG1 Y10\nG2 X20 Y20 I10 J0\nG1 X30\n"
HEADER = {
    "lines": 6, "last_line": 7, "file": "part.nc", "dialect": "grbl", "modes": "G0 G54 G17 G21 G90 G94 F0",
    "offsets_mm": {"G54": [-100.0, -50.0, -20.0], "G92": [0.0, 0.0, 0.0], "TLO": [0.0]},
    "mpos_mm": [-100.0, -50.0, -20.0],
}  # fmt: skip


def story(finished: int, may_be_sent: int, seen_mm: tuple[float, ...] = (10, 5, 0), zero: dict | None = None, **header):
    """Return the story of a killed job that was last seen at a work position."""
    offset_mm = (zero or HEADER)["offsets_mm"]["G54"]
    mpos_mm = tuple(work + offset for work, offset in zip(seen_mm, offset_mm, strict=True))
    group = Group(1.0, may_be_sent, may_be_sent, finished, 1, 1, "Run", mpos_mm, seen_mm)
    return JobReplay(Path("1.journal"), HEADER | header, group, KILLED, zero=zero or {})


def test_interval_is_told_as_places_with_the_lines_of_the_file():
    found = progress_interval(story(3, 6), TEXT)
    assert found == ProgressInterval(pytest.approx((10, 0, 0)), pytest.approx((30, 20, 0)), 5, 7, 5)
    assert progress_interval(story(0, 2), TEXT).first_line == 2


@pytest.mark.parametrize(
    ("seen_mm", "line"),
    [
        ((10, 0, 0), 4),
        ((10, 9.99, 0), 5),
        ((20 - 10 * 2**-0.5, 10 + 10 * 2**-0.5, 0), 6),
        ((25, 20, 0), 7),
        ((5, 0.5, 0), 0),
        ((25, 20, 5), 0),
        ((5, 0, 0), 4),
    ],
)
def test_machine_is_seen_on_its_way_or_off_it(seen_mm, line):
    assert progress_interval(story(2, 6, seen_mm), TEXT).seen_line == line


def test_zero_that_was_set_within_the_job_counts():
    zero = {"line": 4, "modes": "G1 G54 G17 G21 G90 G94 F600", "offsets_mm": {"G54": [-90.0, -40.0, -15.0]}}
    found = progress_interval(story(3, 6, (10, 5, 0), zero), TEXT)
    assert found.begin_mm == pytest.approx((10, 0, 0)) and found.seen_line == 5


@pytest.mark.parametrize(
    ("told", "text"),
    [
        (story(3, 6, mpos_mm=None), TEXT),
        (story(3, 6, lines=5), TEXT),
        (story(3, 6), "G21\nG1 X[\n"),
        (story(6, 6), TEXT),
        (story(3, 6), TEXT.replace("G1 Y10", "G38.2 Z-1")),
    ],
)
def test_where_the_path_or_the_place_is_not_known_nothing_is_said(told, text):
    assert progress_interval(told, text) is None


def test_what_lies_before_the_interval_is_forgotten_as_it_is_read():
    count = 2 * PIECE_LINES + 10
    text = "G21 G90\nG1 F600\n" + "".join(f"G1 X{number % 7}\n" for number in range(count))
    found = progress_interval(story(count - 5, count, (3.5, 0, 0), lines=count + 2), text)
    assert found.begin_mm == pytest.approx(((count - 8) % 7, 0, 0)) and found.seen_line
