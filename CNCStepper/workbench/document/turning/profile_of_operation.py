# SPDX-License-Identifier: LGPL-2.1-or-later
"""The half profile of a turning operation, as the rows of a job file: of a profile object, or of what is drawn."""

from __future__ import annotations

from typing import Any

from CNCStepper.errors import CycleError, Text
from CNCStepper.workbench.drawings.half_profile import read_half_profile
from CNCStepper.workbench.features.base import proxy_type
from CNCStepper.workbench.features.cycle_operation import drawings_of
from CNCStepper.workbench.features.turning.turning_profile import TurningProfile, content_of

RADIUS, OUTSIDE, INSIDE = "radius", "outside", "bore"
Pair = tuple[Any, tuple[str, ...]]


def profile_pair(obj: Any) -> Pair | None:
    """Return the drawing of an operation's profile and the names of its edges, None for none; raises CycleError."""
    pairs = drawings_of(obj)
    if len(pairs) > 1:
        raise CycleError(
            "profile-several",
            Text("{obj} follows one profile", obj=obj.Label),
            value=", ".join(drawing.Label for drawing, _ in pairs),
            advice="choose one of them",
        )
    return pairs[0] if pairs else None


def side_of(operation: Any) -> str:
    """Return which side of a solid an operation follows: its bore with a tool for the inside, else its outside."""
    from CNCStepper.workbench.features.turning.turning_tool import model_of

    return INSIDE if model_of(operation.Tool).is_inside else OUTSIDE


def rows_of(pair: Pair, x_is: str, side: str) -> list[Any]:
    """Return the rows of a profile with X as a radius or a diameter; raises GeometryError or JobError."""
    from CNCStepper.job.turning.profile_rows import in_x

    drawing, names = pair
    if proxy_type(drawing) != TurningProfile.Type:
        return read_half_profile(drawing, names, side=side).rows(x_is)  # type: ignore[arg-type]
    rows = content_of(drawing)
    return rows if drawing.XIs == x_is else in_x(rows, 0.5 if x_is == RADIUS else 2.0)


def look_at_profile(drawing: Any, names: tuple[str, ...], side: str = OUTSIDE) -> None:
    """Raise GeometryError or JobError for what gives no half profile."""
    rows_of((drawing, names), RADIUS, side)
