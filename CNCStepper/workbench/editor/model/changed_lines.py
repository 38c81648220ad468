# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which lines have changed since the process that reads was told last: only they are sent. It knows no Qt."""

from __future__ import annotations

from typing import NamedTuple


class Change(NamedTuple):
    """`removed` lines from `first` on, counted from 0 in the text as it was told, gave way to `added` lines."""

    first: int
    removed: int
    added: int


def joined(earlier: Change | None, first: int, removed: int, added: int) -> Change:
    """Return one change for two: `earlier`, and then lines from `first` of the text that it had made.

    told     ....|ooooo|.......
    present  ....|nnn|.........      earlier: o lines became n
               |rrrrrr|              then: r lines become a; the stretch that both touch is one change
    """
    if earlier is None:
        return Change(first, removed, added)
    begin = min(earlier.first, first)
    end = max(earlier.first + earlier.added, first + removed)
    grown = earlier.added - earlier.removed
    return Change(begin, end - grown - begin, end - begin + added - removed)


def moved(line: int, first: int, removed: int, added: int) -> int:
    """Return a line's number after a change, all counted from 1 but `first`, from 0; removed lines give `first`."""
    if line <= first:
        return line
    if line <= first + removed:
        return min(line, first + max(added, 1))
    return line + added - removed
