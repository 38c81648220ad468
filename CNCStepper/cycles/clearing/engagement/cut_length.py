# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cut length of a run at bounded engagement, compared with offset parallels at the same stepover.

A way at the engagement t takes off no more than its stepover a = r (1 - cos t) a millimetre, so it is at least as long
as the material's area over a. Parallels are that long for the area of the tool centre's room, and half the room's loops
longer: the first of them cuts with the tool's whole width, which no bounded way may. In a long channel in which the
tool's centre has w to each side, that makes, in the mean,

    (r + w) / (w + a / 2) times the parallels:   1.6 times at 60 degrees where w = r, at 45 degrees where w = 1.3 r

So there are pockets for which no way is within both bounds. They are refused, with the engagement that would do.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from CNCStepper.cycles.clearing.pattern import Area
from CNCStepper.errors import CycleError, Text
from CNCStepper.geometry.region import Region

LONGEST = 1.6  # times the length of parallels


@dataclass(frozen=True)
class Length:
    """How far a run cuts in its room, and how long the room's parallels are, `apart_mm` apart."""

    cut_mm: float
    parallels_mm: float
    apart_mm: float

    @property
    def times(self) -> float:
        """How many times as far it cuts."""
        return self.cut_mm / self.parallels_mm


def parallels_mm(room: Region, apart_mm: float, tolerance_mm: float) -> float:
    """Return how long a room's loops and all their parallels are."""
    length_mm, ring, count = 0.0, room, 0
    while not ring.empty:
        length_mm, count = length_mm + ring.length_mm, count + 1
        ring = room.offset(-count * apart_mm, tolerance_mm)
    return length_mm


def require_short(area: Area, lengths: Sequence[Length]) -> None:
    """Raise CycleError where the runs of an area together cut more than LONGEST times as far as its parallels."""
    cut_mm, all_parallels_mm = sum(one.cut_mm for one in lengths), sum(one.parallels_mm for one in lengths)
    if cut_mm <= LONGEST * all_parallels_mm:
        return
    together = Length(cut_mm, all_parallels_mm, lengths[0].apart_mm)
    deg = _enough_deg(area, together)
    stepover_mm = math.ceil(100.0 * area.tool_mm * (1.0 - math.cos(math.radians(deg)))) / 100.0
    raise CycleError(
        "engagement-long",
        "the pocket is so narrow that its way at this engagement would be too long beside parallels",
        value=f"{together.times:.2f} times",
        limit=Text("at most {longest:g} times", longest=LONGEST),
        advice=Text(
            "use an engagement_max_deg of {deg} or more with a stepover_mm of {stepover_mm:g} or "
            "more, a smaller tool, or another pattern",
            deg=deg,
            stepover_mm=stepover_mm,
        ),
    )


def _enough_deg(area: Area, length: Length) -> int:
    """Return the least engagement at which the same work, cut length by stepover, would be within LONGEST."""
    half_mm = area.room.length_mm / 2.0
    room_mm2 = (length.parallels_mm - half_mm) * length.apart_mm
    enough_mm = (length.cut_mm * length.apart_mm / LONGEST - room_mm2) / half_mm
    return math.ceil(math.degrees(math.acos(max(1.0 - enough_mm / area.tool_mm, -1.0))))
