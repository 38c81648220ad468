# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cutting paths of a program's earlier parts, kept on the disk: what is asked of them is read when it is asked.

    blocks    (cutter, where in the file, how many segments)     float64[n, 7] each: begin, end and row

The file has no name, or goes with its folder, so that nothing is left of a check that is killed.
"""

from __future__ import annotations

import tempfile
from collections import Counter
from collections.abc import Iterator

import numpy as np

from CNCStepper.simulation.cutter_solid import Cutter
from CNCStepper.simulation.exact.stock_contact import Cuts
from CNCStepper.simulation.tip_segments import Segments

BLOCK = 65_536  # segments that are read at once
COLUMNS = 7


class StoredCuts:
    """The tip's path below the stock's top, by cutter, of all parts that were added; iterating reads it.

    Its rows are those of the whole program.
    """

    def __init__(self) -> None:
        self._file = tempfile.TemporaryFile(prefix="cncstepper-cuts-")  # noqa: SIM115  closed by close()
        self._blocks: list[tuple[Cutter, int, int]] = []

    def add(self, cuts: Cuts, row: int = 0) -> None:
        """Keep the path of a part whose rows begin at `row` of the program; raises OSError on a full disk."""
        for cutter, pieces in cuts:
            for first in range(0, len(pieces), BLOCK):
                some = pieces[first : first + BLOCK]
                self._blocks.append((cutter, self._file.seek(0, 2), len(some)))
                self._file.write(np.column_stack([some.begin, some.end, some.row + float(row)]).tobytes())
        self._file.flush()

    def __iter__(self) -> Iterator[tuple[Cutter, Segments]]:
        for cutter, place, count in self._blocks:
            self._file.seek(place)
            columns = np.frombuffer(self._file.read(8 * COLUMNS * count)).reshape(-1, COLUMNS)
            yield cutter, Segments(columns[:, :3], columns[:, 3:6], columns[:, 6].astype(np.int64))

    def joined(self) -> list[tuple[Cutter, Segments]]:
        """Return the whole path, each cutter's as one."""
        counts = Counter[Cutter]()
        for cutter, _, count in self._blocks:
            counts[cutter] += count
        whole = {cutter: _room(count) for cutter, count in counts.items()}
        filled = Counter[Cutter]()
        for cutter, some in self:
            place = slice(filled[cutter], filled[cutter] + len(some))
            for name in ("begin", "end", "row"):
                getattr(whole[cutter], name)[place] = getattr(some, name)
            filled[cutter] += len(some)
        return list(whole.items())

    def close(self) -> None:
        """Give the disk back."""
        self._file.close()


def _room(count: int) -> Segments:
    """Return so many segments, to be filled."""
    return Segments(np.empty((count, 3)), np.empty((count, 3)), np.empty(count, np.int64))
