# SPDX-License-Identifier: LGPL-2.1-or-later
"""Closed chains that cross each other, as the boundaries of the area inside an odd number of them.

+-------+             +-------+
|    .--|--.          |    .--+            So an even-odd fill paints them, and so a pocket with a hole that
|   (   |   )   ──►   |   (   +--.         crosses its border is cleared: two chains that only touch.
|    '--|--'          |    '--+   )
+-------+             +-------+--'
"""

from __future__ import annotations

from collections.abc import Sequence

from CNCStepper.drawing.drawing import Chain
from CNCStepper.drawing.repair.crossings import crossing_groups
from CNCStepper.geometry.region import Region


def without_crossings(chains: Sequence[Chain]) -> tuple[Chain, ...]:
    """Return closed chains of which none crosses another; those that cross none are returned as they are.

    The boundaries of a group that crosses have the attributes of its first chain, and its place in the order. Raises
    GeometryError where the chains of a group are too close to each other to be told apart.
    """
    found: dict[int, list[Chain]] = {number: [chain] for number, chain in enumerate(chains)}
    for group in crossing_groups([chain.curve for chain in chains]):
        region = Region.even_odd([chains[number].curve for number in group])
        found |= {number: [] for number in group}
        found[group[0]] = [Chain(loop, chains[group[0]].attributes) for loop in region.loops]
    return tuple(chain for number in range(len(chains)) for chain in found[number])
