# SPDX-License-Identifier: LGPL-2.1-or-later
"""One stepped half profile as a sketch, as a solid of revolution, as single edges, and as points."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import FreeCAD
import Part
from FreeCAD import Vector

STEPS = ((12.0, 0.0), (12.0, -20.0), (18.0, -20.0), (18.0, -40.0))
POINTS = tuple(f"{2 * r}; {z}" for r, z in STEPS)


def sketch(document: Any) -> Any:
    """The steps as a sketch on the XZ plane: its Y is the document's Z."""
    made = document.addObject("Sketcher::SketchObject", "Sketch")
    made.Placement = FreeCAD.Placement(Vector(), FreeCAD.Rotation(Vector(1, 0, 0), 90))
    for (r0, z0), (r1, z1) in pairwise(STEPS):
        made.addGeometry(Part.LineSegment(Vector(r0, z0, 0), Vector(r1, z1, 0)), False)
    return made


def shaft(document: Any) -> Any:
    """The steps as a solid of revolution about Z."""
    made = document.addObject("Part::Feature", "Shaft")
    parts = [Part.makeCylinder(r, h, Vector(0, 0, z)) for r, h, z in ((12, 20, -20), (18, 20, -40))]
    made.Shape = parts[0].fuse(parts[1]).removeSplitter()
    return made


def edges(document: Any) -> Any:
    """The steps as single lines."""
    made = document.addObject("Part::Feature", "Lines")
    places = [Vector(r, 0, z) for r, z in STEPS]
    made.Shape = Part.Compound([Part.makeLine(*pair) for pair in pairwise(places)])
    return made
