# SPDX-License-Identifier: LGPL-2.1-or-later
"""The path that the axes took, as a CSV file: simulated seconds and machine coordinates in mm."""

from __future__ import annotations

from io import TextIOWrapper
from pathlib import Path

from CNCStepper.atomic_file import open_live
from CNCStepper.errors import LinkError, Text
from CNCStepper.virtual.grbl.machine import Grbl

HEADER = "t_s,x_mm,y_mm,z_mm\n"


class Trace:
    """Writes a row for every step of the axis that moves farthest.

    The board tells where it is whenever the planner changes the pace, so that between two tellings the
    path is straight and its speed constant: the rows between are set on that line, and no place of the
    true path is farther from a row than one step. The first row is where and when the first motion begins.
    """

    def __init__(self, path: str | Path, board: Grbl):
        try:
            self._file = TextIOWrapper(open_live(Path(path)), encoding="ascii", newline="")
        except OSError as error:
            raise LinkError(
                "trace-file",
                Text("the trace '{path}' cannot be written: {error}", path=path, error=error.strerror),
                advice="give another path",
            ) from error
        self._file.write(HEADER)
        self._time_s = board.time_s
        self._written_s = -1.0
        self._steps = board.axes.position_steps
        self._mm = board.axes.position_mm
        self._declared = board.axes.declared
        board.on_step = self._note

    def flush(self) -> None:
        """Put on disk what has been noted so far."""
        self._file.flush()

    def close(self) -> None:
        """Write out what is left."""
        self._file.close()

    def _note(self, board: Grbl) -> None:
        steps = board.axes.position_steps
        if steps != self._steps:
            went = board.axes.declared == self._declared  # homing sets a place without going there
            rows = max(abs(now - before) for now, before in zip(steps, self._steps, strict=True)) if went else 1
            self._draw(board.time_s, board.axes.position_mm, rows)
            self._steps = steps
        self._time_s = board.time_s
        self._declared = board.axes.declared

    def _draw(self, time_s: float, mm: list[float], rows: int) -> None:
        """Write `rows` rows from the last place to this one."""
        begin_s, begin = self._time_s, self._mm
        if begin_s > self._written_s:  # the axes have rested
            self._write(begin_s, begin)
        for row in range(1, rows + 1):
            part = row / rows
            place = [before + (now - before) * part for before, now in zip(begin, mm, strict=True)]
            self._write(begin_s + (time_s - begin_s) * part, place)
        self._mm = mm

    def _write(self, time_s: float, mm: list[float]) -> None:
        self._file.write(f"{time_s:.6f},{mm[0]:.6f},{mm[1]:.6f},{mm[2]:.6f}\n")
        self._written_s = time_s
