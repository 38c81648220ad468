# SPDX-License-Identifier: LGPL-2.1-or-later
"""The half profile of a turning operation, as the rows of a job file: of a profile object, or of what is drawn."""

from __future__ import annotations

from typing import Any

from CNCStepper.errors import CycleError, JobError, Text
from CNCStepper.workbench.features.base import proxy_type
from CNCStepper.workbench.features.cycle_operation import drawings_of
from CNCStepper.workbench.features.turning.turning_profile import TurningProfile, content_of

RADIUS = "radius"
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


def rows_of(pair: Pair, x_is: str) -> list[Any]:
    """Return the rows of a profile with X as a radius or a diameter; raises GeometryError or JobError."""
    from CNCStepper.job.turning.profile_rows import in_x

    drawing, names = pair
    if proxy_type(drawing) == TurningProfile.Type:
        rows, given = content_of(drawing), drawing.XIs
    else:
        rows, given = drawn_rows(drawing, names), RADIUS
    if given == x_is:
        return rows
    return in_x(rows, 0.5 if x_is == RADIUS else 2.0)


def drawn_rows(drawing: Any, names: tuple[str, ...]) -> list[Any]:
    """Return the rows that a drawing gives, X as the radius; raises JobError for what gives none."""
    what = Text("'{drawing}' is no profile by points", drawing=drawing.Label)
    raise JobError("profile-drawing", what, advice="make a profile by points and choose that")


def look_at_profile(drawing: Any, names: tuple[str, ...]) -> None:
    """Raise GeometryError or JobError for what gives no half profile."""
    rows_of((drawing, names), RADIUS)
