# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a jet or wire does over a sheet, gathered from the rows: cuts, and the travel between them.

    rows    rapid | lead-in  contour  lead-out | rapid | lead-in ...        power is on from | to |
    cut             0       0        0                   1

A row cuts while the power is on, unless it is a rapid. A beam at less than half of the chart's power marks the sheet
and does not go through it. At most MOST_SEGMENTS are kept, so that the memory stays flat: of a longer program the
pieces that it cuts free are not known.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
import shapely
from shapely.geometry import Polygon

from CNCStepper.machine.profile import Machine
from CNCStepper.simulation.check_context import CheckContext, Cutting
from CNCStepper.simulation.cutter_solid import Tools, tool_numbered
from CNCStepper.simulation.exact.beams import beam_rows
from CNCStepper.simulation.stock import Stock
from CNCStepper.simulation.tip_segments import Segments, segments
from CNCStepper.state import State
from CNCStepper.tolerances import NO_LENGTH_MM
from CNCStepper.toolpath import RAPID

FLATTEN_MM = 0.01
MOST_SEGMENTS = 1_000_000
MARKING_SHARE = 0.5  # of the chart's power
BESIDE_MM = 1000.0  # how far a sheet that is not known reaches beyond the path
TORCH = 0  # of $ behind M3


@dataclass(frozen=True)
class PathPieces:
    """Segments seen from above, in the order of the rows.

    ends_mm: x and y of begin and end, float64[n, 4]. low_mm: the lower of their heights, NaN where not known.
    radius_mm: of the kerf. row: of the whole program. line: of the file. cut: the number of the cut that each belongs
    to, from 0. end_s: when the row ends, NaN where that was not told.
    """

    ends_mm: np.ndarray
    low_mm: np.ndarray
    radius_mm: np.ndarray
    row: np.ndarray
    line: np.ndarray
    cut: np.ndarray
    end_s: np.ndarray

    def __len__(self) -> int:
        return len(self.row)

    def __getitem__(self, which: np.ndarray | slice) -> PathPieces:
        return PathPieces(*(getattr(self, name)[which] for name in self.__dataclass_fields__))

    @cached_property
    def lines(self) -> np.ndarray:
        """The segments as shapely lines, object[n]."""
        return shapely.linestrings(self.ends_mm.reshape(-1, 2, 2))

    @cached_property
    def tree(self) -> shapely.STRtree:
        """A tree over the lines."""
        return shapely.STRtree(self.lines)

    @cached_property
    def first_of_cuts(self) -> np.ndarray:
        """The index of the first segment of each cut, int64[cuts]."""
        return np.flatnonzero(np.diff(self.cut, prepend=-1))


def is_torch(state: State) -> bool:
    """Return whether the torch is on: QtPlasmaC's scribe ($1) and its spots ($2) do not go through."""
    return state.spindle_number == TORCH


def joined(parts: list[PathPieces]) -> PathPieces:
    """Return pieces of path as one, in their order."""
    if len(parts) == 1:
        return parts[0]
    return PathPieces(
        *(np.concatenate([getattr(part, name) for part in parts]) for name in PathPieces.__dataclass_fields__)
    )


