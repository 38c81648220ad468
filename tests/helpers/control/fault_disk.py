# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sender's disk, which can be filled: what a journal writes then fails in the middle of its record.

A journal permits fewer lines ahead here than elsewhere, so that a full disk stops a short program too.
"""

from __future__ import annotations

import errno
from collections.abc import Callable, Iterator
from concurrent.futures import Executor, Future
from contextlib import ExitStack, contextmanager
from math import inf
from unittest.mock import patch

from CNCStepper.control.journal import writer
from CNCStepper.control.journal.writer import JournalFile

LEAST_LINES, AHEAD_S = 4, 0.5
FOR_GOOD_S = 3.0  # a person who finds no room for so long stops the job


class AtOnce(Executor):
    """Does at once what it is given."""

    def submit(self, function, /, *arguments, **words):
        done: Future = Future()
        try:
            done.set_result(function(*arguments, **words))
        except OSError as error:
            done.set_exception(error)
        return done


class Disk:
    """A disk as fast as memory; `clock` in s."""

    def __init__(self, clock: Callable[[], float]):
        self.is_full_for_good = False
        self._clock = clock
        self._full_until_s = -inf

    @property
    def is_full(self) -> bool:
        """Whether it takes nothing now."""
        return self._clock() < self._full_until_s

    def fill(self, for_s: float) -> None:
        """Let it be full from now on, for so long; from FOR_GOOD_S on without an end."""
        self.is_full_for_good = for_s >= FOR_GOOD_S
        self._full_until_s = inf if self.is_full_for_good else self._clock() + for_s

    @contextmanager
    def in_use(self) -> Iterator[None]:
        """Let every journal be written to this disk."""
        with ExitStack() as patches:
            patches.enter_context(patch.object(JournalFile, "_write", lambda file, line: self._write(file, line)))
            patches.enter_context(patch.multiple(writer, least_lines=lambda baud: LEAST_LINES, AHEAD_S=AHEAD_S))
            yield

    def _write(self, file: JournalFile, line: bytes) -> None:
        file._file.seek(file._end)
        if self.is_full:
            file._file.write(line[: len(line) // 2])
            raise OSError(errno.ENOSPC, "No space left on device")
        file._file.write(line)
