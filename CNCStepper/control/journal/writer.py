# SPDX-License-Identifier: LGPL-2.1-or-later
"""The journal of a running job: a range of lines is on the disk before the first of it is sent.

    sender's thread    keep ──► entry ──┐                 ┌──► permitted: the range may be sent
    writer's thread                     └─► write, fsync ─┘    or trouble: the disk takes nothing any more

One entry at most is on its way; it also says what was acknowledged and what is certainly cut. A range may be
taken back by a smaller one: lines beyond it are not sent from the moment at which it is asked for.

The first record of a journal: the program, its certificate, the machine and its work zero.

The file of one journal while it is written: locked, its owner's only, every record on the disk before it counts.

How many lines a journal records ahead of the lines sent: never so few that the stream waits.

A slow line after slow ones says nothing of the next, which may be one of many short ones: so never fewer are allowed
than the line can carry while a slow disk writes.
"""

from __future__ import annotations

import operator
import os
import shutil
import sys
import time
from collections.abc import Callable, Mapping
from concurrent.futures import Executor, Future, ThreadPoolExecutor
from contextlib import suppress
from itertools import islice
from pathlib import Path
from typing import Any

from CNCStepper import __version__
from CNCStepper.control.journal.journal_records import Group, to_line
from CNCStepper.control.journal.replay import FORMAT, VERSION
from CNCStepper.control.journal.store import JOURNAL, prune
from CNCStepper.control.processes.file_lock import take_lock_with_retries
from CNCStepper.control.processes.thread_priority import go_first
from CNCStepper.control.program.send_job import SendJob
from CNCStepper.control.protocol.grbl.connect import ControllerInfo, offsets_of
from CNCStepper.control.protocol.grbl.driver import Grbl, Received
from CNCStepper.control.session.files import new_session, sync_folder
from CNCStepper.control.session.status import Outcome
from CNCStepper.control.stream.executed_lines import Capacity, finished_lines, longest_step_mm
from CNCStepper.control.stream.status_snapshot import HOMING
from CNCStepper.control.transport.output_queue import BITS_PER_BYTE
from CNCStepper.control.transport.port_identity import identify
from CNCStepper.errors import JobError, Text


def header_of(job: SendJob, driver: Grbl, found: ControllerInfo) -> dict[str, Any]:
    """Return the first record of a job's journal, as plain data; positions and offsets in mm.

    goes_back: some line of the file is sent again after later ones, so that its number alone names no place.
    made_with, profile: the options of the command line, and the machine's profile; empty where they are not known.
    """
    return {
        "format": FORMAT,
        "version": VERSION,
        "made_by": f"CNCStepper {__version__}",
        "begin": time.strftime("%Y-%m-%d %H:%M:%S"),
        "file": _where(job.file),
        "program_sha256": job.program_sha256,
        "restart_of": dict(job.restart_of),
        "certificate_sha256": job.certificate_sha256,
        "machine": job.machine,
        "profile": job.retrace.get("machine", {}),
        "made_with": dict(job.made_with),
        "lines": len(job.lines),
        "last_line": job.place(len(job.lines) - 1).line,
        "goes_back": any(map(operator.gt, job.file_lines, islice(job.file_lines, 1, None))),
        "port": job.port,
        "port_identity": identify(job.port).to_json(),
        "baud": job.baud,
        "firmware": found.version,
        "greeted": found.greeted,
        "homing": bool(found.settings.get(HOMING)),
        "modes": found.modes,
        "offsets_mm": offsets_of(driver, found),
        "dialect": job.program_dialect or job.dialect,
        "wire_dialect": job.dialect,
        "controller": found.firmware.key,
        "mpos_mm": driver.mpos_mm,
    }


def _where(file: str) -> str:
    """Return the whole path of a program's file, or its name where it is no file (a program within a document)."""
    return str(Path(file).resolve()) if file and Path(file).is_file() else file


class JournalFile:
    """A new journal at `path`; raises OSError when it cannot be made."""

    def __init__(self, path: Path):
        self.path = path
        descriptor = os.open(path, os.O_RDWR | os.O_CREAT | os.O_EXCL | getattr(os, "O_BINARY", 0), 0o600)
        self._file = open(descriptor, "r+b", buffering=0)  # noqa: SIM115 - closed by `close`
        self._count = 0
        self._end = 0  # of the records on the disk
        try:
            take_lock_with_retries(self._file)
            sync_folder(path.parent)
        except OSError:
            self.close()
            path.unlink()
            raise

    def append(self, content: Mapping[str, Any]) -> None:
        """Write one record; when this returns it is on the disk. After an OSError the file is as it was before."""
        line = to_line(self._count, content)
        try:
            self._write(line)
        except OSError:
            with suppress(OSError):  # if this fails, the next record overwrites it
                self._file.truncate(self._end)
            raise
        self._end += len(line)
        self._count += 1

    def close(self) -> None:
        """Close the file, and let its lock go."""
        self._file.close()

    def _write(self, line: bytes) -> None:
        self._file.seek(self._end)
        left = memoryview(line)
        while left:
            left = left[self._file.write(left) or 0 :]
        os.fsync(self._file.fileno())


