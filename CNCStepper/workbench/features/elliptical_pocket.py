# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_EllipticalPocket: from a drawing that holds one ellipse, or from numbers."""

from __future__ import annotations

from typing import Any

from CNCStepper.workbench.features.base import ANGLE, DISTANCE, ENUMERATION, INTEGER, POSITION, SPEED, Property, edit
from CNCStepper.workbench.features.operation import CUT, OPERATION, RESULT, Operation, drawn, parameters
from CNCStepper.workbench.words import later

ELLIPSE, FINISH, PATH = later("Ellipse"), later("Finish"), later("Path")
SHAPE = ("Centre", "RadiusX", "RadiusY", "Rotation")


class EllipticalPocket(Operation):
    """The proxy of an elliptical pocket; with a drawing its centre, radii and rotation follow the ellipse in it."""

    Type = "CNCStepper_EllipticalPocket"
    CYCLE = "elliptical_pocket"
    PROPERTIES = (
        *OPERATION,
        *drawn(ELLIPSE, later("A sketch or wire that holds one ellipse; without it the numbers count")),
        Property("centre_mm", "Centre", POSITION, ELLIPSE, later("Centre"), later("The centre, from the work zero"),
                 (0.0, 0.0, 0.0)),
        Property("radius_x_mm", "RadiusX", DISTANCE, ELLIPSE, later("Radius x"),
                 later("Half the width along the ellipse's first axis"), 40.0),
        Property("radius_y_mm", "RadiusY", DISTANCE, ELLIPSE, later("Radius y"),
                 later("Half the width along its second axis"), 25.0),
        Property("rotation_deg", "Rotation", ANGLE, ELLIPSE, later("Rotation"),
                 later("From X to the ellipse's first axis"), 0.0),
        Property("depth_mm", "Depth", DISTANCE, CUT, later("Depth"), later("The depth of the pocket, ap_total"), 10.0),
        Property("stepdown_mm", "Stepdown", DISTANCE, CUT, later("Stepdown ap"),
                 later("The depth of one pass at most, ap"), 2.0),
        Property("stepover_mm", "Stepover", DISTANCE, CUT, later("Stepover ae"),
                 later("The width of one pass at most, ae"), 2.4),
        Property("direction", "Direction", ENUMERATION, CUT, later("Direction"),
                 later("How the cutter turns against the feed"), "climb", choices=("climb", "conventional")),
        Property("finish_stepdown_mm", "FinishStepdown", DISTANCE, FINISH, later("Last stepdown"),
                 later("The last pass in depth, ap_acab; 0: none"), 0.2),
        Property("finish_stepover_mm", "FinishStepover", DISTANCE, FINISH, later("Last stepover"),
                 later("The last pass at the wall, ae_acab; 0: none"), 0.3),
        Property("finish_feed_mm_min", "FinishFeed", SPEED, FINISH, later("Wall feed"),
                 later("The feed of the last pass at the wall; 0: the tool's own feed"), 0.0),
        Property("method", "Method", ENUMERATION, PATH, later("Method"),
                 later("Arcs within a tolerance, or the published points"), "tolerance",
                 choices=("tolerance", "dda")),
        Property("tolerance_mm", "Tolerance", DISTANCE, PATH, later("Tolerance"),
                 later("How far the wall may be off the ellipse"), 0.01),
        Property("resolution_mm", "Resolution", DISTANCE, PATH, later("Resolution"),
                 later("The step of the published method"), 0.05),
        Property("entry", "Entry", ENUMERATION, PATH, later("Entry"), later("How the tool goes down"), "helix",
                 choices=("helix", "ramp", "plunge")),
        Property("entry_angle_deg", "EntryAngle", ANGLE, PATH, later("Entry angle"),
                 later("How steeply a helix or ramp goes down"), 3.0),
        Property("ap_mm", "StepdownUsed", DISTANCE, RESULT, later("Stepdown ap"),
                 later("ap, recalculated to whole passes"), 0.0, output=True),
        Property("levels", "Levels", INTEGER, RESULT, later("Levels"), later("How many passes in depth"), 0,
                 output=True),
        Property("ae_mm", "StepoverUsed", DISTANCE, RESULT, later("Stepover ae"),
                 later("ae, recalculated to whole passes"), 0.0, output=True),
        Property("passes", "Passes", INTEGER, RESULT, later("Passes"), later("How many passes at each depth"), 0,
                 output=True),
        Property("unreachable_mm", "Unreachable", DISTANCE, RESULT, later("Unreachable"),
                 later("What the round tool must leave at the ends of the long axis"), 0.0, output=True),
    )  # fmt: skip

    def follow(self, obj: Any, origin_mm: tuple[float, ...]) -> None:
        """Take centre, radii and rotation from the drawing where there is one."""
        if obj.Drawing is None:
            return
        from CNCStepper.workbench.ellipses import ellipse_of

        ellipse = ellipse_of(obj.Drawing)
        x, y = ellipse.centre_mm
        edit(
            obj,
            centre_mm=(x - origin_mm[0], y - origin_mm[1]),
            radius_x_mm=ellipse.radius_x_mm,
            radius_y_mm=ellipse.radius_y_mm,
            rotation_deg=ellipse.rotation_deg,
        )

    def cycle_values(self, obj: Any, origin_mm: tuple[float, ...]) -> dict[str, Any]:
        """Return the parameters; the centre is one in the plane."""
        return {**parameters(obj), "centre_mm": tuple(obj.Centre)[:2]}

    def onChanged(self, obj: Any, name: str) -> None:
        """Let the numbers be typed only where no drawing gives them; FreeCAD calls this at every change."""
        super().onChanged(obj, name)
        if name == "Drawing":
            for shape in set(SHAPE) & set(obj.PropertiesList):
                obj.setEditorMode(shape, 1 if obj.Drawing is not None else 0)
