# SPDX-License-Identifier: LGPL-2.1-or-later
r"""The pattern "offset": passes parallel to the room's walls, a stepover apart, cut without lifting the tool.

    +-----------------------------+      The rings make a tree (offset_rings.py): each piece at a depth holds
    |  .--------.      .------.   |      the pieces that are one stepover deeper.
    |  |  +--+  |______|      |   |
    |  |  |A |             B  |   |      It is cut from the deepest piece A outwards; where two pieces become one,
    |  |  +--+   ______       |   |      the other, B, is cut from there inwards, and the way out goes on after it.
    |  '--------'      '------'   |      So one entry is enough.
    +-----------------------------+

From ring to ring the tool steps over by the shortest way; where the next one is not beside it, it first goes back
along rings and steps that are cut already (ring_links.py).
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from CNCStepper.cycles.clearing.helix_and_ramp_entry import HELIX_SHARES
from CNCStepper.cycles.clearing.offset_rings import Ring, ring_tree, spots
from CNCStepper.cycles.clearing.pattern import Area, Run
from CNCStepper.cycles.clearing.ring_links import RingLinker
from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.curve_columns import complex_of, xy_of
from CNCStepper.geometry.region import Region
from CNCStepper.tolerances import SAME_MM

MOST_LOOKS = 64  # places on a ring at which a helix is tried


def offset(area: Area) -> list[Run]:
    """Return one run for each piece of the room."""
    return [_run(area, part) for part in area.room.parts()]


def _run(area: Area, room: Region) -> Run:
    root = ring_tree(room, area)
    walk = RingLinker(room, area.stepover_mm)
    for ring, inwards in _order(root):
        loops = list(ring.region.loops)
        if not walk.begun:
            first, begin_mm = _begin(loops, room, area.tool_mm)
            walk.begin(_turned(loops.pop(first).started_at_length(begin_mm), inwards == area.climb), ring)
        for loop in walk.nearest_first([_turned(loop, inwards == area.climb) for loop in loops]):
            walk.lay(loop, ring)
        for spot in spots(ring, area):
            walk.link_near(spot, ring)
        walk.laid(ring)
    return Run(tuple(walk.passes), area.stepover_mm if root.children else 0.0, back=walk.way_back())


def _order(root: Ring) -> Iterator[tuple[Ring, bool]]:
    """Yield the rings in the order they are cut, and whether their material lies inwards of them."""
    path = [root]
    while path[-1].children:
        path.append(max(path[-1].children, key=lambda ring: (ring.height, ring.region.area_mm2)))
    for place in range(len(path) - 1, -1, -1):
        yield path[place], False
        below = path[place + 1] if place + 1 < len(path) else None
        stack = [child for child in reversed(path[place].children) if child is not below]
        while stack:
            ring = stack.pop()
            yield ring, True
            stack += reversed(ring.children)


def _turned(loop: Curve, turn: bool) -> Curve:
    return loop.reversed() if turn else loop


def _begin(loops: list[Curve], room: Region, tool_mm: float) -> tuple[int, float]:
    """Return the loop, and the length on it, at which the room is widest: there a helix has its place."""
    best = (-1.0, 0, 0.0)
    for number, loop in enumerate(loops):
        count = min(max(len(loop), 16), MOST_LOOKS)
        places_mm = loop.length_mm * np.arange(count) / count
        places, directions = loop.at_length(places_mm)
        inwards = xy_of(1j * complex_of(directions))
        for share in HELIX_SHARES:
            free_mm = room.distances_mm(places + share * tool_mm * inwards)
            widest = int(np.argmax(free_mm))
            if free_mm[widest] >= share * tool_mm - SAME_MM:
                best = max(best, (share, number, float(places_mm[widest])))
                break
    return best[1], best[2]
