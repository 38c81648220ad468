# SPDX-License-Identifier: LGPL-2.1-or-later
r"""Roughing and finishing along a profile (G70, G71, G72), as LinuxCNC 2.9 does it; segments: `turned_profile.py`.

    The profile is mirrored and turned until Z and X fall from its begin to its end, the moves are turned back:

      begin *----------------------+   passes at X, X - I, X - 2 I ... each: down along the profile, along Z to it,
             \  <---------------- /    away at 45 degrees (R), back over it, and down for the next.
              \  <-------------- /     A pocket is cut when the climb out of the one before leads down again.
               \_______________*/

Invariants: the first segment leads from where the cycle begins to the profile; all others are the part, D farther out.
"""

from __future__ import annotations

from dataclasses import replace

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.lathe.turned_profile import (
    APART,
    SHORT,
    Segment,
    Tool,
    climb,
    climb_only,
    dive,
    finish_corner,
    join,
)
from CNCStepper.tolerances import SAME_PROFILE_POINT

MOST_STEPS = 100_000  # of a cycle: a depth of cut that needs more is a mistake
ENDLESS = "end the profile at the X where the cycle begins, or make I larger"
NO_POCKETS, ONLY_POCKETS, POCKETS_AFTER = 1, 2, 3  # the digit of G71.1 and G71.2; the state after the first pass


class TurnedTool:
    """Moves the real tool for a profile that was mirrored and turned."""

    def __init__(self, tool: Tool, turned: int):
        self.tool = tool
        self.turned = turned

    def line(self, end: complex) -> None:
        """Cut along a line."""
        self.tool.line(self._back(end))

    def rapid(self, end: complex) -> None:
        """Rapid to a point."""
        self.tool.rapid(self._back(end))

    def arc(self, ccw: bool, centre: complex, end: complex) -> None:
        """Cut along an arc."""
        mirrored = self.turned & 3 in (1, 2)
        self.tool.arc(ccw != mirrored, self._back(centre), self._back(end))

    def _back(self, point: complex) -> complex:
        quarter, mirrors = self.turned & 4, self.turned & 3
        if quarter:
            point = 1j * point
        if mirrors in (1, 2):
            point = point.conjugate()
        return -point if mirrors == 3 or mirrors == (2 if quarter else 1) else point


