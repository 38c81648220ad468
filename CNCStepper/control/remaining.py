# SPDX-License-Identifier: LGPL-2.1-or-later
"""How long a job still takes: its planned times, corrected by how long its lines really took."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from CNCStepper.workbench.dock.state import STANDING

TRUSTED_S = 5.0  # of planned time that must lie behind before the measured ratio counts wholly


class Remaining:
    """The clock of one job.

    lines, ends_s: the file line and the planned end of every row of the program, in s from its begin; both empty for
    a job of which only the number of lines is known. expected_ratio: real seconds in a planned one, to begin with.
    """

    def __init__(self, lines: Sequence[int] = (), ends_s: Sequence[float] = (), expected_ratio: float = 1.0):
        self._lines, self._ends_s = _by_line(lines, ends_s)
        self._expected_ratio = expected_ratio
        self._moving_s = 0.0
        self._last_s: float | None = None
        self._planned_s = 0.0
        self._fraction = 0.0

    @property
    def planned_s(self) -> float:
        """The planned duration of the whole program, 0 when it is not known."""
        return float(self._ends_s[-1]) if len(self._ends_s) else 0.0

    def take(self, phase: str, elapsed_s: float, file_line: int, acknowledged: int, total: int) -> None:
        """Learn from a status; time during which the machine was seen held does not count as cutting."""
        if phase not in STANDING or self._last_s is None:
            self._moving_s += max(elapsed_s - (self._last_s or 0.0), 0.0)
        self._last_s = elapsed_s
        self._planned_s = self._planned_to(file_line)
        self._fraction = acknowledged / total if total else 0.0

    @property
    def ratio(self) -> float:
        """Real seconds in a planned one, as measured; the expected one counts less the longer the job is cut."""
        if self._planned_s <= 0.0:
            return self._expected_ratio
        trust = min(self._planned_s / TRUSTED_S, 1.0)
        return (1.0 - trust) * self._expected_ratio + trust * self._moving_s / self._planned_s

    @property
    def remaining_s(self) -> float | None:
        """The time still to go, None when nothing can be said yet."""
        if self.planned_s:
            return max(self.planned_s - self._planned_s, 0.0) * self.ratio
        if self._fraction <= 0.0:
            return None
        return self._moving_s * (1.0 - self._fraction) / self._fraction

    @property
    def done(self) -> float:
        """The part of the work that lies behind, 0 to 1: by planned time where it is known, else by lines."""
        return min(self._planned_s / self.planned_s, 1.0) if self.planned_s else self._fraction

    def _planned_to(self, file_line: int) -> float:
        if not self.planned_s:
            return 0.0
        import numpy as np

        index = int(np.searchsorted(self._lines, file_line, side="right")) - 1
        return float(self._ends_s[index]) if index >= 0 else 0.0


def _by_line(lines: Sequence[int], ends_s: Sequence[float]) -> tuple[Any, Any]:
    """Return the file lines in rising order and the latest planned end up to each."""
    if not len(lines):
        return (), ()
    import numpy as np

    order = np.argsort(np.asarray(lines), kind="stable")
    return np.asarray(lines)[order], np.maximum.accumulate(np.asarray(ends_s, dtype=float)[order])