LEAST, MOST = 16, 8192  # lines, whatever the baud rate
DISK_S = 0.4  # of lines as quick as the line carries them: for half of that a write may take
LINE_BYTES = 12  # of a short line with its end
AHEAD_S = 2.0  # of lines at the present rate
REFILL = 0.5  # of them left: time to write the next
WINDOW_S = 1.0  # over which the rate is taken


def least_lines(baud: int) -> int:
    """Return how many lines are always allowed ahead on a line of so many bits a second."""
    return min(max(round(DISK_S * baud / (BITS_PER_BYTE * LINE_BYTES)), LEAST), MOST)


class WriteAhead:
    """Follows the rate at which lines go out; a disk that was too slow for it once gets twice the time."""

    def __init__(self, now_s: float, baud: int):
        self.lines = self._least = least_lines(baud)
        self._rate = 0.0  # of the window before
        self._sent, self._since_s = 0, now_s

    def is_short(self, sent: int, permitted: int) -> bool:
        """Return whether the next range is due."""
        return permitted - sent <= self.lines * REFILL

    def next_range(self, sent: int, permitted: int, now_s: float) -> int:
        """Return how many lines may be sent in all from now on; called once for each group."""
        least = 2 * self.lines if sent >= permitted else self._least
        self.lines = round(min(max(self._rate_now(sent, now_s) * AHEAD_S, least), MOST))
        return sent + self.lines

    def _rate_now(self, sent: int, now_s: float) -> float:
        """Return lines a second, of this window or of the one before, whichever is more."""
        elapsed_s = now_s - self._since_s
        rate = (sent - self._sent) / max(elapsed_s, WINDOW_S)
        more = max(rate, self._rate)
        if elapsed_s >= WINDOW_S:
            self._rate, self._sent, self._since_s = rate, sent, now_s
        return more


ROOM_BYTES = 10_000_000  # a day's journal
PROGRESS_S = 2.0  # between two entries that permit nothing new
AGAIN_S = 1.0  # until the next try after one that failed
MENDED = "the journal is written again: a job that was held for it can be resumed"


