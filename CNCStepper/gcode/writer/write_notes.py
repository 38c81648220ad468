# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a writer had to write differently, because the dialect lacks it: how often, and where first."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass
class Note:
    """what: a sentence without full stop. times: how often. line: of the table's source, 0 where there is none."""

    what: str
    times: int = 0
    line: int = 0

    def __str__(self) -> str:
        if self.times == 1:
            return self.what + f" (line {self.line})" * bool(self.line)
        return f"{self.what} ({self.times} times" + f", first at line {self.line}" * bool(self.line) + ")"


class Notes:
    """The notes of one program in the order in which they came up."""

    def __init__(self) -> None:
        self._notes: dict[str, Note] = {}

    def add(self, what: str, line: int = 0) -> None:
        """Note that `what` was done once more."""
        note = self._notes.setdefault(what, Note(what, line=line))
        note.times += 1

    def once(self, what: str) -> None:
        """Note what is so from now on, however often it is asked."""
        self._notes.setdefault(what, Note(what, 1))

    def __iter__(self):
        return iter(self._notes.values())

    def __len__(self) -> int:
        return len(self._notes)