class SheetCuts:
    """The cuts and the travel of a program that may come in parts, each a whole table of consecutive rows."""

    def __init__(self, cutting: Cutting, tools: Tools, stock: Stock | None):
        self.cutting = cutting
        self.is_complete = True  # all of the path is kept
        self._tools, self._stock = tools, stock
        self._rows = 0
        self._count = -1  # of the last cut
        self._was_on = False
        self._cuts: list[PathPieces] = []
        self._travel: list[PathPieces] = []

    def see(self, subject: CheckContext, ends_s: np.ndarray | None = None) -> None:
        """Take the next part; ends_s: the end of each row, float64[n], where it is known."""
        through, travels = self._rows_that_cut(subject)
        path = segments(subject.toolpath, FLATTEN_MM)
        known = path.known_in((0, 1))
        if sum(map(len, self._cuts)) + sum(map(len, self._travel)) + len(known) > MOST_SEGMENTS:
            self.is_complete = False
        cut = self._numbers(through)
        if self.is_complete:
            ends_s = np.full(len(subject.table), np.nan) if ends_s is None else ends_s
            has_height = np.isfinite(subject.end[:, 2])
            for which, kept in ((through, self._cuts), (travels, self._travel)):
                some = known[which[known.row]]
                kept.append(self._pieces(some, subject, cut, ends_s, has_height))
        self._rows += len(subject.table)

    @cached_property
    def cuts(self) -> PathPieces:
        """The cutting segments of all parts, those that go only up or down too."""
        return joined(self._cuts or [_NONE])

    @cached_property
    def travel(self) -> PathPieces:
        """The segments between the cuts that go sideways."""
        travel = joined(self._travel or [_NONE])
        return travel[_lengths(travel) > NO_LENGTH_MM]

    @cached_property
    def sheet(self) -> Polygon:
        """The sheet's outline; a large one round the path where the stock is not known."""
        if self._stock is not None:
            return self._stock.outline
        ends = self.cuts.ends_mm.reshape(-1, 2)
        if not len(ends):
            return Polygon()
        return shapely.box(*(ends.min(axis=0) - BESIDE_MM), *(ends.max(axis=0) + BESIDE_MM))

    @cached_property
    def moving(self) -> PathPieces:
        """The cutting segments that move sideways: the sheet loses their kerf."""
        return self.cuts[_lengths(self.cuts) > NO_LENGTH_MM]

    def _rows_that_cut(self, subject: CheckContext) -> tuple[np.ndarray, np.ndarray]:
        """Return which rows cut through the sheet, and on which the beam is not on, bool[n] each."""
        is_beam, on = beam_rows(subject.toolpath, self._tools)
        feeds, least = subject.table.kind != RAPID, self._least_rpm(subject.machine)
        through = [is_torch(state) and state.spindle_rpm >= least for state in subject.toolpath.states]
        return on & feeds & np.array(through, bool)[subject.table.state], is_beam & ~(on & feeds)

    def _least_rpm(self, machine: Machine) -> float:
        """Return the S word from which a beam goes through, 0 where the chart's row has no power."""
        data = self.cutting.cut_data
        if data is None or not (data.power or (data.power_percent and machine.has_spindle)):
            return 0.0
        return MARKING_SHARE * data.power_s(machine.spindle.max_rpm)

    def _numbers(self, through: np.ndarray) -> np.ndarray:
        """Return the number of the cut that each row belongs to, int64[n]; of other rows, that of the one before."""
        begins = through & ~np.append(self._was_on, through[:-1])
        cut = self._count + np.cumsum(begins)
        if len(through):
            self._count, self._was_on = int(cut[-1]), bool(through[-1])
        return cut

    def _pieces(
        self, some: Segments, subject: CheckContext, cut: np.ndarray, ends_s: np.ndarray, has_height: np.ndarray
    ) -> PathPieces:
        radius = {number: self._radius_mm(number) for number in np.unique(subject.tool_numbers).tolist()}
        return PathPieces(
            np.hstack([some.begin[:, :2], some.end[:, :2]]),
            np.where(has_height[some.row], some.low_mm, np.nan),
            np.array([radius[number] for number in subject.tool_numbers[some.row].tolist()], float),
            some.row + self._rows,
            subject.table.line[some.row].astype(np.int64),
            cut[some.row],
            ends_s[some.row],
        )

    def _radius_mm(self, number: int) -> float:
        tool = tool_numbered(self._tools, number)
        return tool.radius_mm if tool else 0.0


def _lengths(path: PathPieces) -> np.ndarray:
    return np.hypot(path.ends_mm[:, 2] - path.ends_mm[:, 0], path.ends_mm[:, 3] - path.ends_mm[:, 1])


_NONE = PathPieces(
    np.zeros((0, 4)),
    np.zeros(0),
    np.zeros(0),
    np.zeros(0, np.int64),
    np.zeros(0, np.int64),
    np.zeros(0, np.int64),
    np.zeros(0),
)
