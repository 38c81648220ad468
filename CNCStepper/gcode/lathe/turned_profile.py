# SPDX-License-Identifier: LGPL-2.1-or-later
r"""The profile of a turned part: a chain of lines and arcs, points as complex numbers Z + iX in units of the text.

       X  ^            dive: the tool goes down along the segment, climb: up
          |   \       /
          |    \_____/         Z decreases along the chain in its one position (`roughing_and_finishing.py`)
          +--------------> Z

It is worked on as LinuxCNC's G70, G71 and G72 do, with their tolerances.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import sqrt
from typing import Protocol

from CNCStepper.errors import ProgramError
from CNCStepper.tolerances import SAME_PROFILE_POINT

SHORT = 1e-3
APART = 1e-2


class Tool(Protocol):
    """Who moves the tool."""

    def line(self, end: complex) -> None:
        """Cut along a line."""

    def rapid(self, end: complex) -> None:
        """Rapid to a point."""

    def arc(self, ccw: bool, centre: complex, end: complex) -> None:
        """Cut along an arc."""


@dataclass
class Segment:
    """A line, or an arc about `centre`; corner: the size of a fillet or chamfer that is still to be made."""

    start: complex
    end: complex
    centre: complex | None = None
    ccw: bool = False
    corner: float = 0.0

    @property
    def size(self) -> float:
        """How large it is: the chord, or the radius where that is smaller."""
        chord = abs(self.start - self.end)
        return chord if self.centre is None else min(chord, self.radius)

    @property
    def radius(self) -> float:
        """The radius of an arc."""
        return abs(self.start - self._centre)

    @property
    def _centre(self) -> complex:
        assert self.centre is not None
        return self.centre

    def monotonic(self) -> bool:
        """Whether Z never increases along it."""
        way = (self.end - self.start).real
        if self.centre is None:
            return way <= SHORT
        if self.corner:
            return True
        sense = 1.0 if self.ccw else -1.0
        heights = (sense * (point - self.centre).imag for point in (self.start, self.end))
        return all(height >= -SHORT for height in heights) and way <= -SHORT

    def mirror_x(self) -> None:
        """Change the sign of X."""
        self._map(lambda point: point.conjugate())
        self.ccw = not self.ccw

    def mirror_z(self) -> None:
        """Change the sign of Z."""
        self._map(lambda point: -point.conjugate())
        self.ccw = not self.ccw

    def rotate(self) -> None:
        """Turn a quarter, clockwise."""
        self._map(lambda point: -1j * point)

    def _map(self, map_point) -> None:
        self.start, self.end = map_point(self.start), map_point(self.end)
        if self.centre is not None:
            self.centre = map_point(self.centre)

    def offset(self, distance: float) -> None:
        """Shift it sideways, to its left where `distance` is below 0."""
        if self.centre is None:
            shift = 1j * distance * (self.start - self.end) / abs(self.start - self.end)
            self.start, self.end = self.start + shift, self.end + shift
            return
        factor = (self.radius + (distance if self.ccw else -distance)) / self.radius
        self.start = factor * (self.start - self.centre) + self.centre
        self.end = factor * (self.end - self.centre) + self.centre

    def crossings(self, x: float) -> list[float]:
        """Return the Z at which it has the height X; both ends of a level line."""
        if self.centre is None:
            return self._line_crossings(x)
        height = x - self.centre.imag
        square = -(height - self.radius) * (height + self.radius)
        if square < -SAME_PROFILE_POINT:
            return []
        half = sqrt(max(0.0, square))
        return [z for z in (self.centre.real + half, self.centre.real - half) if self._holds(complex(z, x))]

    def _line_crossings(self, x: float) -> list[float]:
        low, high = sorted((self.start.imag, self.end.imag))
        if low > x + SAME_PROFILE_POINT or high < x - SAME_PROFILE_POINT:
            return []
        if abs((self.start - self.end).imag) < SAME_PROFILE_POINT:
            return [self.start.real, self.end.real]
        share = (x - self.start.imag) / (self.end.imag - self.start.imag)
        return [share * (self.end.real - self.start.real) + self.start.real]

    def _holds(self, point: complex) -> bool:
        """Whether a point of the circle lies on the arc."""
        sense = 1.0 if self.ccw else -1.0
        centre = self._centre
        after = ((self.start - centre).conjugate() * (point - centre)).imag * sense
        before = ((self.end - centre).conjugate() * (point - centre)).imag * sense
        return after >= -SAME_PROFILE_POINT and before <= SAME_PROFILE_POINT

    def draw(self, tool: Tool) -> None:
        """Cut along it."""
        if self.centre is None:
            tool.line(self.end)
        else:
            tool.arc(self.ccw, self.centre, self.end)


# where two neighbours meet


def join(before: Segment, after: Segment) -> None:
    """Let `before` end and `after` begin where they cross."""
    if before.centre is None and after.centre is None:
        meeting = _lines_meet(before, after)
    elif before.centre is not None and after.centre is not None:
        meeting = _arcs_meet(before, after)
    elif abs(after.start - before.end) < SAME_PROFILE_POINT:
        return
    elif after.centre is None:
        meeting = _circle_meets_line(before.end, before._centre, after.start, after.end, after.start)
    else:
        meeting = _circle_meets_line(after.end, after.centre, before.start, before.end, after.start)
    before.end = after.start = meeting


def _lines_meet(before: Segment, after: Segment) -> complex:
    turn = (after.start - after.end).conjugate() / abs(after.start - after.end)
    first, last = (before.start - after.end) * turn, (before.end - after.end) * turn
    if (first - last).imag == 0:
        raise _no_profile("two lines of the profile are parallel")
    share = first.imag / (first - last).imag
    return (first + share * (last - first)) / turn + after.end


def _circle_meets_line(on: complex, centre: complex, begin: complex, end: complex, near: complex) -> complex:
    """Return where a circle through `on` crosses a line, the crossing that is nearer to `near`."""
    turn = (begin - end).conjugate() / abs(begin - end)
    middle = (centre - end) * turn
    half = sqrt(max(0.0, abs(middle - (on - end) * turn) ** 2 - middle.imag**2))
    points = [(middle.real + sign * half) / turn + end for sign in (1.0, -1.0)]
    return min(reversed(points), key=lambda point: abs(near - point))


def _arcs_meet(before: Segment, after: Segment) -> complex:
    a, b, c = after.radius, before.radius, abs(after._centre - before._centre)
    if not a or not c:
        raise _no_profile("two arcs of the profile have one centre")
    share = (c * c + a * a - b * b) / 2.0 / a / c
    turn = complex(share, sqrt(1 - min(1.0, share * share)))
    return turn * (before._centre - after._centre) / c * a + after._centre


def finish_corner(before: Segment, corner: Segment, after: Segment) -> None:
    """Give a fillet or chamfer its place between its neighbours."""
    if not corner.corner:
        return
    for size in (corner.corner, -corner.corner):
        first, last = replace(before), replace(after)
        first.offset(size)
        last.offset(size)
        if (first.end - last.start).real <= APART:
            break
    else:
        raise _no_profile("a corner of the profile is too small for its fillet or chamfer")
    join(first, last)
    middle = (first.end + last.start) / 2.0
    first.offset(-size)
    last.offset(-size)
    corner.start = before.end = first.end
    corner.end = after.start = last.start
    if corner.centre is not None:
        corner.centre, corner.corner = middle, 0.0
        corner.ccw = (corner.start - middle).imag > 0 or (corner.end - middle).imag > 0


def _no_profile(what: str) -> ProgramError:
    return ProgramError("profile", what, advice="correct the profile")


# along a segment, from one pass to the next


def dive(segment: Segment, place: complex, x: float, tool: Tool, fast: bool) -> complex | None:
    """Go down along a segment as far as X, and return where the tool is; None where it does not lead down."""
    if segment.centre is not None:
        return _dive_arc(segment, place, x, tool)
    if segment.start.imag <= segment.end.imag + SAME_PROFILE_POINT:
        return None
    end = segment.end
    if x >= end.imag:
        at = segment.crossings(x)
        if not at:
            raise _no_profile("the profile cannot be reached from where the cycle begins")
        end = complex(at[0], x)
    (tool.rapid if fast else tool.line)(end)
    return end


def _dive_arc(segment: Segment, place: complex, x: float, tool: Tool) -> complex | None:
    centre = segment._centre
    if abs(place - segment.end) < SAME_PROFILE_POINT or (place - segment.end).real <= SAME_PROFILE_POINT:
        return segment.end
    at = segment.crossings(x) or segment.crossings(x - SAME_PROFILE_POINT)
    if segment.ccw:
        if place.real - SAME_PROFILE_POINT > centre.real:
            return None
        end = segment.end if not at or at[-1] > centre.real else complex(at[-1], x)
    else:
        if place.real <= centre.real:
            return None
        if at and at[0] < centre.real:  # only its far side is that high: the next pass is lower
            return place
        end = complex(at[0], x) if at else segment.end
    tool.arc(segment.ccw, centre, end)
    return end


def climb(segment: Segment, place: complex, tool: Tool) -> tuple[complex, bool]:
    """Go up along a segment; return the tool's position, and whether the segment falls again."""
    if segment.centre is None:
        if segment.end.imag + SAME_PROFILE_POINT < segment.start.imag:
            return place, True
        tool.line(segment.end)
        return segment.end, False
    if not segment.ccw and place.real > segment.centre.real:
        return place, True
    if segment.ccw and place.real < segment.centre.real:
        return place, True
    end = _top(segment)
    if abs(place - end) > SHORT:
        tool.arc(segment.ccw, segment.centre, end)
    return end, segment.ccw


def climb_only(segment: Segment, place: complex, tool: Tool) -> complex:
    """Cross to where a segment leads up, and go along it; return where the tool is."""
    at = segment.crossings(place.imag)
    if not at or (segment.centre is None and segment.end.imag < segment.start.imag):
        return place
    if segment.centre is None:
        tool.line(complex(at[0], place.imag))
        tool.line(segment.end)
        return segment.end
    near = at[0] if segment.ccw else at[-1]
    if (near < segment.centre.real) if segment.ccw else (near > segment.centre.real):
        return place
    place, end = complex(near, place.imag), _top(segment)
    tool.line(place)
    if abs(place - end) > SHORT:
        tool.arc(segment.ccw, segment.centre, end)
    return end


def _top(segment: Segment) -> complex:
    """Return how far an arc leads up: its end, or its highest point."""
    centre = segment._centre
    if segment.ccw and segment.end.real < centre.real:
        return complex(centre.real, centre.imag + segment.radius)
    return segment.end
