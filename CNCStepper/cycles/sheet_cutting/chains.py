# SPDX-License-Identifier: LGPL-2.1-or-later
r"""The drawn chains of a sheet: which are parts, holes and open lines, and what lies in what.

+-----------------+      depth 0   outline of a part: the cut runs outside of it
|  .-----------.  |      depth 1   hole in it: the cut runs inside
|  |  +-----+  |  |      depth 2   a part inside the hole, and so on
|  |  |part |  |  |
|  |  +-----+  |  |      open      cut on its line
|  '-----------'  |
+-----------------+
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import shapely

from CNCStepper.errors import CycleError, Text
from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.cut_order.cut_order import parents
from CNCStepper.tolerances import SAME_CUT_MM

SHORTEST_MM = 0.02  # a shorter curve is nothing to cut


@dataclass(frozen=True)
class Chain:
    """A drawn chain: number from 1 in drawing order, holder: index of the smallest closed chain around it, or -1.

    curve: counter-clockwise where it is closed. depth: how many closed chains lie around it. paths: where the beam's
    centre runs, with the part on the good side; several where the kerf does not get through a narrow place.
    """

    number: int
    curve: Curve
    depth: int
    holder: int
    paths: tuple[Curve, ...]

    @property
    def is_open(self) -> bool:
        """Whether it is cut on its line."""
        return not self.curve.closed

    @property
    def is_hole(self) -> bool:
        """Whether it is the outline of a hole."""
        return self.curve.closed and self.depth % 2 == 1

    @property
    def is_part(self) -> bool:
        """Whether it is the outline of a part."""
        return self.curve.closed and self.depth % 2 == 0

    @property
    def diameter_mm(self) -> float:
        """The diameter of the circle with the same area."""
        return float(2.0 * np.sqrt(abs(self.curve.area_mm2) / np.pi))

    @property
    def title(self) -> str:
        """The chain in words for people."""
        return f"{'line' if self.is_open else 'hole' if self.is_hole else 'part'} {self.number}"


def nested(curves: Sequence[Curve]) -> tuple[list[Chain], list[str]]:
    """Return the chains of drawn curves, without paths, and warnings; raises CycleError for such as have no length."""
    drawn, warnings = _once(curves)
    holders = parents([curve for _, curve in drawn])
    chains = [
        Chain(number, curve if curve.area_mm2 >= 0.0 or not curve.closed else curve.reversed(), 0, holder, ())
        for (number, curve), holder in zip(drawn, holders, strict=True)
    ]
    return [_at_depth(chain, holders) for chain in chains], warnings


def polygon_of(curve: Curve, flat_mm: float) -> shapely.Polygon:
    """Return a closed curve as a polygon of chords."""
    return shapely.Polygon(curve.points(flat_mm))


def _once(curves: Sequence[Curve]) -> tuple[list[tuple[int, Curve]], list[str]]:
    """Return the curves with their numbers, those drawn twice once."""
    drawn: dict[tuple[int, ...], tuple[int, Curve]] = {}
    twice = 0
    for number, curve in enumerate(curves, start=1):
        if not curve.length_mm > SHORTEST_MM:
            raise CycleError(
                "curve-length",
                Text("curve {number} has no length", number=number),
                value=f"{curve.length_mm:g} mm",
                advice="draw it larger, or leave it out",
            )
        curve = curve.without_short()
        middle = curve.xy[:-1].mean(axis=0) if curve.closed else curve.xy[[0, -1]].mean(axis=0)
        measures = (*middle.tolist(), curve.length_mm, abs(curve.area_mm2) if curve.closed else -1.0)
        key = tuple(round(value / SAME_CUT_MM) for value in measures)
        twice += key in drawn
        drawn.setdefault(key, (number, curve))
    warnings: list[str] = [Text("{twice} curve(s) are drawn twice and are cut once", twice=twice)] if twice else []
    return list(drawn.values()), warnings


def _at_depth(chain: Chain, holders: Sequence[int]) -> Chain:
    depth, holder = 0, chain.holder
    while holder >= 0:
        depth, holder = depth + 1, holders[holder]
    return Chain(chain.number, chain.curve, depth, chain.holder, ())
