# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tip's path of a whole program, kept on the disk until all of it is known, with what each segment belongs to."""

from __future__ import annotations

import tempfile
from collections.abc import Iterator

import numpy as np

from CNCStepper.simulation.tip_segments import Segments

BLOCK = 65_536  # segments that are read at once
RECORD = np.dtype(
    [
        ("begin", "f8", 3),
        ("end", "f8", 3),
        ("row", "i8"),
        ("line", "i4"),
        ("tool", "i4"),
        ("is_feed", "?"),
        ("chip_mm", "f8"),
    ]
)


class TipPathStore:
    """Records of segments in the order in which they are run; iterating reads them, so many at once as a block holds.

    The file has no name, so that nothing is left of a check that is killed.
    """

    def __init__(self) -> None:
        self._file = tempfile.TemporaryFile(prefix="cncstepper-path-")  # noqa: SIM115  closed by close()

    def add(self, records: np.ndarray) -> None:
        """Keep further records; raises OSError on a full disk."""
        self._file.seek(0, 2)
        self._file.write(records.tobytes())

    def __iter__(self) -> Iterator[np.ndarray]:
        self._file.flush()
        place = 0
        while True:
            self._file.seek(place)
            data = self._file.read(BLOCK * RECORD.itemsize)
            if not data:
                return
            place += len(data)
            yield np.frombuffer(data, RECORD)

    def close(self) -> None:
        """Give the disk back."""
        self._file.close()


def path_of_records(records: np.ndarray) -> Segments:
    """Return the segments of records; the row of each is its place among them."""
    return Segments(records["begin"], records["end"], np.arange(len(records)))
