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

from CNCStepper.errors import GeometryError, Text
from CNCStepper.geometry.curve import Curve, from_points, joined
from CNCStepper.tolerances import TOUCHING_MM
from CNCStepper.workbench.drawings.joined_curves import DrawnCurve
from CNCStepper.workbench.drawings.shapes import open_line

SAMPLES = 64  # places along a curve by which it is seen whether another one holds it, beside its vertices


def nested(drawn: Sequence[DrawnCurve]) -> tuple[tuple[Curve, ...], tuple[Curve, ...]]:
    """Return the outlines and the islands among closed curves; raises GeometryError for an open one or two that cross.

    Curves may touch.
    """
    for each in drawn:
        if not each.curve.closed:
            raise open_line(each.label, tuple(each.curve.xy[-1]))
    holders = _holders(drawn)
    pairs = [(each.curve, len(held)) for each, held in zip(drawn, holders, strict=True)]
    outlines = tuple(curve for curve, depth in pairs if depth % 2 == 0)
    islands = [(number, curve) for number, (curve, depth) in enumerate(pairs) if depth % 2]
    return outlines, tuple(_ring(curve, _next_within(number, pairs, holders)) for number, curve in islands)


def _holders(drawn: Sequence[DrawnCurve]) -> list[list[int]]:
    """Return the numbers of the curves that hold each curve."""
    reach_mm = np.array([np.abs(each.curve.bulge).max(initial=0.0) * each.curve.length_mm for each in drawn])[:, None]
    low = np.array([each.curve.xy.min(axis=0) for each in drawn]).reshape(-1, 2) - reach_mm
    high = np.array([each.curve.xy.max(axis=0) for each in drawn]).reshape(-1, 2) + reach_mm
    areas = np.array([abs(each.curve.area_mm2) for each in drawn])
    found = []
    for number, each in enumerate(drawn):
        near = np.all(low <= high[number], axis=1) & np.all(high >= low[number], axis=1) & (areas > areas[number])
        found.append([other for other in np.flatnonzero(near).tolist() if _holds(drawn[other], each)])
    return found


def _holds(outer: DrawnCurve, inner: DrawnCurve) -> bool:
    """Return whether a closed curve lies within a larger one; raises GeometryError where the two cross."""
    places, _ = inner.curve.at_length((np.arange(SAMPLES) + 0.37) * inner.curve.length_mm / SAMPLES)
    points = np.vstack([places, inner.curve.xy])
    clear = points[outer.curve.distances_mm(points) > TOUCHING_MM]
    within = outer.curve.winding(clear) != 0
    if within.any() and not within.all():
        x, y = clear[int(np.argmax(within != within[0]))]
        raise GeometryError(
            "outlines-cross",
            Text(
                "'{inner}' and '{outer}' cross, so that it is not clear what lies inside",
                inner=inner.label,
                outer=outer.label,
            ),
            value=f"near X {x:.4g} Y {y:.4g}",
            advice="join them into one outline, or move one of them",
        )
    return bool(within.any())


def _next_within(island: int, pairs: list[tuple[Curve, int]], holders: list[list[int]]) -> list[Curve]:
    depth = pairs[island][1]
    return [curve for (curve, own), held in zip(pairs, holders, strict=True) if own == depth + 1 and island in held]


def _ring(island: Curve, inner: list[Curve]) -> Curve:
    """Return an island without the outlines that it holds, as one curve; see the module's text."""
    ring = island
    for curve in inner:
        away = curve.reversed() if curve.area_mm2 * island.area_mm2 > 0 else curve
        begin, end = ring.xy[0], away.xy[0]
        ring = joined([ring, from_points([begin, end]), away, from_points([end, begin])])
    return ring
