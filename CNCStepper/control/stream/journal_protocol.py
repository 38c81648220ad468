# SPDX-License-Identifier: LGPL-2.1-or-later
"""The interface of a journal for a job's run, and a journal that stores nothing.

The journal of a program while its machine runs a leg: back, forward, or along the rest.
"""

from __future__ import annotations

import sys
from dataclasses import replace
from typing import Protocol

from CNCStepper.control.program.send_job import SendJob
from CNCStepper.control.protocol.grbl.connect import ControllerInfo
from CNCStepper.control.protocol.grbl.driver import Grbl, Received
from CNCStepper.control.session.status import Outcome
from CNCStepper.errors import JobError


class ActiveJournal(Protocol):
    """A journal that has begun, in the hands of the run; nothing here waits for the disk but `end`."""

    @property
    def permitted(self) -> int:
        """How many lines of the job, from its first, may be sent by now."""

    def on_message(self, received: list[Received]) -> None:
        """Take the controller's buffer sizes from its messages."""

    def note_made(self, lines: int) -> None:
        """Note that the controller has made the job's first `lines` lines."""

    def keep(self, sent: int, acknowledged: int, is_idle: bool) -> list[str]:
        """Write due records, and return warnings for the operator. is_idle: acknowledged lines are cut."""

    def note_zero(self, found: ControllerInfo, sent: int) -> None:
        """Record the machine's state at a pause after which all lines before `sent` (from 0) are cut.

        Where its work zero is another one now, no line goes out before that is on the disk.
        """

    def holds(self, sent: int) -> bool:
        """Return whether the job must be held: no further line can be put on the disk."""

    def mark_uncertain(self, line: int) -> None:
        """Note that a line (from 0) or a later one was not cut as the program says: it is not finished."""

    def end(self, outcome: Outcome) -> list[str]:
        """Write how the job ended, and return warnings for the operator."""


def check_not_held(journal: ActiveJournal, sent: int) -> None:
    """Refuse to resume a job whose next lines cannot be put on the disk; raises JobError.

    The machine would move briefly and be held again.
    """
    if journal.holds(sent):
        raise JobError(
            "journal-unwritable",
            "the journal of the job cannot be written",
            advice="free space on its disk, and resume when the journal is written again",
        )


class Journals(ActiveJournal, Protocol):
    """A journal before its job."""

    def begin(self, job: SendJob, driver: Grbl, found: ControllerInfo) -> None:
        """Put the job on the disk, and wait for it; raises JobError when that cannot be done."""


class NoJournal:
    """Permits every line and keeps nothing."""

    permitted = sys.maxsize

    def begin(self, job: SendJob, driver: Grbl, found: ControllerInfo) -> None:
        """Do nothing."""

    def on_message(self, received: list[Received]) -> None:
        """Do nothing."""

    def note_made(self, lines: int) -> None:
        """Do nothing."""

    def keep(self, sent: int, acknowledged: int, is_idle: bool) -> list[str]:
        """Do nothing."""
        return []

    def note_zero(self, found: ControllerInfo, sent: int) -> None:
        """Do nothing."""

    def holds(self, sent: int) -> bool:
        """Return False."""
        return False

    def mark_uncertain(self, line: int) -> None:
        """Do nothing."""

    def end(self, outcome: Outcome) -> list[str]:
        """Do nothing."""
        return []


class LegJournal:
    """Counts the lines of a leg as the program's, where they are its rest; of another leg nothing is written.

    sent, acknowledged: how many of the program's lines, when the leg begins. lines_before: how many lie before those
    of the leg; None when it is not the program's rest.
    """

    def __init__(self, program: ActiveJournal, sent: int, acknowledged: int, lines_before: int | None):
        self.program, self.sent, self.acknowledged = program, sent, acknowledged
        self._lines_before = lines_before

    @classmethod
    def from_now(cls, journal: ActiveJournal, sent: int, acknowledged: int, lines_before: int | None) -> LegJournal:
        """Return the journal of the leg that begins now; `journal` is the program's, or that of the leg before."""
        if isinstance(journal, LegJournal):
            return cls(journal.program, journal.sent, journal.acknowledged, lines_before)
        return cls(journal, sent, acknowledged, lines_before)

    @property
    def permitted(self) -> int:
        """How many lines of the leg may be sent by now."""
        return sys.maxsize if self._lines_before is None else self.program.permitted - self._lines_before

    def on_message(self, received: list[Received]) -> None:
        """Take the controller's buffer sizes from its messages."""
        self.program.on_message(received)

    def note_made(self, lines: int) -> None:
        """Note that the controller has made the leg's first `lines` lines."""
        if self._lines_before is not None:
            self.program.note_made(max(0, self._lines_before + lines))

    def keep(self, sent: int, acknowledged: int, is_idle: bool) -> list[str]:
        """Write due records of the program, and return warnings for the operator."""
        if self._lines_before is None:
            return self.program.keep(self.sent, self.acknowledged, False)
        self.sent = max(0, self._lines_before + sent)
        self.acknowledged = max(0, self._lines_before + acknowledged)
        return self.program.keep(self.sent, self.acknowledged, is_idle)

    def note_zero(self, found: ControllerInfo, sent: int) -> None:
        """Record the machine's state at a pause."""
        self.program.note_zero(found, self.sent if self._lines_before is None else max(0, self._lines_before + sent))

    def holds(self, sent: int) -> bool:
        """Return whether the leg must be held: no further line of the program can be put on the disk."""
        return self._lines_before is not None and self.program.holds(max(0, self._lines_before + sent))

    def mark_uncertain(self, line: int) -> None:
        """Note that a line of the leg, or a later one, was not cut as it says."""
        if self._lines_before is not None:
            self.program.mark_uncertain(max(0, self._lines_before + line))

    def end(self, outcome: Outcome) -> list[str]:
        """Write how the job ended, and return warnings for the operator."""
        status = replace(outcome.status, sent=self.sent, acknowledged=self.acknowledged)
        return self.program.end(outcome if self._lines_before is not None else replace(outcome, status=status))
