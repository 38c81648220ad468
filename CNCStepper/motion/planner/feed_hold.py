# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hold, resume and override of a pass through a table while its pulses are sent, between two segments.

    speed  ‾‾‾‾‾‾\\              /‾‾‾‾‾       the pass brakes along the path, over corners too; while it is held the
                  \\____....____/             clock goes on by REST_S at a time, and no pulse, no place is lost
           piece │ │ rest rest │ piece

`live_motion.Motion` does the same for a controller that hears at any tick; pulses that are made ahead of their time
cannot.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from CNCStepper.errors import MachineRefusal
from CNCStepper.motion.planner.buffers import TICKS_PER_S
from CNCStepper.motion.planner.look_ahead import plan_again, reload_running_block, set_overrides
from CNCStepper.motion.planner.plan import Run
from CNCStepper.motion.planner.table_planning import run_empty, stand_still

PIECE_ROWS = 4  # segments of the first piece
PIECE_TICKS = round(0.04 * TICKS_PER_S)  # so long or up to thrice as long is what is decided before a hold is heard
REST_S = 0.05
REST_TICKS = round(REST_S * TICKS_PER_S)
LEAST_SHARE, MOST_SHARE = 0.01, 1.0  # no faster than programmed: the port was tried at the program's own rate


class FeedHold:
    """What is asked of a pass while it runs; it may be asked from any thread.

    held: it is to stand still. share: of every programmed speed, feeds and rapids.
    """

    def __init__(self) -> None:
        self.held = False
        self.share = 1.0

    def hold(self) -> None:
        """Request a feed hold along the path."""
        self.held = True

    def resume(self) -> None:
        """Ask to go on."""
        self.held = False

    def slow(self, share: float) -> None:
        """Ask for a share of every speed; raises MachineRefusal outside LEAST_SHARE to MOST_SHARE."""
        if not LEAST_SHARE <= share <= MOST_SHARE:
            limit = f"{100 * LEAST_SHARE:.0f} to {100 * MOST_SHARE:.0f} %"
            what = "pulses go at a share of the programmed speed"
            raise MachineRefusal("override", what, value=f"{100 * share:g} %", limit=limit)
        self.share = share

    def segments(self, run: Run) -> Iterator[np.recarray]:
        """Yield the segments of a pass, few at a time, as `Run.segments` does; none: at rest for REST_S."""
        whole, rows, in_force = run.table, PIECE_ROWS, 1.0
        while True:
            run.table = whole[:rows].view(np.recarray)
            if self.share != in_force:
                in_force = self.share
                set_overrides(run.course.planner, in_force, in_force)
            if self.held:
                yield from self._stand(run)
            begin = run.clock
            if not len(piece := run.piece()):
                break
            rows = _rows_for_next(rows, run.clock - begin, len(whole))
            yield piece
        for dwell in run.stops.last():
            stand_still(run.course, dwell)

    def _stand(self, run: Run) -> Iterator[np.recarray]:
        """Brake, and let time pass until nobody holds any more."""
        planner, table = run.course.planner, run.table
        reload_running_block(planner)
        planner.ramp[0].hold = True
        while count := run_empty(run.course, table, 0):
            yield table[:count].view(np.recarray)
        plan_again(planner)
        while self.held:
            yield table[:0].view(np.recarray)
            stand_still(run.course, REST_TICKS)
        planner.ramp[0].hold = planner.ramp[0].ended = False


def _rows_for_next(rows: int, lasted: int, most: int) -> int:
    """Return how many segments the next piece may have, after one of `rows` that lasted some ticks."""
    if lasted < PIECE_TICKS:
        return min(2 * rows, most)
    return max(rows // 2, 1) if lasted > 3 * PIECE_TICKS else rows
