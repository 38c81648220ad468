# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where chains cross or touch themselves, and where closed chains cross each other."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
import shapely

from CNCStepper.cancellation import checkpoint
from CNCStepper.geometry.curve import Curve
from CNCStepper.tolerances import SAME_CROSSING_MM

CHORD_MM = 0.002  # how far chords leave the arcs
AT_ONCE = 256  # chains, or chords of one, of which crossings are looked for at once
Place = tuple[float, float]


def self_crossings(curves: Sequence[Curve], most: int) -> list[Place]:
    """Return up to `most` places where curves cross or touch themselves; a doubled stretch counts at its ends."""
    lines = _lines(curves)
    found: list[Place] = []
    for number in np.flatnonzero(~shapely.is_simple(lines)).tolist():
        if len(found) >= most:
            break
        found += _crossings_of(lines[number], most - len(found))
    return found


def closed_crossings(curves: Sequence[Curve], most: int) -> list[Place]:
    """Return up to `most` places where two closed curves cross each other."""
    lines = _lines(curves)
    found: list[Place] = []
    for a, b in _crossing_pairs(lines):
        found += _places(shapely.intersection(lines[a], lines[b]))
        if len(found) >= most:
            return found[:most]
    return found


def crossing_groups(curves: Sequence[Curve]) -> list[list[int]]:
    """Return the numbers of closed curves that cross each other, directly or by others, in groups of two or more."""
    group = list(range(len(curves)))
    for a, b in _crossing_pairs(_lines(curves)):
        low, high = sorted((group[a], group[b]))
        if low != high:
            group = [low if own == high else own for own in group]
    members: dict[int, list[int]] = {}
    for number, own in enumerate(group):
        members.setdefault(own, []).append(number)
    return [own for own in members.values() if len(own) > 1]


def _crossing_pairs(lines: np.ndarray) -> Iterator[tuple[int, int]]:
    """Yield the numbers of two lines that cross, the lower one first."""
    tree = shapely.STRtree(lines)
    for first in range(0, len(lines), AT_ONCE):
        checkpoint()
        own, other = tree.query(lines[first : first + AT_ONCE], predicate="crosses")
        later = other > own + first
        yield from zip((own[later] + first).tolist(), other[later].tolist(), strict=True)


def _lines(curves: Sequence[Curve]) -> np.ndarray:
    points = [curve.points(CHORD_MM) for curve in curves]
    number = np.repeat(np.arange(len(points)), [len(each) for each in points])
    return np.asarray(shapely.linestrings(np.concatenate([np.empty((0, 2)), *points]), indices=number))


def _crossings_of(line: shapely.LineString, most: int) -> list[Place]:
    """Return where the chords of one line meet, but for neighbours at their common end."""
    xy = shapely.get_coordinates(line)
    xy = xy[np.append(True, np.hypot(*np.diff(xy, axis=0).T) > 0.0)]
    chords = shapely.linestrings(np.stack([xy[:-1], xy[1:]], axis=1))
    tree, count = shapely.STRtree(chords), len(chords)
    closed = bool(np.hypot(*(xy[-1] - xy[0])) <= SAME_CROSSING_MM)
    found: list[Place] = []
    for first in range(0, count, AT_ONCE):
        checkpoint()
        own, other = tree.query(chords[first : first + AT_ONCE], predicate="intersects")
        own = own + first
        apart = (other > own + 1) & ~(closed & (own == 0) & (other == count - 1))
        for a, b in zip(own[apart].tolist(), other[apart].tolist(), strict=True):
            found += [place for place in _places(shapely.intersection(chords[a], chords[b])) if _is_new(place, found)]
            if len(found) >= most:
                return found[:most]
    return found


def _is_new(place: Place, found: Sequence[Place]) -> bool:
    return all(abs(place[0] - x) > SAME_CROSSING_MM or abs(place[1] - y) > SAME_CROSSING_MM for x, y in found)


def _places(met: shapely.Geometry) -> Iterator[Place]:
    """Yield the points in which two lines meet; of a common stretch one end."""
    for part in shapely.get_parts(met):
        x, y = shapely.get_coordinates(part)[0].tolist()
        yield x, y
