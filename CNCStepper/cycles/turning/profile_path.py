# SPDX-License-Identifier: LGPL-2.1-or-later
"""The path of the nose's centre along a profile with its stock, as roughing and finishing share it; finishing itself.

After a cut the tool leaves along the bisector of its edges: there is no material in the angle between them, so that
all rapids lie in what is cut already.
"""

from __future__ import annotations

import math

from CNCStepper.cycles.turning.nose_path import centre_path, framed, require_reach, sharp_hollows
from CNCStepper.cycles.turning.turning_moves import TurningMoves
from CNCStepper.cycles.turning.turning_operation import TurnFinish, TurnRough
from CNCStepper.cycles.turning.turning_setup import TurningSetup
from CNCStepper.errors import CycleError
from CNCStepper.geometry.curve import Curve
from CNCStepper.tolerances import SAME_MM

CLEAR_MM = 0.3  # of rapids over a level that is cut
BEGIN_MM = 10.0  # that a finished profile may begin behind the raw end


def stock_top_mm(setup: TurningSetup, side: float) -> float:
    """Return the height of the raw surface in the frame: the bar outside, what is hollow in a bore."""
    return setup.radius_mm if side > 0 else -setup.bore_mm / 2


class ProfilePath:
    """One profile with its stock; heights and places are those of the nose's centre in the frame."""

    def __init__(self, operation: TurnRough | TurnFinish, setup: TurningSetup, moves: TurningMoves, profile: Curve):
        self.setup, self.moves, self.profile = setup, moves, profile
        self.nose_mm = setup.tool.nose_mm
        self.distance_mm = self.nose_mm + operation.stock_to_leave_mm
        self.raw_mm = stock_top_mm(setup, moves.side)
        self.top_mm = self.raw_mm + self.nose_mm
        self.safe_mm = self.top_mm + clear_of_bore(operation.clearance_mm, setup, moves.side)
        self.path = centre_path(profile, self.distance_mm, self.safe_mm, self.raw_mm)
        self.front_mm = max(setup.face_mm, float(profile.xy[0, 0])) + self.nose_mm + operation.clearance_mm
        front, back = (angle * moves.side for angle in setup.tool.edges_deg)
        self.leave_deg = 60.0 if setup.tool.is_round else (front + back) / 2

    def require_front(self, slack_mm: float) -> None:
        """Raise CycleError where passes along z would begin in the stock: the profile must begin at its end."""
        if self.profile.xy[0, 0] < self.setup.face_mm - slack_mm - self.distance_mm:
            what, value = "the profile begins behind the stock's end", f"z {self.profile.xy[0, 0]:g} mm"
            limit = f"z {self.setup.face_mm:g} mm"
            raise CycleError("profile-begin", what, value=value, limit=limit, advice="begin it at the end face")

    def along_path(self) -> None:
        """Follow the path once, from before the stock."""
        self.require_front(BEGIN_MM)
        self.moves.approach_front(self.front_mm, self.safe_mm)
        self.moves.open_cycle("G70", {})
        self.contour(self.path)

    def leave(self, height_mm: float) -> None:
        """Rise to a height along the bisector of the edges."""
        rise_mm = height_mm - self.moves.r_mm
        if rise_mm > SAME_MM:
            run_mm = rise_mm / math.tan(math.radians(self.leave_deg))
            self.moves.rapid(self.moves.z_mm + run_mm, height_mm)

    def contour(self, path: Curve) -> None:
        """Follow the path from the front, end the cycle, and leave beside the stock."""
        moves, (z, r) = self.moves, path.xy[0].tolist()
        self.leave(self.safe_mm)
        moves.rapid(self.front_mm, self.safe_mm)
        moves.open_profile()
        moves.rapid(self.front_mm, r)
        moves.feed(z, r)
        moves.follow(path)
        moves.close_cycle()
        moves.close_cycle()
        self.out()

    def out(self) -> None:
        """Go home: beside the stock, or out of the bore."""
        moves = self.moves
        self.leave(max(self.safe_mm, moves.r_mm + CLEAR_MM) if moves.side > 0 else self.safe_mm)
        if moves.side < 0:
            moves.rapid(self.front_mm, moves.r_mm)
        moves.go_home()


def clear_of_bore(clearance_mm: float, setup: TurningSetup, side: float) -> float:
    """Return how far from the raw surface the tool goes beside it: in a bore no farther than half its radius."""
    return clearance_mm if side > 0 else min(clearance_mm, setup.bore_mm / 8)


def finish(operation: TurnFinish, setup: TurningSetup, moves: TurningMoves) -> dict[str, float]:
    """Append one pass along the exact parallel of the setup's profile, from before it to beside the stock.

    Return its figures. Raises CycleError before the first move.
    """
    assert setup.profile is not None
    profile = framed(setup.profile, moves.side)
    require_reach(profile, setup, moves.side)
    ProfilePath(operation, setup, moves, profile).along_path()
    return {"length_mm": round(profile.length_mm, 6), "corners_with_fillet": float(sharp_hollows(profile))}
