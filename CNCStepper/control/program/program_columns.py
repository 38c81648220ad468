# SPDX-License-Identifier: LGPL-2.1-or-later
"""The columns of a bundle that hold a program as it is sent: its lines, their places in the file, its messages.

    messages.txt       each message as a string of JSON, since one may have several lines
    message_map.npy    the index of the wire line before which each is told, rising, int32

A program without messages has neither. While a long program is read, its columns are written piece by piece.
"""

from __future__ import annotations

import json
import math
from bisect import bisect_left, bisect_right
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from CNCStepper.control.program.bundle import (
    BLOCK,
    LINE_MAP,
    WIRE,
    array_bytes,
    column_of_file,
    line_bytes,
    new_private,
    number_bytes,
)
from CNCStepper.errors import Place

if TYPE_CHECKING:
    import numpy as np

MESSAGES, MESSAGE_MAP = "messages.txt", "message_map.npy"


class Messages(Mapping[int, str]):
    """Messages to the operator by the index of the wire line before which they are shown, read on demand.

    texts: strings of JSON. Raises ValueError where the columns do not fit each other.
    """

    def __init__(self, indices: Sequence[int], texts: Sequence[str]):
        if len(indices) != len(texts):
            raise ValueError("its messages do not fit their lines")
        self.indices, self.texts = indices, texts
        self._firsts = list(_block_begins(indices))
        self._gap = (0, 0.0)  # no line between these has a message

    def __getitem__(self, index: int) -> str:
        low, high = self._gap
        if low < index < high:  # as for nearly every line
            raise KeyError(index)
        place = self._place(index)
        if place < len(self.indices) and self.indices[place] == index:
            return _text(self.texts[place])
        self._gap = (
            self.indices[place - 1] if place else -1,
            self.indices[place] if place < len(self.indices) else math.inf,
        )
        raise KeyError(index)

    def __iter__(self) -> Iterator[int]:
        return iter(self.indices)

    def __len__(self) -> int:
        return len(self.indices)

    def _place(self, index: int) -> int:
        """Return the index of the first message of a line or of a later one."""
        block = max(bisect_right(self._firsts, index) - 1, 0)
        return bisect_left(self.indices, index, block * BLOCK, min((block + 1) * BLOCK, len(self.indices)))


def messages_of(columns: Mapping[str, Sequence[Any]]) -> Mapping[int, str]:
    """Return the messages of a bundle's columns; raises ValueError where they are not as `message_members` wrote."""
    if MESSAGES not in columns and MESSAGE_MAP not in columns:
        return {}
    return Messages(columns.get(MESSAGE_MAP, ()), columns.get(MESSAGES, ()))


def message_members(messages: Mapping[int, str]) -> dict[str, Iterable[bytes]]:
    """Return messages as members for `bundle.write_bundle`."""
    if not messages:
        return {}
    if isinstance(messages, Messages):
        return {MESSAGES: line_bytes(messages.texts), MESSAGE_MAP: array_bytes(messages.indices)}
    indices = sorted(messages)
    return {MESSAGES: line_bytes([json.dumps(messages[index]) for index in indices]), MESSAGE_MAP: array_bytes(indices)}


def message_bytes(messages: Mapping[int, str]) -> Iterator[bytes]:
    """Yield the bytes of which the messages' fingerprint is made."""
    for pieces in message_members(messages).values():
        yield from pieces


class ColumnWriter:
    """The columns of a program that is still being read, in new files of a folder; file: what its lines are of."""

    def __init__(self, folder: Path, file: str):
        self._paths = [folder / name for name in (WIRE, LINE_MAP, MESSAGES, MESSAGE_MAP)]
        self._files = [new_private(path) for path in self._paths]
        self._of, self._count = file, 0

    def add(self, numbers: np.ndarray, lines: Sequence[str], messages: Mapping[int, str]) -> None:
        """Write further lines; raises ProgramError for one that holds the end of one.

        messages: by the index in these lines, rising.
        """
        wire, line_map, texts, indices = self._files
        wire.writelines(line_bytes(lines, lambda index: Place(self._of, int(numbers[index]))))
        line_map.write(numbers.astype("<i4").tobytes())
        texts.writelines(f"{json.dumps(text)}\n".encode("ascii") for text in messages.values())
        indices.writelines(number_bytes([self._count + index for index in messages]))
        self._count += len(lines)

    def close(self) -> None:
        """Write the buffered rows."""
        for file in self._files:
            file.close()

    def columns(self) -> tuple[Sequence[str], Sequence[int], Mapping[int, str]]:
        """Return what was written, once it is closed: the lines, the file's line of each, the messages."""
        lines, numbers, texts, indices = map(column_of_file, self._paths)
        return lines, numbers, Messages(indices, texts)

    def __enter__(self) -> ColumnWriter:
        return self

    def __exit__(self, *error: object) -> None:
        self.close()


def _block_begins(indices: Sequence[int]) -> Iterator[int]:
    """Yield the first of each block of indices; raises ValueError where they do not rise."""
    last = -1
    for place, index in enumerate(indices):
        if index <= last:
            raise ValueError("its messages do not fit their lines")
        if place % BLOCK == 0:
            yield index
        last = index


def _text(column: str) -> str:
    """Return a message; a damaged one is shown as it is."""
    try:
        return str(json.loads(column))
    except (ValueError, RecursionError):
        return column
