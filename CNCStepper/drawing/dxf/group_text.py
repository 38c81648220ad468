# SPDX-License-Identifier: LGPL-2.1-or-later
"""The lines of a DXF text as places in it: group codes as a column, values where they are asked for.

A group is two lines: its code and its value.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np

CODES = 1100  # group codes are below it
WIDEST = 8  # characters of a code with the blanks around it
NEWLINE, RETURN, BLANK, TAB, ZERO, NINE = b"\n\r \t09"


class NotSplit(Exception):
    """A text that ezdxf has to read whole."""


class TextColumn(NamedTuple):
    """A text for each of n entities as places in the text of the file, int32[n] both; b"" for one that has none."""

    content: bytes
    begin: np.ndarray
    end: np.ndarray

    def of(self, number: int) -> bytes:
        """Return the text of an entity, without a carriage return behind it."""
        return self.content[self.begin[number] : self.end[number]].rstrip(b"\r")


class GroupText:
    """The groups of a text."""

    def __init__(self, content: bytes):
        self._content = content
        self._bytes = np.frombuffer(content, np.uint8)
        newlines = np.flatnonzero(self._bytes == NEWLINE).astype(np.int32)
        self._begin = np.empty(len(newlines) + 2, np.int32)  # of each line; the last one is followed by no other
        self._begin[0], self._begin[-1] = 0, len(content) + 1
        np.add(newlines, 1, out=self._begin[1:-1])
        self._lines = len(newlines) + 1

    def codes(self) -> np.ndarray:
        """Return the code of each group, int32[n]; raises NotSplit where one is no group code."""
        begin, end = self._begin[: self._lines - 1 : 2], self._begin[1 : self._lines : 2] - 1
        codes, digits, ended = np.zeros(len(begin), np.int32), np.zeros(len(begin), bool), np.zeros(len(begin), bool)
        if not len(begin) or int((end - begin).max()) > WIDEST:
            raise NotSplit
        for column in range(int((end - begin).max())):
            inside = begin + column < end
            signs = np.where(inside, self._bytes[np.where(inside, begin + column, 0)], BLANK)
            is_digit = (signs >= ZERO) & (signs <= NINE)
            if not (is_digit | np.isin(signs, (BLANK, TAB, RETURN))).all() or (is_digit & ended).any():
                raise NotSplit
            codes = np.where(is_digit, np.minimum(codes * 10 + signs.astype(np.int32) - ZERO, CODES), codes)
            ended |= digits & ~is_digit
            digits |= is_digit
        if not digits.all() or int(codes.max()) >= CODES:
            raise NotSplit
        return codes

    def value(self, group: int) -> bytes:
        """Return the value of a group as it stands there."""
        line = 2 * group + 1
        return self._content[self._begin[line] : self._begin[line + 1] - 1]

    def values(self, groups: np.ndarray) -> Iterable[bytes]:
        """Yield the values of groups, int64[k]."""
        content, lines = self._content, 2 * groups + 1
        for begin, following in zip(self._begin[lines].tolist(), self._begin[lines + 1].tolist(), strict=True):
            yield content[begin : following - 1]

    def column(self, groups: np.ndarray, numbers: np.ndarray, count: int) -> TextColumn:
        """Return the values of groups, int64[k], as a text for some of `count` entities, by their numbers, int[k]."""
        column = TextColumn(self._content, np.zeros(count, np.int32), np.zeros(count, np.int32))
        column.begin[numbers], column.end[numbers] = self._begin[2 * groups + 1], self._begin[2 * groups + 2] - 1
        return column

    def some(self, kept: np.ndarray) -> bytes:
        """Return the text of the groups for which `kept`, bool[n], is true, and of the line behind the last group."""
        lines = np.repeat(np.append(kept, True), 2)[: self._lines]
        edges = np.flatnonzero(np.diff(np.concatenate([[False], lines, [False]]).astype(np.int8)))
        runs = zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True)
        return b"\n".join(self._content[self._begin[first] : self._begin[last] - 1] for first, last in runs)
