# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_Freehand: points in drawing order become a wire, simplified or smoothed within a tolerance."""

from __future__ import annotations

from typing import Any

from CNCStepper.workbench import packages
from CNCStepper.workbench.features.base import BOOL, DISTANCE, INTEGER, POINTS, Feature, Property
from CNCStepper.workbench.services.translation import later

LINE = later("Line")


class Freehand(Feature):
    """The proxy of a freehand line; its points lie in the object's own plane, which `Placement` sets."""

    Type = "CNCStepper_Freehand"
    PROPERTIES = (
        Property("points_mm", "Points", POINTS, LINE, later("Points"), later("The points as they were drawn"), ()),
        Property("tolerance_mm", "Tolerance", DISTANCE, LINE, later("Tolerance"),
                 later("The wire stays this close to every drawn point; 0 keeps every point that bends the line"), 0.0),
        Property("smooth_mm", "Smooth", DISTANCE, LINE, later("Smooth"),
                 later("Arcs and lines this close to the drawn points, instead of the tolerance; 0: straight lines"),
                 0.0),
        Property("closed", "Closed", BOOL, LINE, later("Closed"), later("Whether the last point joins the first"),
                 False),
        Property("kept", "Kept", INTEGER, LINE, later("Points kept"), later("How many points the wire has"), 0,
                 output=True),
    )  # fmt: skip

    def make(self, obj: Any) -> None:
        """Make the wire from the points; raises GeometryError when they make no line."""
        packages.require("numpy", "shapely")
        from CNCStepper.workbench.drawings.freehand_points import freehand_curve
        from CNCStepper.workbench.drawings.wires import wire_of

        points = [tuple(point) for point in obj.Points]
        height_mm, curve = freehand_curve(points, float(obj.Tolerance), float(obj.Smooth), bool(obj.Closed))
        placement = obj.Placement
        obj.Shape = wire_of(curve, height_mm)
        obj.Placement = placement
        obj.Kept = len(curve.xy)
