# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part at any planned time, forwards and backwards, with the same bytes in both directions.

    moves    |--------c--------c--------c------|        c: a check-point, a part that shares all tiles with
    moment                        ^                     the one before it that no move has reached since

A moment is cut from the last check-point before it. The last move done, or the share of it that is done, is cut
as if none followed it; a check-point lacks that end, so that going on from it is the same as never stopping.
All check-points together hold at most 512 MB: where they would need more, as far as the first ones say or in the end,
they stand further apart.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from CNCStepper.errors import JobError
from CNCStepper.machine.profile import Machine
from CNCStepper.motion.planner.machine_limits import Limits
from CNCStepper.motion.planner.plan import begun
from CNCStepper.motion.planner.segment_index import Pulse, Pulses
from CNCStepper.simulation.cutter_solid import Tools
from CNCStepper.simulation.removal.heightmap import HeightMap, Part
from CNCStepper.simulation.removal.removal_moves import Moves, moves_of
from CNCStepper.simulation.stock import Stock
from CNCStepper.simulation.tip_track import end_after, end_before, ends_of_lines_s
from CNCStepper.toolpath import Toolpath

WORK_CELLS = 1e6  # cells that the moves between two check-points sweep: some 5 ms, where memory allows it
ARC_WORK = 8  # a cell beside an arc costs as much as that many beside a line
MOST_BYTES = 512_000_000  # of all check-points; where they need more every second one is given up
TELLING = 16  # check-points from which it is told how much all of them need


@dataclass(frozen=True)
class TimelinePosition:
    """A program's position in time: the current row (-1 before the first) and how much of it is done."""

    time_s: float
    row: int
    share: float
    line: int


class Timeline:
    """A program's part by time; `at` answers in any order of times.

    ends_s: end of every row, float64[n], as the planner gives it. Within a row the tool is taken to move evenly.
    machine: the one that planned them, where steps by pulse are wanted. motors: the rows as the motors go them, where
    these differ from the tool's.
    """

    def __init__(
        self,
        toolpath: Toolpath,
        ends_s: np.ndarray,
        tools: Tools,
        stock: Stock,
        cell_mm: float = 0.0,
        machine: Machine | Limits | None = None,
        motors: Toolpath | None = None,
    ):
        self._motors, self._machine = motors or toolpath, machine
        self.ends_s = np.asarray(ends_s, float)
        self.lines = toolpath.table().line
        self.moves = moves_of(toolpath, tools, stock)
        self.stock = stock
        uncut = HeightMap(stock, cell_mm).part
        self.stops, self.parts = _check_points(self.moves, uncut)

    @property
    def duration_s(self) -> float:
        """The time of the whole program."""
        return float(self.ends_s[-1]) if len(self.ends_s) else 0.0

    def moment(self, time_s: float) -> TimelinePosition:
        """Return the program's position at a time; times outside it give its begin or its end."""
        time_s = min(max(float(time_s), 0.0), self.duration_s)
        row = int(np.searchsorted(self.ends_s, time_s, side="left"))
        if not len(self.ends_s) or time_s == 0.0:
            return TimelinePosition(time_s, -1, 1.0, 0)
        begin_s = float(self.ends_s[row - 1]) if row else 0.0
        share = (time_s - begin_s) / (float(self.ends_s[row]) - begin_s)
        return TimelinePosition(time_s, row, share, int(self.lines[row]))

    def at(self, time_s: float) -> HeightMap:
        """Return the part at a time."""
        moment = self.moment(time_s)
        if moment.row < 0:
            return HeightMap(self.stock, part=self.parts[0])
        if moment.share == 1.0:  # rows that take no time end with it
            last_row = int(np.searchsorted(self.ends_s, moment.time_s, side="right")) - 1
            return self.after_row(last_row)
        done, share = self._progress(moment.row, moment.share)
        return self._part(done, share)

    def after_row(self, row: int) -> HeightMap:
        """Return the part after a row of the table; -1 is before the first."""
        return self._part(int(np.searchsorted(self.moves.row, row, side="right")), 0.0)

    def next_row(self, time_s: float, by_line: bool = False) -> float:
        """Return the time at which the move in hand, or with `by_line` the line in hand, is done; steps forwards."""
        return end_after(self._ends_of_steps(by_line), time_s)

    def row_before(self, time_s: float, by_line: bool = False) -> float:
        """Return the time at which the move, or line, in hand began; steps backwards."""
        return end_before(self._ends_of_steps(by_line), time_s)

    def next_pulse(self, time_s: float) -> Pulse | None:
        """Return the first pulse of the motors later than a time, None behind the last; steps forwards.

        Raises JobError where the machine is not known.
        """
        return self._pulses.after(time_s)

    def pulse_before(self, time_s: float) -> Pulse | None:
        """Return the last pulse of the motors earlier than a time, None before the first; steps backwards.

        Raises JobError where the machine is not known.
        """
        return self._pulses.before(time_s)

    def _ends_of_steps(self, by_line: bool) -> np.ndarray:
        return ends_of_lines_s(self.ends_s, self.lines) if by_line else self.ends_s

    @cached_property
    def _pulses(self) -> Pulses:
        if self._machine is None:
            raise JobError("pulse-machine", "pulses are those of a machine", advice="give the timeline its machine")
        return Pulses(begun(self._motors), self._machine)

    def _progress(self, row: int, share: float) -> tuple[int, float]:
        """Return how many moves are done whole, and the share that is done of the next."""
        first, last = np.searchsorted(self.moves.row, [row, row + 1])
        done = int(first + np.searchsorted(self.moves.share[first:last], share, side="right"))
        if done == last:
            return done, 0.0
        before = float(self.moves.share[done - 1]) if done > first else 0.0
        return done, (share - before) / (float(self.moves.share[done]) - before)

    def _part(self, done: int, share: float) -> HeightMap:
        """Return the part after `done` moves and a share of the next."""
        if share == 0.0:
            done, share = done - 1, 1.0
        if done < 0:
            return HeightMap(self.stock, part=self.parts[0])
        stop = int(np.searchsorted(self.stops, done, side="right")) - 1
        part = self.parts[stop].after(self.moves, int(self.stops[stop]), done)
        return HeightMap(self.stock, part=part.after(self.moves.part_of(done, share)))

    @property
    def bytes_held(self) -> int:
        """Memory of the tiles of all check-points; shared ones count once."""
        return _bytes_held(self.parts)


