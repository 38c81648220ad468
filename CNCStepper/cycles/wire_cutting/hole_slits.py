# SPDX-License-Identifier: LGPL-2.1-or-later
r"""Slits through a part, by which the wire comes into a closed hole and out again.

ring  - -+- - - -        The shortest straight line from the part's outer ring to the ring in the hole that keeps a
wall  ===|========       kerf's distance from the part's other holes. Where parts lie in the hole, it also leads to
wall  ===|===            a place in there from which ways can begin.
ring  - -+- - - -
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import shapely
from shapely import LineString

from CNCStepper.cycles.moves import Point
from CNCStepper.cycles.wire_cutting.scrap_roadmap import Roadmap
from CNCStepper.cycles.wire_cutting.wire_items import Hole, Part
from CNCStepper.errors import CycleError, Text

TRIED = 128  # places round a hole


@dataclass(frozen=True)
class Slit:
    """A slit: where it leaves the part's ring, where it meets the hole's, and where ways in the hole begin."""

    hole: Hole
    outer: Point
    inner: Point
    begin: Point

    @property
    def line(self) -> LineString:
        """The way of the wire from ring to ring."""
        return LineString([self.outer, self.inner])


def slit_into(part: Part, hole: Hole, roadmap: Roadmap) -> Slit:
    """Return the shortest slit into a hole; raises CycleError where each would cut into another hole."""
    others = shapely.union_all([each.polygon for each in part.holes if each is not hole])
    around = hole.ring.length_mm * np.arange(TRIED) / TRIED
    nearest = shapely.shortest_line(part.chords, hole.chords).coords[1]
    places = np.vstack([hole.ring.at_length(around)[0], nearest])
    away_mm, along_mm = part.ring.nearest(places)
    for index in np.argsort(away_mm, kind="stable").tolist():
        slit = _slit(part, hole, float(along_mm[index]), roadmap)
        far = others.is_empty or slit.line.distance(others) > 2.0 * roadmap.half_mm
        once = slit.line.intersection(part.polygon).length > slit.line.length - 2.1 * roadmap.half_mm
        if far and once and (not hole.inside or roadmap.free(np.array([slit.begin]))[0]):
            return slit
    x, y = places[-1].tolist()
    raise CycleError(
        "wire-slit",
        Text("no straight slit leads into the hole at X{x:.3f} Y{y:.3f} past the part's other holes", x=x, y=y),
        limit=Text("{kerf_mm:g} mm from the other holes", kerf_mm=2.0 * roadmap.half_mm),
        advice="move the holes apart, join them, or draw a slit yourself",
    )


def _slit(part: Part, hole: Hole, along_mm: float, roadmap: Roadmap) -> Slit:
    """Return the slit from a place of the outer ring to the nearest place of the hole's ring."""
    outer = part.ring.at_length(along_mm)[0]
    _, inside_mm = hole.ring.nearest(outer[None, :])
    inner, direction = hole.ring.at_length(float(inside_mm[0]))
    inwards = np.array([-direction[1], direction[0]])
    begin = inner + roadmap.stand_off_mm * inwards
    return Slit(hole, _point(outer), _point(inner), _point(begin))


def _point(place: np.ndarray) -> Point:
    x, y = place.tolist()
    return x, y
