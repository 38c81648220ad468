# SPDX-License-Identifier: LGPL-2.1-or-later
"""The half section of a solid of revolution: the meridian of each of its faces, exactly as the face has it.

A solid here lies with its axis along X; its meridians are turned into the half plane of X and Y, Y above 0.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from CNCStepper.errors import GeometryError, Text
from CNCStepper.geometry.curve import Curve, straight
from CNCStepper.job.curve_fit_cache import Line, fit_of
from CNCStepper.job.turning.section_sides import chained
from CNCStepper.tolerances import SAME_MM
from CNCStepper.workbench.drawings.curves import pieces_of

SPLINE_ROUND_MM = 0.001  # how far a parameter line of a spline may be from a circle about the axis


def section_of(solid: Any, label: str, tolerance_mm: float) -> Curve:
    """Return the boundary of the half section in (z, r): closed, or open with both ends on the axis.

    Raises GeometryError for a solid with a hollow inside, or with a face whose meridian cannot be read.
    """
    pieces: list[Curve] = []
    for face in solid.Faces:
        found = _meridian(face, label, tolerance_mm)
        if found is not None and not any(_is_same(found, other) for other in pieces):
            pieces.append(found)
    chains = chained(pieces)
    chains.sort(key=lambda chain: -float(chain.xy[:, 1].max()))
    if len(chains) > 1:
        z, r = chains[1].xy[0]
        raise GeometryError(
            "section-hollow",
            Text("'{label}' has a hollow that no tool can enter", label=label),
            value=Text("at {z:.4g} mm along the axis, radius {r:.4g} mm", z=z, r=r),
            advice="close it in the drawing",
        )
    return chains[0]


def _meridian(face: Any, label: str, tolerance_mm: float) -> Curve | None:
    """Return the meridian of a face, None where it has no length."""
    import Part

    if isinstance(face.Surface, Part.Plane):
        return _of_plane(face)
    u_first, u_last, v_first, v_last = face.ParameterRange
    across = _turning_parameter(face)
    if across is None:
        raise GeometryError(
            "section-face",
            Text("a face of '{label}' does not run round the axis", label=label),
            value=Text("at {z:.4g} mm along the axis", z=face.CenterOfMass.x),
            advice="draw its half profile",
        )
    middle, span = ((u_first + u_last) / 2, (v_first, v_last)) if across == "u" else (
        (v_first + v_last) / 2, (u_first, u_last))  # fmt: skip
    line = face.Surface.uIso(middle) if across == "u" else face.Surface.vIso(middle)
    edge = line.toShape(*span)
    if edge.Length <= SAME_MM:
        return None
    (piece,) = pieces_of([_turned_up(edge)])
    return fit_of(piece, tolerance_mm) if isinstance(piece, Line) else piece


def _of_plane(face: Any) -> Curve:
    """Return the line of a level face: from its hole, or the axis, to its rim."""
    points = [point for edge in face.Edges for point in edge.discretize(9)]
    radii = [math.hypot(point.y, point.z) for point in points]
    least, most, z = min(radii), max(radii), points[0].x
    return straight((z, 0.0 if most - least <= SAME_MM else least), (z, most))


def _turning_parameter(face: Any) -> str | None:
    """Return the parameter of a face's surface, "u" or "v", that runs round the axis; None where none does."""
    u_first, u_last, v_first, v_last = face.ParameterRange
    u, v = np.linspace(u_first, u_last, 9).tolist(), np.linspace(v_first, v_last, 9).tolist()
    lines = {"u": [face.valueAt(at, v[4]) for at in u], "v": [face.valueAt(u[4], at) for at in v]}
    away_mm = {
        name: max(np.ptp([point.x for point in line]), np.ptp([math.hypot(point.y, point.z) for point in line]))
        for name, line in lines.items()
    }
    name = min(away_mm, key=lambda name: away_mm[name])
    return name if away_mm[name] <= SPLINE_ROUND_MM else None


def _turned_up(edge: Any) -> Any:
    """Return an edge turned about the axis so that its middle has Z 0 and Y above 0."""
    import FreeCAD

    middle = edge.valueAt((edge.FirstParameter + edge.LastParameter) / 2)
    turn = FreeCAD.Rotation(FreeCAD.Vector(1, 0, 0), -math.degrees(math.atan2(middle.z, middle.y)))
    turned = edge.copy()
    turned.Placement = FreeCAD.Placement(FreeCAD.Vector(), turn).multiply(turned.Placement)
    return turned


def _is_same(one: Curve, other: Curve) -> bool:
    """Return whether two meridians are the same, as those of the halves of a face are."""
    ends = [one.xy[[0, -1]], one.xy[[-1, 0]]]
    if min(float(np.abs(end - other.xy[[0, -1]]).max()) for end in ends) > SAME_MM:
        return False
    middles = [curve.at_length(curve.length_mm / 2)[0] for curve in (one, other)]
    return math.dist(*middles) <= SAME_MM
