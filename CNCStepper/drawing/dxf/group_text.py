# SPDX-License-Identifier: LGPL-2.1-or-later
"""The lines of a DXF text as places in it: group codes as a column, values where they are asked for.

A group is two lines: its code and its value.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple

import numpy as np

CODES = 1100  # group codes are below it
BLOCK = 65_536  # bytes or groups that are looked through at once
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


def columns_joined(columns: Sequence[TextColumn]) -> TextColumn:
    """Return columns of texts of one file, one after the other."""
    begin, end = (np.concatenate(places) for places in zip(*(column[1:] for column in columns), strict=True))
    return TextColumn(columns[0].content, begin, end)


class GroupText:
    """The groups of a text."""

    def __init__(self, content: bytes):
        self._content = content
        self._bytes = np.frombuffer(content, np.uint8)
        self._begin = _line_begins(content)
        self._lines = len(self._begin) - 1

    def codes(self) -> np.ndarray:
        """Return the code of each group, int16[n]; raises NotSplit where one is no group code."""
        begin, end = self._begin[: self._lines - 1 : 2], self._begin[1 : self._lines : 2] - 1
        if not len(begin):
            raise NotSplit
        blocks = range(0, len(begin), BLOCK)
        return np.concatenate([self._codes(begin[at : at + BLOCK], end[at : at + BLOCK]) for at in blocks])

    def _codes(self, begin: np.ndarray, end: np.ndarray) -> np.ndarray:
        """Return the codes in some lines; raises NotSplit as `codes`."""
        codes, digits, ended = np.zeros(len(begin), np.int32), np.zeros(len(begin), bool), np.zeros(len(begin), bool)
        if int((end - begin).max()) > WIDEST:
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
        return codes.astype(np.int16)

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
        edges = 2 * np.flatnonzero(np.diff(np.concatenate([[False], kept, [True, False]])))
        edges[-1] = self._lines
        runs = zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True)
        return b"\n".join(self._content[self._begin[first] : self._begin[last] - 1] for first, last in runs)


def _line_begins(content: bytes) -> np.ndarray:
    """Return the place of each line, int32[n + 1]; the last one, behind the text, is followed by no other."""
    signs = np.frombuffer(content, np.uint8)
    begin = np.empty(content.count(b"\n") + 2, np.int32)
    begin[0], begin[-1], done = 0, len(content) + 1, 1
    for first in range(0, len(signs), BLOCK):
        found = np.flatnonzero(signs[first : first + BLOCK] == NEWLINE)
        begin[done : done + len(found)] = found + (first + 1)
        done += len(found)
    return begin
