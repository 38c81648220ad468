# SPDX-License-Identifier: LGPL-2.1-or-later
r"""Roughing a profile out of the stock: passes along z, along x, or along the profile.

level 0  ==========================   beside the stock       Each level is cut in the intervals in which the path
level 1  <-------------------------   from the front         of the nose's centre lies below it. One that is open
level 2      <---/   <-------------   a valley is entered    to the front begins there; a valley is entered down
                     along its right flank                   its right flank. The last pass follows the path.

Along the profile the passes are parallels of the path, evenly apart, each on the stretches of it that lie in the stock.
"""

from __future__ import annotations

import numpy as np

from CNCStepper.cycles.turning.nose_path import centre_path, crossings_mm, framed, require_reach, thickest_mm
from CNCStepper.cycles.turning.profile_path import CLEAR_MM, ProfilePath
from CNCStepper.cycles.turning.turning_moves import TurningMoves, even_passes
from CNCStepper.cycles.turning.turning_operation import TurnRough
from CNCStepper.cycles.turning.turning_setup import TurningSetup
from CNCStepper.errors import CycleError, Text
from CNCStepper.geometry.curve import Curve
from CNCStepper.tolerances import SAME_MM

BEGIN_PASSES = 10  # depths of cut that a profile may begin behind the raw end, where it is faced before
RETRACT_DEG = 45.0  # of the roughing cycles of controllers
Interval = tuple[float, float]  # lengths along the path, of an end to the right and one to the left


def rough(operation: TurnRough, setup: TurningSetup, moves: TurningMoves) -> dict[str, float]:
    """Append the roughing of the setup's profile; return its figures. Raises CycleError before the first move."""
    assert setup.profile is not None
    profile = framed(setup.profile, moves.side)
    require_reach(profile, setup, moves.side)
    work = RoughedProfile(operation, setup, moves, profile)
    work.require_cut(operation.stock_to_leave_mm)
    ways = {"z": work.along_z, "x": work.along_x, "profile": work.along_profile}
    return ways[operation.along]()