def _check_points(moves: Moves, uncut: Part) -> tuple[np.ndarray, list[Part]]:
    """Return after how many moves the check-points lie, from 0 on, and their parts."""
    work = np.cumsum(_swept_cells(moves, uncut.grid.cell_mm))
    total = float(work[-1]) if len(work) else 0.0
    stops = np.unique(np.r_[0, np.searchsorted(work, np.arange(WORK_CELLS, total, WORK_CELLS))]).tolist()
    kept, parts = [0], [uncut]
    stride, held, number = 1, 0, 1
    while number < len(stops):
        parts.append(parts[-1].after(moves, kept[-1], stops[number]))
        kept.append(stops[number])
        held += sum(parts[-1].tiles[changed].nbytes for changed in parts[-1].changed_since(parts[-2]))
        needed = held * len(stops) / number if len(parts) >= TELLING else held
        if needed > MOST_BYTES:
            kept, parts, stride = kept[::2], parts[::2], stride * 2
            held = _bytes_held(parts)
        number = stops.index(kept[-1]) + stride
    return np.array(kept), parts


def _swept_cells(moves: Moves, cell_mm: tuple[float, float]) -> np.ndarray:
    """Return about how many cells each move computes."""
    radius = moves.forms[moves.form, 0]
    length = np.hypot(*(moves.end - moves.begin)[:, :2].T)
    is_arc = moves.arc >= 0
    arcs = moves.arcs[moves.arc[is_arc]]
    length[is_arc] = np.abs(arcs[:, 3]) * arcs[:, 4]
    area = 2 * radius * length + np.where(moves.joined == 0, 4 * radius**2, radius * max(cell_mm) * 4)
    return np.where(is_arc, ARC_WORK, 1) * area / (cell_mm[0] * cell_mm[1])


def _bytes_held(parts: list[Part]) -> int:
    return sum({id(tile): tile.nbytes for part in parts for tile in part.tiles.values()}.values())
