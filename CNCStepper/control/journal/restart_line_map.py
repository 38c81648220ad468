# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which line of the first program a line of its restart is, kept as the pairs of lines from which both count on.

restart    1 ... 9 | 10 11 12 | 13 14 ...      [[10, 812], [13, 809]]: line 11 of the restart is line 813
first      (entry)   812 ...    809 ...        of the first program, and its loop runs 809 again
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

Pairs = Sequence[Sequence[int]]


@dataclass(frozen=True)
class FirstProgram:
    """The program that a restart goes on with; file: its whole path, or its name where it is no file."""

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