class RoughedProfile(ProfilePath):
    """One profile with its stock, cut in passes of an even depth."""

    def __init__(self, operation: TurnRough, setup: TurningSetup, moves: TurningMoves, profile: Curve):
        super().__init__(operation, setup, moves, profile)
        self.ap_mm = operation.ap_mm

    def require_cut(self, leave_mm: float) -> None:
        """Raise CycleError where the stock to leave is as thick as all that is to be cut."""
        thick_mm = thickest_mm(self.profile, self.top_mm - self.nose_mm, self.setup.face_mm)
        if leave_mm >= thick_mm > 0:
            what, value = "stock_to_leave_mm leaves nothing to cut", f"{leave_mm:g} mm"
            limit = Text("below {thick:.4g} mm", thick=thick_mm)
            raise CycleError("leave-all", what, value=value, limit=limit, advice="leave less, or use a thicker bar")

    def heights(self) -> list[float]:
        """Return the levels from beside the stock down to above the path's lowest place, evenly ap or less apart."""
        low = float(self.path.points(0.01)[:, 1].min())
        deep_mm = self.top_mm - low
        count = even_passes(deep_mm, self.ap_mm, "ap_mm")
        return [self.top_mm - number * deep_mm / count for number in range(count)]

    def along_z(self) -> dict[str, float]:
        """Cut level by level, then along the path."""
        self.require_front(BEGIN_PASSES * self.ap_mm)
        levels = self.heights()
        self.moves.approach_front(self.front_mm, self.safe_mm)
        self.moves.open_cycle("G71", self._words(self.safe_mm - float(self.path.points(0.01)[:, 1].min())))
        if len(levels) > 1:
            self._cut_below((0.0, self.path.length_mm), 1, levels)
        self.contour(self.path)
        deep_mm = levels[0] - levels[1] if len(levels) > 1 else self.top_mm - float(self.path.xy[:, 1].min())
        return {"passes": float(len(levels)), "ap_mm": round(deep_mm, 6)}

    def _cut_below(self, parent: Interval, number: int, levels: list[float]) -> None:
        """Cut the intervals of a level within one of the level above, and all below them, from the right."""
        if number == len(levels):
            return
        for interval in self._intervals(parent, levels[number]):
            self._cut(interval, levels[number], levels[number - 1])
            self._cut_below(interval, number + 1, levels)

    def _intervals(self, parent: Interval, level_mm: float) -> list[Interval]:
        """Return the stretches of the path below a level, within one of the level above."""
        found = below(self.path, level_mm)
        return [one for one in found if parent[0] - SAME_MM <= one[0] and one[1] <= parent[1] + SAME_MM]

    def _cut(self, interval: Interval, level_mm: float, above_mm: float) -> None:
        """Cut one interval of a level, coming over the level above it."""
        moves, (begin, end) = self.moves, interval
        z_end = float(self.path.at_length(end)[0][0])
        if begin <= SAME_MM:
            if z_end >= self.setup.face_mm + self.nose_mm:
                return
            self.leave(above_mm + CLEAR_MM)
            moves.rapid(self.front_mm, moves.r_mm)
            moves.rapid(self.front_mm, level_mm)
        else:
            first, entry = self._entry(begin, level_mm, above_mm)
            z, r = self.path.at_length(entry)[0].tolist()
            ramp_mm = min(above_mm + CLEAR_MM - r, float(self.path.at_length(first)[0][0]) - z)
            self.leave(above_mm + CLEAR_MM)
            moves.rapid(z + ramp_mm, above_mm + CLEAR_MM)
            moves.feed(z, r)
            if begin - entry > SAME_MM:
                moves.follow(self.path.part(entry, begin))
        moves.feed(z_end, level_mm)

    def _entry(self, begin_mm: float, level_mm: float, above_mm: float) -> Interval:
        """Return where the tool comes down to the path right of a valley, and from where on nothing is higher.

        That is at the level above, where the path crosses it; else on the hump between this valley and the last one of
        this level, or the front. What is left on the hump's other side is thinner than a level: the last pass cuts it.
        """
        before = [length for length, _ in crossings_mm(self.path, above_mm) if length <= begin_mm + SAME_MM]
        first = before[-1] if before else 0.0
        ends = [length for length, rises in crossings_mm(self.path, level_mm) if rises and first < length < begin_mm]
        if before and not ends:
            return first, first
        first = ends[-1] if ends else first
        places = np.linspace(first, begin_mm, 200)
        heights = self.path.at_length(places)[0][:, 1]
        return first, float(places[len(places) - 1 - int(np.argmax(heights[::-1]))])

    def _words(self, deep_mm: float) -> dict[str, float]:
        """Return the words of a roughing cycle whose levels begin where the tool is: depth of cut and retract."""
        return {"I": deep_mm / even_passes(deep_mm, self.ap_mm, "ap_mm"), "R": min(CLEAR_MM, self.ap_mm)}

    def along_x(self) -> dict[str, float]:
        """Cut down at one z after the other from the front, then along the path."""
        self.require_front(BEGIN_PASSES * self.ap_mm)
        first, last = self.setup.face_mm + self.nose_mm, float(self.path.points(0.01)[:, 0].min())
        count = even_passes(first - last, self.ap_mm, "ap_mm")
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
                self.leave(bottom + CLEAR_MM)
                moves.rapid(moves.z_mm, self.safe_mm)  # through what the insert has swept on its way down
        self.contour(self.path)
        return {"passes": float(count), "ap_mm": round(step_mm, 6)}

    def _is_g72(self) -> bool:
        """Whether G72 can cut it: a path that only rises, and edges between which its retract at 45 degrees lies."""
        rises = bool((np.diff(self.path.points(0.01)[:, 1]) >= -SAME_MM).all())
        front, back = (angle * self.moves.side for angle in self.setup.tool.edges_deg)
        return rises and (self.setup.tool.is_round or back <= RETRACT_DEG <= front)

    def _height_at(self, z_mm: float) -> float:
        """Return the least height of the centre at a place z: above the whole path there; far below before it."""
        crossed = crossings_mm(turned_over(self.path), z_mm)
        heights = [float(self.path.at_length(length)[0][1]) for length, _ in crossed]
        return max(heights) if heights else float(self.path.xy[0, 1])

    def along_profile(self) -> dict[str, float]:
        """Follow parallels of the profile where they lie in the stock, from the outermost to the last."""
        self.require_front(BEGIN_PASSES * self.ap_mm)
        leave_mm = self.distance_mm - self.nose_mm
        deep_mm = thickest_mm(self.profile, self.top_mm - self.nose_mm, self.setup.face_mm) - leave_mm
        count = even_passes(deep_mm, self.ap_mm, "ap_mm")
        self.moves.approach_front(self.front_mm, self.safe_mm)
        for number in range(count - 1, -1, -1):
            away_mm = self.distance_mm + number * deep_mm / count
            path = centre_path(self.profile, away_mm, self.safe_mm, self.raw_mm) if number else self.path
            for stretch in self._in_stock(path):
                self._follow_stretch(path, stretch)
        self.out()
        return {"passes": float(count), "ap_mm": round(max(deep_mm, 0.0) / count, 6)}

    def _in_stock(self, path: Curve) -> list[Interval]:
        """Return the stretches of a path on which the nose is below the raw surface and behind the raw end."""
        crossed = crossings_mm(turned_over(path), self.setup.face_mm + self.nose_mm)
        behind_mm = crossed[-1][0] if crossed else 0.0
        found = below(path, self.top_mm)
        return [(max(first, behind_mm), last) for first, last in found if last > behind_mm + SAME_MM]

    def _follow_stretch(self, path: Curve, stretch: Interval) -> None:
        """Cut along a stretch of a path, from before the stock, or down into it from beside it."""
        moves, (z, r) = self.moves, path.at_length(stretch[0])[0].tolist()
        self.leave(max(self.safe_mm, moves.r_mm + CLEAR_MM))
        from_front = stretch[0] <= SAME_MM or z > self.setup.face_mm + self.nose_mm - SAME_MM
        moves.rapid(max(self.front_mm, z) if from_front else z, moves.r_mm)
        if from_front:
            moves.rapid(moves.z_mm, r)
        moves.feed(z, r)
        moves.follow(path.part(*stretch))


def turned_over(path: Curve) -> Curve:
    """Return a path with z and r exchanged; lengths along it stay."""
    return Curve(path.xy[:, ::-1].copy(), -path.bulge)


def below(path: Curve, level_mm: float) -> list[Interval]:
    """Return the stretches of a path that lie below a height, as lengths along it."""
    found, begin = [], 0.0 if path.xy[0, 1] < level_mm else None
    for length_mm, rises in crossings_mm(path, level_mm):
        if not rises:
            begin = length_mm
        elif begin is not None:
            found.append((begin, length_mm))
            begin = None
    return found
