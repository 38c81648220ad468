# SPDX-License-Identifier: LGPL-2.1-or-later
"""Region: a part of the plane bounded by lines and arcs, with islands; and the regions at a distance from it.

         outer loop, counter-clockwise
       +------- < -------+
       |   .-> -.        |       The region lies to the left of every loop: outer ones run counter-clockwise,
       v  ( hole )       ^       those round holes clockwise. Loops may touch; they never cross.
       |   ' -<- '       |
       +------- > -------+

`Region.of` and `Region.even_odd` take any closed curves: crossing, touching, nested, doubled, in any direction.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from CNCStepper.cancellation import checkpoint
from CNCStepper.errors import GeometryError, Text
from CNCStepper.geometry.boundary_loops import EVEN_ODD, bounds
from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.curve_bundle import Bundle, areas, bundle_of, bundled_rows, short_ones
from CNCStepper.geometry.curve_columns import pairs_of
from CNCStepper.geometry.nearest_point import nearest
from CNCStepper.geometry.offset import left_loops
from CNCStepper.geometry.proximity_tree import spines_of
from CNCStepper.geometry.winding_number import windings
from CNCStepper.tolerances import NO_AREA_MM2, SAME_MM

SMALL_MM = (1e-4, 2e-4, 5e-4, 1e-3)  # how long a step of an outline must be to count; more where that tangles
BESIDE_MM = (4.0 * SAME_MM, 1.2 * SAME_MM)  # distance from a piece at which its two sides are tested


@dataclass(frozen=True, eq=False)
class Region:
    """A region by its loops; see the module's text. Make one with `Region.of`."""

    loops: tuple[Curve, ...]

    @classmethod
    def of(cls, outlines: Sequence[Curve], islands: Sequence[Curve] = ()) -> Region:
        """Return what lies within any of the outlines and within no island.

        Within a curve is where it runs round more often in one direction than in the other. Raises GeometryError
        when a curve is open.
        """
        _require_closed([*outlines, *islands])
        outer = [curve for curve in outlines if _has_length(curve)]
        inner = [curve for curve in islands if _has_length(curve)]
        return cls.trusted(_bounds(outer + inner, len(outer))) if outer else cls(())

    @classmethod
    def even_odd(cls, curves: Sequence[Curve]) -> Region:
        """Return what an odd number of turns of closed curves goes round; raises GeometryError when one is open."""
        _require_closed(curves)
        own = [curve for curve in curves if _has_length(curve)]
        return cls.trusted(_bounds(own, EVEN_ODD)) if own else cls(())

    @classmethod
    def trusted(cls, bundle: Bundle) -> Region:
        """Return the region with the loops of a bundle, which bound one for certain."""
        made = cls(tuple(bundle.curves()))
        made.__dict__["bundle"] = bundle
        return made

    @cached_property
    def bundle(self) -> Bundle:
        """The loops in a few columns, as kernels take them."""
        return bundle_of(self.loops)

    @cached_property
    def rows(self) -> np.ndarray:
        """The segments of all loops; see box_tree.py."""
        return bundled_rows(*self.bundle)  # type: ignore[no-any-return]

    @property
    def empty(self) -> bool:
        """Whether nothing belongs to the region."""
        return not self.loops

    @property
    def area_mm2(self) -> float:
        """The area of the region."""
        return sum(loop.area_mm2 for loop in self.loops)

    @property
    def length_mm(self) -> float:
        """The length of all loops."""
        return sum(loop.length_mm for loop in self.loops)

    def contains(self, points: np.ndarray) -> np.ndarray:
        """Return which points, float64[m, 2], lie in the region, bool[m]; on a loop itself either."""
        if self.empty:
            return np.zeros(len(points), bool)
        return windings(self.rows, pairs_of(points)) > 0  # type: ignore[no-any-return]

    def distances_mm(self, points: np.ndarray) -> np.ndarray:
        """Return how far each point, float64[m, 2], is from the nearest loop; infinite when there is none."""
        if self.empty:
            return np.full(len(points), np.inf)
        return nearest(self.rows, self.spines, pairs_of(points))[0]  # type: ignore[no-any-return]

    @cached_property
    def spines(self) -> np.ndarray:
        """The tree over `rows`; see proximity_tree.py."""
        return spines_of(self.rows)  # type: ignore[no-any-return]

    def offset(self, distance_mm: float, tolerance_mm: float) -> Region:
        """Return the region grown by `distance_mm` on all sides, shrunk when it is below 0, within `tolerance_mm`.

        Loops vanish, split and merge as they must; outer corners become arcs. Where the region is exactly as wide
        as twice the distance, it may vanish there or stay as a strip thinner than the tolerance.
        """
        checkpoint()
        if not tolerance_mm > 0:
            what, advice = "a tolerance must be above 0", "give a tolerance above 0"
            raise GeometryError("offset-tolerance", what, value=f"{tolerance_mm:g} mm", advice=advice)
        if not np.isfinite(distance_mm):
            what, advice = "a distance must be a number", "give a finite number"
            raise GeometryError("offset-distance", what, value=f"{distance_mm:g} mm", advice=advice)
        if self.empty or abs(distance_mm) <= SAME_MM:
            return self
        if distance_mm < 0:
            return Region.trusted(left_loops(self.bundle, -distance_mm, tolerance_mm))
        return Region.trusted(left_loops(self.bundle.reversed(), distance_mm, tolerance_mm).reversed())

    def without_short(self, shortest_mm: float) -> Region:
        """Return the region with runs of steps up to `shortest_mm` long joined up: offsets of offsets gather such."""
        short = short_ones(*self.bundle, shortest_mm) if self.loops else np.zeros(0, bool)
        if not short.any():
            return self
        keeps = np.split(~short, np.cumsum(self.bundle.counts)[:-1])
        return Region(tuple(_joined_up(loop, keep) for loop, keep in zip(self.loops, keeps, strict=True)))

    def parts(self) -> list[Region]:
        """Return the region's pieces that hang together, each one outer loop with the holes in it."""
        outers = sorted((loop for loop in self.loops if loop.area_mm2 > 0), key=lambda loop: loop.area_mm2)
        if len(outers) == 1:
            return [self]
        found: list[list[Curve]] = [[loop] for loop in outers]
        for hole in (loop for loop in self.loops if loop.area_mm2 <= 0):
            found[_holder(outers, hole)].append(hole)
        return [Region(tuple(part)) for part in found]


