# SPDX-License-Identifier: LGPL-2.1-or-later
"""The half profile of a turned part from a document: a sketch, picked edges, or the section of a solid of revolution.

                     the lathe's axis                        z = 0                          radius
 sketch, edges       the document's Z axis; the X axis       as drawn                       X, or Y on the YZ plane;
                     for what lies on the XY plane                                          Y on the XY plane
 solid, its edges    its own, towards +Z, else +X, else +Y   its end face in that direction  from its axis

`flip` turns the axis round. What is drawn wholly on the other side of the axis is turned about it. z falls towards the
chuck, so a profile runs from the larger z on; X of its rows is the radius unless `x_is` says "diameter". Lines and arcs
come over exactly, ellipses and splines as arcs within the tolerance.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np

from CNCStepper.errors import GeometryError, JobError, Text
from CNCStepper.geometry.curve import Curve
from CNCStepper.job.curve_fit_cache import Line, fit_of
from CNCStepper.job.turning.profile_form import Xis, check_profile
from CNCStepper.job.turning.section_sides import Side, chained, from_front, profile_rows, side_of
from CNCStepper.tolerances import SAME_HEIGHT_MM
from CNCStepper.workbench.drawings.curves import SHORTEST_MM, pieces_of, require_tolerance
from CNCStepper.workbench.drawings.meridians import section_of
from CNCStepper.workbench.drawings.revolution_axis import Axis, axis_of
from CNCStepper.workbench.drawings.shapes import parts_of, placed_shape

TOLERANCE_MM = 0.002  # of ellipses and splines, as that of a job's arcs
Zero = Literal["drawn", "end"]


@dataclass(frozen=True)
class HalfProfile:
    """A profile in (z, r). frame: the placement in the document of its plane, z along the frame's X, r along its Y."""

    chain: Curve
    frame: Any

    def rows(self, x_is: Xis = "radius") -> list[Any]:
        """Return it as the `points` of a job file's profile."""
        return profile_rows(self.chain, x_is)


def half_profile(drawing: Any, names: Sequence[str] = (), **more: Any) -> list[Any]:
    """Return the rows of a drawing's profile, X as radius; see `read_half_profile`."""
    return read_half_profile(drawing, names, **more).rows()


def read_half_profile(
    drawing: Any,
    names: Sequence[str] = (),
    *,
    side: Side = "outside",
    flip: bool = False,
    zero: Zero | None = None,
    tolerance_mm: float = TOLERANCE_MM,
) -> HalfProfile:
    """Return the profile of a sketch or wire, of the picked edges, or of a solid's section.

    names: the edges that count ("Edge3"); of a solid none for its section. side: of a solid, its outside or its bore.
    zero: "end" puts z = 0 at the end of the profile or of the solid, "drawn" leaves it at the document's zero along the
    axis; see the module's text. Raises GeometryError and JobError for what is no profile.
    """
    require_tolerance(tolerance_mm)
    solid = _solid(drawing)
    if any(not name.startswith("Edge") for name in names):
        raise GeometryError(
            "profile-picked",
            "a profile is made of edges",
            value=", ".join(names),
            advice="pick edges only, or the whole object",
        )
    frame = _frame_of_axis(axis_of(solid, drawing.Label)) if solid else _frame_of_plane(drawing, names)
    if flip:
        frame = frame.multiply(_turn("Y"))
    if solid and not names:
        boundary = section_of(_in_frame(solid, frame), drawing.Label, tolerance_mm)
        chain = side_of(boundary, side)
    else:
        chain, frame = _drawn(drawing, names, frame, tolerance_mm)
    if (zero or ("end" if solid else "drawn")) == "end":
        end_mm = _end_mm(solid, frame) if solid else float(chain.points(TOLERANCE_MM)[:, 0].max())
        chain, frame = chain.moved(-end_mm, 0.0), frame.multiply(_moved(end_mm))
    check_profile(chain)
    return HalfProfile(chain, frame)


def _solid(drawing: Any) -> Any:
    """Return the one solid of a drawing, None where it has none; raises GeometryError for more."""
    solids = placed_shape(drawing).Solids
    if len(solids) > 1:
        raise GeometryError(
            "profile-solids",
            Text("'{drawing}' has more than one solid", drawing=drawing.Label),
            value=f"{len(solids)}",
            limit="1",
            advice="choose one of them, or join them",
        )
    return solids[0] if solids else None


def _drawn(drawing: Any, names: Sequence[str], frame: Any, tolerance_mm: float) -> tuple[Curve, Any]:
    """Return the chain of a drawing's edges, and its frame; raises GeometryError and JobError."""
    edges = [edge for part in parts_of(drawing, names) for edge in part.Edges if not edge.Degenerated]
    edges = [edge for edge in edges if edge.Length > SHORTEST_MM]
    if not edges:
        raise GeometryError(
            "drawing-empty",
            Text("the drawing '{drawing}' holds no lines", drawing=drawing.Label),
            advice="draw something in it, or choose another drawing",
        )
    if _solid(drawing):
        frame = frame.multiply(_turn_to(edges, frame))
    edges = [_in_frame(edge, frame) for edge in edges]
    points = _points(edges)
    _refuse_off_plane(points, drawing.Label)
    if points[:, 1].max() <= SAME_HEIGHT_MM and points[:, 1].min() < -SAME_HEIGHT_MM:
        frame, edges = frame.multiply(_turn("X")), [_in_frame(edge, _turn("X")) for edge in edges]
    pieces = [fit_of(one, tolerance_mm) if isinstance(one, Line) else one for one in pieces_of(edges)]
    chains = chained(pieces)
    if len(chains) != 1:
        ends = ", ".join(f"z {z:.4g} r {r:.4g}" for z, r in (chain.xy[0].tolist() for chain in chains[:3]))
        what, value = "a profile must be one chain of lines", f"{len(chains)} ({ends})"
        raise JobError("profile-chains", what, value=value, limit="1", advice="draw it joined up")
    if chains[0].closed:
        z, r = chains[0].xy[0].tolist()
        what, value = "the profile is closed: it has no end at the chuck", f"at z {z:.4g} mm, radius {r:.4g} mm"
        raise JobError("profile-closed", what, value=value, advice="take out the axis and the line at the chuck")
    return from_front(chains[0]), frame


