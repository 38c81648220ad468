# SPDX-License-Identifier: LGPL-2.1-or-later
r"""Roughing a profile out of the stock: passes along z, along x, or along the profile.

    level 0  ==========================   beside the stock       Each level is cut in the intervals in which the path
    level 1  <-------------------------   from the front         of the nose's centre lies below it. One that is open
    level 2      <---/   <-------------   a valley is entered    to the front begins there; a valley is entered down
                         along its right flank                   its right flank. The last pass follows the path.

After a cut the tool leaves along the bisector of its edges: there is no material in the angle between them, so that
all rapids lie in what is cut already.
"""

from __future__ import annotations

import math

import numpy as np

from CNCStepper.cycles.turning.nose_path import centre_path, crossings_mm, framed, require_reach
from CNCStepper.cycles.turning.turning_moves import TurningMoves
from CNCStepper.cycles.turning.turning_operation import TurnRough
from CNCStepper.cycles.turning.turning_setup import TurningSetup
from CNCStepper.errors import CycleError
from CNCStepper.geometry.curve import Curve
from CNCStepper.tolerances import SAME_MM

CLEAR_MM = 0.3  # of rapids over a level that is cut
RETRACT_DEG = 45.0  # of the roughing cycles of controllers
Interval = tuple[float, float]  # lengths along the path, of an end to the right and one to the left


def rough(operation: TurnRough, setup: TurningSetup, moves: TurningMoves) -> dict[str, float]:
    """Append the roughing of the setup's profile; return its figures. Raises CycleError before the first move."""
    assert setup.profile is not None
    profile = framed(setup.profile, moves.side)
    require_reach(profile, setup, moves.side)
    work = RoughedProfile(operation, setup, moves, profile)
    ways = {"z": work.along_z, "x": work.along_x, "profile": work.along_profile}
    return ways[operation.along]()


def stock_top_mm(setup: TurningSetup, side: float) -> float:
    """Return the height of the raw surface in the frame: the bar outside, what is hollow in a bore."""
    return setup.radius_mm if side > 0 else -setup.bore_mm / 2


