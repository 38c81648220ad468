# SPDX-License-Identifier: LGPL-2.1-or-later
r"""Which side of the drawn curves is scrap, and the tool's paths along it.

    outside    . - - - - - - .         inside    +---------------+       left   - - - - - - - - >  tool
              |  +---------+  |                  |  . - - - - .  |             ---------------->   drawn
              |  | part    |  |                  |  | scrap   |  |
              |  |  +---+  |  |                  |  |         |  |       Closed outlines that lie in each other
              |  |  |( )|  |  |                  |  ' - - - - '  |       are part and hole in turn: `outside` cuts
              |  |  +---+  |  |                  +---------------+       outside of the part, so inside its holes.
              |  +---------+  |
               ' - - - - - - '

Climb milling has the part to the right of the tool (the spindle turns clockwise): clockwise round a part, counter-
clockwise in a hole, along an open line from its begin to its end when the tool is to its left. `on` runs as drawn.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import shapely
from shapely.geometry.base import BaseGeometry

from CNCStepper.cycles.contours.contour_parameters import Side
from CNCStepper.errors import CycleError, GeometryError, Text
from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.cut_order.cut_order import parents
from CNCStepper.geometry.offset import parallels
from CNCStepper.geometry.region import Region
from CNCStepper.geometry.shapely_polygons import polygons_of

OFFSET_TOLERANCE_MM = 0.004  # of which an offset uses an eighth at most
FOLLOWED_MM = 0.02  # a wall is followed where the tool's path comes so near to its distance
FLAT_MM = 0.002


@dataclass(frozen=True)
class Sides:
    """The drawn curves, the side on which the tool runs, its radius, the stock to leave, and the direction.

    region: what closed outlines of `inside` or `outside` enclose; None for other sides.
    """

    curves: tuple[Curve, ...]
    side: Side
    tool_mm: float
    leave_mm: float
    climb: bool
    region: Region | None

    @property
    def clear_mm(self) -> float:
        """How far the tool's centre stays from the drawn curves."""
        return 0.0 if self.side == "on" else self.tool_mm + self.leave_mm

    def tracks(self, aside_mm: float = 0.0) -> list[Curve]:
        """Return the paths of the tool's centre, `aside_mm` farther from the wall than it comes at last."""
        if self.side == "on":
            return list(self.curves)
        far_mm = self.clear_mm + aside_mm
        if self.region is None:
            signed_mm = far_mm if self.side == "left" else -far_mm
            found = [each for curve in self.curves for each in parallels(curve, signed_mm, OFFSET_TOLERANCE_MM)]
            return found if self.climb == (self.side == "left") else [each.reversed() for each in found]
        grown = self.region.offset(far_mm if self.side == "outside" else -far_mm, OFFSET_TOLERANCE_MM)
        loops = list(grown.loops)
        return loops if self.climb == (self.side == "inside") else [loop.reversed() for loop in loops]

    def hanging(self, tracks: Sequence[Curve]) -> int:
        """Return how many pieces that were to come apart stay joined, for the tool does not fit between them."""
        if self.region is None:
            return 0
        round_parts = 1 if self.side == "outside" else -1
        as_drawn = 1 if self.climb == (self.side == "inside") else -1
        pieces = sum(loop.area_mm2 * round_parts > 0 for loop in self.region.loops)
        return max(pieces - sum(track.area_mm2 * as_drawn * round_parts > 0 for track in tracks), 0)

    def tightest(self) -> tuple[float, float]:
        """Return the place in the scrap where two of the outlines come nearest to each other, where pieces hang."""
        assert self.region is not None
        lines = np.array([shapely.LineString(loop.points(FLAT_MM)) for loop in self.region.loops])
        near_mm = 2.0 * self.clear_mm + FOLLOWED_MM
        first, second = shapely.STRtree(lines).query(lines, predicate="dwithin", distance=near_mm)
        first, second = first[first < second], second[first < second]
        gaps = shapely.shortest_line(lines[first], lines[second])
        middles = shapely.line_interpolate_point(gaps, 0.5, normalized=True)
        scrap = shapely.contains(polygons_of(self.region), middles) == (self.side == "inside")
        middle = middles[np.where(scrap, shapely.length(gaps), np.inf).argmin()]
        return float(middle.x), float(middle.y)

    def scrap_of(self, swept: BaseGeometry) -> BaseGeometry:
        """Return what of a swept area is scrap."""
        if self.region is None:
            return swept
        if self.side == "outside":
            return swept.difference(polygons_of(self.region.offset(self.leave_mm, OFFSET_TOLERANCE_MM)))
        return swept.intersection(polygons_of(self.region.offset(-self.leave_mm, OFFSET_TOLERANCE_MM)))

    def wall(self) -> list[Curve]:
        """Return the lines to which the tool's rim comes."""
        if self.region is None or not self.leave_mm:
            return list(self.region.loops if self.region is not None else self.curves)
        far_mm = self.leave_mm if self.side == "outside" else -self.leave_mm
        return list(self.region.offset(far_mm, OFFSET_TOLERANCE_MM).loops)


