# SPDX-License-Identifier: LGPL-2.1-or-later
"""The lines of a long text, kept on the disk: a program that jumps is read wherever it leads, and only a part is held.

    file     | 256 lines | 256 lines | ...        in UTF-8, each line with a LF
    blocks           v                            those read last, as lists of lines

The file has no name, so that nothing is left of it where the process is killed.
"""

from __future__ import annotations

import tempfile
from array import array
from collections.abc import Iterable, Sequence
from types import TracebackType
from typing import overload

from CNCStepper.errors import Text
from CNCStepper.gcode.syntax.words import program_lines

BLOCK = 256  # lines that are read at once
MOST_BLOCKS = 512  # that are held
MOST_HELD = 32_000_000  # characters of them


class LineStore(Sequence[str]):
    """Lines that are added a piece of the text after the other, and then read in any order; raises OSError."""

    def __init__(self) -> None:
        self._file = tempfile.TemporaryFile(prefix="cncstepper-lines-")  # noqa: SIM115  closed by close()
        self._begins = array("q", [0])  # of the blocks that are whole, and of the next one
        self._count = 0
        self._waiting: list[str] = []  # lines of the block that is not whole yet
        self._blocks: dict[int, list[str]] = {}
        self._held = 0

    @classmethod
    def of(cls, pieces: Iterable[str]) -> LineStore:
        """Return the store of a text that comes in pieces of whole lines."""
        store = cls()
        for piece in pieces:
            store.add(piece)
        return store

    def __enter__(self) -> LineStore:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None) -> None:
        self.close()

    def add(self, piece: str) -> None:
        """Add whole lines of the text."""
        lines = program_lines(piece)
        self._count += len(lines)
        self._waiting += lines
        whole = len(self._waiting) // BLOCK * BLOCK
        for first in range(0, whole, BLOCK):
            self._begins.append(self._begins[-1] + self._written(self._waiting[first : first + BLOCK]))
        del self._waiting[:whole]

    def close(self) -> None:
        """Give the disk back."""
        self._file.close()

    @overload
    def __getitem__(self, index: int) -> str: ...

    @overload
    def __getitem__(self, index: slice) -> list[str]: ...

    def __getitem__(self, index: int | slice) -> str | list[str]:
        if isinstance(index, slice):
            return [self[place] for place in range(*index.indices(self._count))]
        place = index + self._count if index < 0 else index
        if not 0 <= place < self._count:
            raise IndexError(Text("there are {count} lines, none at {index}", count=self._count, index=index))
        number, line = divmod(place, BLOCK)
        block = self._blocks.get(number)
        return (self._read(number) if block is None else block)[line]

    def __len__(self) -> int:
        return self._count

    def _written(self, lines: list[str]) -> int:
        """Write lines at the end; return how many bytes they are."""
        data = "".join(f"{line}\n" for line in lines).encode("utf-8", "surrogatepass")
        self._file.seek(0, 2)
        return self._file.write(data)

    def _read(self, number: int) -> list[str]:
        """Return a block, and keep it; those that were read first are forgotten."""
        if number == len(self._begins) - 1:
            return self._waiting
        begin, end = self._begins[number], self._begins[number + 1]
        self._file.seek(begin)
        block = self._file.read(end - begin).decode("utf-8", "surrogatepass").split("\n")[:-1]
        self._blocks[number] = block
        self._held += end - begin
        while len(self._blocks) > 1 and (len(self._blocks) > MOST_BLOCKS or self._held > MOST_HELD):
            old = next(iter(self._blocks))
            del self._blocks[old]
            self._held -= self._begins[old + 1] - self._begins[old]
        return block
