# SPDX-License-Identifier: LGPL-2.1-or-later
"""Records of a journal as bytes: a line each, its CRC-32 before its JSON.

    1c291ca3 {"n":0,...}        n counts from 0, so that a line taken out of the middle is missed

A file that was cut off anywhere still gives all records before the cut: the torn one was never relied on. One that
is whole and yet wrong was damaged later, which is another thing.

One entry of a journal: how far a job may have gone, and how far it certainly has.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from dataclasses import asdict, dataclass
from typing import Any
from zlib import crc32

from CNCStepper.control.protocol.grbl.status_reports import Vector
from CNCStepper.errors import Text

NUMBER = "n"
_DIGITS = 8  # of the checksum, then a blank


@dataclass(frozen=True)
class Records:
    """What a file holds: the records that are whole, and in words what is wrong with the rest.

    is_torn: the last record was not written to its end. is_end_damaged: the last one was, but cannot be read.
    """

    contents: list[dict[str, Any]]
    faults: tuple[str, ...] = ()
    is_torn: bool = False
    is_end_damaged: bool = False


def to_line(number: int, content: Mapping[str, Any]) -> bytes:
    """Return record `number` with its line end."""
    body = json.dumps({NUMBER: number, **content}, separators=(",", ":")).encode("ascii")
    return b"%0*x %s\n" % (_DIGITS, crc32(body), body)


def read_records(data: bytes) -> Records:
    """Return the records of a whole file; damage is reported in words, never raised."""
    *lines, tail = data.split(b"\n")
    contents = [_content(line) for line in lines]
    last = _content(tail) or _content(tail[:-1])  # only its line end is missing or wrong
    if last:
        contents.append(last)
    is_end_damaged = bool(contents) and contents[-1] is None
    whole = [content for content in contents if content is not None]
    return Records(whole, tuple(_faults(contents)), bool(tail) and not last, is_end_damaged)


def _content(line: bytes) -> dict[str, Any] | None:
    checksum, _, body = line.partition(b" ")
    if len(checksum) != _DIGITS or b"%0*x" % (_DIGITS, crc32(body)) != checksum:
        return None
    try:
        content = json.loads(body)
    except (ValueError, RecursionError):
        return None
    return content if isinstance(content, dict) and isinstance(content.get(NUMBER), int) else None


def _faults(contents: list[dict[str, Any] | None]) -> Iterator[str]:
    expected = 0
    for place, content in enumerate(contents, 1):
        if content is None:
            yield Text("line {place} of the journal is damaged", place=place)
        elif content[NUMBER] != expected:
            yield Text("line {place} of the journal is not the one that was written there", place=place)
        expected = (expected if content is None else content[NUMBER]) + 1


@dataclass(frozen=True)
class Group:
    """Counts of wire lines from the job's first, and their offsets in the file.

    time_s: since 1970. may_be_sent: no line from here on has gone out. acknowledged: the controller took these.
    finished: these are certainly cut. first_line: the file's line of the first that is not; 0 when all are.
    last_line: the file's line of the last that may be sent; 0 for none. state, mpos_mm, wpos_mm: last reported.
    """

    time_s: float
    may_be_sent: int
    acknowledged: int
    finished: int
    first_line: int
    last_line: int
    state: str = ""
    mpos_mm: Vector | None = None
    wpos_mm: Vector | None = None

    def to_content(self) -> dict[str, Any]:
        """Return it as plain data, short: a long job writes one a second."""
        return {"group": list(asdict(self).values())}

    @classmethod
    def from_content(cls, content: dict[str, Any]) -> Group:
        """Return the group of `to_content`, after its way through JSON."""
        values: list[Any] = content["group"]
        return cls(*values[:-2], *map(_vector, values[-2:]))


def _vector(values: list[float] | None) -> Vector | None:
    return tuple(values) if values else None
