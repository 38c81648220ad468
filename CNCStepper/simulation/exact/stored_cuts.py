# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cutting paths of a program's earlier parts, on the disk, read on demand.

    blocks    (cutter, where in the file, how many segments)     float64[n, 7] each: begin, end and row

The file has no name, or goes with its folder, so that nothing is left of a check that is killed.
"""

from __future__ import annotations

import tempfile
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from CNCStepper.simulation.cutter_solid import Cutter
from CNCStepper.simulation.exact.segment_blocks import Blocks
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
            yield cutter, _segments(np.frombuffer(self._file.read(8 * COLUMNS * count)).reshape(-1, COLUMNS))

    def by_cutter(self) -> list[tuple[Cutter, Blocks]]:
        """Return the whole path, each cutter's in blocks that are read as often as they are asked for."""
        cutters = dict.fromkeys(cutter for cutter, _, _ in self._blocks)
        return [(cutter, Blocks(_OfCutter(self, cutter))) for cutter in cutters]

    def of(self, cutter: Cutter) -> Iterator[Segments]:
        """Yield the path of one cutter, as many blocks at once as are not longer than one of BLOCK segments."""
        waiting, count = [np.zeros((0, COLUMNS))], 0
        for _, place, length in (block for block in self._blocks if block[0] == cutter):
            if count + length > BLOCK:
                yield _segments(np.concatenate(waiting))
                waiting, count = [], 0
            self._file.seek(place)
            waiting.append(np.frombuffer(self._file.read(8 * COLUMNS * length)).reshape(-1, COLUMNS))
            count += length
        yield _segments(np.concatenate(waiting))

    def close(self) -> None:
        """Give the disk back."""
        self._file.close()


@dataclass(frozen=True)
class _OfCutter:
    kept: StoredCuts
    cutter: Cutter

    def __iter__(self) -> Iterator[Segments]:
        return self.kept.of(self.cutter)


def _segments(columns: np.ndarray) -> Segments:
    return Segments(columns[:, :3], columns[:, 3:6], columns[:, 6].astype(np.int64))
