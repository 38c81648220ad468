# SPDX-License-Identifier: LGPL-2.1-or-later
"""Facing: passes from beside the stock towards the axis, one behind the other from the raw end to the finished face."""

from __future__ import annotations

from CNCStepper.cycles.turning.turning_moves import TurningMoves, even_passes
from CNCStepper.cycles.turning.turning_operation import TurnFace
from CNCStepper.cycles.turning.turning_setup import TurningSetup
from CNCStepper.errors import CycleError
from CNCStepper.tolerances import SAME_MM

UPRIGHT_DEG = 90.0


def face(operation: TurnFace, setup: TurningSetup, moves: TurningMoves) -> dict[str, float]:
    """Append the facing; return its figures. Raises CycleError before the first move."""
    _require_reach(setup)
    nose_mm, last_mm = setup.tool.nose_mm, operation.to_z_mm + operation.stock_to_leave_mm
    deep_mm = setup.face_mm - last_mm
    if deep_mm < -SAME_MM:
        what, value, limit = "the face lies before the stock", f"z {last_mm:g} mm", f"z {setup.face_mm:g} mm at most"
        raise CycleError("face-outside", what, value=value, limit=limit, advice="give the stock a greater face_mm")
    count = even_passes(deep_mm, operation.ap_mm, "ap_mm")
    safe_mm = setup.radius_mm + nose_mm + operation.clearance_mm
    away_mm = setup.face_mm + nose_mm + operation.clearance_mm
    inner_mm = max(operation.to_diameter_mm, setup.bore_mm) / 2
    end_mm = inner_mm - nose_mm if inner_mm else 0.0
    moves.approach_front(away_mm, safe_mm)
    for number in range(1, count + 1):
        z = setup.face_mm - number * deep_mm / count + nose_mm
        moves.rapid(z, safe_mm)
        moves.feed(z, end_mm)
        moves.feed(z + operation.clearance_mm / 2, end_mm)
        moves.rapid(away_mm, end_mm)
        moves.rapid(away_mm, safe_mm)
    moves.go_home()
    return {"passes": float(count), "ap_mm": round(deep_mm / count, 6)}


def _require_reach(setup: TurningSetup) -> None:
    tool = setup.tool
    if tool.is_inside or tool.hand == "left":
        what, limit = "facing takes a right-hand tool for the outside", "a right-hand turning tool"
        raise CycleError("face-tool", what, value=tool.words, limit=limit, advice="use another tool")
    front = tool.edges_deg[0]
    if not tool.is_round and front > UPRIGHT_DEG:
        what, limit = "the front edge of the insert does not reach a flat face", f"at most {UPRIGHT_DEG:g} deg"
        raise CycleError("insert-front", what, value=f"{front:g} deg", limit=limit, advice="use another holder")
