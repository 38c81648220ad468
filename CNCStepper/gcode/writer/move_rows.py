# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes the rows of a table as blocks: rounded ends, arcs that every controller accepts, safe approaches."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from math import isnan

import numpy as np

from CNCStepper.errors import Place, ProgramError, Text
from CNCStepper.gcode.dialects import Dialect
from CNCStepper.gcode.dialects.codes import AXES
from CNCStepper.gcode.interpreter.motion.arcs import FULL_TURN
from CNCStepper.gcode.writer.block_emitter import BlockEmitter, Counts
from CNCStepper.gcode.writer.rounded_arcs import Limits, Piece, TrueArc, rounded
from CNCStepper.gcode.writer.write_options import WriteOptions
from CNCStepper.state import State
from CNCStepper.tolerances import SAME_COUNT
from CNCStepper.toolpath import ARC_CW, LINE, PLANE_AXES, RAPID, Toolpath


class RowWriter:
    """Knows the table in work coordinates, in counts of the last digit, and which whole counts are nearest.

    keeps_lengths: the lengths of tools are words of the text (or nobody's business); else they are in the coordinates.
    must_lift: Z goes to clearance before the next row. lifted: it has, and the row's own place is still to be reached.
    off_grid: the machine is off the position of `page.at` by less than a last digit.
    """

    def __init__(self, toolpath: Toolpath, page: BlockEmitter, options: WriteOptions, keeps_lengths: bool = True):
        self.path = toolpath
        self.table = table = toolpath.table()
        self.page = page
        self.grid = page.grid
        self.dialect = dialect = page.dialect
        self.options = options
        self.has_height = True
        self.must_lift = self._lifts = options.retract and page.writing.lifts
        self.lifted = False
        self._clearance = self.grid.count(options.clearance_mm)
        self._limits = self._arc_limits(dialect)
        self._chords = replace(self._limits, flat=self.grid.exact(options.chord_mm), largest_radius=0.0)
        arc = dialect.motion_code(ARC_CW)
        self._has_arcs, self._turns_word = arc is not None, arc is not None and "P" in arc.takes
        _check_axes(toolpath)
        self._off_grid = False
        self._offsets = offsets = self._origins(keeps_lengths)
        begins = self.grid.exact(toolpath.begins()[:, :3] - offsets)
        ends = self.grid.exact(table.end[:, :3] - offsets)
        self._begins, self._begin_counts = begins.tolist(), _whole(begins)
        self._ends, self._end_counts = ends.tolist(), _whole(ends)
        self._centres = self.grid.exact(table.centre - offsets).tolist()
        self.kinds, self._feeds = table.kind.tolist(), table.feed.tolist()
        self._planes, self.turns = table.plane.tolist(), table.turns.tolist()

    def any_height(self, first: int, last: int) -> bool:
        """Whether a height of the rows [first, last) is known."""
        return any(not isnan(end[2]) for end in self._ends[first:last])

    def write(self, row: int) -> None:
        """Write one row; what rounds to no move at all is left out."""
        begin, end, kind = self._begin_counts[row], self._end_counts[row], self.kinds[row]
        self._check_known(row)
        if self.options.retract and kind in (RAPID, LINE) and begin == end:
            return
        feed = self._feeds[row] if kind != RAPID else self.options.rapid_mm_min
        if self.lifted:
            self._approach(begin, end, kind, feed)
        if kind in (RAPID, LINE):
            self.page.move(kind, end, feed, nowhere=not self.options.retract)
        else:
            if self._off_grid:  # from here a whole circle would end elsewhere than it begins, and be none
                self.page.move(LINE, list(self.page.at), feed)
            self._arc(row, kind, feed)
        self._off_grid = False

    def end_counts(self, row: int) -> tuple[int, int, int]:
        """Return where a row ends on the grid; raises ProgramError where that is not known."""
        self._check_known(row)
        x, y, z = self._end_counts[row]
        return x or 0, y or 0, z or 0

    def centre_counts(self, row: int) -> tuple[float, float]:
        """Return X and Z of an arc's centre on the grid, not rounded."""
        x, _, z = self._centres[row]
        return x, z

    def lift_first(self) -> None:
        """Move Z to clearance where that is still to be done, so that it is the first motion."""
        if self.must_lift and self.has_height:
            height = self.page.at[2]
            wanted = self._clearance if height is None else max(height, self._clearance)
            self.page.move(RAPID, [None, None, wanted], self.options.rapid_mm_min)
            self.lifted = True
        self.must_lift = False

    def lift_next(self) -> None:
        """Let Z go to clearance before the next row."""
        self.must_lift = self._lifts

    def begin(self, row: int) -> None:
        """Stand where `row` begins, as the program does."""
        self.page.begin_at(self._begin_counts[row])
        self._off_grid = not _is_on_grid(np.nan_to_num(self._begins[row]).tolist())

    def lift(self, higher_mm: float = 0.0) -> None:
        """Retract to clearance, or above it, from below."""
        height, wanted = self.page.at[2], self._clearance + self.grid.count(higher_mm)
        if self._lifts and self.has_height and (height is None or height < wanted):
            self.page.move(RAPID, [None, None, wanted], self.options.rapid_mm_min)

    def rebase(self, row: int) -> None:
        """Take the place before `row` in the work system now in force; what was a whole digit there is none here."""
        self.page.at = list(self._begin_counts[row])
        self.page.forget()
        moved = self.grid.exact(self._offsets[row] - self._offsets[max(row - 1, 0)])
        self._off_grid = not _is_on_grid(moved.tolist())

    def _approach(self, begin: Counts, end: Counts, kind: int, feed: float) -> None:
        """Come from clearance to where the row begins: over the place first, then down."""
        self.lifted = False
        x, y, z = end if kind == RAPID else begin
        if kind == RAPID:
            if z is None or z < self._clearance:
                self.page.move(RAPID, [x, y, None], feed)
            return
        self.page.move(RAPID, [x, y, None], self.options.rapid_mm_min)
        if z is not None:
            height = self.page.at[2]
            up = height is not None and z > height
            self.page.move(RAPID if up else LINE, [None, None, z], self.options.rapid_mm_min if up else feed)

    def _arc(self, row: int, kind: int, feed: float) -> None:
        plane = self._planes[row]
        first, second, normal = PLANE_AXES[plane]
        begin, end = self._begins[row], self._ends[row]
        limits = self._chords if self._becomes_lines(row, plane) else self._limits
        for arc, low, high, turns in self._turns(row, kind == ARC_CW, limits):
            at_first, at_second = self.page.at[first], self.page.at[second]
            if at_first is None or at_second is None:
                raise self._refusal(row, "the arc begins at a place that is not known")
            pieces = rounded((at_first, at_second), arc, limits)
            for piece in pieces:
                share = low + (high - low) * piece.share
                target: Counts = [None, None, None]
                target[first], target[second] = piece.end
                if not isnan(end[normal]):
                    target[normal] = round(begin[normal] + share * (end[normal] - begin[normal]))
                if piece.offset is None:
                    self.page.move(LINE, target, feed)
                else:
                    self.page.arc(kind, target, piece.offset, plane, feed, turns if len(pieces) == 1 else 1)
        self.page.move(LINE, self._end_counts[row], feed)  # only what rounding left of a helix that vanished

    def _becomes_lines(self, row: int, plane: int) -> bool:
        """Whether the dialect lacks this arc, so that lines stand for it."""
        normal = PLANE_AXES[plane][2]
        rises = self._begins[row][normal] != self._ends[row][normal] and not isnan(self._ends[row][normal])
        lacks = ""
        if not self._has_arcs:
            lacks = "arcs"
        elif not self.page.has_plane(plane):
            lacks = "arcs outside the plane XY"
        elif rises and not self.page.writing.helices:
            lacks = "helices"
        if lacks:
            self._note(
                row,
                Text("{lacks} became lines, at most {chord_mm:g} mm away", lacks=lacks, chord_mm=self.options.chord_mm),
            )
        return bool(lacks)

    def _turns(self, row: int, clockwise: bool, limits: Limits) -> Iterator[tuple[TrueArc, float, float, int]]:
        """Yield (arc, share of the row at its begin, at its end, P word) for each arc to be written."""
        first, second, _ = PLANE_AXES[self._planes[row]]
        points = (self._begins[row], self._ends[row], self._centres[row])
        begin, end, centre = ((point[first], point[second]) for point in points)
        last = TrueArc(begin, end, centre, clockwise)
        turns = self.turns[row]
        if turns == 1:
            yield from self._halves(row, last, 0.0, 1.0)
            return
        if self._turns_word and any(piece.offset for piece in self._try(last, limits)):
            yield last, 0.0, 1.0, turns
            return
        if limits is self._limits:
            self._note(row, "several turns of an arc became one arc a turn")
        whole = FULL_TURN * (turns - 1) + last.sweep_rad
        share = FULL_TURN / whole
        for turn in range(turns - 1):
            yield from self._halves(row, TrueArc(begin, begin, centre, clockwise), turn * share, (turn + 1) * share)
        yield from self._halves(row, last, share * (turns - 1), 1.0)

    def _halves(self, row: int, arc: TrueArc, low: float, high: float) -> Iterator[tuple[TrueArc, float, float, int]]:
        """Yield the arc, or two where the dialect has no full circles."""
        if self.page.writing.full_circles or arc.sweep_rad < FULL_TURN:
            yield arc, low, high, 1
            return
        self._note(row, "full circles became two arcs")
        middle, half = arc.at(0.5), (low + high) / 2
        yield replace(arc, end=middle), low, half, 1
        yield replace(arc, begin=middle), half, high, 1

    def _try(self, arc: TrueArc, limits: Limits) -> tuple[Piece, ...]:
        """Return the pieces of an arc where one line holds it whole, else nothing."""
        pieces = rounded((round(arc.begin[0]), round(arc.begin[1])), arc, limits)
        return pieces if len(pieces) == 1 else ()

    def _arc_limits(self, dialect: Dialect) -> Limits:
        rule = dialect.arc_rules[self.options.units].limits(self.grid.counts)
        flat = self.grid.exact(self.options.flat_mm) if self.options.flat_mm > 0 else 0.5
        return Limits(rule, flat, self.grid.exact(self.page.writing.largest_radius_mm))

    def _origins(self, keeps_lengths: bool) -> np.ndarray:
        """Return where each row's coordinates begin, mm; G92, and lengths that have no word, are in them."""
        states = self.table.state
        origins = np.zeros((len(self.path.states), 3))
        for index, first in zip(*np.unique(states, return_index=True), strict=True):
            origins[index] = self._origin(self.path.states[index], keeps_lengths, int(self.table.line[first]))
        return origins[states]

    def _origin(self, state: State, keeps_lengths: bool, line: int) -> np.ndarray:
        origin = np.array(state.offset_mm[:3]) - np.array(state.g92_mm[:3])
        if any(state.g92_mm):
            self.page.notes.add("the shift of G92 went into the coordinates", line)
        if state.tool_length_mm and not keeps_lengths:
            origin[2] -= state.tool_length_mm
            self.page.notes.add("lengths of tools went into the coordinates", line)
        return origin

    def _note(self, row: int, what: str) -> None:
        self.page.notes.add(what, int(self.table.line[row]))

    def _check_known(self, row: int) -> None:
        for axis, (begin, end) in enumerate(zip(self._begins[row], self._ends[row], strict=True)):
            if isnan(end) and not isnan(begin):
                raise self._refusal(row, Text("the row leads to an unknown place along {axis}", axis=AXES[axis]))

    def _refusal(self, row: int, what: str) -> ProgramError:
        line = int(self.table.line[row])
        value = f"row {row}" + f", line {line}" * bool(line)
        advice = "G53 and G28 have no place in work coordinates: give the work zero, or take them out"
        return ProgramError("unknown-position", what, value=value, advice=advice)


def _whole(points: np.ndarray) -> list[Counts]:
    """Return points in whole counts, None where a coordinate is not known."""
    if not np.isnan(points).any():
        return np.rint(points).astype(np.int64).tolist()
    return [[None if isnan(count) else round(count) for count in point] for point in points.tolist()]


def _is_on_grid(point: Sequence[float]) -> bool:
    """Whether a point or way, in counts, has whole last digits."""
    return all(abs(count - round(count)) < SAME_COUNT for count in point)


def _check_axes(toolpath: Toolpath) -> None:
    """Refuse moves of further axes."""
    table = toolpath.table()
    further = table.end[:, 3:]
    moved = (further != further[:1]).any(axis=1)
    if moved.any():
        what, value = "programs with more than the axes X, Y and Z are not written", f"{table.end.shape[1]} axes"
        line = int(table.line[np.argmax(moved)])
        place = Place("", line) if line else None
        raise ProgramError("axes", what, value=value, advice="leave the others out", place=place)
