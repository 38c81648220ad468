# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes roughing and finishing along a profile as G71, G72 and G70, where that is asked for and the dialect has them.

    O101 SUB                      the path of the control point, once for each cycle, at the begin of the program
    G0 X24.400 Z2.800
    G1 X24.400 Z0.800
    G3 X26.000 Z-0.600 I... K...
    O101 ENDSUB
    ...
    G71 Q101 X60.000 Z2.800 I1.900 R0.300

    G71 U1.9 R0.3                 the same for a control whose cycles take two blocks: the profile is behind them, and
    G71 P101 Q103 U0. W0. F0.2    the tool returns to where it was; G70 is written where a G71 before it has its profile
    N101 G00 X48.8
    N102 G01 Z0.8
    N103 G03 X52. Z-0.6 I... K...

In the table a span "turning_cycle" has the name of the cycle, and a span "turned_profile" in it its last pass. The nose
is compensated in that path, so that D, the stock to leave, is in it too. G72 draws it from the chuck to the end face.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from math import copysign

from CNCStepper.gcode.dialects.codes import MOTION_NAMES
from CNCStepper.gcode.writer.block_emitter import BlockEmitter
from CNCStepper.gcode.writer.move_rows import RowWriter
from CNCStepper.toolpath import ARC_CCW, ARC_CW, LINE, RAPID, Span, Toolpath

FACING, FINISHING = "G72", "G70"
NAMES = (FINISHING, "G71", FACING)
FIRST_SUBROUTINE = 101
REVERSED = {ARC_CW: ARC_CCW, ARC_CCW: ARC_CW}
Place = tuple[int, int, int]  # in counts of the last digit
Piece = tuple[int, Place, Place, tuple[float, float]]  # kind, begin, end, centre (X, Z) in counts


class ProfileCycles:
    """The cycles along profiles of a table, by their first row; none unless they are wanted."""

    def __init__(self, toolpath: Toolpath, page: BlockEmitter, rows: RowWriter, wanted: bool):
        self.page, self.rows = page, rows
        self._table, self._states = toolpath.table(), toolpath.states
        cycles = [span for span in toolpath.spans if span.kind == "turning_cycle" and span.name in NAMES and wanted]
        profiles = [span for span in toolpath.spans if span.kind == "turned_profile"]
        self._spans = {span.first: span for span in cycles if span.last > span.first}
        self._profiles = {
            span.first: one
            for span in self._spans.values()
            for one in profiles
            if span.first <= one.first and one.last == span.last
        }

    def declare(self, first: int, last: int) -> None:
        """Write what must be at the begin of a program of rows [first, last): nothing."""

    def write(self, row: int, last: int) -> int:
        """Write the cycle that begins at `row` and return the row after it; 0 where there is none."""
        span = self._spans.get(row)
        if span is None or span.last > last or row not in self._profiles:
            return 0
        if self.page.turn_rpm:  # under G96 each row has its own
            self.page.use_turn_feed(self._states[int(self._table.state[span.last - 1])].spindle_rpm)
        return self._cycle(span, self._profiles[row])

    def _cycle(self, span: Span, profile: Span) -> int:
        """Write a cycle and return the row after it, 0 where it is left to its rows."""
        raise NotImplementedError

    def _end(self, row: int) -> Place:
        return self.rows.end_counts(row)

    def _feed(self, span: Span) -> str:
        return self.page.cycle_feed(float(self._table.feed[span.last - 1]))

    def _pieces(self, span: Span, profile: Span) -> list[Piece]:
        """Return the pieces of a profile in the order of its cycle: G72 draws it towards the front."""
        pieces = [
            (int(self._table.kind[row]), self._end(before), self._end(row), self.rows.centre_counts(row))
            for before, row in pairwise(range(profile.first, profile.last))
        ]
        if span.name != FACING:
            return pieces
        return [(REVERSED.get(kind, kind), end, begin, centre) for kind, begin, end, centre in reversed(pieces)]

    def _lines(self, pieces: list[Piece]) -> Iterator[list[str]]:
        """Yield the words of the blocks of a profile: to its begin, then along it."""
        yield [MOTION_NAMES[RAPID], *self._place(pieces[0][1])]
        for kind, begin, end, (x, z) in pieces:
            centre = [] if kind == LINE else [self._offset("I", x - begin[0]), self._offset("K", z - begin[2])]
            yield [MOTION_NAMES[kind], *self._place(end), *centre]

    def _place(self, place: Place) -> list[str]:
        return [self.page.coordinate(axis, place[axis]) for axis in (0, 2)]

    def _offset(self, letter: str, counts: float) -> str:
        return f"{letter}{self.page.grid.text(round(counts))}"


