# SPDX-License-Identifier: LGPL-2.1-or-later
"""The path for the judge, of a program that is read part after part: on the disk until it is complete."""

from __future__ import annotations

import tempfile
from collections.abc import Sequence

import numpy as np

from CNCStepper.cycles.cycle import Removal
from CNCStepper.simulation.cutter_solid import Tools
from CNCStepper.simulation.exact.stored_cuts import StoredCuts
from CNCStepper.simulation.exact.swept_area import Judgement, cutting_path, judge_cuts
from CNCStepper.simulation.stock import Stock
from CNCStepper.toolpath import Toolpath

LINE = np.dtype("<i4")


class JudgedPath:
    """Parts of a program whose shapes are judged together, and the file's line of each row.

    Neither file has a name, so that nothing is left of a check that is killed. Both raise OSError on a full disk.
    """

    def __init__(self, tools: Tools, stock: Stock):
        self._tools, self._stock = tools, stock
        self._cuts, self._rows = StoredCuts(), 0
        self._lines = tempfile.TemporaryFile(prefix="cncstepper-lines-")  # noqa: SIM115  closed by close()

    def see(self, toolpath: Toolpath) -> None:
        """Take the next part."""
        self._cuts.add(cutting_path(toolpath, self._tools, 0.0, self._stock), self._rows)
        self._lines.write(toolpath.table().line.astype(LINE).tobytes())
        self._rows += len(toolpath)

    def judged(self, removals: Sequence[Removal]) -> Judgement:
        """Return how far the program is from cutting exactly the removals, as `swept_area.judge` does of a whole
        one."""
        return judge_cuts(self._cuts.by_cutter(), removals, self._stock)

    def line(self, row: int) -> int:
        """Return the file's line of a row, and 1 where there is none (-1)."""
        if not 0 <= row < self._rows:
            return 1
        self._lines.seek(row * LINE.itemsize)
        return int(np.frombuffer(self._lines.read(LINE.itemsize), LINE)[0])

    def close(self) -> None:
        """Give the disk back."""
        self._cuts.close()
        self._lines.close()
