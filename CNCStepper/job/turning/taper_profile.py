# SPDX-License-Identifier: LGPL-2.1-or-later
"""The half profile of a cone that is given by its dimensions, with the chamfers and fillets at its two corners."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from CNCStepper.cycles.turning.turn_taper import end_radius_mm
from CNCStepper.cycles.turning.turning_operation import TurningOperation, TurnTaper
from CNCStepper.errors import CycleError, Text
from CNCStepper.geometry.curve import Curve
from CNCStepper.job.turning.profile_form import ProfileForm
from CNCStepper.job.turning.turning_job import TurningJob

FACE_SIZES = 3.0  # of a corner: how much of the face beside it belongs to the profile


def profile_of(operation: TurningOperation, job: TurningJob) -> Curve | None:
    """Return the profile in (z, r) that an operation follows: the job's, a taper's own, or None."""
    if isinstance(operation, TurnTaper):
        return taper_profile(operation, job.tools[operation.tool].is_inside)
    return job.curves.get(getattr(operation, "profile", ""))


def taper_profile(operation: TurnTaper, is_inside: bool) -> Curve:
    """Return the cone from its begin towards the chuck; raises CycleError or JobError with the number that would do."""
    side = -1.0 if is_inside else 1.0
    radii, z_end = (operation.diameter_mm / 2, end_radius_mm(operation)), operation.z_mm - operation.length_mm
    if radii[1] < 0:
        what, limit = "the cone ends beyond the axis: angle_deg", Text("radius at its end 0 mm or more")
        raise CycleError("taper-axis", what, value=f"{operation.angle_deg:g} deg", limit=limit, advice="lower it")
    begin = _corner((radii[0], operation.z_mm), operation.begin_chamfer_mm, operation.begin_fillet_mm)
    end = _corner((radii[1], z_end), operation.end_chamfer_mm, operation.end_fillet_mm)
    rows = [
        *_beside(begin, -side, (0.0, radii[0]) if side > 0 else None),
        begin,
        end,
        *_beside(end, side, (0.0, radii[1]) if side < 0 else None),
    ]
    return ProfileForm.model_validate({"name": "taper", "points": rows}).curve("radius", Path())


def _corner(place: tuple[float, float], chamfer_mm: float, fillet_mm: float) -> Any:
    """Return the row of a corner, a plain point where nothing is cut from it."""
    if not chamfer_mm and not fillet_mm:
        return place
    return {"to": place, "chamfer_mm": chamfer_mm, "fillet_mm": fillet_mm}


def _beside(row: Any, way: float, bounds: tuple[float, float] | None) -> list[tuple[float, float]]:
    """Return the point on the face or shoulder beside a corner, nothing beside a sharp one; bounds: of its radius."""
    if not isinstance(row, dict):
        return []
    (r, z), size_mm = row["to"], row["chamfer_mm"] or row["fillet_mm"]
    beside = r + way * FACE_SIZES * size_mm
    return [(min(max(beside, bounds[0]), bounds[1]) if bounds else beside, z)]
