# SPDX-License-Identifier: LGPL-2.1-or-later
"""On which side of its gap a job's lines have left each motor, where they take up the play of the axes.

So that who was jogged between two lines comes back as the next line presumes it, on that side (`program_pause.py`).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence, Set
from math import inf
from typing import TYPE_CHECKING

from CNCStepper.control.program.certificate import CHECK_AGAIN
from CNCStepper.control.program.send_job import SendJob
from CNCStepper.control.protocol.grbl.status_reports import Vector
from CNCStepper.control.stream.return_after_jog import THERE_MM, Axes, back_over_backlash
from CNCStepper.errors import JobError, Text
from CNCStepper.state import ZERO3

if TYPE_CHECKING:
    import numpy as np

    from CNCStepper.machine.backlash import Backlash

UP = 2  # the axis


class BacklashTracker:
    """Follows the motors of one job, line by line as they are sent.

    ahead_mm: how far each stands ahead of its tool, by axis. top_mm: the greatest height of Z to which the lines have
    led, in machine coordinates.
    """

    def __init__(self, play: Backlash):
        self.ahead_mm: Sequence[float] = ZERO3  # as the lines presume it before the first
        self.top_mm = -inf
        self._play = play

    def begin(self, ahead_mm: Sequence[float]) -> None:
        """Stand so far ahead, at most as far as the gaps allow."""
        self.ahead_mm = [self._play.ahead_after(axis, ahead, 0.0) for axis, ahead in enumerate(ahead_mm)]

    def follow(self, here_mm: np.ndarray, ends_mm: np.ndarray) -> None:
        """Follow moves from a place, in machine coordinates, float64[3] and float64[n, 3], in which no axis turns."""
        place_mm = here_mm.tolist()
        for end_mm in ends_mm.tolist():
            ways_mm = [end - begin for begin, end in zip(place_mm, end_mm, strict=True)]
            self.ahead_mm = [
                self._play.ahead_after(axis, *pair)
                for axis, pair in enumerate(zip(self.ahead_mm, ways_mm, strict=True))
            ]
            self.top_mm = max(self.top_mm, place_mm[UP], end_mm[UP])
            place_mm = end_mm

    def way_back(
        self, here_mm: Vector, there_mm: Vector, loose: Set[int], work_zero_mm: float
    ) -> Iterator[tuple[Axes, float]]:
        """Yield positions and speeds of the motors' return, as `back_over_backlash`, in work mm.

        loose: the axes that were moved, or have to be. work_zero_mm: how high the work zero is, in machine coordinates.
        """
        top_mm = self.top_mm - work_zero_mm if loose - {UP} else -inf
        at_mm = list(here_mm)
        for axes, feed_mm_min in back_over_backlash(here_mm, there_mm, self.ahead_mm, loose, top_mm, self._play):
            end_mm = [at if axis is None else axis for at, axis in zip(at_mm, axes, strict=True)]
            if any(abs(end - at) > THERE_MM for at, end in zip(at_mm, end_mm, strict=True)):
                yield axes, feed_mm_min
                at_mm = end_mm


def backlash_tracker(job: SendJob) -> BacklashTracker | None:
    """Return those of a job at its begin, None where its lines take up no play; raises JobError for a bad profile."""
    profile = job.retrace.get("machine") or {}
    if not any(axis.get("backlash_mm") for axis in profile.get("axis", {}).values()):
        return None
    from pydantic import ValidationError

    from CNCStepper.gcode.wire.backlash_compensation import backlash_of
    from CNCStepper.machine.profile import Machine

    try:
        machine = Machine.model_validate(profile)
    except ValidationError as error:
        what = Text("the job's machine profile cannot be read: {error}", error=error)
        raise JobError("machine-profile", what, advice=CHECK_AGAIN) from error
    play = backlash_of(machine, machine.language(job.dialect))
    return BacklashTracker(play) if play else None
