# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cutting paths of a program's earlier parts, kept on the disk: what is asked of them is read when it is asked.

    blocks    (cutter, where in the file, how many segments)     float64[n, 6] each: begin and end

The file has no name, or goes with its folder, so that nothing is left of a check that is killed.
"""

from __future__ import annotations

import tempfile
from collections.abc import Iterator

import numpy as np

from CNCStepper.simulation.contact import Cuts
from CNCStepper.simulation.cutter import Cutter
from CNCStepper.simulation.segments import Segments

BLOCK = 65_536  # segments that are read at once
COLUMNS = 6


class KeptCuts:
    """The tip's path below the stock's top, by cutter, of all parts that were added; iterating reads it."""

    def __init__(self) -> None:
        self._file = tempfile.TemporaryFile(prefix="cncstepper-cuts-")  # noqa: SIM115  closed by close()
        self._blocks: list[tuple[Cutter, int, int]] = []

    def add(self, cuts: Cuts) -> None:
        """Keep the path of a part; raises OSError on a full disk."""
        for cutter, pieces in cuts:
            for first in range(0, len(pieces), BLOCK):
                some = pieces[first : first + BLOCK]
                self._blocks.append((cutter, self._file.seek(0, 2), len(some)))
                self._file.write(np.hstack([some.begin, some.end]).tobytes())
        self._file.flush()

    def __iter__(self) -> Iterator[tuple[Cutter, Segments]]:
        for cutter, place, count in self._blocks:
            self._file.seek(place)
            columns = np.frombuffer(self._file.read(8 * COLUMNS * count)).reshape(-1, COLUMNS)
            yield cutter, Segments(columns[:, :3], columns[:, 3:], np.zeros(count, np.int64))

    def close(self) -> None:
        """Give the disk back."""
        self._file.close()
