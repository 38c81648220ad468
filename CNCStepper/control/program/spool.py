# SPDX-License-Identifier: LGPL-2.1-or-later
"""The lines of a job in a file, read as they are needed: a sender's memory does not grow with the program.

12 G1X10F600        the file's line, and what is sent; one record a line
13 G1X20
"""

from __future__ import annotations

import os
from array import array
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from functools import lru_cache
from itertools import count
from pathlib import Path
from typing import Any, overload

from CNCStepper.control.program.send_job import SendJob
from CNCStepper.control.program.wire_line import check_line
from CNCStepper.errors import Place

BLOCK = 1024  # records that are read at once
KEPT_BLOCKS = 2


def write_spool(path: Path, job: SendJob) -> SendJob:
    """Write the lines of a job to a new file that only its owner can read; return the job without them.

    Raises ProgramError for a line that holds the end of one.
    """
    numbers = map(int, job.file_lines) if len(job.file_lines) else count(1)
    with SpoolWriter(path, job.file) as spool:
        spool.add(numbers, job.lines)
    return replace(job, lines=(), file_lines=())


class SpoolWriter:
    """A new spool, which only its owner can read, written piece by piece; file: what its lines are of."""

    def __init__(self, path: Path, file: str):
        descriptor = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600)
        self._file = open(descriptor, "w", encoding="utf-8", newline="\n")  # noqa: SIM115  closed by __exit__
        self._of = file

    def add(self, numbers: Iterable[int], lines: Iterable[str]) -> None:
        """Write further lines; raises ProgramError for one that holds the end of one."""
        self._file.writelines(_record(number, line, self._of) for number, line in zip(numbers, lines, strict=False))

    def close(self) -> None:
        """Write out what is still held."""
        self._file.close()

    def __enter__(self) -> SpoolWriter:
        return self

    def __exit__(self, *error: object) -> None:
        self.close()


def read_spool(path: Path, job: SendJob) -> SendJob:
    """Return a job whose lines are those of `write_spool`, read when they are asked for."""
    spool = _Spool(path)
    return replace(
        job,
        lines=_Column(spool, lambda record: record.partition(" ")[2]),
        file_lines=_Column(spool, lambda record: int(record.partition(" ")[0])),
    )


def _record(number: int, line: str, file: str) -> str:
    if "\n" in line:
        check_line(line, Place(file, number))
    return f"{number} {line}\n"


class _Spool:
    """The records of a file; for any thread. offsets: where every BLOCK-th record begins, and the end."""

    def __init__(self, path: Path):
        self._path = path
        self._offsets = array("q")
        self.count = 0
        offset = 0
        with open(path, "rb") as file:
            for self.count, record in enumerate(file, 1):
                if (self.count - 1) % BLOCK == 0:
                    self._offsets.append(offset)
                offset += len(record)
        self._offsets.append(offset)

    @property
    def blocks(self) -> int:
        """How many blocks there are."""
        return len(self._offsets) - 1

    def read(self, number: int) -> list[str]:
        """Return the records of a block."""
        begin, end = self._offsets[number], self._offsets[number + 1]
        with open(self._path, "rb") as file:
            file.seek(begin)
            return file.read(end - begin).decode("utf-8").split("\n")[:-1]


class _Column(Sequence[Any]):
    """One half of every record; of the last blocks read they are kept, for who reads at two places at once."""

    def __init__(self, spool: _Spool, half: Callable[[str], Any]):
        self._spool = spool
        self._half = half
        self._block = lru_cache(KEPT_BLOCKS)(lambda number: list(map(half, spool.read(number))))

    def __len__(self) -> int:
        return self._spool.count

    def __iter__(self) -> Iterator[Any]:
        for number in range(self._spool.blocks):
            yield from map(self._half, self._spool.read(number))

    @overload
    def __getitem__(self, index: int) -> Any: ...

    @overload
    def __getitem__(self, index: slice) -> tuple[Any, ...]: ...

    def __getitem__(self, index: int | slice) -> Any:
        if isinstance(index, slice):
            return tuple(self[place] for place in range(*index.indices(len(self))))
        if index < 0:
            index += len(self)
            if index < 0:
                raise IndexError(index)
        number, place = divmod(index, BLOCK)
        return self._block(number)[place]
