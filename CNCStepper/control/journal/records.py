# SPDX-License-Identifier: LGPL-2.1-or-later
"""Records of a journal as bytes: a line each, its CRC-32 before its JSON.

    1c291ca3 {"n":0,...}        n counts from 0, so that a line taken out of the middle is missed

A file that was cut off anywhere still gives all records before the cut: the torn one was never relied on. One that
is whole and yet wrong was damaged later, which is another thing.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any
from zlib import crc32

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
