# SPDX-License-Identifier: LGPL-2.1-or-later
"""The lines that are sent, held as the bytes that go over the wire."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import overload

import numpy as np

AT_ONCE = 4096  # lines that are made at once


class WireLines(Sequence[str]):
    """Lines of plain ASCII, each made from the bytes when it is asked for; a sequence as a tuple of them is.

    data    G21\\nG0X1\\nM2\\n
    ends       3    8  11      of each line, where its newline stands
    """

    def __init__(self, data: bytes):
        self.data = data
        self._ends = np.flatnonzero(np.frombuffer(data, np.uint8) == ord("\n"))

    @overload
    def __getitem__(self, index: int) -> str: ...

    @overload
    def __getitem__(self, index: slice) -> tuple[str, ...]: ...

    def __getitem__(self, index: int | slice) -> str | tuple[str, ...]:
        if isinstance(index, slice):
            return tuple(self[place] for place in range(*index.indices(len(self))))
        end = int(self._ends[index])
        return self.data[self.data.rfind(b"\n", 0, end) + 1 : end].decode("ascii")

    def begins(self, indices: np.ndarray) -> np.ndarray:
        """Return where lines begin in `data`, int64[n]; the index behind the last one is the end."""
        return np.append(0, self._ends + 1)[indices]

    def __len__(self) -> int:
        return len(self._ends)

    def __iter__(self) -> Iterator[str]:
        begin = 0
        for last in range(AT_ONCE, len(self) + AT_ONCE, AT_ONCE):
            end = int(self._ends[min(last, len(self)) - 1]) + 1
            yield from self.data[begin:end].decode("ascii").split("\n")[:-1]
            begin = end

    def __eq__(self, other: object) -> bool:
        if isinstance(other, WireLines):
            return self.data == other.data
        return tuple(self) == other if isinstance(other, tuple) else NotImplemented

    def __hash__(self) -> int:
        return hash(self.data)

    def __repr__(self) -> str:
        return repr(tuple(self))
