# SPDX-License-Identifier: LGPL-2.1-or-later
"""The movements of which turning cycles are made, in the frame in which the material lies below the tool.

    outside   r up                     inside (a bore)   the picture is mirrored: r' = -r, so that cycles and
                                                         geometry are the same and the bore's wall lies below

Places are those of the nose's centre; the table gets the control point in the program's coordinates.
"""

from __future__ import annotations

from dataclasses import replace
from math import ceil, hypot

from CNCStepper.cycles.passes import require_few_passes
from CNCStepper.cycles.turning.turned_coordinates import Placement
from CNCStepper.cycles.turning.turning_setup import TurningSetup
from CNCStepper.geometry.curve import Curve
from CNCStepper.tolerances import SAME_MM
from CNCStepper.toolpath import ARC_CCW, ARC_CW, ZX, TableBuilder


def even_passes(deep_mm: float, most_mm: float, name: str) -> int:
    """Return how many even passes of at most `most_mm` cut a depth, one at least; name: of the key that limits them.

    Raises CycleError for more than `MOST_PASSES`.
    """
    require_few_passes(deep_mm, most_mm, name)
    return max(ceil(deep_mm / most_mm - SAME_MM), 1)


class TurningMoves:
    """Appends movements of the nose's centre to a table; z_mm, r_mm: where it is, in the frame."""

    def __init__(self, table: TableBuilder, placement: Placement, setup: TurningSetup):
        self._table, self._placement, self._setup = table, placement, setup
        self.side = -1.0 if setup.tool.is_inside else 1.0
        self._nose = setup.tool.nose_centre
        self._has_cycles = True  # of controllers
        z, r = setup.start
        self.home = (z + self._nose[0], self.side * (r + self._nose[1]))
        self.z_mm, self.r_mm = self.home

    def mirrored(self, setup: TurningSetup) -> TurningMoves:
        """Return the moves of a setup that is the mirror image in z, of the same program; no cycle goes that way."""
        moves = TurningMoves(self._table, self._placement.mirrored(), setup)
        moves._has_cycles = False
        return moves

    def tip(self, z_mm: float, r_mm: float) -> tuple[float, float]:
        """Return where the nose's centre is, in the frame, with the control point at a place of the part."""
        return z_mm + self._nose[0], self.side * (r_mm + self._nose[1])

    def rapid(self, z_mm: float, r_mm: float) -> None:
        """Rapid to a place."""
        if self._moves_to(z_mm, r_mm):
            self._table.rapid(self._place(z_mm, r_mm))
            self.z_mm, self.r_mm = z_mm, r_mm

    def feed(self, z_mm: float, r_mm: float) -> None:
        """Cut straight to a place."""
        if self._moves_to(z_mm, r_mm):
            self._table.feed(self._place(z_mm, r_mm), self._feed_mm_min(r_mm))
            self.z_mm, self.r_mm = z_mm, r_mm

    def follow(self, curve: Curve) -> None:
        """Cut along a curve in (z, r), which begins where the tool is."""
        rows = zip(curve.xy[1:].tolist(), curve.bulge.tolist(), curve.centres.tolist(), strict=True)
        for (z, r), bulge, (centre_z, centre_r) in rows:
            if not bulge:
                self.feed(z, r)
            elif self._moves_to(z, r):
                clockwise = (bulge < 0) != ((self.side < 0) != self._placement.mirrors)
                centre = self._place(centre_z, centre_r)
                kind = ARC_CW if clockwise else ARC_CCW
                self._table.arc(kind, self._place(z, r), centre, self._feed_mm_min(r), plane=ZX)
                self.z_mm, self.r_mm = z, r

    def rapid_tip(self, z_mm: float, r_mm: float) -> None:
        """Rapid with the control point to a place of the part."""
        self.rapid(*self.tip(z_mm, r_mm))

    def thread_tip(self, z_mm: float, r_mm: float, lead_mm: float, rpm: float) -> None:
        """Cut straight with the control point to a place of the part; Z follows the spindle by `lead_mm` a turn."""
        z, r = self.tip(z_mm, r_mm)
        share = hypot(z - self.z_mm, r - self.r_mm) / abs(z - self.z_mm)
        self._table.event("synchronised", lead_mm * share, "G33")
        self._table.feed(self._place(z, r), lead_mm * share * rpm)
        self.z_mm, self.r_mm = z, r

    def open_cycle(self, name: str, words: dict[str, float]) -> None:
        """Begin the span of a cycle."""
        self._table.open_span("turning_cycle", name if self._has_cycles else "", **words)

    def open_profile(self) -> None:
        """Begin the span of a cycle's profile within that of the cycle."""
        self._table.open_span("turned_profile", "")

    def close_cycle(self) -> None:
        """End the innermost of these spans."""
        self._table.close_span()

    def dwell(self, seconds: float) -> None:
        """Wait."""
        if seconds > 0:
            self._table.event("dwell", seconds)

    def go_home(self) -> None:
        """Rapid to the start from beside or before the stock: along z first, then along r."""
        self.rapid(self.home[0], self.r_mm)
        self.rapid(*self.home)

    def approach_front(self, z_mm: float, r_mm: float) -> None:
        """Rapid from the start to a place before the raw end."""
        if self.home[0] >= z_mm:
            self.rapid(self.z_mm, r_mm)
        else:
            self.rapid(z_mm, self.r_mm)
        self.rapid(z_mm, r_mm)

    def approach_top(self, z_mm: float, r_mm: float) -> None:
        """Rapid from the start to a place beside the stock, as far from the axis as nothing is in the way."""
        self.rapid(self.z_mm, max(self.r_mm, r_mm))
        self.rapid(z_mm, self.r_mm)
        self.rapid(z_mm, r_mm)

    def _moves_to(self, z_mm: float, r_mm: float) -> bool:
        return abs(z_mm - self.z_mm) > SAME_MM or abs(r_mm - self.r_mm) > SAME_MM

    def _feed_mm_min(self, r_mm: float) -> float:
        """Return the feed of a move to a place, and let the spindle's speed follow it where it does."""
        rpm = self._setup.rpm_at(self.side * r_mm - self._nose[1])
        if rpm != self._table.state.spindle_rpm:
            self._table.set_state(replace(self._table.state, spindle_rpm=rpm))
        return self._setup.feed_mm_rev * rpm

    def _place(self, z_mm: float, r_mm: float) -> tuple[float, float, float]:
        return self._placement.program(z_mm - self._nose[0], self.side * r_mm - self._nose[1])
