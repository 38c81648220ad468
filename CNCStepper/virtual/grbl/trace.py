# SPDX-License-Identifier: LGPL-2.1-or-later
"""The path that the axes took, as a CSV file: simulated seconds and machine coordinates."""

from __future__ import annotations

from pathlib import Path

from CNCStepper.errors import LinkError
from CNCStepper.virtual.grbl.machine import Grbl

HEADER = "t_s,x_mm,y_mm,z_mm\n"


class Trace:
    """Writes a row for each place of the axes that differs from the last; on disk whenever they rest."""

    def __init__(self, path: str | Path):
        try:
            self._file = open(path, "w", encoding="ascii", newline="")  # noqa: SIM115
        except OSError as error:
            raise LinkError(
                "trace-file", f"the trace '{path}' cannot be written: {error.strerror}", advice="give another path"
            ) from error
        self._file.write(HEADER)
        self._last: tuple[int, ...] | None = None
        self._flushed = False

    def note(self, board: Grbl) -> None:
        """Write where the axes are now, if they have moved."""
        place = board.axes.position_steps
        if place != self._last:
            self._last = place
            self._file.write(",".join([f"{board.time_s:.6f}", *(f"{mm:.6f}" for mm in board.axes.position_mm)]) + "\n")
            self._flushed = False
        elif not self._flushed:
            self._file.flush()
            self._flushed = True

    def close(self) -> None:
        """Write out what is left."""
        self._file.close()
