# SPDX-License-Identifier: LGPL-2.1-or-later
"""One stroke of the mouse, from press to release, as points of a plane; it knows nothing of windows."""

from __future__ import annotations

import math

Point = tuple[float, float]

CLOSING_PIXELS = 10  # a release this near to the start closes the line
SNAPPED_DEG = 5.0  # a straight part this near to a multiple of 45 degrees becomes one
TOLERANCE_PIXELS = 1.5  # how far the simplified line may leave the drawn one: no eye sees it in this view


class Stroke:
    """A line that grows; `pixel_mm` is the size of a pixel of the view where it began."""

    def __init__(self, start: Point, pixel_mm: float):
        self.pixel_mm = pixel_mm
        self._drawn = [start]
        self._tip: Point | None = None  # the moving end of a straight part
        self._farthest_mm = 0.0

    @property
    def points(self) -> list[Point]:
        """The points up to now."""
        return self._drawn if self._tip is None else [*self._drawn, self._tip]

    @property
    def closing(self) -> bool:
        """Whether a release now would close the line: it has been away from its start, and is back."""
        reach_mm = CLOSING_PIXELS * self.pixel_mm
        away = self._farthest_mm > 2 * reach_mm and len(self.points) > 2
        return away and math.dist(self.points[0], self.points[-1]) <= reach_mm

    @property
    def tolerance_mm(self) -> float:
        """The tolerance for simplifying, a round figure near TOLERANCE_PIXELS and never above it."""
        return rounded_down(TOLERANCE_PIXELS * self.pixel_mm)

    def move(self, point: Point, straight: bool) -> None:
        """Go on to `point`: freely, or `straight` from where the stroke was when that began."""
        if straight:
            self._tip = snapped(self._drawn[-1], point)
        else:
            if self._tip is not None:
                self._drawn.append(self._tip)
                self._tip = None
            if math.dist(point, self._drawn[-1]) >= self.pixel_mm / 2:
                self._drawn.append(point)
        self._farthest_mm = max(self._farthest_mm, math.dist(self.points[0], self.points[-1]))

    def line(self) -> tuple[list[Point], bool]:
        """Return the points of the whole line and whether it is closed; [] for a click that drew nothing."""
        points, closed = list(self.points), self.closing
        while closed and math.dist(points[0], points[-1]) <= CLOSING_PIXELS * self.pixel_mm:
            points.pop()
        if not closed and self._farthest_mm < 2 * self.pixel_mm:
            return [], False
        return points, closed


def snapped(corner: Point, pointer: Point) -> Point:
    """Return the end of a straight part: the pointer, or a near place on a multiple of 45 degrees."""
    across, up = pointer[0] - corner[0], pointer[1] - corner[1]
    angle_deg = math.degrees(math.atan2(up, across))
    whole_deg = 45.0 * round(angle_deg / 45.0)
    if abs(angle_deg - whole_deg) > SNAPPED_DEG:
        return pointer
    ux, uy = round(math.cos(math.radians(whole_deg)), 15), round(math.sin(math.radians(whole_deg)), 15)
    along_mm = across * ux + up * uy
    return (corner[0] + along_mm * ux, corner[1] + along_mm * uy)


def rounded_down(size_mm: float) -> float:
    """Return the next 1, 2 or 5 times a power of ten at or below a size above 0."""
    power = 10.0 ** math.floor(math.log10(size_mm))
    digit = max(digit for digit in (1, 2, 5) if digit * power <= size_mm * (1 + 1e-9))
    return float(f"{digit * power:.1g}")
