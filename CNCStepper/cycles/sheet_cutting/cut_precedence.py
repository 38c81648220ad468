# SPDX-License-Identifier: LGPL-2.1-or-later
r"""What must be cut before what, so that nothing is cut after it may have moved.

inside first     a chain before the closed one around it: that one frees everything in it
tight clusters   where the bands of neighbouring cuts run into each other, they enclose scrap, and free it together
                 with what lies there

 ___________      The bands of 1, 2 and 3 meet and enclose the triangle with 4. A cut needs a way to the sheet
| 1 \ 4 / 2 |     over material and over cuts that are still to be made: from outside each cut of a cluster is
|----\_/----|     reached over another one, which is made later. So 4 comes before the one over which it is
|____ 3 ____|     reached, and that one before the next one outwards.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import shapely

from CNCStepper.cycles.sheet_cutting.chains import Chain
from CNCStepper.cycles.sheet_cutting.chord_pieces import ChordPieces, points_of
from CNCStepper.tolerances import CUT_TOUCHES_MM

ROUGH_MM = 0.01
CONVEX = 1e-3  # an outline that fills all but this share of its hull encloses no scrap


@dataclass(frozen=True)
class _Ground:
    """The chains, the runs of their paths by chain, the kerf, and the closed chains as polygons by chain."""

    chains: Sequence[Chain]
    paths: ChordPieces
    kerf_mm: float
    hulls: dict[int, shapely.Polygon]


def precedence(chains: Sequence[Chain], paths: ChordPieces, kerf_mm: float) -> list[tuple[int, int]]:
    """Return pairs of chains, by index: the first is cut before the second. paths: owned by the chains' indices."""
    pairs = [(index, chain.holder) for index, chain in enumerate(chains) if chain.holder >= 0]
    pairs += _crossed(chains)
    ground = _Ground(chains, paths, kerf_mm, _hulls(chains))
    for cluster in _clusters(ground):
        pairs += _from_outside(ground, cluster)
    return sorted(set(pairs))


def _crossed(chains: Sequence[Chain]) -> list[tuple[int, int]]:
    """Return open chains before the closed ones that they cross: afterwards the parts lie loose."""
    lines = [index for index, chain in enumerate(chains) if chain.is_open]
    if not lines:
        return []
    shapes = [shapely.LineString(chain.curve.points(ROUGH_MM)) for chain in chains]
    found = shapely.STRtree(shapes).query([shapes[index] for index in lines], predicate="intersects")
    return [(lines[line], other) for line, other in found.T.tolist() if not chains[other].is_open]


def _hulls(chains: Sequence[Chain]) -> dict[int, shapely.Polygon]:
    """Return the hulls of outlines that are not convex: scrap in their bays may be enclosed by their own cut."""
    index = [number for number, chain in enumerate(chains) if chain.is_part]
    rings = points_of([chains[number].curve for number in index], ROUGH_MM)
    polygons = np.array([shapely.Polygon(ring) for ring in rings], object)
    hulls = shapely.convex_hull(polygons)
    bays = shapely.area(polygons) < (1.0 - CONVEX) * shapely.area(hulls)
    return {number: hull for number, hull, bay in zip(index, hulls, bays.tolist(), strict=True) if bay}


def _clusters(ground: _Ground) -> list[list[int]]:
    """Return the groups of chains whose bands meet, and single ones with others in their bays."""
    one, other, _ = ground.paths.pairs(ground.kerf_mm + CUT_TOUCHES_MM)
    joined = set(zip(one.tolist(), other.tolist(), strict=True))
    groups = _groups(joined)
    grouped = {index for group in groups for index in group}
    return groups + [[index] for index in _with_guests(ground) if index not in grouped]


def _groups(pairs: set[tuple[int, int]]) -> list[list[int]]:
    """Return what hangs together by pairs."""
    beside: dict[int, set[int]] = {}
    for one, other in pairs:
        beside.setdefault(one, set()).add(other)
        beside.setdefault(other, set()).add(one)
    groups, seen = [], set()
    for first in sorted(beside):
        if first in seen:
            continue
        group, waiting = [], [first]
        seen.add(first)
        while waiting:
            here = waiting.pop()
            group.append(here)
            new = sorted(beside[here] - seen)
            seen.update(new)
            waiting += new
        groups.append(sorted(group))
    return groups


