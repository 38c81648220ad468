# SPDX-License-Identifier: LGPL-2.1-or-later
"""One move of the table as a curve: a point of it, the places nearest to a point, a part of it in either sense.

share   0 ----------- 0.3 ------------------- 1       of the length of a line, of the angle of an arc or helix
        begin         |--- part(0.3, 1) ----> end
        <-part(0.3, 0)|
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from math import atan2, ceil, cos, dist, hypot, isnan, sin, sqrt, tau

from CNCStepper.tolerances import FULL_CIRCLE_RAD, WHOLE_TURNS
from CNCStepper.toolpath import ARC_CCW, ARC_CW, LINE, PLANE_AXES, RAPID

Point = tuple[float, float, float]
STILL_MM = 1e-4  # far less than a step, and more than the last digits of a text


@dataclass(frozen=True)
class Move:
    """A row of a table of moves with the point where it begins; mm, machine coordinates, mm/min (0 for a rapid)."""

    kind: int
    begin: Point
    end: Point
    centre: Point = (0.0, 0.0, 0.0)
    plane: int = 0
    turns: int = 0
    feed_mm_min: float = 0.0

    @property
    def is_arc(self) -> bool:
        """Whether it is an arc or a helix."""
        return self.kind in (ARC_CW, ARC_CCW)

    @property
    def is_known(self) -> bool:
        """Whether its begin is known in all axes."""
        return not any(map(isnan, (*self.begin, *self.end)))

    @property
    def is_still(self) -> bool:
        """Whether it leads nowhere, as that of a tool whose motors cross their gaps."""
        return self.length_mm < STILL_MM

    @cached_property
    def length_mm(self) -> float:
        """The length of the move."""
        if not self.is_arc:
            return dist(self.begin, self.end)
        normal = PLANE_AXES[self.plane][2]
        return hypot(self.sweep_rad * sum(self._radii) / 2, self.end[normal] - self.begin[normal])

    @cached_property
    def sweep_rad(self) -> float:
        """The angle of an arc, positive counter-clockwise."""
        sense = 1.0 if self.kind == ARC_CCW else -1.0
        angle = ((self._angle(self.end) - self._angle(self.begin)) * sense) % tau
        angle = tau if angle <= FULL_CIRCLE_RAD or tau - angle < 1e-12 else angle
        return sense * (angle + tau * max(self.turns - 1, 0))

    @property
    def radius_mm(self) -> float:
        """The radius of an arc at its begin."""
        return self._radii[0]

    def at(self, share: float) -> Point:
        """Return the point at a share of the move, 0 to 1."""
        point = [one + (other - one) * share for one, other in zip(self.begin, self.end, strict=True)]
        if self.is_arc and 0.0 < share < 1.0:
            first, second, _ = PLANE_AXES[self.plane]
            angle = self._angle(self.begin) + self.sweep_rad * share
            radius = self._radii[0] + (self._radii[1] - self._radii[0]) * share
            point[first] = self.centre[first] + radius * cos(angle)
            point[second] = self.centre[second] + radius * sin(angle)
        return point[0], point[1], point[2]

    def nearest(self, point: Sequence[float]) -> Iterator[tuple[float, float]]:
        """Yield (share, distance in mm) of each place that is nearest to `point`: one of a line, of an arc one a turn.

        The ends of an arc count too, where the point lies before or behind it.
        """
        shares = self._arc_shares(point) if self.is_arc else [self._line_share(point)]
        for share in dict.fromkeys(shares):
            yield share, dist(self.at(share), point)

    def part(self, begin: float, end: float) -> Move:
        """Return the part from one share to another, reversed where `end` is the smaller."""
        kind = self.kind
        if end < begin and self.is_arc:
            kind = ARC_CW if kind == ARC_CCW else ARC_CCW
        turns = max(1, ceil(abs(self.sweep_rad * (end - begin)) / tau - WHOLE_TURNS)) if self.is_arc else 0
        return Move(kind, self.at(begin), self.at(end), self.centre, self.plane, turns, self.feed_mm_min)

    def straight(self) -> Move:
        """Return the straight way between its ends."""
        return Move(LINE, self.begin, self.end, feed_mm_min=self.feed_mm_min) if self.kind != RAPID else self

    @cached_property
    def _radii(self) -> tuple[float, float]:
        return self._arm(self.begin), self._arm(self.end)

    def _arm(self, point: Sequence[float]) -> float:
        first, second, _ = PLANE_AXES[self.plane]
        return hypot(point[first] - self.centre[first], point[second] - self.centre[second])

    def _angle(self, point: Sequence[float]) -> float:
        first, second, _ = PLANE_AXES[self.plane]
        return atan2(point[second] - self.centre[second], point[first] - self.centre[first])

    def _line_share(self, point: Sequence[float]) -> float:
        way = [other - one for one, other in zip(self.begin, self.end, strict=True)]
        length = sum(value * value for value in way)
        along = sum((value - one) * step for value, one, step in zip(point, self.begin, way, strict=False))
        return min(1.0, max(0.0, along / length)) if length else 0.0

    def _arc_shares(self, point: Sequence[float]) -> list[float]:
        """Return the shares at which the arc passes the point's angle, and its ends."""
        sweep = abs(self.sweep_rad)
        first = ((self._angle(point) - self._angle(self.begin)) * (1.0 if self.sweep_rad > 0 else -1.0)) % tau
        return [0.0, *((first + tau * turn) / sweep for turn in range(ceil((sweep - first) / tau))), 1.0]


def chords_of(move: Move, arc_tolerance_mm: float) -> int:
    """Return into how many straight pieces grbl cuts an arc, at least one."""
    room = arc_tolerance_mm * (2.0 * move.radius_mm - arc_tolerance_mm) if move.is_arc else 0.0
    return max(1, int(abs(0.5 * move.sweep_rad * move.radius_mm) / sqrt(room))) if room > 0 else 1
