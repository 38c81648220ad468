# SPDX-License-Identifier: LGPL-2.1-or-later
r"""A walk along rings: each new one is reached by a step from one that is laid, and laid ones are ways back.

ring 0 --step--> ring 1 --step--> ring 2        The tool stands on ring 2. Ring 3 is nearest to ring 1: the tool
                      \                         goes along ring 2 to its begin, back over the step, along ring 1
                       step--> ring 3           to the new step, and over it. All of that is cut already.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from CNCStepper.cycles.clearing.offset_rings import Ring
from CNCStepper.cycles.clearing.pattern import Pass
from CNCStepper.cycles.clearing.straight_links import LinkRegion
from CNCStepper.cycles.moves import Point, point_of
from CNCStepper.geometry.curve import Curve, joined, straight
from CNCStepper.geometry.region import Region
from CNCStepper.tolerances import COINCIDENT_MM

BESIDE = 1.5  # stepovers: a ring so near is reached by a step from where the tool stands
LOOKS = 48  # places on a ring from which the nearest laid one is looked for


@dataclass(frozen=True, eq=False)
class LinkedCurve:
    """A curve that is cut: begun at the end of a step that left `parent` at a length on it."""

    curve: Curve
    ring: Ring
    parent: LinkedCurve | None = None
    left_mm: float = 0.0

    @property
    def stem(self) -> LinkedCurve:
        """The parent of one that has one."""
        assert self.parent is not None
        return self.parent

    def trunk(self) -> list[LinkedCurve]:
        """Return this one, its parent and so on."""
        found = [self]
        while found[-1].parent is not None:
            found.append(found[-1].parent)
        return found

    def along(self, from_mm: float, to_mm: float) -> Iterator[Curve]:
        """Yield the way between two places on the curve, round a closed one the shorter one; none of no length."""
        length_mm, forth_mm = self.curve.length_mm, to_mm - from_mm
        if self.curve.closed:
            forth_mm = (forth_mm + length_mm / 2.0) % length_mm - length_mm / 2.0
        if forth_mm > COINCIDENT_MM:
            yield self.curve.part(from_mm, to_mm)
        elif forth_mm < -COINCIDENT_MM:
            yield self.curve.part(to_mm, from_mm).reversed()

    def step(self) -> Curve:
        """Return the way from the parent to the begin."""
        return straight(point_of(self.stem.curve.at_length(self.left_mm)[0]), point_of(self.curve.xy[0]))


class RingLinker:
    """The linked passes so far, and the tool's position: on a linked curve at a length."""

    def __init__(self, room: Region, stepover_mm: float):
        self.passes: list[Pass] = []
        self._ground = LinkRegion(room)
        self._done: set[Ring] = set()
        self._free: dict[Ring, Region] = {}  # all cut, with what lies in them, and in no other of these
        self._over: LinkRegion | None = None  # these together
        self._near_mm = BESIDE * stepover_mm
        self._laid: list[LinkedCurve] = []
        self._at: LinkedCurve
        self._at_mm = 0.0
        self._here: Point

    @property
    def begun(self) -> bool:
        """Whether anything is laid."""
        return bool(self._laid)

    def begin(self, curve: Curve, ring: Ring) -> None:
        """Lay the first curve."""
        self._add(LinkedCurve(curve, ring))

    def laid(self, ring: Ring) -> None:
        """Take note that the loops of a ring are cut; where its children are too, straight ways may lead over it."""
        self._done.add(ring)
        found: Ring | None = ring
        while found is not None and found in self._done and all(child in self._free for child in found.children):
            self._free[found] = found.region
            found = found.parent
        outer = [region for ring, region in self._free.items() if ring.parent not in self._free]
        self._over = LinkRegion(Region(tuple(loop for region in outer for loop in region.loops))) if outer else None

    def nearest_first(self, loops: Sequence[Curve]) -> Iterator[Curve]:
        """Yield the loops, each time the one nearest to the tool's position."""
        left = list(loops)
        while len(left) > 1:
            away = [loop.distances_mm(np.array([self._here]))[0] for loop in left]
            yield left.pop(int(np.argmin(away)))
        yield from left

    def lay(self, loop: Curve, ring: Ring) -> None:
        """Go to a closed loop and along it."""
        (away_mm,), (at_mm,) = loop.nearest(np.array([self._here]))
        if not (away_mm <= self._near_mm and self._ground.sees(self._here, point_of(loop.at_length(at_mm)[0]))):
            parent, left_mm, at_mm = self._nearest_laid(loop, ring)
            self._go(parent, left_mm)
        self._add(LinkedCurve(loop.started_at_length(float(at_mm)), ring, self._at, self._at_mm))

    def link_near(self, curve: Curve, ring: Ring) -> None:
        """Go to a curve near the loops of a ring, from the loop that is nearest to one of its ends."""
        ends = curve.xy[[0, -1]]
        loops = [laid for laid in self._laid if laid.ring is ring]
        ways = [(laid, *laid.curve.nearest(ends)) for laid in loops]
        laid, away_mm, left_mm = min(ways, key=lambda way: way[1].min())
        last = int(np.argmin(away_mm))
        self._go(laid, float(left_mm[last]))
        self._add(LinkedCurve(curve.reversed() if last else curve, ring, self._at, self._at_mm))

    def way_back(self) -> Curve | None:
        """Return a way over what is cut to the begin of the first curve, where no straight one leads there."""
        begin = self._laid[0]
        if self._over is None or self._over.sees(self._here, point_of(begin.curve.xy[0])):
            return None
        ways = list(self._back(begin, 0.0))
        return self._shortened(joined(ways)) if ways else None

    def _add(self, laid: LinkedCurve) -> None:
        if laid.parent is not None:
            self._link(laid.step())
        self.passes.append(Pass(f"roughing {len(self._laid) + 1}", laid.curve))
        self._laid.append(laid)
        self._stand(laid, 0.0 if laid.curve.closed else laid.curve.length_mm)

    def _stand(self, at: LinkedCurve, at_mm: float) -> None:
        self._at, self._at_mm = at, at_mm
        self._here = point_of(at.curve.at_length(at_mm)[0])

    def _nearest_laid(self, loop: Curve, ring: Ring) -> tuple[LinkedCurve, float, float]:
        """Return the laid curve next to a loop, and the lengths on both of the shortest way between them."""
        places_mm = np.concatenate([loop.before_mm[:-1], loop.length_mm * np.arange(LOOKS) / LOOKS])
        places = loop.at_length(places_mm)[0]
        found, least_mm = (self._laid[0], 0.0, 0.0), np.inf
        for laid in self._laid:
            if laid.ring is not ring and laid.ring not in ring.children and ring not in laid.ring.children:
                continue
            place, away_mm, left_mm = laid.curve.nearest_of(places, least_mm)
            if place >= 0:
                found, least_mm = (laid, left_mm, float(places_mm[place])), away_mm
        return found

    def _go(self, there: LinkedCurve, there_mm: float) -> None:
        """Go to a place on a laid curve over what is cut: straight where that can be, else back along the rings."""
        target = point_of(there.curve.at_length(there_mm)[0])
        if self._over is not None and self._over.sees(self._here, target):
            self._link(straight(self._here, target))
        else:
            ways = list(self._back(there, there_mm))
            if ways:
                self._link(self._shortened(joined(ways)))
        self._stand(there, there_mm)

    def _back(self, there: LinkedCurve, there_mm: float) -> Iterator[Curve]:
        """Yield the ways along rings and steps to a place on a laid curve."""
        at, at_mm, down = self._at, self._at_mm, there.trunk()
        while at not in down:
            yield from at.along(at_mm, 0.0)
            yield at.step().reversed()
            at, at_mm = at.stem, at.left_mm
        for laid in reversed(down[: down.index(at)]):
            yield from at.along(at_mm, laid.left_mm)
            yield laid.step()
            at, at_mm = laid, 0.0
        yield from at.along(at_mm, there_mm)

    def _shortened(self, way: Curve) -> Curve:
        """Return a way over cut ground with straight ones in place of stretches, as long ones as are found."""
        if self._over is None:
            return way
        stay = self._over.shortened(way.xy)
        return Curve.trusted(way.xy[stay], np.where(np.diff(stay) == 1, way.bulge[stay[:-1]], 0.0))

    def _link(self, way: Curve) -> None:
        if len(way) > 1 or math.dist(way.xy[0].tolist(), way.xy[1].tolist()) > COINCIDENT_MM:
            self.passes.append(Pass("link", way))