def _refuse_off_plane(points: np.ndarray, label: str) -> None:
    """Raise GeometryError where points in a frame, float64[n, 3], leave its half plane."""
    worst = int(np.argmax(np.abs(points[:, 2])))
    if abs(points[worst, 2]) > SAME_HEIGHT_MM:
        raise GeometryError(
            "profile-plane",
            Text("'{label}' does not lie in a plane through the lathe's axis", label=label),
            value=Text("{away:.4g} mm beside it", away=abs(float(points[worst, 2]))),
            limit=f"{SAME_HEIGHT_MM} mm",
            advice="draw it on the XZ plane, with X as the radius and Z along the axis",
        )


def _end_mm(solid: Any, frame: Any) -> float:
    """Return the largest z of a solid in a frame."""
    return float(_in_frame(solid, frame).optimalBoundingBox(False).XMax)


def _frame_of_axis(axis: Axis) -> Any:
    """Return the frame of a half plane at an axis, its zero where the document's is along it."""
    import FreeCAD

    along = FreeCAD.Vector(*axis.direction)
    aside = FreeCAD.Vector(0, 0, 1) if abs(axis.direction[2]) < 0.9 else FreeCAD.Vector(1, 0, 0)
    radius = (aside - along * aside.dot(along)).normalize()
    base = axis.point - axis.direction * float(axis.point @ axis.direction)
    rotation = FreeCAD.Rotation(along, radius, along.cross(radius), "XYZ")
    return FreeCAD.Placement(FreeCAD.Vector(*base), rotation)


def _frame_of_plane(drawing: Any, names: Sequence[str]) -> Any:
    """Return the frame of a drawing by the plane that it lies in; see the module's text."""
    import FreeCAD

    normal = _normal(drawing, names)
    if normal is not None and abs(normal.z) > 0.5:
        return FreeCAD.Placement()
    radius = FreeCAD.Vector(0, 1, 0) if normal is not None and abs(normal.x) > 0.5 else FreeCAD.Vector(1, 0, 0)
    along = FreeCAD.Vector(0, 0, 1)
    return FreeCAD.Placement(FreeCAD.Vector(), FreeCAD.Rotation(along, radius, along.cross(radius), "XYZ"))


def _normal(drawing: Any, names: Sequence[str]) -> Any:
    """Return the normal of a sketch, or of the plane of edges; None for edges of which several planes hold all."""
    import FreeCAD

    if drawing.isDerivedFrom("Sketcher::SketchObject"):
        placed = drawing.getGlobalPlacement() if hasattr(drawing, "getGlobalPlacement") else drawing.Placement
        return placed.Rotation.multVec(FreeCAD.Vector(0, 0, 1))
    points = _points([edge for part in parts_of(drawing, names) for edge in part.Edges])
    if not len(points):
        return None
    _, spread, axes = np.linalg.svd(points - points.mean(axis=0))
    return FreeCAD.Vector(*axes[2]) if spread[1] > SAME_HEIGHT_MM else None


def _points(edges: Sequence[Any]) -> np.ndarray:
    """Return places along edges, float64[n, 3]."""
    return np.array([tuple(point) for edge in edges for point in edge.discretize(9)]).reshape(-1, 3)


def _turn_to(edges: Sequence[Any], frame: Any) -> Any:
    """Return the turn about a frame's axis that brings the edge farthest from the axis into its half plane."""
    import FreeCAD

    points = _points([_in_frame(edge, frame) for edge in edges])
    y, z = points[np.argmax(np.hypot(*points[:, 1:].T)), 1:].tolist()
    about = FreeCAD.Rotation(FreeCAD.Vector(1, 0, 0), math.degrees(math.atan2(z, y)))
    return FreeCAD.Placement(FreeCAD.Vector(), about)


def _in_frame(shape: Any, frame: Any) -> Any:
    """Return a copy of a shape as it lies in a frame."""
    copy = shape.copy()
    copy.Placement = frame.inverse().multiply(copy.Placement)
    return copy


def _turn(about: str) -> Any:
    """Return a half turn about an axis of a frame."""
    import FreeCAD

    axis = FreeCAD.Vector(1, 0, 0) if about == "X" else FreeCAD.Vector(0, 1, 0)
    return FreeCAD.Placement(FreeCAD.Vector(), FreeCAD.Rotation(axis, 180))


def _moved(z_mm: float) -> Any:
    import FreeCAD

    return FreeCAD.Placement(FreeCAD.Vector(z_mm, 0, 0), FreeCAD.Rotation())
