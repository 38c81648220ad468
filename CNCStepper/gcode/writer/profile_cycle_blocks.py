# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes roughing and finishing along a profile as G71, G72 and G70, where that is asked for and the dialect has them.

    O101 SUB                      the path of the control point, once for each cycle, at the begin of the program
    G0 X24.400 Z2.800
    G1 X24.400 Z0.800
    G3 X26.000 Z-0.600 I... K...
    O101 ENDSUB
    ...
    G71 Q101 X60.000 Z2.800 I1.900 R0.300

In the table a span "turning_cycle" has the name of the cycle, and a span "turned_profile" in it its last pass. The nose
is compensated in that path, so that D, the stock to leave, is in it too. G72 draws it from the chuck to the end face.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from CNCStepper.gcode.dialects.codes import MOTION_NAMES
from CNCStepper.gcode.writer.block_emitter import BlockEmitter
from CNCStepper.gcode.writer.move_rows import RowWriter
from CNCStepper.toolpath import ARC_CCW, ARC_CW, LINE, RAPID, Span, Toolpath

FACING = "G72"
NAMES = ("G70", "G71", FACING)
FIRST_SUBROUTINE = 101
REVERSED = {ARC_CW: ARC_CCW, ARC_CCW: ARC_CW}
Place = tuple[int, int, int]  # in counts of the last digit
Piece = tuple[int, Place, Place, tuple[float, float]]  # kind, begin, end, centre (X, Z) in counts


class ProfileCycleWriter:
    """Writes the cycles along profiles; whole: as cycles, else row by row."""

    def __init__(self, toolpath: Toolpath, page: BlockEmitter, rows: RowWriter, whole: bool):
        self.page, self.rows = page, rows
        self._table, self._states = toolpath.table(), toolpath.states
        takes = whole and page.dialect.o_words
        cycles = [span for span in toolpath.spans if span.kind == "turning_cycle" and span.name in NAMES and takes]
        profiles = [span for span in toolpath.spans if span.kind == "turned_profile"]
        self._spans = {span.first: span for span in cycles if span.last > span.first}
        self._profiles = {
            span.first: one
            for span in self._spans.values()
            for one in profiles
            if span.first <= one.first and one.last == span.last
        }
        numbers = enumerate(sorted(self._profiles), start=FIRST_SUBROUTINE)
        self._numbers = {first: number for number, first in numbers}

    def declare(self, first: int, last: int) -> None:
        """Write the subroutines of the profiles of rows [first, last)."""
        for row, profile in sorted(self._profiles.items()):
            if first <= row < last:
                self.page.line(f"O{self._numbers[row]} SUB")
                for line in self._lines(self._spans[row], profile):
                    self.page.line(*line)
                self.page.line(f"O{self._numbers[row]} ENDSUB")

    def write(self, row: int, last: int) -> int:
        """Write the cycle that begins at `row` as one block and return the row after it; 0 where there is none."""
        span = self._spans.get(row)
        if span is None or span.last > last or row not in self._profiles:
            return 0
        page, profile, x_z = self.page, self._profiles[row], (0, 2)
        begin = self._end(profile.first - 1)
        words = [f"Q{self._numbers[row]}", *(page.coordinate(axis, begin[axis]) for axis in x_z)]
        words += [f"{letter}{page.grid.short(value)}" for letter, value in span.words.items()]
        feed = float(self._table.feed[span.last - 1])
        if page.turn_rpm:  # under G96 each row has its own
            page.use_turn_feed(self._states[int(self._table.state[span.last - 1])].spindle_rpm)
        end = self._end(span.last - 1)
        if span.name != FACING:
            page.profile_cycle(span.name, words, feed, end)
            return span.last
        front = self._end(profile.first)
        page.profile_cycle(span.name, words, feed, front)
        page.move(RAPID, [end[0], front[1], front[2]])
        page.move(RAPID, [*end])
        return span.last

    def _end(self, row: int) -> Place:
        return self.rows.end_counts(row)

    def _pieces(self, profile: Span) -> Iterator[Piece]:
        for before, row in pairwise(range(profile.first, profile.last)):
            yield int(self._table.kind[row]), self._end(before), self._end(row), self.rows.centre_counts(row)

    def _lines(self, span: Span, profile: Span) -> Iterator[list[str]]:
        """Yield the words of a subroutine's blocks: to the begin of the profile, then along it."""
        pieces = list(self._pieces(profile))
        if span.name == FACING:
            pieces = [(REVERSED.get(kind, kind), end, begin, centre) for kind, begin, end, centre in reversed(pieces)]
        yield [MOTION_NAMES[RAPID], *self._place(pieces[0][1])]
        for kind, begin, end, (x, z) in pieces:
            centre = [] if kind == LINE else [self._offset("I", x - begin[0]), self._offset("K", z - begin[2])]
            yield [MOTION_NAMES[kind], *self._place(end), *centre]

    def _place(self, place: Place) -> list[str]:
        return [self.page.coordinate(axis, place[axis]) for axis in (0, 2)]

    def _offset(self, letter: str, counts: float) -> str:
        return f"{letter}{self.page.grid.text(round(counts))}"
