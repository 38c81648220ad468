# SPDX-License-Identifier: LGPL-2.1-or-later
"""The chunks of a table while it is being read: by number, but only those around the last one asked for are kept.

read     0   1   2   3   4   5           so much is read as is asked for, and one more
kept                 3   4   5
asked for                ^
"""

from __future__ import annotations

from collections.abc import Callable, Iterable

from CNCStepper.toolpath import Chunk


class ChunkWindow:
    """A list of chunks for one pass from the first to the last; empty ones are passed over.

    taken: called with each chunk as it is read. Its length counts what is read, which is beyond any chunk asked for as
    long as there are more.
    """

    def __init__(self, chunks: Iterable[Chunk], taken: Callable[[Chunk], None] = lambda chunk: None):
        self._coming = (chunk for chunk in chunks if len(chunk))
        self._taken = taken
        self._kept: dict[int, Chunk] = {}
        self._read = 0
        self._read_to(0)

    def __len__(self) -> int:
        return self._read

    def __getitem__(self, number: int) -> Chunk:
        self._read_to(number + 1)
        for old in [kept for kept in self._kept if kept < number - 1]:
            del self._kept[old]
        if number not in self._kept:
            raise IndexError(f"chunk {number} is not read yet or no longer kept")
        return self._kept[number]

    def _read_to(self, number: int) -> None:
        while self._read <= number and (chunk := next(self._coming, None)) is not None:
            self._taken(chunk)
            self._kept[self._read] = chunk
            self._read += 1
