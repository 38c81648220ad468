# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where open lines begin that meet each other: on no edge that is cut already, as no pierce may lie there.

one end on another line       the line begins at its other end
both ends on other lines      the line is cut before those at one of its ends, and begins there
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import shapely

from CNCStepper.geometry.curve import Curve
from CNCStepper.tolerances import SAME_CUT_MM

FLAT_MM = 0.001


@dataclass(frozen=True)
class Begins:
    """turned: lines that run backwards; fixed: lines that may not be turned; before: a line, and one cut after it."""

    turned: frozenset[int]
    fixed: frozenset[int]
    before: tuple[tuple[int, int], ...]


def begins_of(lines: Mapping[int, Curve], kerf_mm: float) -> Begins:
    """Return how open lines, by number, begin on no edge that another one has cut before."""
    ways = {number: shapely.LineString(line.points(FLAT_MM)) for number, line in lines.items()}
    reach_mm = max(kerf_mm, SAME_CUT_MM)
    met = {number: [_met(ways, number, end, reach_mm) for end in (0, -1)] for number in lines}
    begins = {number: int(bool(begin)) for number, (begin, end) in met.items() if bool(begin) != bool(end)}
    before: list[tuple[int, int]] = []
    for number, ends in met.items():
        if ends[0] and ends[1]:
            for end in (0, 1):
                if not any(_waits(other, number, before) for other in ends[end]):
                    begins[number] = end
                    before += [(number, other) for other in sorted(ends[end])]
                    break
    turned = frozenset(number for number, end in begins.items() if end)
    return Begins(turned, frozenset(begins), tuple(before))


def _met(ways: Mapping[int, shapely.LineString], number: int, end: int, reach_mm: float) -> set[int]:
    """Return the lines to which an end of a line comes so near that a pierce there reaches their edge."""
    point = shapely.Point(ways[number].coords[end])
    return {other for other, way in ways.items() if other != number and way.dwithin(point, reach_mm)}


def _waits(first: int, last: int, before: list[tuple[int, int]]) -> bool:
    """Return whether a line is cut before another one already, over any others."""
    if first == last:
        return True
    return any(_waits(after, last, before) for one, after in before if one == first)
