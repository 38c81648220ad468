# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drilling on the axis: in one go, in pecks out of the hole, or in pecks that only break the chip."""

from __future__ import annotations

from CNCStepper.cycles.turning.turning_moves import TurningMoves, even_passes
from CNCStepper.cycles.turning.turning_operation import TurnDrill
from CNCStepper.cycles.turning.turning_setup import TurningSetup
from CNCStepper.errors import CycleError


def drill_axis(operation: TurnDrill, setup: TurningSetup, moves: TurningMoves) -> dict[str, float]:
    """Append the hole; return its figures. Raises CycleError before the first move."""
    tool = setup.tool
    if tool.kind != "drill":
        what, limit = "holes on the axis take a drill", "a drilling tool"
        raise CycleError("drill-tool", what, value=tool.words, limit=limit, advice="use another tool")
    if tool.reach_mm and operation.depth_mm > tool.reach_mm:
        what, value = "the drill does not reach so deep", f"{operation.depth_mm:g} mm"
        raise CycleError("drill-reach", what, value=value, limit=f"{tool.reach_mm:g} mm", advice="use a longer drill")
    above_mm, deep_mm = setup.face_mm + operation.clearance_mm, operation.depth_mm + setup.face_mm
    count = even_passes(deep_mm, operation.peck_mm, "peck_mm") if operation.peck_mm else 1
    moves.approach_front(above_mm, 0.0)
    for number in range(1, count + 1):
        depth = setup.face_mm - number * deep_mm / count
        moves.feed(depth, 0.0)
        if number == count:
            break
        if operation.retract == "full":
            moves.rapid(above_mm, 0.0)
            moves.rapid(depth + operation.clearance_mm, 0.0)
        else:
            moves.rapid(depth + operation.clearance_mm, 0.0)
    moves.dwell(operation.dwell_s)
    moves.rapid(above_mm, 0.0)
    moves.go_home()
    return {"pecks": float(count), "peck_mm": round(deep_mm / count, 6)}