class Turning:
    """A profile and how it lies: bit 1 of `turned` mirrors Z, 2 mirrors X, 4 turns a quarter.

    above: how far above the first pass the cycle begins; LinuxCNC cuts the first one where it begins.
    """

    def __init__(self, segments: list[Segment], turned: int = 0):
        self.segments = segments
        self.turned = turned
        self.above = 0.0
        self.depth = 0.5
        self.escape = complex(0.3, 0.3)
        self._pockets: list[complex] = []
        self._steps = 0

    def copy(self) -> Turning:
        """Return a copy with segments of its own."""
        return Turning([replace(segment) for segment in self.segments], self.turned)

    # how the profile lies

    def _rotate(self) -> None:
        for segment in self.segments:
            segment.rotate()
        self.turned ^= 4

    def _fall(self) -> None:
        """Mirror the profile until Z and X fall along it."""
        way = self.segments[0].end - self.segments[-1].end
        for segment in self.segments:
            if way.imag > 0:
                segment.mirror_x()
            if way.real < 0:
                segment.mirror_z()
        self.turned ^= 2 * (way.imag > 0) + (way.real < 0)

    def _check(self) -> None:
        first = self.segments[0]
        if (first.end - first.start).real > 0:
            first.start = complex(first.end.real, first.start.imag)
        if not all(segment.monotonic() for segment in self.segments):
            what = "the profile turns back along Z"
            raise ProgramError("profile", what, advice="let Z always rise or always fall")

    def _finish_corners(self) -> None:
        for index in range(1, len(self.segments) - 1):
            finish_corner(*self.segments[index - 1 : index + 2])
        self.segments = [segment for segment in self.segments if segment.size >= SHORT]

    # the cycles

    def finish(self, tool: Tool, begin: complex, first: float, last: float, passes: int) -> None:
        """G70: passes along the profile, from `first` to `last` away."""
        self.segments[0].start = begin
        alone = Turning([replace(segment) for segment in self.segments[1:]])
        alone._fall()
        if not all(segment.monotonic() for segment in alone.segments):
            alone._rotate()
            alone._fall()
        alone._check()
        if alone.turned & 4:
            self._rotate()
        self._fall()
        self._finish_corners()
        self._check()
        out = TurnedTool(tool, self.turned)
        for number in range(passes, 0, -1):
            path = self.copy()
            path.away((number - 1) * (first - last) / passes + last)
            out.rapid(path.segments[0].start)
            out.rapid(path.segments[0].end)
            for segment in path.segments[1:]:
                segment.draw(out)

    def rough(
        self, tool: Tool, mode: int, begin: complex, away: float, depth: float, escape: float, facing: bool
    ) -> None:
        """G71, and G72 where `facing`: passes `depth` apart, `away` from the profile, with `escape` between them."""
        self.segments[0].start = begin
        if facing:
            self._rotate()
        self._fall()
        self._finish_corners()
        self._check()
        self.away(away)
        out = TurnedTool(tool, self.turned)
        self.depth, self.escape = max(depth, 2 * SAME_PROFILE_POINT), escape * (1 + 1j)
        first, last = self.segments[0], self.segments[-1]
        out.rapid(first.start)
        if last.end.imag < first.start.imag:
            self.segments.append(Segment(last.end, complex(last.end.real, first.start.imag)))
        self._pockets = [first.start - 1j * self.above]
        self._pocket(mode, first.start, 0, out)

    def away(self, distance: float) -> None:
        """Shift the profile sideways, in steps so small that no segment turns round."""
        front = self.segments.pop(0)
        whole = self.segments[-1].start - front.start
        if whole == 0 or ((front.end - front.start) / whole).imag < 0:
            distance = -distance
        done = 0.0
        while done != distance:
            self._step()
            step = min([segment.size / 2 for segment in self.segments] + [abs(distance - done)])
            step = -step if distance < 0 else step
            self._shift(step, distance > 0)
            done += step
        for before, after in zip(self.segments, self.segments[1:], strict=False):
            before.end = after.start = (before.end + after.start) / 2.0
        front.end = self.segments[0].start
        self.segments.insert(0, front)

    def _shift(self, step: float, outwards: bool) -> None:
        for segment in self.segments:
            segment.offset(step)
        kept = [segment for segment in self.segments if segment.size >= SHORT]
        if not kept:
            raise ProgramError("profile", "the profile is smaller than its allowance", advice="make D smaller")
        self.segments = kept[:1]
        for after in kept[1:]:
            before = self.segments[-1]
            if (before.end - after.start).real > APART:  # they have come apart: an arc about the old corner
                old = [replace(before), replace(after)]
                for segment in old:
                    segment.offset(-step)
                corner = (old[0].end + old[1].start) / 2.0
                self.segments.append(Segment(before.end, after.start, corner, outwards))
            self.segments.append(after)
        self._join_all()

    def _join_all(self) -> None:
        """Let neighbours meet; what has turned round or vanished is left out."""
        index = 0
        while index < len(self.segments) - 1:
            self._step()
            if not self.segments[index].monotonic():
                before = index - 1 if index else index
                smaller = self.segments[index].size < self.segments[before].size
                del self.segments[index if smaller else before]
                index = 0
            if self.segments[index].size < SHORT:
                del self.segments[index]
                index = 0
            elif index < len(self.segments) - 1:
                join(self.segments[index], self.segments[index + 1])
            index += 1

    def _step(self) -> None:
        self._steps += 1
        if self._steps > MOST_STEPS:
            what, limit = "the cycle takes too many passes", f"{MOST_STEPS} steps"
            raise ProgramError("passes-many", what, value="I", limit=limit, advice=ENDLESS)

    def _pocket(self, mode: int, place: complex, index: int, out: Tool) -> None:
        """Cut from `place` on: pass after pass, then up along the profile, then the next pocket."""
        while True:
            x = self._pockets[-1].imag
            if mode == ONLY_POCKETS:
                place, index, mode = self._over(place, index, out), self._after_dives, POCKETS_AFTER
            bottom = self._passes(place, index, x, out)
            if bottom is None:
                return
            place, index = bottom
            if mode == NO_POCKETS:
                for segment in self.segments[index:]:
                    place = climb_only(segment, place, out)
                return
            up = self._climb(mode, place, index, out)
            if up is None:
                return
            place, index = up

    def _over(self, place: complex, index: int, out: Tool) -> complex:
        """Go down the first dive without cutting passes; `_after_dives` is the segment after it."""
        while index < len(self.segments):
            lower = dive(self.segments[index], place, -1e9, out, index == 0)
            if lower is None:
                break
            place = lower
            index += 1
        self._after_dives = index
        return place

    def _climb(self, mode: int, place: complex, index: int, out: Tool) -> tuple[complex, int] | None:
        """Go up along the profile; return place and segment where the next pocket begins."""
        while index < len(self.segments):
            self._step()
            place, down = climb(self.segments[index], place, out)
            if down:
                if mode == POCKETS_AFTER:
                    if place.imag > self._pockets[-1].imag and len(self._pockets) > 1:
                        self._pockets.pop()
                    if len(self._pockets) == 1:
                        self._pockets.append(place)
                return place, index
            index += 1
        return None

    def _passes(self, place: complex, index: int, x: float, out: Tool) -> tuple[complex, int] | None:
        """Cut pass below pass; return place and segment at the bottom, None at the end of the profile."""
        while index < len(self.segments):
            self._step()
            while x - SAME_PROFILE_POINT > place.imag:
                self._step()
                x -= self.depth
            lower = dive(self.segments[index], place, x, out, index == 0)
            if lower is None:
                return place, index
            place = lower
            if abs(place.imag - x) > SAME_PROFILE_POINT:
                index += 1
                continue
            index, cut = self._cut(place, index, out)
            if cut:
                x -= self.depth
        return None

    def _cut(self, place: complex, index: int, out: Tool) -> tuple[int, bool]:
        """Cut one pass along Z; return the segment to continue with, and whether the next pass is lower."""
        for other in range(index, len(self.segments)):
            at = self.segments[other].crossings(place.imag)
            if not at:
                continue
            z = at[0] if other != index else at[-1]
            distance = abs(z - place.real)
            if z - SAME_PROFILE_POINT > place.real or (distance < SAME_PROFILE_POINT and other == index):
                continue
            if distance < SAME_PROFILE_POINT:
                meets = abs(place - self.segments[other].start) < SAME_PROFILE_POINT
                return (other, False) if meets else (index, True)
            out.line(complex(z, place.imag))
            escape = min(1.0, distance / 2 / self.escape.real) * self.escape if self.escape.real else 0j
            out.rapid(complex(z, place.imag) + escape)
            out.rapid(place - escape.conjugate())
            (out.rapid if index == 0 else out.line)(place)
            return index, True
        return index, False