class Journal:
    """The journal of one job, in `folder`; `path` is its file once it has begun.

    executor: writes; one thread of its own when None. clock: in s, for what is due.
    """

    def __init__(self, folder: Path, *, executor: Executor | None = None, clock: Callable[[], float] = time.monotonic):
        self.path: Path | None = None
        self.permitted = 0
        self._folder = folder
        self._executor = executor
        self._clock = clock
        self._capacity = Capacity()
        self._file: JournalFile | None = None
        self._writing: Future[None] | None = None
        self._asked = 0  # permitted once the record that is being written is on the disk
        self._written: Group | None = None
        self._offsets_mm: dict[str, Any] = {}
        self._zero: dict[str, Any] = {}  # a zero that differs from the header's, as a record has it
        self._trouble = ""
        self._due_s = 0.0
        self._finished = 0
        self._doubted = sys.maxsize  # the first line that may have been cut otherwise

    def begin(self, job: SendJob, driver: Grbl, found: ControllerInfo) -> None:
        """Put the job and its first lines on the disk; raises JobError when the disk is full or cannot be written."""
        self._job, self._driver = job, driver
        self._step_mm = longest_step_mm(driver.settings)
        self._ahead = WriteAhead(self._clock(), job.baud)
        first = min(self._ahead.lines, len(job.lines))
        try:
            self._check_room()
            prune(self._folder)
            self.path = new_session(self._folder, JOURNAL)
            self._file = JournalFile(self.path)
            self._offsets_mm = offsets_of(driver, found)
            self._file.append(header_of(job, driver, found))
            self._file.append(self._group(first, 0, 0).to_content())
        except OSError as error:
            self._discard()
            raise self._refusal(error.strerror or str(error)) from error
        self.permitted = first
        self._executor = self._executor or ThreadPoolExecutor(1, "journal", go_first)

    def on_message(self, received: list[Received]) -> None:
        """Take the controller's buffer sizes from its messages."""
        self._capacity.on_message(received)

    def note_made(self, lines: int) -> None:
        """Note that the controller has made the job's first `lines` lines."""
        self._finished = max(self._finished, lines)

    def keep(self, sent: int, acknowledged: int, is_idle: bool) -> list[str]:
        """Write due records, and return warnings for the operator. is_idle: acknowledged lines are cut."""
        told = self._collected()
        if self._writing is None and self._is_due(sent):
            self._finished = max(self._finished, self._certain(acknowledged, is_idle))
            may_be_sent = min(self._ahead.next_range(sent, self.permitted, self._clock()), len(self._job.lines))
            self._put(self._group(may_be_sent, acknowledged, self._finished))
        return told

    def note_zero(self, found: ControllerInfo, sent: int) -> None:
        """Record the machine's state at a pause after which all lines before `sent` (from 0) are cut.

        Where its work zero is another one now, no line goes out before that is on the disk.
        """
        offsets_mm = offsets_of(self._driver, found)
        if offsets_mm == self._offsets_mm:
            return
        self._offsets_mm = offsets_mm
        line = self._job.place(min(sent, len(self._job.lines) - 1)).line
        self._zero = {"zero": {"line": line, "modes": found.modes, "offsets_mm": offsets_mm}}
        self._finished = max(self._finished, sent)
        self.permitted = self._asked = sent  # also of a range that is being written
        self._written, self._due_s = None, self._clock()

    def holds(self, sent: int) -> bool:
        """Return whether the job must be held: no further line can be put on the disk."""
        return bool(self._trouble) and self.permitted <= sent < len(self._job.lines)

    def mark_uncertain(self, line: int) -> None:
        """Learn that a line (from 0) or one after it was cut otherwise than programmed: none is finished."""
        self._doubted = min(self._doubted, line)

    def end(self, outcome: Outcome) -> list[str]:
        """Write how the job ended, and return warnings for the operator."""
        if self._file is None:
            return []
        told = self._collected(wait=True)
        status = outcome.status
        done = len(self._job.lines) if outcome.done else 0
        finished = max(self._finished, done, self._certain(status.acknowledged, False))
        self._finished = min(finished, self._doubted)
        group = self._group(status.sent, status.acknowledged, self._finished)
        end = {"end": outcome.kind, "why": outcome.text, "position_known": outcome.position_known}
        try:
            self._file.append(end | group.to_content() | self._zero)
        except OSError as error:
            told.append(
                Text(
                    "the journal could not be closed ({error}): the job will be listed as killed",
                    error=error.strerror or error,
                )
            )
        self._file.close()
        self._file = None
        if self._executor:
            self._executor.shutdown()
        return told

    # --- due records ---------------------------------------------------------------------------

    def _is_due(self, sent: int) -> bool:
        now_s = self._clock()
        if self._trouble:
            return now_s >= self._due_s
        if self.permitted < len(self._job.lines) and self._ahead.is_short(sent, self.permitted):
            return True
        return now_s >= self._due_s

    def _certain(self, acknowledged: int, is_idle: bool) -> int:
        if is_idle:
            return acknowledged
        try:
            return finished_lines(self._job.lines, acknowledged, self._capacity.moves, self._step_mm)
        except JobError:  # the lines cannot be read any more: what was certain before remains
            return 0

    def _group(self, may_be_sent: int, acknowledged: int, finished: int) -> Group:
        driver, job = self._driver, self._job
        return Group(
            round(time.time(), 3),
            may_be_sent,
            acknowledged,
            finished,
            job.known_line(finished + 1) if finished < len(job.lines) else 0,
            job.known_line(may_be_sent),
            driver.status.name if driver.status else "",
            driver.mpos_mm,
            driver.wpos_mm,
        )

    # --- writing -------------------------------------------------------------------------------

    def _put(self, group: Group) -> None:
        self._due_s = self._clock() + PROGRESS_S
        if self._written and _facts(group) == _facts(self._written):
            return
        assert self._executor and self._file
        self._written = group
        self._asked = group.may_be_sent
        self.permitted = min(self.permitted, self._asked)
        self._writing = self._executor.submit(self._file.append, group.to_content() | self._zero)
        self._writing.add_done_callback(lambda _: self._driver.link.wake())

    def _collected(self, wait: bool = False) -> list[str]:
        """Take the result of a write that has come to its end; return what people must know of it."""
        if self._writing is None or not (wait or self._writing.done()):
            return []
        error, self._writing = self._writing.exception(), None
        if error is None:
            self.permitted = self._asked
            return self._mended()
        if not isinstance(error, OSError):
            raise error
        self._written = None
        self._due_s = self._clock() + AGAIN_S
        return self._broken(error.strerror or str(error))

    def _broken(self, trouble: str) -> list[str]:
        known, self._trouble = self._trouble, trouble
        if known:
            return []
        place = self._job.place(max(self.permitted - 1, 0))
        return [
            Text(
                "the journal cannot be written ({trouble}): the job goes on to {place} and is held "
                "there; make room on the disk of {folder}",
                trouble=trouble,
                place=place,
                folder=self._folder,
            )
        ]

    def _mended(self) -> list[str]:
        known, self._trouble = self._trouble, ""
        return [MENDED] if known else []

    # --- a disk that takes nothing -------------------------------------------------------------

    def _check_room(self) -> None:
        free = shutil.disk_usage(self._folder).free
        if free < ROOM_BYTES:
            raise OSError(None, Text("only {free} kB are free", free=free // 1000))

    def _refusal(self, why: str) -> JobError:
        return JobError(
            "journal-unwritable",
            Text("the journal of the job cannot be written: {why}", why=why),
            advice=Text(
                "make room on the disk of {folder}, and see that you may write there; then send again",
                folder=self._folder,
            ),
        )

    def _discard(self) -> None:
        """Leave nothing of a journal whose job never began."""
        if self._file:
            self._file.close()
            self._file.path.unlink(missing_ok=True)
            self._file = None


def _facts(group: Group) -> tuple[Any, ...]:
    """Return what of a group is worth another entry."""
    return (group.may_be_sent, group.acknowledged, group.finished, group.state, group.mpos_mm)
