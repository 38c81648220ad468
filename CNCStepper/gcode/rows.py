# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes the rows of a table onto a page: rounded ends, arcs that every controller accepts, safe approaches."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from math import isnan

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.codes import AXES
from CNCStepper.gcode.dialects import Dialect
from CNCStepper.gcode.moves import FULL_TURN
from CNCStepper.gcode.options import WriteOptions
from CNCStepper.gcode.page import Page
from CNCStepper.gcode.round_arc import Limits, Piece, TrueArc, rounded
from CNCStepper.toolpath import ARC_CW, LINE, PLANE_AXES, RAPID, Toolpath

Counts = list[int | None]


class RowWriter:
    """Knows the table in work coordinates; `must_lift`: Z goes to clearance before the next row."""

    def __init__(self, toolpath: Toolpath, page: Page, dialect: Dialect, options: WriteOptions):
        self.path = toolpath
        self.table = table = toolpath.table()
        self.page = page
        self.grid = page.grid
        self.has_height = True
        self.must_lift = True
        self._lifted = False
        self._clearance = self.grid.count(options.clearance_mm)
        self._limits = self._arc_limits(dialect, options)
        self._turns_word = "P" in dialect.codes["G2"].takes
        self._check_states()
        offsets = toolpath.offsets_mm()
        self._begins = (toolpath.begins() - offsets).tolist()
        self._ends = (table.end - offsets).tolist()
        self._centres = (table.centre - offsets).tolist()

    def any_height(self, first: int, last: int) -> bool:
        """Whether the rows [first, last) know their height at all."""
        return any(not isnan(end[2]) for end in self._ends[first:last])

    def write(self, row: int) -> None:
        """Write one row; what rounds to no move at all is left out."""
        begin, end, kind = self._begins[row], self._ends[row], int(self.table.kind[row])
        self._check_known(row)
        if kind in (RAPID, LINE) and self._counts(begin) == self._counts(end):
            return
        feed = float(self.table.feed[row])
        if self._lifted:
            self._approach(begin, end, kind, feed)
        if kind in (RAPID, LINE):
            self.page.move(kind, self._counts(end), feed)
        else:
            self._arc(row, kind, feed)

    def lift_first(self) -> None:
        """Move Z to clearance where that is still to be done, so that it is the first motion."""
        if self.must_lift and self.has_height:
            height = self.page.at[2]
            self.page.move(RAPID, [None, None, self._clearance if height is None else max(height, self._clearance)])
            self._lifted = True
        self.must_lift = False

    def lift(self) -> None:
        """Retract to clearance from below."""
        height = self.page.at[2]
        if self.has_height and (height is None or height < self._clearance):
            self.page.move(RAPID, [None, None, self._clearance])

    def rebase(self, row: int) -> None:
        """Take the place before `row` in the work system now in force."""
        self.page.at = self._counts(self._begins[row])
        self.page.forget()

    def _approach(self, begin: list[float], end: list[float], kind: int, feed: float) -> None:
        """Come from clearance to where the row begins: over the place first, then down."""
        self._lifted = False
        x, y, z = self._counts(end if kind == RAPID else begin)
        if kind == RAPID:
            if z is None or z < self._clearance:
                self.page.move(RAPID, [x, y, None])
            return
        self.page.move(RAPID, [x, y, None])
        if z is not None:
            height = self.page.at[2]
            self.page.move(RAPID if height is not None and z > height else LINE, [None, None, z], feed)

    def _arc(self, row: int, kind: int, feed: float) -> None:
        plane = int(self.table.plane[row])
        first, second, normal = PLANE_AXES[plane]
        begin, end = self._begins[row], self._ends[row]
        for arc, low, high, turns in self._turns(row, kind == ARC_CW):
            at_first, at_second = self.page.at[first], self.page.at[second]
            if at_first is None or at_second is None:
                raise self._refusal(row, "the arc begins at a place that is not known")
            pieces = rounded((at_first, at_second), arc, self._limits)
            for piece in pieces:
                share = low + (high - low) * piece.share
                target: Counts = [None, None, None]
                target[first], target[second] = piece.end
                if not isnan(end[normal]):
                    target[normal] = self.grid.count(begin[normal] + share * (end[normal] - begin[normal]))
                if piece.offset is None:
                    self.page.move(LINE, target, feed)
                else:
                    self.page.arc(kind, target, piece.offset, plane, feed, turns if len(pieces) == 1 else 1)
        self.page.move(LINE, self._counts(end), feed)  # only what rounding left of a helix that vanished

    def _turns(self, row: int, clockwise: bool) -> Iterator[tuple[TrueArc, float, float, int]]:
        """Yield (arc, share of the row at its begin, at its end, P word) for each turn to be written."""
        first, second, _ = PLANE_AXES[int(self.table.plane[row])]
        points = (self._begins[row], self._ends[row], self._centres[row])
        begin, end, centre = ((self.grid.exact(p[first]), self.grid.exact(p[second])) for p in points)
        last = TrueArc(begin, end, centre, clockwise)
        turns = int(self.table.turns[row])
        if turns > 1 and self._turns_word and any(piece.offset for piece in self._try(last)):
            yield last, 0.0, 1.0, turns
            return
        whole = FULL_TURN * (turns - 1) + last.sweep_rad
        for turn in range(turns - 1):
            share = FULL_TURN / whole
            yield TrueArc(begin, begin, centre, clockwise), turn * share, (turn + 1) * share, 1
        yield last, FULL_TURN * (turns - 1) / whole, 1.0, 1

    def _try(self, arc: TrueArc) -> tuple[Piece, ...]:
        """Return the pieces of an arc where one line holds it whole, else nothing."""
        pieces = rounded((round(arc.begin[0]), round(arc.begin[1])), arc, self._limits)
        return pieces if len(pieces) == 1 else ()

    def _counts(self, point: list[float]) -> Counts:
        return [None if isnan(value) else self.grid.count(value) for value in point]

    def _arc_limits(self, dialect: Dialect, options: WriteOptions) -> Limits:
        counts = 10**self.grid.decimals
        rule = dialect.arc_rules[options.units]
        in_counts = replace(
            rule, slack=rule.slack * counts, gap=rule.gap * counts, smallest_radius=rule.smallest_radius * counts
        )
        assert dialect.writing is not None  # the writer has asked
        flat = self.grid.exact(options.flat_mm) if options.flat_mm > 0 else 0.5
        return Limits(in_counts, flat, self.grid.exact(dialect.writing.largest_radius_mm))

    def _check_states(self) -> None:
        for index in sorted(set(self.table.state.tolist())):
            state = self.path.states[index]
            for shift, name in ((any(state.g92_mm), "G92 offset"), (state.tool_length_mm, "tool length offset")):
                if shift:
                    what = f"a program with a {name} is not written"
                    raise ProgramError("offset", what, advice="use a work offset (G54) instead")

    def _check_known(self, row: int) -> None:
        for axis in range(3):
            if isnan(self._ends[row][axis]) and not isnan(self._begins[row][axis]):
                raise self._refusal(row, f"the row leads to an unknown place along {AXES[axis]}")

    def _refusal(self, row: int, what: str) -> ProgramError:
        line = int(self.table.line[row])
        value = f"row {row}" + f", line {line}" * bool(line)
        advice = "G53 and G28 have no place in work coordinates: give the work zero, or take them out"
        return ProgramError("unknown-position", what, value=value, advice=advice)
