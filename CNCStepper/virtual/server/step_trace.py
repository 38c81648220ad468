# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files of a virtual machine: the positions of its axes as CSV, and the raw bytes received.

Both are written while it runs, so that a killed machine leaves its data.
"""

from __future__ import annotations

from collections.abc import Sequence
from io import TextIOWrapper
from pathlib import Path

import numpy as np

from CNCStepper.atomic_file import open_live
from CNCStepper.errors import LinkError, Text

REST_S = 0.05  # between two steps: the axes rest in between, and a row says so


class StepTrace:
    """Rows of t_s and the axes' places in mm: the first at rest before all, one behind each step, one at rest after.

    columns: names of the axes. A step is where its row is; a rest between two steps has rows at both its ends, so that
    lines between the rows are no slow motion.
    """

    def __init__(self, path: str | Path, columns: Sequence[str]):
        self._file = TextIOWrapper(_open(path), encoding="ascii", newline="")
        self._file.write(",".join(["t_s", *(f"{name}_mm" for name in columns)]) + "\n")
        self._last_s, self._last = 0.0, (0.0,) * len(columns)
        self._rests = True  # a row at rest is the last one
        self._write(0.0, self._last)
        self._file.flush()

    def note(self, blocks: Sequence[np.ndarray]) -> None:
        """Write the places of some blocks, float64[k, 1 + axes], times rising."""
        for block in blocks:
            for time_s, *places in block.tolist():
                if time_s - self._last_s > REST_S:
                    self._write(time_s - REST_S, self._last)
                self._write(time_s, tuple(places))
                self._rests = False

    def rest(self, time_s: float, places: tuple[float, ...]) -> None:
        """Write where the axes rest, once."""
        if not self._rests:
            self._write(max(time_s, self._last_s), places)
            self._rests = True

    def flush(self) -> None:
        """Put on disk what has been noted so far."""
        self._file.flush()

    def close(self) -> None:
        """Write out what is left."""
        self._file.close()

    def _write(self, time_s: float, places: tuple[float, ...]) -> None:
        self._file.write(f"{time_s:.6f},{','.join(f'{place:.6f}' for place in places)}\n")
        self._last_s, self._last = time_s, places


class ByteRecord:
    """The bytes of a client as they came."""

    def __init__(self, path: str | Path):
        self._file = _open(path)

    def note(self, data: bytes) -> None:
        """Write some bytes."""
        self._file.write(data)

    def flush(self) -> None:
        """Put on disk what has come so far."""
        self._file.flush()

    def close(self) -> None:
        """Write out what is left."""
        self._file.close()


def _open(path: str | Path):
    try:
        return open_live(Path(path))
    except OSError as error:
        raise LinkError(
            "trace-file",
            Text("'{path}' cannot be written: {error}", path=str(path), error=error.strerror or ""),
            advice="give another path",
        ) from error