class SubroutineCycleWriter(ProfileCycles):
    """Writes them as LinuxCNC takes them, with their profiles as subroutines."""

    def __init__(self, toolpath: Toolpath, page: BlockEmitter, rows: RowWriter, wanted: bool):
        super().__init__(toolpath, page, rows, wanted)
        numbers = enumerate(sorted(self._profiles), start=FIRST_SUBROUTINE)
        self._numbers = {first: number for number, first in numbers}

    def declare(self, first: int, last: int) -> None:
        """Write the subroutines of the profiles of rows [first, last)."""
        for row, profile in sorted(self._profiles.items()):
            if first <= row < last:
                self.page.line(f"O{self._numbers[row]} SUB")
                for line in self._lines(self._pieces(self._spans[row], profile)):
                    self.page.line(*line)
                self.page.line(f"O{self._numbers[row]} ENDSUB")

    def _cycle(self, span: Span, profile: Span) -> int:
        page = self.page
        page.line(self._feed(span))
        words = [f"Q{self._numbers[span.first]}", *self._place(self._end(profile.first - 1))]
        words += [f"{letter}{page.grid.short(value)}" for letter, value in span.words.items()]
        end = self._end(span.last - 1)
        if span.name != FACING:
            page.profile_cycle(span.name, words, end)
            return span.last
        front = self._end(profile.first)
        page.profile_cycle(span.name, words, front)
        page.move(RAPID, [end[0], front[1], front[2]])
        page.move(RAPID, [*end])
        return span.last


class NumberedCycleWriter(ProfileCycles):
    """Writes them in two blocks, with their profiles as numbered blocks behind them."""

    def __init__(self, toolpath: Toolpath, page: BlockEmitter, rows: RowWriter, wanted: bool):
        super().__init__(toolpath, page, rows, wanted)
        self._next = FIRST_SUBROUTINE
        self._written: dict[tuple[Place, str], list[str]] = {}  # by begin and text of a profile: its P and Q

    def _cycle(self, span: Span, profile: Span) -> int:
        pieces, begin, page = self._pieces(span, profile), self._end(profile.first - 1), self.page
        lines, place = list(self._lines(pieces)), pieces[0][1]
        key = begin, str(lines)
        if span.name == FINISHING:
            if key not in self._written:
                return 0
            page.profile_cycle(FINISHING, [*self._written[key], self._feed(span)], begin)
            return span.last
        facing = span.name == FACING
        if facing and place[0] != begin[0]:
            return 0
        if facing or (place[2] == begin[2] and _rises_to(begin[0], pieces)):
            del lines[0][1 if facing else 2]  # the first block of a profile without pockets moves one axis
        named = self._written[key] = [f"P{self._next}", f"Q{self._next + len(lines) - 1}"]
        depth, retract = (page.with_point(page.grid.short(span.words[letter])) for letter in "IR")
        page.move(RAPID, [*begin])
        page.line(span.name, f"{'W' if facing else 'U'}{depth}", f"R{retract}")
        page.profile_cycle(span.name, [*named, "U0.", "W0.", self._feed(span)], begin)
        for number, words in enumerate(lines, start=self._next):
            page.line(f"N{number}", *words)
        self._next += len(lines)
        return span.last


def profile_cycles(toolpath: Toolpath, page: BlockEmitter, rows: RowWriter, whole: bool) -> ProfileCycles:
    """Return the writer of the dialect's form of these cycles; whole: as cycles, else row by row."""
    writer = NumberedCycleWriter if page.dialect.two_block_cycles else SubroutineCycleWriter
    return writer(toolpath, page, rows, whole and (page.dialect.o_words or page.dialect.two_block_cycles))


def _rises_to(begin_x: int, pieces: list[Piece]) -> bool:
    """Whether a profile never leads away from the X where its cycle begins: each piece by both its ends."""
    side = copysign(1.0, begin_x - pieces[0][1][0])
    ways: list[float] = []
    for kind, begin, end, (_, centre_z) in pieces:
        if kind == LINE:
            ways.append(end[0] - begin[0])
        else:
            sense = 1.0 if kind == ARC_CCW else -1.0
            ways += [sense * (place[2] - centre_z) for place in (begin, end)]
    return all(side * way >= -1 for way in ways)  # a count is rounding
