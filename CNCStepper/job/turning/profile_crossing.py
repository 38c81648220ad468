# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a half profile crosses itself first, and the smallest change after which it does not.

A change moves one point straight along z or r to its neighbour's height, or else leaves points out. What is named
makes the whole profile one that can be turned, not only one that does not cross itself.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np
import shapely

from CNCStepper.errors import JobError, Text
from CNCStepper.geometry.curve import Curve
from CNCStepper.tolerances import SAME_MM

MOST_POINTS = 12  # about the crossing that are tried
Change = tuple[Curve, Text, Text]  # a chain; limit and advice that say it


def crossing_error(chain: Curve, chords: np.ndarray, can_be_turned: Callable[[Curve], bool]) -> JobError:
    """Return the refusal of a chain that crosses itself; chords: its points."""
    place = first_crossing(chords)
    changes = (*_moves(chain, place), *_omissions(chain, place))
    named = ((limit, advice) for other, limit, advice in changes if can_be_turned(other))
    limit, advice = next(named, _without_way_back(chords))
    value = Text("at z {z:.6g} mm, radius {r:.6g} mm", z=place[0], r=place[1])
    return JobError("profile-crossing", "the profile crosses itself", value=value, limit=limit, advice=advice)


def _without_way_back(chords: np.ndarray) -> tuple[Text, Text]:
    """Return limit and advice for a chain that no small change mends."""
    z = chords[int(np.argmax(way_back_mm(chords))), 0]
    return Text("z {z:.6g} mm", z=z), Text("after z {z:.6g} mm let z never rise along it", z=z)


def way_back_mm(points: np.ndarray) -> np.ndarray:
    """Return how far z rises again after each point."""
    return np.maximum.accumulate(points[::-1, 0])[::-1] - points[:, 0]


def first_crossing(chords: np.ndarray) -> tuple[float, float]:
    """Return the place (z, r) at which a chain of lines that is not simple meets itself first."""
    lines = shapely.linestrings(np.stack([chords[:-1], chords[1:]], axis=1))
    one, other = shapely.STRtree(lines).query(lines, predicate="intersects")
    later = np.flatnonzero(other > one + 1)
    if len(later):
        first = later[np.lexsort((one[later], other[later]))[0]]
        middle = lines[one[first]].intersection(lines[other[first]]).centroid
        return middle.x, middle.y
    ways = np.diff(chords, axis=0)
    along = np.einsum("ij,ij->i", ways[:-1], ways[1:])
    across = ways[:-1, 0] * ways[1:, 1] - ways[:-1, 1] * ways[1:, 0]
    back = np.flatnonzero((along < 0) & (np.abs(across) <= SAME_MM * np.abs(along)))  # the chain folds onto itself
    z, r = chords[back[0] + 1] if len(back) else chords[-1]
    return float(z), float(r)


def _moves(chain: Curve, place: tuple[float, float]) -> Iterator[Change]:
    """Yield the chain with one point moved, the smallest way first."""
    found = []
    for at in _nearest(chain, place):
        for other in (at - 1, at + 1):
            for axis in (0, 1):
                if 0 <= other < len(chain.xy):
                    found.append((abs(chain.xy[other, axis] - chain.xy[at, axis]), at, other, axis))
    for way_mm, at, other, axis in sorted(found):
        xy = chain.xy.copy()
        xy[at, axis] = xy[other, axis]
        keep = np.concatenate([[True], np.hypot(*np.diff(xy, axis=0).T) > SAME_MM])
        if way_mm > SAME_MM and keep.sum() > 1:
            limit = Text("z {z:.6g} mm, radius {r:.6g} mm", z=xy[at, 0], r=xy[at, 1])
            what = "move its point at z {z:.6g} mm, radius {r:.6g} mm there"
            advice = Text(what, z=chain.xy[at, 0], r=chain.xy[at, 1])
            yield Curve(xy[keep], chain.bulge[keep[1:]]), limit, advice


def _omissions(chain: Curve, place: tuple[float, float]) -> Iterator[Change]:
    """Yield the chain without some points in a row, the fewest first."""
    near = sorted(_nearest(chain, place))
    for count in range(1, len(near) + 1):
        for first in near:
            last = first + count - 1
            if first == 0 or last >= len(chain.xy) - 1:
                continue
            xy = np.delete(chain.xy, np.s_[first : last + 1], axis=0)
            bulge = np.concatenate([chain.bulge[: first - 1], [0.0], chain.bulge[last + 1 :]])
            what = "leave out what follows z {z:.6g} mm, radius {r:.6g} mm"
            before = chain.xy[first - 1]
            yield Curve(xy, bulge), Text("{count} points fewer", count=count), Text(what, z=before[0], r=before[1])


def _nearest(chain: Curve, place: tuple[float, float]) -> list[int]:
    """Return the numbers of the points nearest to a place."""
    nearest: list[int] = np.argsort(np.hypot(*(chain.xy - place).T), kind="stable")[:MOST_POINTS].tolist()
    return nearest
