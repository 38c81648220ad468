# SPDX-License-Identifier: LGPL-2.1-or-later
r"""A cone without a drawing: its profile from two diameters or an angle, roughed along z and finished in one pass.

    r_end  ___|  end corner            outside; in a bore the same, mirrored at the wall of the hole
              \
               \___  begin corner      z_mm at the begin, length_mm from there towards the chuck
                   |
"""

from __future__ import annotations

from math import radians, tan
from typing import Any

from CNCStepper.cycles.turning.profile_path import finish
from CNCStepper.cycles.turning.turn_rough import rough
from CNCStepper.cycles.turning.turning_moves import TurningMoves
from CNCStepper.cycles.turning.turning_operation import TurnFinish, TurnRough, TurnTaper
from CNCStepper.cycles.turning.turning_setup import TurningSetup


def taper(operation: TurnTaper, setup: TurningSetup, moves: TurningMoves) -> dict[str, float]:
    """Append roughing and the last pass of the cone in the setup's profile; return their figures.

    Raises CycleError before the first move.
    """
    shared: dict[str, Any] = {"tool": operation.tool, "profile": "taper", "clearance_mm": operation.clearance_mm}
    last_mm = operation.last_pass_mm
    roughing = TurnRough(cycle="turn_rough", ap_mm=operation.ap_mm, stock_to_leave_mm=last_mm, **shared)
    figures = rough(roughing, setup, moves)
    if last_mm:
        figures |= finish(TurnFinish(cycle="turn_finish", **shared), setup, moves)
    return figures


def end_radius_mm(operation: TurnTaper) -> float:
    """Return the radius of the cone at its end towards the chuck."""
    if operation.by == "diameters":
        return operation.end_diameter_mm / 2
    return operation.diameter_mm / 2 + operation.length_mm * tan(radians(operation.angle_deg))
