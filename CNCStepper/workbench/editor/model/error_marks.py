# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a program is refused: the newest that is known, which moves with the text until it is read again. No Qt here.

Also which lines have changed since the process that reads was told last: only they are sent.
"""

from __future__ import annotations

from bisect import bisect_left
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

from CNCStepper.control.session.status import error_from_json
from CNCStepper.errors import CNCStepperError


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
    """Return where a line stands after a change, all counted from 1 but `first`, from 0; lines that went are at it."""
    if line <= first:
        return line
    if line <= first + removed:
        return min(line, first + max(added, 1))
    return line + added - removed


@dataclass(frozen=True)
class Mark:
    """A refusal: `length` characters from `column` on, both from 1; 0 means the whole line."""

    line: int
    column: int
    length: int
    error: CNCStepperError


class Marks:
    """The refusals of a text in the order of its lines."""

    def __init__(self) -> None:
        self.all: list[Mark] = []
        self._lines: list[int] = []

    def take(self, refusals: list[dict[str, Any]]) -> None:
        """Take a result of the reading process."""
        self._set(sorted((mark_of(refusal) for refusal in refusals), key=lambda mark: mark.line))

    def move(self, first: int, removed: int, added: int) -> None:
        """Follow a change of the text: `removed` lines from `first` on, counted from 0, gave way to `added`."""
        if removed != added:
            self._set([replace(mark, line=moved(mark.line, first, removed, added)) for mark in self.all])

    def between(self, first: int, last: int) -> list[Mark]:
        """Return those in lines `first` to `last`, from 1."""
        return self.all[bisect_left(self._lines, first) : bisect_left(self._lines, last + 1)]

    def at(self, line: int) -> Mark | None:
        """Return the first in a line, None for a good one."""
        return next(iter(self.between(line, line)), None)

    def _set(self, marks: list[Mark]) -> None:
        self.all = marks
        self._lines = [mark.line for mark in marks]


def mark_of(refusal: dict[str, Any]) -> Mark:
    """Return a refusal of the process that reads as a mark."""
    error = error_from_json({key: value for key, value in refusal.items() if key != "length"})
    place = error.place
    return Mark(place.line if place else 0, place.column if place else 0, refusal["length"], error)
