# SPDX-License-Identifier: LGPL-2.1-or-later
"""The remaining time of a job: its planned times, corrected by the time that its lines took.

What is shown never rises in steady cutting. Where the estimate lies above it, the shown clock goes slower, so that both
reach zero together; it follows at once an estimate that lies below, and one of another pace.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Sequence

from CNCStepper.control.session.job_phase import STANDING

TRUSTED_S = 5.0  # of planned time that must lie behind before the measured ratio counts wholly
OTHER_PACE = 1.5  # an estimate so many times the shown time is another pace (an override, a slower machine)


class Remaining:
    """The clock of one job.

    plan: lines of the file in rising order, each with the planned time in s by its end; empty for a job of which only
    the number of lines is known.
    """

    def __init__(self, plan: Sequence[Sequence[float]] = ()):
        self._lines = [line for line, _ in plan]
        self._ends_s = [end_s for _, end_s in plan]
        self._planned_s = self._ends_s[-1] if plan else 0.0
        self._behind_s = 0.0  # of the plan
        self._next_s = 0.0  # of it, when the lines under way are done
        self._moving_s = 0.0
        self._moved_s = 0.0  # of that, when the last line was seen done
        self._last_s: float | None = None
        self._share_of_lines = 0.0
        self._shown_s: float | None = None

    def take(self, phase: str, elapsed_s: float, file_line: int, done: int, total: int) -> None:
        """Note a time at which `done` lines were cut, the last being `file_line` of the file.

        Time during which the machine was seen held does not count as cutting.
        """
        moved_s = 0.0
        if phase not in STANDING or self._last_s is None:
            moved_s = max(elapsed_s - (self._last_s or 0.0), 0.0)
            self._moving_s += moved_s
        self._last_s = elapsed_s
        place = bisect_right(self._lines, file_line)
        before = self.done
        self._behind_s = self._ends_s[place - 1] if place else 0.0
        self._next_s = self._ends_s[min(place, len(self._ends_s) - 1)] if self._ends_s else 0.0
        self._share_of_lines = done / total if total else 0.0
        if self.done != before:
            self._moved_s = self._moving_s
        self._show(moved_s)

    def _show(self, moved_s: float) -> None:
        """Let the shown time go on by the time that the machine has moved."""
        shown_s, estimate_s = self._shown_s, self.estimate_s
        if shown_s is None or estimate_s is None or not shown_s < estimate_s <= OTHER_PACE * shown_s:
            self._shown_s = estimate_s
        else:
            self._shown_s = shown_s - min(moved_s * shown_s / (estimate_s + moved_s), shown_s)

    @property
    def ratio(self) -> float:
        """Real seconds in a planned one, as measured; trusted the more the longer the job is cut."""
        if self._behind_s <= 0.0:
            return 1.0
        trust = min(self._behind_s / TRUSTED_S, 1.0)
        return (1.0 - trust) + trust * self._moved_s / self._behind_s

    @property
    def remaining_s(self) -> float | None:
        """The remaining time as it is shown; None while it is unknown."""
        return self._shown_s

    @property
    def estimate_s(self) -> float | None:
        """The remaining time as measured now; None while it is unknown."""
        if self._planned_s:
            under_way_s = min(self._moving_s - self._moved_s, (self._next_s - self._behind_s) * self.ratio)
            return (self._planned_s - self._behind_s) * self.ratio - under_way_s
        if self._share_of_lines <= 0.0:
            return None
        return self._moved_s * (1.0 - self._share_of_lines) / self._share_of_lines

    @property
    def done(self) -> float:
        """The part of the work that lies behind, 0 to 1: by planned time where it is known, else by lines."""
        return self._behind_s / self._planned_s if self._planned_s else self._share_of_lines
