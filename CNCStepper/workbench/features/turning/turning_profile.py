# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_TurningProfile: a half profile by its points, drawn in the XZ plane: X is the radius."""

from __future__ import annotations

from typing import Any

from CNCStepper.errors import JobError
from CNCStepper.workbench import packages
from CNCStepper.workbench.features.base import ENUMERATION, Feature, Property
from CNCStepper.workbench.services.translation import later

PROFILE = later("Profile")
LINES = "App::PropertyStringList"


class TurningProfile(Feature):
    """The proxy of a profile; its keys are those of a job file's `[[profile]]`, each row a line of text."""

    Type = "CNCStepper_TurningProfile"
    PROPERTIES = (
        Property("x_is", "XIs", ENUMERATION, PROFILE, later("X is"), later("What the X of a row is"), "diameter",
                 choices=("diameter", "radius")),
        Property("points", "Points", LINES, PROFILE, later("Points"),
                 later("X; Z of each point from the end face to the chuck; then chamfer, fillet, cw or ccw"),
                 ("20; 0", "20; -30")),
    )  # fmt: skip

    def check(self, obj: Any) -> None:
        """Raise JobError for rows of which no profile can be made."""
        curve_of(obj)

    def make(self, obj: Any) -> None:
        """Draw the profile."""
        import Part
        from FreeCAD import Matrix

        from CNCStepper.workbench.drawings.wires import wire_of

        wire = wire_of(curve_of(obj), 0.0)
        obj.Shape = Part.Wire(wire.transformed(Matrix(0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 1)).Edges)


def content_of(obj: Any) -> list[Any]:
    """Return the rows of a profile object as a job file has them, X as its own x_is says; raises JobError."""
    packages.require()
    from CNCStepper.job.turning.profile_rows import content_of_lines

    rows = content_of_lines(obj.Points)
    if len(rows) < 2:
        raise JobError("profile-short", "a profile needs two points or more", advice="write X; Z of each in a row")
    return rows


def curve_of(obj: Any) -> Any:
    """Return the chain of a profile object in (z, r), checked; raises JobError with the number that would do."""
    rows = content_of(obj)
    from pathlib import Path

    from CNCStepper.job.turning.profile_form import ProfileForm
    from CNCStepper.machine.profile import validated

    form = validated(ProfileForm, {"name": obj.Label, "points": rows}, obj.Label)
    return form.curve(obj.XIs, Path())
