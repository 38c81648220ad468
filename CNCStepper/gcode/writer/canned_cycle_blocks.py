# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes the holes of canned cycles as blocks, where the dialect has them: the first whole, the next ones X and Y only.

    G98 G83 X10.000 Y5.000 Z-8.500 R2.000 Q2.000 F120     a run begins; G98 goes back to the height before it
    X20.000
    Y15.000
    G80                                                   it ends before anything else is written

A block is written only where it means the very rows of its hole, by the definition that the reader uses too; other
holes are written row by row. A run goes on over rows and events that write nothing, since the text that is read again
has none of them. A rapid up to R before a hole belongs to the block of a run that begins below R.
"""

from __future__ import annotations

from collections import defaultdict
from dataclasses import dataclass
from math import ceil

from CNCStepper.canned_cycle_expansion import DWELL, FEED, OWN_WORD, PECK_BACK_MM, RAPID, Canned, Stroke
from CNCStepper.gcode.dialects.codes import AXES
from CNCStepper.gcode.writer.block_emitter import BlockEmitter
from CNCStepper.gcode.writer.move_rows import RowWriter
from CNCStepper.tolerances import SAME_COUNT
from CNCStepper.toolpath import LINE, Event, Span, Toolpath
from CNCStepper.toolpath import RAPID as RAPID_ROW

ROUNDED_ENDS = 1.5 + SAME_COUNT  # counts
KINDS = {RAPID_ROW: RAPID, LINE: FEED}


@dataclass(frozen=True)
class _Block:
    """A hole's words in counts of the text's last digit (P in seconds), and the feed of its rows.

    peck_slack: how far the whole counts of Q may move where a peck ends.
    """

    cycle: Canned
    x: int
    y: int
    feed_mm_min: float
    peck_slack: float


class CycleWriter:
    """Writes runs of blocks; `page` has the machine's position."""

    def __init__(self, toolpath: Toolpath, page: BlockEmitter, rows: RowWriter):
        self.path = toolpath
        self.table = toolpath.table()
        self.page = page
        self.grid = page.grid
        self.rows = rows
        names = page.writing.canned
        cycles = [span for span in toolpath.spans if span.kind == "cycle" and span.name in names]
        self._spans = {span.first: span for span in cycles if span.last > span.first}
        self._edges = {row for span in toolpath.spans if span.kind == "operation" for row in (span.first, span.last)}
        self._events: defaultdict[int, list[Event]] = defaultdict(list)
        for event in toolpath.events if self._spans else ():
            self._events[event.index].append(event)
        self._last: Canned | None = None
        self._initial = 0

    def write(self, row: int, last: int) -> int:
        """Write the hole that begins at `row` as a block and return the row after it; `row` where there is none."""
        span = self._spans.get(row) or self._lifted(row)
        block = self._block(span) if span and span.last <= last and not self.rows.lifted else None
        if span is None or block is None:
            return row
        rows = self._rows(row, span)
        if self._run is None or not self._means(block, self._initial, rows):
            initial = self.page.at[2] or 0
            if not self._means(block, initial, rows):
                return row
            self.page.end_cycle()
            self._initial = initial
        self.page.canned(block.cycle.name, self._words(block), block.feed_mm_min, self.rows.end_counts(span.last - 1))
        self._last = block.cycle
        return span.last

    @property
    def _run(self) -> Canned | None:
        """The cycle whose run the next block continues, if there is one."""
        return self._last if self.page.in_cycle else None

    def _lifted(self, row: int) -> Span | None:
        """Return the hole whose block begins with this rapid, if there is one and nothing happens in between."""
        span = self._spans.get(row + 1)
        if span is None or self._events[row + 1] or row + 1 in self._edges or self.table.kind[row] != RAPID_ROW:
            return None
        return span if self.table.state[row] == self.table.state[row + 1] else None

    def _block(self, span: Span) -> _Block | None:
        """Return the words of a hole; None where the rows are not of one state and feed, or more happens in between."""
        rows = slice(span.first, span.last)
        cuts = self.table.feed[rows][self.table.kind[rows] == LINE]
        between = [event for index in range(span.first + 1, span.last) for event in self._events[index]]
        plain = all(event.kind == "dwell" for event in between) and len(set(self.table.state[rows].tolist())) == 1
        if not plain or not len(cuts) or len(set(cuts.tolist())) > 1 or None in self.page.at:
            return None
        offset = self.path.states[int(self.table.state[span.first])].offset_mm
        x, y, z = (self.grid.count(span.words[axis] - offset[k]) for k, axis in enumerate(AXES))
        r = self.grid.count(span.words["R"] - offset[2])
        own = self._own(span)
        back = self.grid.count(PECK_BACK_MM)
        cycle = Canned(span.name, z, r, own, span.words["G"] == 98.0, back)
        return _Block(cycle, x, y, float(cuts[0]), self._peck_slack(span, cycle))

    def _peck_slack(self, span: Span, cycle: Canned) -> float:
        """Return how far rounding moves the lowest peck: Q, and R, a peck and the retract by half a count each."""
        if OWN_WORD[cycle.name] != "Q":
            return 0.0
        return ROUNDED_ENDS + cycle.pecks * (cycle.own - float(self.grid.exact(span.words["Q"])))

    def _own(self, span: Span) -> float:
        """Return Q in counts, rounded up so that there are no more pecks than meant, or P in seconds."""
        letter = OWN_WORD[span.name]
        if letter == "Q":
            return float(ceil(self.grid.exact(span.words["Q"]) - SAME_COUNT))
        return round(span.words["P"], 3) if letter else 0.0

    def _rows(self, first: int, span: Span) -> list[Stroke]:
        """Return the moves of the rows from `first` to the span's end on the grid, without rows that do not move."""
        strokes: list[Stroke] = []
        for row in range(first, span.last):
            if row > first:
                strokes += [Stroke(DWELL, strokes[-1].end, round(event.value, 3)) for event in self._events[row]]
            strokes.append(Stroke(KINDS.get(int(self.table.kind[row]), ""), self.rows.end_counts(row)))
        return self._moving(strokes)

    def _means(self, block: _Block, initial: int, rows: list[Stroke]) -> bool:
        """Whether the block has the moves of the rows; only the ends of its pecks may differ by rounding."""
        at = (self.page.at[0] or 0, self.page.at[1] or 0, self.page.at[2] or 0)
        cycle = block.cycle
        if cycle.pecks > len(rows):
            return False
        lift = cycle.lift(at, initial)
        (hole,) = cycle.holes(cycle.r if lift else at[2], initial, [(block.x, block.y)])
        meant = self._moving([*lift, *hole])
        exact = {at[2], cycle.z, cycle.r, cycle.clear(initial)}
        slacks = [0.0 if stroke.end[2] in exact else block.peck_slack for stroke in meant]
        return len(meant) == len(rows) and all(map(_same, meant, rows, slacks))

    def _moving(self, strokes: list[Stroke]) -> list[Stroke]:
        moving: list[Stroke] = []
        at: tuple[float | None, ...] = tuple(self.page.at)
        for stroke in strokes:
            if stroke.kind == DWELL or stroke.end != at:
                moving.append(stroke)
            at = stroke.end
        return moving

    def _words(self, block: _Block) -> list[str]:
        """Return the words that are not in force."""
        cycle, run, text = block.cycle, self._run, self.grid.text
        places = {"X": block.x, "Y": block.y}
        changed = [letter for k, letter in enumerate("XY") if run is None or places[letter] != self.page.at[k]]
        words = [f"{letter}{text(places[letter])}" for letter in changed or ["X"]]
        whole = run is None or run.name != cycle.name
        if whole or (run and run.z != cycle.z):
            words.append(f"Z{text(int(cycle.z))}")
        if whole or (run and run.r != cycle.r):
            words.append(f"R{text(int(cycle.r))}")
        if (letter := OWN_WORD[cycle.name]) and (whole or (run and run.own != cycle.own)):
            words.append(f"Q{text(int(cycle.own))}" if letter == "Q" else f"P{cycle.own:g}")
        modes = [("G98" if cycle.to_initial else "G99")] if run is None or run.to_initial != cycle.to_initial else []
        return [*modes, *([cycle.name] if whole else []), *words]


def _same(one: Stroke, other: Stroke, slack: float) -> bool:
    """Whether two strokes are the same on the grid, heights within `slack`."""
    if one.kind != other.kind or one.end[:2] != other.end[:2]:
        return False
    return abs(one.end[2] - other.end[2]) <= slack and abs(one.seconds - other.seconds) < SAME_COUNT
