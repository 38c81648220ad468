# SPDX-License-Identifier: LGPL-2.1-or-later
"""Replays a journal: how its job ended, and between which lines.

lines   0 ... finished | first ... last | may_be_sent ... total
        certainly cut  | not certain    | certainly not sent

Which line of the first program a line of its restart is, kept as the pairs of lines from which both count on.

restart    1 ... 9 | 10 11 12 | 13 14 ...      [[10, 812], [13, 809]]: line 11 of the restart is line 813
first      (entry)   812 ...    809 ...        of the first program, and its loop runs 809 again

The program text named by a journal, if its file still holds what was sent.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from pathlib import Path
from typing import Any

from CNCStepper.control.journal.journal_records import Group, Records, read_records
from CNCStepper.control.processes.file_lock import is_locked
from CNCStepper.control.program.certificate import digest_of_text
from CNCStepper.control.session.status import DONE
from CNCStepper.errors import JobError, Place, Text
from CNCStepper.gcode.syntax.text_format import decoded

Pairs = Sequence[Sequence[int]]


@dataclass(frozen=True)
class FirstProgram:
    """The program that a restart continues; file: its whole path, or its name where it is no file."""

    file: str
    sha256: str
    pairs: Pairs

    @classmethod
    def of(cls, content: Mapping[str, Any]) -> FirstProgram | None:
        """Return the one of `to_content`, or None where there is none."""
        return cls(content["file"], content["program_sha256"], content["lines"]) if content else None

    def to_content(self) -> dict[str, Any]:
        """Return it as plain data."""
        return {"file": self.file, "program_sha256": self.sha256, "lines": [list(pair) for pair in self.pairs]}

    def line(self, line: int) -> int:
        """Return which of its lines a line of the restart is; a line of the entry is where the restart begins."""
        here, there = next((pair for pair in reversed(self.pairs) if pair[0] <= line), self.pairs[0])
        return there + max(line - here, 0)

    @property
    def goes_back(self) -> bool:
        """Whether the restart runs some line of it again after later ones, so that its number names no place."""
        return any(next_there < there + here_to - here for (here, there), (here_to, next_there) in pairwise(self.pairs))


def pairs_of(file_lines: Sequence[int]) -> Iterator[tuple[int, int]]:
    """Yield the pairs of a restart. file_lines: the first program's line of each of its lines, 0 for the entry's."""
    before = -1
    for here, there in enumerate(file_lines, 1):
        if there and there != before + 1:
            yield here, int(there)
        before = int(there) if there else -1


FORMAT, VERSION = "CNCStepper journal", 1
RUNNING, KILLED = "running", "killed"


@dataclass(frozen=True)
class JobReplay:
    """One job as its journal has it.

    header: what was known before the first line (see `header.header_of`). group: the last entry. end: how the job
    ended: one of RUNNING, KILLED, "done", "stopped", "failed". why: the words of its outcome. position_known:
    whether the controller's position could be trusted at the end; None for a job that was killed.
    is_end_damaged: nothing is known of the last lines sent, so that any may have been. zero: the work zero that was set
    within the job, as the header has it, and the pause's line of the file; empty: it is the header's.
    """

    path: Path
    header: Mapping[str, Any]
    group: Group
    end: str
    why: str = ""
    position_known: bool | None = None
    faults: tuple[str, ...] = field(default=())
    is_end_damaged: bool = False
    zero: Mapping[str, Any] = field(default_factory=dict)

    @property
    def is_done(self) -> bool:
        """Whether the job was cut to its end."""
        return self.end == DONE

    @property
    def total(self) -> int:
        """How many lines the job has."""
        return int(self.header["lines"])

    @property
    def finished(self) -> int:
        """How many lines are certainly cut."""
        return self.group.finished

    @property
    def may_be_sent(self) -> int:
        """How many lines may have been sent."""
        return self.total if self.is_end_damaged else self.group.may_be_sent

    @property
    def first_line(self) -> int:
        """The file's line of the first that is not certainly cut; 0 when all are."""
        return self.group.first_line

    @property
    def first_program(self) -> FirstProgram | None:
        """The program that was restarted, where the job is a restart."""
        return FirstProgram.of(self.header.get("restart_of", {}))

    @property
    def restarted(self) -> tuple[str, str, int, bool]:
        """What a restart begins from: file, fingerprint, line, and whether that line alone names no place."""
        header, first = self.header, self.first_program
        if first is None:
            return header["file"], header["program_sha256"], self.first_line, header["goes_back"]
        goes_back = header["goes_back"] or first.goes_back
        return first.file, first.sha256, first.line(self.first_line), goes_back

    @property
    def position_kept(self) -> bool:
        """Whether the position was known at the end, and is not lost when the port is opened: it greeted no opening."""
        return self.position_known is True and not self.header.get("greeted", False)

    @property
    def last_line(self) -> int:
        """The file's line of the last that may have been sent; 0 for none."""
        return int(self.header["last_line"]) if self.is_end_damaged else self.group.last_line


def read_replay(path: Path) -> JobReplay:
    """Return the replay of a journal file; raises JobError naming the file when it cannot be read."""
    try:
        is_running = is_locked(path)
        if not path.is_file():  # of a pipe one would wait for the end
            raise _refusal("journal-damaged", "the journal lacks its beginning, or is none", path)
        records = read_records(path.read_bytes())
    except OSError as error:
        raise _refusal(
            "journal-unreadable", Text("the journal cannot be read: {error}", error=error.strerror), path
        ) from error
    try:
        return _story(path, records, is_running)
    except (KeyError, IndexError, TypeError, ValueError) as error:
        raise _refusal("journal-damaged", "the journal lacks its beginning, or is none", path) from error


def _story(path: Path, records: Records, is_running: bool) -> JobReplay:
    header = records.contents[0]
    if (header["format"], header["version"]) != (FORMAT, VERSION):
        raise ValueError(header["format"])
    *_, last = (content for content in records.contents if "group" in content)
    ended = records.contents[-1] if "end" in records.contents[-1] and not records.is_end_damaged else {}
    return JobReplay(
        path,
        header,
        Group.from_content(last),
        ended.get("end", RUNNING if is_running else KILLED),
        ended.get("why", ""),
        ended.get("position_known"),
        records.faults,
        records.is_end_damaged,
        last.get("zero", {}),
    )


def _refusal(code: str, what: str, path: Path) -> JobError:
    return JobError(code, what, advice="look at the machine, and restart the program by hand", place=Place(str(path)))


def text_sent(story: JobReplay, texts: Iterable[str] = ()) -> str | None:
    """Return the text that was sent, found among these texts or in its file; None where neither is it any more."""
    sha256, file = story.header["program_sha256"], Path(story.header["file"])
    if (found := next((text for text in texts if digest_of_text(text) == sha256), None)) is not None:
        return found
    try:
        text = decoded(file.read_bytes())[0]
    except OSError:  # removed, or not readable by this user
        return None
    return text if not sha256 or digest_of_text(text) == sha256 else None