def _joined_up(loop: Curve, keep: np.ndarray) -> Curve:
    """Return a loop without some of its segments; each remaining one is extended to the next."""
    stay = np.flatnonzero(keep)
    return loop if len(stay) == len(loop) else Curve(loop.xy[np.append(stay, stay[0])], loop.bulge[stay])


def _require_closed(curves: Sequence[Curve]) -> None:
    for curve in curves:
        if not curve.closed:
            gap_mm = float(np.hypot(*(curve.xy[-1] - curve.xy[0])))
            what, advice = "an outline or island is open", "close it"
            raise GeometryError("region-open", what, value=Text("gap {gap_mm:g} mm", gap_mm=gap_mm), advice=advice)


def _has_length(curve: Curve) -> bool:
    return curve.length_mm > SMALL_MM[-1]


def _holder(outers: Sequence[Curve], hole: Curve) -> int:
    """Return which of the outer loops, smallest first, holds a hole: most of it, for the two may touch."""
    places = hole.at_length((np.arange(9) + 0.5) * hole.length_mm / 9)[0]
    for index, outer in enumerate(outers):
        if (outer.winding(places) > 0).sum() > 4:
            return index
    what, advice = "a hole lies in no outline", "draw an outline round it, or leave it out"
    raise GeometryError("region-hole", what, value=f"at {hole.xy[0, 0]:g}, {hole.xy[0, 1]:g}", advice=advice)


def _bounds(curves: Sequence[Curve], outlines: int) -> Bundle:
    """Return the loops round what lies within one of the first curves and none of the others, or EVEN_ODD of all."""
    bundle = bundle_of(curves)
    for small_mm, beside_mm in itertools.product(SMALL_MM, BESIDE_MM):
        closes, found = bounds(bundle, outlines, small_mm, beside_mm)
        if closes:
            return found.where(np.abs(areas(*found)) > NO_AREA_MM2)
    x, y = bundle.xy[0]
    raise GeometryError(
        "region-tangle",
        "outlines and islands lie too close to each other to be told apart",
        value=f"near {x:g}, {y:g}",
        advice=Text("make them coincide, or keep them {small_mm:g} mm apart", small_mm=SMALL_MM[-1]),
    )
