# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a job's run asks of a journal, and the one that keeps none."""

from __future__ import annotations

import sys
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

    def keep(self, sent: int, acknowledged: int, is_idle: bool) -> list[str]:
        """Write due records, and return warnings for the operator. is_idle: acknowledged lines are cut."""

    def note_zero(self, found: ControllerInfo, sent: int) -> None:
        """Record the machine's state at a pause after which all lines before `sent` (from 0) are cut.

        Where its work zero is another one now, no line goes out before that is on the disk.
        """

    def holds(self, sent: int) -> bool:
        """Return whether the job must be held: no further line can be put on the disk."""

    def mark_uncertain(self, line: int) -> None:
        """Learn that a line (from 0) or one after it was cut otherwise than the program says: none is finished."""

    def end(self, outcome: Outcome) -> list[str]:
        """Write how the job ended, and return warnings for the operator."""


def check_not_held(journal: ActiveJournal, sent: int) -> None:
    """Refuse to go on with a job of which no further line can be put on the disk; raises JobError.

    The machine would move for a moment and be held again.
    """
    if journal.holds(sent):
        raise JobError(
            "journal-unwritable",
            "the journal of the job cannot be written",
            advice="make room on its disk, and resume when it is said to be written again",
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
