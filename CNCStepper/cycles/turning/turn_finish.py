# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finishing: one pass along the exact parallel of the profile, from before it to beside the stock."""

from __future__ import annotations

from CNCStepper.cycles.turning.nose_path import framed, require_reach, sharp_hollows
from CNCStepper.cycles.turning.profile_path import ProfilePath
from CNCStepper.cycles.turning.turning_moves import TurningMoves
from CNCStepper.cycles.turning.turning_operation import TurnFinish
from CNCStepper.cycles.turning.turning_setup import TurningSetup


def finish(operation: TurnFinish, setup: TurningSetup, moves: TurningMoves) -> dict[str, float]:
    """Append the finishing of the setup's profile; return its figures. Raises CycleError before the first move."""
    assert setup.profile is not None
    profile = framed(setup.profile, moves.side)
    require_reach(profile, setup, moves.side)
    ProfilePath(operation, setup, moves, profile).along_path()
    return {"length_mm": round(profile.length_mm, 6), "corners_with_fillet": float(sharp_hollows(profile))}