class RoughedProfile:
    """One profile with its stock; heights and places are those of the nose's centre in the frame."""

    def __init__(self, operation: TurnRough, setup: TurningSetup, moves: TurningMoves, profile: Curve):
        self.setup, self.moves, self.profile, self.ap_mm = setup, moves, profile, operation.ap_mm
        self.nose_mm = setup.tool.nose_mm
        self.distance_mm = self.nose_mm + operation.stock_to_leave_mm
        self.top_mm = stock_top_mm(setup, moves.side) + self.nose_mm
        self.safe_mm = self.top_mm + clear_of_bore(operation.clearance_mm, setup, moves.side)
        self.path = centre_path(profile, self.distance_mm, self.safe_mm)
        self.front_mm = max(setup.face_mm, float(profile.xy[0, 0])) + self.nose_mm + operation.clearance_mm
        front, back = (angle * moves.side for angle in setup.tool.edges_deg)
        self.leave_deg = 60.0 if setup.tool.is_round else (front + back) / 2

    def heights(self) -> list[float]:
        """Return the levels from beside the stock down to above the path's lowest place, evenly ap or less apart."""
        low = float(self.path.points(0.01)[:, 1].min())
        deep_mm = self.top_mm - low
        count = max(math.ceil(deep_mm / self.ap_mm - SAME_MM), 1)
        return [self.top_mm - number * deep_mm / count for number in range(count)]

    def along_z(self) -> dict[str, float]:
        """Cut level by level, then along the path."""
        self._require_front()
        levels = self.heights()
        self.moves.approach_front(self.front_mm, self.safe_mm)
        self.moves.open_cycle("G71", self._words(self.safe_mm - float(self.path.points(0.01)[:, 1].min())))
        if len(levels) > 1:
            self._cut_below((0.0, self.path.length_mm), 1, levels)
        self._contour(self.path)
        deep_mm = levels[0] - levels[1] if len(levels) > 1 else self.top_mm - float(self.path.xy[:, 1].min())
        return {"passes": float(len(levels)), "ap_mm": round(deep_mm, 6)}

    def _require_front(self) -> None:
        """Raise CycleError where passes along z would begin in the stock: the profile must begin at its end."""
        if self.profile.xy[0, 0] < self.setup.face_mm - 10 * self.ap_mm - self.distance_mm:
            what, value = "the profile begins behind the stock's end", f"z {self.profile.xy[0, 0]:g} mm"
            limit = f"z {self.setup.face_mm:g} mm"
            raise CycleError("profile-begin", what, value=value, limit=limit, advice="begin it at the end face")

    def _cut_below(self, parent: Interval, number: int, levels: list[float]) -> None:
        """Cut the intervals of a level within one of the level above, and all below them, from the right."""
        if number == len(levels):
            return
        for interval in self._intervals(parent, levels[number]):
            self._cut(interval, levels[number], levels[number - 1])
            self._cut_below(interval, number + 1, levels)

    def _intervals(self, parent: Interval, level_mm: float) -> list[Interval]:
        """Return the stretches of the path below a level, within one of the level above."""
        found, begin = [], 0.0 if self.path.xy[0, 1] < level_mm else None
        for length_mm, rises in crossings_mm(self.path, level_mm):
            if not rises:
                begin = length_mm
            elif begin is not None:
                found.append((begin, length_mm))
                begin = None
        return [one for one in found if parent[0] - SAME_MM <= one[0] and one[1] <= parent[1] + SAME_MM]

    def _cut(self, interval: Interval, level_mm: float, above_mm: float) -> None:
        """Cut one interval of a level, coming over the level above it."""
        moves, (begin, end) = self.moves, interval
        z_end = float(self.path.at_length(end)[0][0])
        if begin <= SAME_MM:
            if z_end >= self.setup.face_mm + self.nose_mm:
                return
            self._leave(above_mm + CLEAR_MM)
            moves.rapid(self.front_mm, moves.r_mm)
            moves.rapid(self.front_mm, level_mm)
        else:
            entry = self._entry(begin, above_mm)
            z, r = self.path.at_length(entry)[0].tolist()
            self._leave(above_mm + CLEAR_MM)
            moves.rapid(z, above_mm + CLEAR_MM)
            moves.feed(z, r)
            if begin - entry > SAME_MM:
                moves.follow(self.path.part(entry, begin))
        moves.feed(z_end, level_mm)

    def _entry(self, begin_mm: float, above_mm: float) -> float:
        """Return where the tool comes down to the path right of a valley: at the level above, or on a hump below it."""
        before = [length for length, _ in crossings_mm(self.path, above_mm) if length <= begin_mm + SAME_MM]
        first = before[-1] if before else 0.0
        places = np.linspace(first, begin_mm, 200)
        heights = self.path.at_length(places)[0][:, 1]
        return float(places[len(places) - 1 - int(np.argmax(heights[::-1]))]) if not before else first

    def _leave(self, height_mm: float) -> None:
        """Rise to a height along the bisector of the edges."""
        rise_mm = height_mm - self.moves.r_mm
        if rise_mm > SAME_MM:
            run_mm = rise_mm / math.tan(math.radians(self.leave_deg))
            self.moves.rapid(self.moves.z_mm + run_mm, height_mm)

    def along_path(self) -> None:
        """Follow the path once, from before the stock."""
        self._require_front()
        self.moves.approach_front(self.front_mm, self.safe_mm)
        self.moves.open_cycle("G70", {})
        self._contour(self.path)

    def _words(self, deep_mm: float) -> dict[str, float]:
        """Return the words of a roughing cycle whose levels begin where the tool is: depth of cut and retract."""
        return {"I": deep_mm / max(math.ceil(deep_mm / self.ap_mm - SAME_MM), 1), "R": min(CLEAR_MM, self.ap_mm)}

    def _contour(self, path: Curve) -> None:
        """Follow the path from the front, end the cycle, and leave beside the stock."""
        moves, (z, r) = self.moves, path.xy[0].tolist()
        self._leave(self.safe_mm)
        moves.rapid(self.front_mm, self.safe_mm)
        moves.open_profile()
        moves.rapid(self.front_mm, r)
        moves.feed(z, r)
        moves.follow(path)
        moves.close_cycle()
        moves.close_cycle()
        self._out()

    def _out(self) -> None:
        """Go home: beside the stock, or out of the bore."""
        moves = self.moves
        self._leave(max(self.safe_mm, moves.r_mm + CLEAR_MM) if moves.side > 0 else self.safe_mm)
        if moves.side < 0:
            moves.rapid(self.front_mm, moves.r_mm)
        moves.go_home()

    def along_x(self) -> dict[str, float]:
        """Cut down at one z after the other from the front, then along the path."""
        self._require_front()
        first, last = self.setup.face_mm + self.nose_mm, float(self.path.points(0.01)[:, 0].min())
        count = max(math.ceil((first - last) / self.ap_mm - SAME_MM), 1)
        step_mm = (first - last) / count
        moves = self.moves
        moves.approach_front(self.front_mm, self.safe_mm)
        moves.open_cycle("G72" if self._is_g72() else "", self._words(self.front_mm - last))
        for number in range(1, count):
            z = first - number * step_mm
            bottom = self._height_at(z)
            if bottom < self.top_mm:
                moves.rapid(z, self.safe_mm)
                moves.feed(z, bottom)
                moves.feed(z, self.safe_mm)  # along the wall that it has just cut
        self._contour(self.path)
        return {"passes": float(count), "ap_mm": round(step_mm, 6)}

    def _is_g72(self) -> bool:
        """Whether G72 can cut it: a path that only rises, and edges between which its retract at 45 degrees lies."""
        rises = bool((np.diff(self.path.points(0.01)[:, 1]) >= -SAME_MM).all())
        front, back = (angle * self.moves.side for angle in self.setup.tool.edges_deg)
        return rises and (self.setup.tool.is_round or back <= RETRACT_DEG <= front)

    def _height_at(self, z_mm: float) -> float:
        """Return the least height of the centre at a place z: above the whole path there; far below before it."""
        turned = Curve(self.path.xy[:, ::-1].copy(), -self.path.bulge)
        heights = [float(self.path.at_length(length)[0][1]) for length, _ in crossings_mm(turned, z_mm)]
        return max(heights) if heights else float(self.path.xy[0, 1])

    def along_profile(self) -> dict[str, float]:
        """Follow parallels of the profile, from outside the stock to the last."""
        self._require_front()
        deep_mm = self.top_mm - float(self.path.points(0.01)[:, 1].min())
        count = max(math.ceil(deep_mm / self.ap_mm - SAME_MM), 1)
        self.moves.approach_front(self.front_mm + deep_mm, self.safe_mm)
        for number in range(count - 1, -1, -1):
            away_mm = self.distance_mm + number * deep_mm / count
            path = centre_path(self.profile, away_mm, self.safe_mm) if number else self.path
            moves, (z, r) = self.moves, path.xy[0].tolist()
            self._leave(max(self.safe_mm, moves.r_mm + CLEAR_MM))
            moves.rapid(self.front_mm + deep_mm, moves.r_mm)
            moves.rapid(self.front_mm + deep_mm, r)
            moves.feed(z, r)
            moves.follow(path)
        self._out()
        return {"passes": float(count), "ap_mm": round(deep_mm / count, 6)}


def clear_of_bore(clearance_mm: float, setup: TurningSetup, side: float) -> float:
    """Return how far from the raw surface the tool goes beside it: in a bore no farther than half its radius."""
    return clearance_mm if side > 0 else min(clearance_mm, setup.bore_mm / 8)
