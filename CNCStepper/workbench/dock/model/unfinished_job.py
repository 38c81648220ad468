# SPDX-License-Identifier: LGPL-2.1-or-later
"""A job that did not end, from its journal; no Qt, and no call blocks.

A thread looks whether there is one, and whoever asked looks at `poll` now and then; what its path says takes a process
of its own (`workers/unfinished_job.py`).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from concurrent.futures import Future
from typing import Any

from CNCStepper.control.journal.replay import KILLED
from CNCStepper.control.processes.background_thread import in_background
from CNCStepper.control.program.certificate import digest_of_text
from CNCStepper.control.session.status import DONE, FAILED, STOPPED
from CNCStepper.workbench.dock.model.button_states import ControllerSnapshot
from CNCStepper.workbench.services.translation import later

NAMES = {
    "program": later("Program"),
    "goes on with": later("Goes on with"),
    "machine": later("Machine"),
    KILLED: later("Killed"),
    STOPPED: later("Stopped"),
    FAILED: later("Failed"),
    DONE: later("Done"),
    "damaged": later("Damaged"),
    "outputs": later("Outputs"),
    "certain": later("Certain"),
    "not certain": later("Not certain"),
    "not sent": later("Not sent"),
    "on the path": later("On the path"),
    "last seen": later("Last seen"),
    "work zero": later("Work zero"),
    "position": later("Position"),
    "restart": later("Restart"),
}
Found = Callable[[Any], None]


class Reading:
    """At most one question at a time; the newest counts."""

    def __init__(self) -> None:
        self._answer: Future[Any] | None = None
        self._found: Found | None = None

    def ask(self, find: Callable[[], Any], found: Found) -> None:
        """Let a thread find something; `poll` hands it to `found`."""
        self._answer, self._found = in_background(find), found

    def poll(self) -> None:
        """Hand out what was found; raises what the finding raised."""
        answer, found = self._answer, self._found
        if answer is not None and found is not None and answer.done():
            self._answer = self._found = None
            found(answer.result())


def why_not_now(moment: ControllerSnapshot) -> str:
    """Return why no restart can be chosen now, "" when one can."""
    return later("A job is being cut: wait for its end, or stop it.") if moment.job_runs else ""


def program_of(sha256: str, programs: Iterable[tuple[Any, str]]) -> Any:
    """Return the object whose text has a fingerprint; None where none has. programs: objects with their texts."""
    return next((obj for obj, text in programs if digest_of_text(text) == sha256), None)
