# SPDX-License-Identifier: LGPL-2.1-or-later
"""Closed curves of a drawing as outlines and islands: the outermost are outlines, within them are islands, and so on.

+--------------------+
| outline            |      A curve is an outline when an even number of the others holds it, else an island.
|   +------------+   |
|   | island     |   |      What an island holds is to be cut again. An island is taken out of all outlines, so
|   |  +------+  |   |      it is given as a ring: round the island, over a bridge to the outline in it, round
|   |  |outl. |  |   |      that the other way, and back over the bridge. Both ways over the bridge cancel.
|   |  +------+  |   |
|   +------------+   |
+--------------------+
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from CNCStepper.geometry.curve import Curve, from_points, joined
from CNCStepper.workbench.shapes import open_line


def nested(curves: Sequence[Curve], label: str) -> tuple[tuple[Curve, ...], tuple[Curve, ...]]:
    """Return the outlines and the islands among closed curves; raises GeometryError for an open one.

    label: of the drawing, for that sentence.
    """
    for curve in curves:
        if not curve.closed:
            raise open_line(label, tuple(curve.xy[-1]))
    holders = [[other for other in curves if other is not curve and _holds(other, curve)] for curve in curves]
    pairs = list(zip(curves, map(len, holders), strict=True))
    outlines = tuple(curve for curve, depth in pairs if depth % 2 == 0)
    islands = tuple(_ring(curve, _next_within(curve, depth, pairs)) for curve, depth in pairs if depth % 2)
    return outlines, islands


def _holds(outer: Curve, inner: Curve) -> bool:
    """Return whether one closed curve lies within another: by a point of it, for what crosses is refused later."""
    if abs(outer.area_mm2) <= abs(inner.area_mm2):
        return False
    middle, _ = inner.at_length(inner.length_mm * 0.37)
    return bool(outer.winding(np.reshape(middle, (1, 2)))[0] != 0)


def _next_within(island: Curve, depth: int, pairs: list[tuple[Curve, int]]) -> list[Curve]:
    return [curve for curve, own in pairs if own == depth + 1 and _holds(island, curve)]


def _ring(island: Curve, inner: list[Curve]) -> Curve:
    """Return an island without the outlines that it holds, as one curve; see the module's text."""
    ring = island
    for curve in inner:
        away = curve.reversed() if curve.area_mm2 * island.area_mm2 > 0 else curve
        begin, end = ring.xy[0], away.xy[0]
        ring = joined([ring, from_points([begin, end]), away, from_points([end, begin])])
    return ring