def sides_of(curves: Sequence[Curve], side: Side, tool_mm: float, leave_mm: float, climb: bool) -> Sides:
    """Return the sides of drawn curves; raises CycleError for open curves with an inside and closed ones without."""
    _require_kind(curves, side)
    curves = tuple(curve.without_short() for curve in curves)
    region = enclosed(curves) if side in ("inside", "outside") else None
    if region is not None and region.empty:
        raise CycleError("outline-empty", "the outlines enclose nothing", advice="draw outlines with an area")
    return Sides(curves, side, tool_mm, leave_mm, climb, region)


def enclosed(curves: Sequence[Curve]) -> Region:
    """Return what outlines enclose, those inside others being holes and parts in turn."""
    holder = parents(curves)
    depths = [_depth(holder, index) for index in range(len(curves))]
    loops: list[Curve] = []
    for depth in range(0, max(depths) + 1, 2):
        layer = [[curve for curve, own in zip(curves, depths, strict=True) if own == depth + hole] for hole in (0, 1)]
        loops += Region.of(*layer).loops
    return Region(tuple(loops))


def require_followed(sides: Sides, tracks: Sequence[Curve]) -> None:
    """Raise CycleError when the tool follows one of the drawn curves nowhere, because it does not fit."""
    lines = shapely.linestrings if tracks else None
    paths = shapely.multilinestrings([lines(track.points(FLAT_MM)) for track in tracks]) if lines else None
    for number, curve in enumerate(sides.curves, start=1):
        drawn = shapely.LineString(curve.points(FLAT_MM))
        if paths is not None and shapely.dwithin(paths, drawn, sides.clear_mm + FOLLOWED_MM):
            continue
        x, y = curve.xy[0]
        raise CycleError(
            "tool-wide",
            Text(
                "the tool fits nowhere along curve {number}, which begins at X{x:.3f} Y{y:.3f}", number=number, x=x, y=y
            ),
            value=Text("{clear_mm:g} mm with the stock to leave", clear_mm=2.0 * sides.clear_mm),
            advice="choose a smaller tool or less stock to leave",
        )


def _require_kind(curves: Sequence[Curve], side: Side) -> None:
    for number, curve in enumerate(curves, start=1):
        if not curve.length_mm > FOLLOWED_MM:
            raise CycleError(
                "curve-length",
                Text("curve {number} has no length", number=number),
                value=f"{curve.length_mm:g} mm",
                advice="draw it larger, or leave it out",
            )
        if side in ("inside", "outside") and not curve.closed:
            gap_mm = float(np.hypot(*(curve.xy[-1] - curve.xy[0])))
            raise CycleError(
                "curve-open",
                Text("curve {number} is open, it has no {side}", number=number, side=side),
                value=Text("gap {gap_mm:.3g} mm", gap_mm=gap_mm),
                advice='close it, or use side "left", "right" or "on"',
            )
        if side in ("left", "right") and curve.closed:
            raise CycleError(
                "curve-closed",
                Text("curve {number} is closed, it has no {side}", number=number, side=side),
                advice='use side "inside", "outside" or "on"',
            )


def _depth(holder: Sequence[int], index: int) -> int:
    depth = 0
    while (index := holder[index]) >= 0:
        depth += 1
    return depth


def as_cycle_error(error: GeometryError) -> CycleError:
    """Return a GeometryError as a CycleError."""
    return CycleError(error.code, error.what, value=error.value, limit=error.limit, advice=error.advice)
