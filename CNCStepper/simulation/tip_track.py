# SPDX-License-Identifier: LGPL-2.1-or-later
"""The position of the tool's tip at any time, and the program line that moves it there.

begins_s   ends_s        A row's share of its way grows evenly between the two moments, along its arc;
   |  row k  |           before `begins_s` the tool stands (a dwell), and so it does at a point whose
---+=========+---        way there is not known.

Steps through a program's time by move or by line: from any time to the next end of one, and back.
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from functools import cached_property
from pathlib import Path

import numpy as np

from CNCStepper.simulation.arc_chords import Arcs, arcs_of
from CNCStepper.simulation.tip_segments import tips_mm
from CNCStepper.toolpath import Chunk, Toolpath


def end_after(ends_s: np.ndarray, time_s: float) -> float:
    """Return the first of the rising `ends_s` that is later than a moment, else the last; 0 where there is none."""
    place = int(np.searchsorted(ends_s, time_s, side="right"))
    return float(ends_s[min(place, len(ends_s) - 1)]) if len(ends_s) else 0.0


def end_before(ends_s: np.ndarray, time_s: float) -> float:
    """Return the last of the rising `ends_s` that is earlier than a moment, else 0, the begin."""
    place = int(np.searchsorted(ends_s, time_s, side="left"))
    return float(ends_s[place - 1]) if place else 0.0


def ends_of_lines_s(ends_s: np.ndarray, lines: np.ndarray) -> np.ndarray:
    """Return when each line is done, from the ends and the lines of all moves in the order in which they are run."""
    return ends_s[np.r_[lines[1:] != lines[:-1], True]] if len(lines) else ends_s


@dataclass(frozen=True)
class TipTrack:
    """The moves of a program in time; all arrays have one entry a row.

    begin, end, centre: float64[n, 3], of the tip in the stock's work coordinates, mm, NaN where unknown.
    kind, plane, turns: as in the table of moves. begins_s, ends_s: rising. line: of the file, from 1.
    tool: the number of the tool that moves.
    """

    begin: np.ndarray
    end: np.ndarray
    centre: np.ndarray
    kind: np.ndarray
    plane: np.ndarray
    turns: np.ndarray
    begins_s: np.ndarray
    ends_s: np.ndarray
    line: np.ndarray
    tool: np.ndarray

    @classmethod
    def of(cls, toolpath: Toolpath, ends_s: np.ndarray) -> TipTrack:
        """Return the track of a table of moves whose rows end at `ends_s`."""
        table = toolpath.table()
        begin, end = tips_mm(toolpath)
        centre = table.centre + (end - table.end[:, :3])
        tool = np.array([state.tool for state in toolpath.states], np.int32)[table.state]
        columns = (table.kind, table.plane, table.turns, _begins_s(toolpath, ends_s), ends_s, table.line, tool)
        return cls(begin, end, centre, *columns)

    def __len__(self) -> int:
        return len(self.ends_s)

    @property
    def duration_s(self) -> float:
        """The time at which the last row ends."""
        return float(self.ends_s[-1]) if len(self) else 0.0

    def save(self, path: Path) -> None:
        """Write it as a file of arrays."""
        np.savez(path, **{entry.name: getattr(self, entry.name) for entry in fields(self)})

    @classmethod
    def load(cls, path: Path) -> TipTrack:
        """Return the track that `save` wrote."""
        with np.load(path, allow_pickle=False) as arrays:
            return cls(**{entry.name: arrays[entry.name] for entry in fields(cls)})

    def row_at(self, time_s: float) -> int:
        """Return the row that runs at a time; the first one before the begin, the last one after the end."""
        return min(int(np.searchsorted(self.ends_s, time_s, side="left")), len(self) - 1)

    def share_at(self, row: int, time_s: float) -> float:
        """Return the share of a row that is done at a time, from 0 to 1."""
        length_s = float(self.ends_s[row] - self.begins_s[row])
        return min(max((time_s - float(self.begins_s[row])) / length_s, 0.0), 1.0) if length_s > 0 else 1.0

    def tip_mm(self, row: int, share: float) -> np.ndarray:
        """Return where the tip is, float64[3], when it has done a share of a row's way; NaN where it is not known."""
        begin, end = self.begin[row], self.end[row]
        point = (begin + (end - begin) * share if share < 1.0 else end.copy())[None, :]
        if share < 1.0:
            for arcs in self._arcs:
                arcs.bend(point, np.array([row]), np.array([share]))
        return np.where(np.isfinite(point[0]), point[0], np.where(np.isfinite(begin), begin, end))

    def tips_mm(self, rows: np.ndarray, shares: np.ndarray) -> np.ndarray:
        """Return where the tip is, float64[n, 3], at shares of rows' ways; NaN where it is not known."""
        points = self.begin[rows] + (self.end[rows] - self.begin[rows]) * shares[:, None]
        for arcs in self._arcs:
            arcs.bend(points, rows, shares)
        return points

    def row_of_line(self, line: int) -> int:
        """Return the last row of a line of the file, or of the nearest line before it that moves; else the first."""
        return max(int(np.searchsorted(self._rising_lines, line, side="right")) - 1, 0)

    def next_s(self, time_s: float, by_line: bool) -> float:
        """Return when the line in hand, or else the move, is done; steps forwards."""
        return end_after(self._line_ends_s if by_line else self.ends_s, time_s)

    def before_s(self, time_s: float, by_line: bool) -> float:
        """Return when the line in hand, or else the move, began; steps backwards."""
        return end_before(self._line_ends_s if by_line else self.ends_s, time_s)

    @cached_property
    def _arcs(self) -> list[Arcs]:
        table = Chunk(0, self.kind, self.end, self.centre, self.plane, self.turns, self.ends_s, self.tool, self.line)
        return arcs_of(table, self.begin, self.end, self.centre)

    @cached_property
    def _rising_lines(self) -> np.ndarray:
        return np.maximum.accumulate(self.line)

    @cached_property
    def _line_ends_s(self) -> np.ndarray:
        return ends_of_lines_s(self.ends_s, self.line)


def _begins_s(toolpath: Toolpath, ends_s: np.ndarray) -> np.ndarray:
    """Return the time at which every row starts: the end of the row before, and the dwells between."""
    begins_s = np.concatenate([[0.0], ends_s[:-1]])[: len(ends_s)]
    for event in toolpath.events:
        if event.kind == "dwell" and event.index < len(ends_s):
            begins_s[event.index] += event.value
    return np.minimum(begins_s, ends_s)
