# SPDX-License-Identifier: LGPL-2.1-or-later
"""A journal's bytes: cut off at every length, damaged in every byte, and lines taken out of it."""

from __future__ import annotations

from pathlib import Path

import pytest

from CNCStepper.control.journal.journal_records import Group, read_records, to_line
from CNCStepper.control.journal.replay import FORMAT, KILLED, VERSION, read_replay
from CNCStepper.errors import JobError

HEADER = {"format": FORMAT, "version": VERSION, "lines": 900, "last_line": 901}
GROUPS = [Group(1.5, 64 * k, 50 * k, 30 * k, 30 * k + 2, 64 * k + 1, "Run", (1.0, 2.0, 3.0), None) for k in range(1, 5)]
LINES = [to_line(number, content) for number, content in enumerate([HEADER, *(g.to_content() for g in GROUPS)])]
WHOLE = b"".join(LINES)


def story_of(data: bytes, path: Path):
    path.write_bytes(data)
    return read_replay(path)


def test_what_is_written_is_read_again(tmp_path):
    story = story_of(WHOLE, tmp_path / "ç é.journal")
    assert story.group == GROUPS[-1] and not story.faults and story.end == KILLED
    assert (story.finished, story.may_be_sent, story.first_line, story.last_line) == (120, 256, 122, 257)


def test_every_cut_length_gives_the_records_before_the_cut(tmp_path):
    ends = [sum(map(len, LINES[: count + 1])) for count in range(len(LINES))]
    for length in range(len(WHOLE)):
        whole = sum(end - 1 <= length for end in ends)  # the line end itself may be missing
        if whole < 2:
            with pytest.raises(JobError, match="journal-damaged"):
                story_of(WHOLE[:length], tmp_path / "cut.journal")
            continue
        story = story_of(WHOLE[:length], tmp_path / "cut.journal")
        assert story.group == GROUPS[whole - 2] and not story.faults and not story.is_end_damaged, length
        is_torn = length not in (ends[whole - 1], ends[whole - 1] - 1)
        assert read_records(WHOLE[:length]).is_torn == is_torn, length


@pytest.mark.parametrize("change", [0x01, 0x80, ord("\n")])
def test_a_byte_that_changed_is_told_or_of_no_account(tmp_path, change):
    for place, byte in enumerate(WHOLE):
        damaged = WHOLE[:place] + bytes([byte ^ change]) + WHOLE[place + 1 :]
        try:
            story = story_of(damaged, tmp_path / "damaged.journal")
        except JobError as error:
            assert error.code == "journal-damaged" and place < len(LINES[0]) + len(LINES[1]), place
            continue
        is_last_line_end = place == len(WHOLE) - 1
        assert bool(story.faults) != is_last_line_end, place
        if story.is_end_damaged:
            assert story.may_be_sent == 900 and story.last_line == 901 and story.finished <= 120
        else:
            assert story.group == GROUPS[-1], place


def test_the_damaged_line_is_named(tmp_path):
    damaged = b"".join([*LINES[:2], LINES[2].replace(b"Run", b"Ran"), *LINES[3:]])
    assert story_of(damaged, tmp_path / "one.journal").faults == ("line 3 of the journal is damaged",)


def test_a_line_taken_out_is_missed(tmp_path):
    story = story_of(b"".join([*LINES[:2], *LINES[3:]]), tmp_path / "short.journal")
    assert story.faults == ("line 3 of the journal is not the one that was written there",)
    assert story.group == GROUPS[-1]


@pytest.mark.parametrize("data", [b"", b"\n", b"no journal\n", to_line(0, {"format": "x", "version": 1}), b"\xff" * 99])
def test_what_is_no_journal_is_refused(tmp_path, data):
    with pytest.raises(JobError, match="journal-damaged"):
        story_of(data, tmp_path / "none.journal")


def test_a_journal_that_is_not_there_is_refused(tmp_path):
    with pytest.raises(JobError, match="journal-unreadable"):
        read_replay(tmp_path / "no.journal")