def _with_guests(ground: _Ground) -> list[int]:
    """Return the outlines in whose bays another chain begins."""
    if not ground.hulls:
        return []
    index = list(ground.hulls)
    spots = shapely.points([chain.curve.xy[0] for chain in ground.chains])
    hull, spot = shapely.STRtree(spots).query([ground.hulls[each] for each in index], predicate="contains")
    beside = [
        index[each]
        for each, guest in zip(hull.tolist(), spot.tolist(), strict=True)
        if guest != index[each] and ground.chains[guest].holder == ground.chains[index[each]].holder
    ]
    return sorted(set(beside))


def _from_outside(ground: _Ground, cluster: list[int]) -> list[tuple[int, int]]:
    """Return pairs for a cluster: each cut that is reached from outside only over another one comes before that one."""
    lines = {index: _line(ground, index) for index in cluster}
    half_mm = ground.kerf_mm / 2.0
    runs = ground.paths.lines[np.isin(ground.paths.owner, cluster)]  # whole paths may be filled by a buffer
    bands = shapely.union_all(shapely.buffer(runs, half_mm + CUT_TOUCHES_MM / 4.0, quad_segs=16))
    holders = {ground.chains[index].holder for index in cluster}
    guests = [index for index, chain in enumerate(ground.chains) if index not in lines and chain.holder in holders]
    outside = shapely.union_all([shapely.LineString(part.exterior.coords) for part in shapely.get_parts(bands)])
    faces = [shapely.Polygon(ring.coords) for part in shapely.get_parts(bands) for ring in part.interiors]
    shapely.prepare(faces)
    touched = {index: _touching(line, faces, half_mm + CUT_TOUCHES_MM) for index, line in lines.items()}
    rim = [index for index, line in lines.items() if line.distance(outside) <= half_mm + CUT_TOUCHES_MM]
    pairs = _reached(rim, touched, _neighbours(ground, lines))
    order = {index: place for place, index in enumerate([*rim, *(child for child, _ in pairs)])}
    return pairs + _of_guests(ground, guests, faces, touched, order)


def _line(ground: _Ground, index: int) -> shapely.LineString:
    own = ground.paths.owner == index
    return shapely.union_all(ground.paths.lines[own])


def _touching(line: shapely.LineString, faces: list[shapely.Polygon], reach_mm: float) -> set[int]:
    if not faces:
        return set()
    return set(np.flatnonzero(shapely.dwithin(faces, line, reach_mm)).tolist())


def _neighbours(ground: _Ground, lines: dict[int, shapely.LineString]) -> dict[int, set[int]]:
    index = list(lines)
    one, other = shapely.STRtree(list(lines.values())).query(
        list(lines.values()), predicate="dwithin", distance=ground.kerf_mm + CUT_TOUCHES_MM
    )
    found: dict[int, set[int]] = {each: set() for each in index}
    for a, b in zip(one.tolist(), other.tolist(), strict=True):
        if a != b:
            found[index[a]].add(index[b])
    return found


def _reached(rim: list[int], touched: dict[int, set[int]], beside: dict[int, set[int]]) -> list[tuple[int, int]]:
    """Return pairs (cut, the one over which it is reached), breadth first from the cuts at the rim."""
    waiting, seen = deque(sorted(rim)), set(rim)
    pairs = []
    while waiting:
        here = waiting.popleft()
        reached = {index for index, faces in touched.items() if faces & touched[here]} | beside[here]
        for index in sorted(reached - seen):
            pairs.append((index, here))
            seen.add(index)
            waiting.append(index)
    return pairs


def _of_guests(
    ground: _Ground,
    guests: list[int],
    faces: list[shapely.Polygon],
    touched: dict[int, set[int]],
    order: dict[int, int],
) -> list[tuple[int, int]]:
    """Return what lies in an enclosed face before the first cut over which the face is reached."""
    if not guests or not faces:
        return []
    spots = shapely.points([ground.chains[index].curve.xy[0] for index in guests])
    face, guest = shapely.STRtree(spots).query(faces, predicate="contains")
    pairs = []
    for number, place in zip(face.tolist(), guest.tolist(), strict=True):
        over = [index for index, own in touched.items() if number in own and index in order]
        if over and ground.chains[guests[place]].holder not in over:
            pairs.append((guests[place], min(over, key=order.__getitem__)))
    return pairs
