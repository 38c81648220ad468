# SPDX-License-Identifier: LGPL-2.1-or-later
"""Grooves with parallel walls and parting off: plunges of a blade, with pecks where asked for."""

from __future__ import annotations

import math

from CNCStepper.cycles.passes import require_few_passes
from CNCStepper.cycles.turning.turning_moves import TurningMoves
from CNCStepper.cycles.turning.turning_operation import TurnGroove, TurnPart
from CNCStepper.cycles.turning.turning_setup import TurningSetup
from CNCStepper.errors import CycleError
from CNCStepper.tolerances import SAME_MM

PECK_CLEAR_MM = 0.3  # how far a peck goes back, and before the last depth the feed begins again
OVERLAP = 0.9  # of the blade's flat


def groove(operation: TurnGroove, setup: TurningSetup, moves: TurningMoves) -> dict[str, float]:
    """Append plunges from wall to wall; return their figures. Raises CycleError before the first move."""
    left_mm, width_mm = _blade(setup)
    if operation.width_mm < width_mm - SAME_MM:
        what, limit = "the blade is wider than the groove", f"{operation.width_mm:g} mm"
        raise CycleError("blade-width", what, value=f"{width_mm:g} mm", limit=limit, advice="use another blade")
    side, floor, top = moves.side, operation.diameter_mm / 2, operation.top_diameter_mm / 2
    _require_deep(side * (top - floor), setup)
    flat_mm = width_mm - 2 * min(setup.tool.nose_mm, width_mm / 2)
    room_mm = operation.width_mm - width_mm
    count = 1 + max(math.ceil(room_mm / max(flat_mm * OVERLAP, SAME_MM) - SAME_MM), 0)
    safe = top + side * operation.clearance_mm
    _approach(moves, operation.z_mm - left_mm + room_mm, safe, setup, operation.clearance_mm)
    for number in range(count):
        z = operation.z_mm - left_mm + room_mm * (1 - number / max(count - 1, 1))
        moves.rapid(*moves.tip(z, safe))
        _plunge(moves, z, safe, floor, operation.peck_mm)
        moves.dwell(operation.dwell_s)
        moves.feed(*moves.tip(z, safe))
    _leave(moves, setup, operation.clearance_mm)
    return {"plunges": float(count), "ae_mm": round(room_mm / max(count - 1, 1), 6)}


def part(operation: TurnPart, setup: TurningSetup, moves: TurningMoves) -> dict[str, float]:
    """Append parting off; return its figures. Raises CycleError before the first move."""
    left_mm, width_mm = _blade(setup)
    if setup.tool.is_inside:
        raise CycleError("part-tool", "parting off takes a blade for the outside", advice="take out inside = true")
    end = max(operation.to_diameter_mm, setup.bore_mm) / 2
    floor = end if operation.to_diameter_mm else end - setup.tool.nose_mm
    _require_deep(setup.radius_mm - floor, setup)
    z, safe = operation.z_mm - width_mm - left_mm, setup.radius_mm + operation.clearance_mm
    _approach(moves, z, safe, setup, operation.clearance_mm)
    _plunge(moves, z, safe, floor, operation.peck_mm)
    moves.feed(*moves.tip(z, safe))
    _leave(moves, setup, operation.clearance_mm)
    return {"plunges": 1.0, "depth_mm": round(setup.radius_mm - floor, 6)}


def _blade(setup: TurningSetup) -> tuple[float, float]:
    """Return where the blade's side towards the chuck lies from the control point, and its width."""
    if setup.tool.kind != "parting":
        what, limit = "grooves and parting take a blade", "a parting blade"
        raise CycleError("blade-tool", what, value=setup.tool.words, limit=limit, advice="use another tool")
    return min(z for z, _, _ in setup.tool.outline()), setup.tool.width_mm


def _require_deep(deep_mm: float, setup: TurningSetup) -> None:
    """Raise CycleError for a depth of no material, or one that the blade does not reach."""
    if deep_mm <= SAME_MM:
        what = "the floor of the groove lies outside the material"
        raise CycleError("groove-depth", what, value=f"{deep_mm:.4g} mm deep", limit="above 0 mm", advice="correct it")
    if setup.tool.reach_mm and deep_mm > setup.tool.reach_mm:
        what, value = "the blade does not reach so deep", f"{deep_mm:.4g} mm"
        raise CycleError(
            "blade-reach", what, value=value, limit=f"{setup.tool.reach_mm:g} mm", advice="use a longer one"
        )


def _plunge(moves: TurningMoves, z: float, safe: float, floor: float, peck_mm: float) -> None:
    """Feed down to the floor, going back a little after each peck."""
    side, depth = moves.side, safe
    if peck_mm:
        require_few_passes(side * (depth - floor), peck_mm, "peck_mm")
    while peck_mm and side * (depth - floor) > peck_mm + SAME_MM:
        depth -= side * peck_mm
        moves.feed(*moves.tip(z, depth))
        moves.feed(*moves.tip(z, depth + side * PECK_CLEAR_MM))
    moves.feed(*moves.tip(z, floor))


def _approach(moves: TurningMoves, z: float, safe: float, setup: TurningSetup, clearance_mm: float) -> None:
    if moves.side > 0:
        moves.approach_top(*moves.tip(z, max(safe, setup.radius_mm + clearance_mm)))
    else:
        moves.approach_front(setup.face_mm + clearance_mm, moves.tip(z, safe)[1])
        moves.rapid(*moves.tip(z, safe))


def _leave(moves: TurningMoves, setup: TurningSetup, clearance_mm: float) -> None:
    if moves.side > 0:
        moves.rapid(moves.z_mm, max(moves.r_mm, setup.radius_mm + clearance_mm + setup.tool.nose_mm))
    else:
        moves.rapid(setup.face_mm + clearance_mm, moves.r_mm)
    moves.go_home()
