# SPDX-License-Identifier: LGPL-2.1-or-later
"""The groups of a DXF text, some at a time: their codes as a column, values where they are asked for.

    chunks of bytes ──► windows of whole groups, cut where an entity begins ──► GroupText

A group is two lines: its code and its value. What a window held is let go with it.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import numpy as np

CODES = 1100  # group codes are below it
BLOCK = 65_536  # bytes or groups that are looked through at once
WIDEST = 8  # characters of a code with the blanks around it
NEWLINE, RETURN, BLANK, TAB, ZERO, NINE = b"\n\r \t09"


class NotSplit(Exception):
    """A text that ezdxf has to read whole."""


class GroupText:
    """The groups of a part of a text; in the last part a line may end with the text.

    `codes` is the code of each group, int16[n]. Raises NotSplit where one is no group code.
    """

    def __init__(self, content: bytes, is_last: bool = True):
        self._content = content
        self._bytes = np.frombuffer(content, np.uint8)
        self._begin = _line_begins(content)
        self._lines = len(self._begin) - (1 if is_last else 2)
        self.codes = self._all_codes()

    def cut_at_last_entity(self) -> bytes:
        """Give up the groups from the last entity on and return their text; all stay, and b"", where none begins."""
        zeros = np.flatnonzero(self.codes == 0)
        if not len(zeros) or not zeros[-1]:
            return b""
        self.codes = self.codes[: zeros[-1]]
        self._lines = 2 * int(zeros[-1])
        return self._content[self._begin[self._lines] :]

    def _all_codes(self) -> np.ndarray:
        last = self._lines // 2 * 2
        begin, end = self._begin[0:last:2], self._begin[1:last:2] - 1
        blocks = range(0, len(begin), BLOCK)
        return np.concatenate(
            [np.empty(0, np.int16), *(self._codes(begin[at : at + BLOCK], end[at : at + BLOCK]) for at in blocks)]
        )

    def _codes(self, begin: np.ndarray, end: np.ndarray) -> np.ndarray:
        """Return the codes in some lines; raises NotSplit as the class says."""
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

    def values(self, groups: np.ndarray) -> Iterator[bytes]:
        """Yield the values of groups, int64[k]."""
        content, lines = self._content, 2 * groups + 1
        for begin, following in zip(self._begin[lines].tolist(), self._begin[lines + 1].tolist(), strict=True):
            yield content[begin : following - 1]

    def texts(self, groups: np.ndarray, numbers: np.ndarray, count: int) -> list[bytes]:
        """Return the values of groups, int64[k], as a text for some of `count` entities, by their numbers, int[k].

        An entity without one has b""; a carriage return behind a text is left out.
        """
        found = [b""] * count
        for number, value in zip(numbers.tolist(), self.values(groups), strict=True):
            found[number] = value.rstrip(b"\r")
        return found

    def some(self, kept: np.ndarray) -> bytes:
        """Return the text of the groups for which `kept`, bool[n], is true, and of the line behind the last group."""
        edges = 2 * np.flatnonzero(np.diff(np.concatenate([[False], kept, [True, False]])))
        edges[-1] = self._lines
        runs = zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True)
        return b"".join(self._content[self._begin[first] : self._begin[last]] for first, last in runs)


def windows(chunks: Iterable[bytes]) -> Iterator[GroupText]:
    """Yield the groups of a text in parts; each part but the first begins with the group of an entity."""
    waiting: list[bytes] = []
    size = least = 0
    for chunk in chunks:
        waiting.append(chunk)
        size += len(chunk)
        if size < least:
            continue
        text = GroupText(b"".join(waiting), is_last=False)
        tail = text.cut_at_last_entity()
        if tail:
            yield text
            waiting, size, least = [tail], len(tail), 0
        else:
            least = 2 * size  # a long entity: how often it is begun anew grows with its logarithm
    yield GroupText(b"".join(waiting))


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
