# SPDX-License-Identifier: LGPL-2.1-or-later
"""The process that reads a solid with FreeCAD: `freecadcmd solid_edges.py`, its question in QUESTION as JSON.

The question is [FILE, HEIGHT, TOLERANCE] as `drawing/solids/occ_edges.py` takes it; FILE is STEP, BREP or FCStd. Of a
document the visible objects with a solid or a face are read, those that others are made of left out.
"""

from __future__ import annotations

import json
import os
from typing import Any

from CNCStepper.drawing.solids.process_limits import answer, limit_process, refuse
from CNCStepper.drawing.solids.sheet_heights import AXES, MOST_SLICES, asked_slices, section_heights, sheet_count
from CNCStepper.tolerances import SAME_MM

QUESTION = "CNCSTEPPER_SOLID"
LEVEL = 1e-9  # of a face's direction


def main(path: str, height: str, tolerance: str) -> None:
    """Answer with the edges of the solid in a file at a height, or with its triangles and level faces."""
    limit_process()
    try:
        shape = _shape(path)
        if asked := asked_slices(height):
            answer(_slices(shape, *asked))
        answer(_outline(shape, float(tolerance)) if height == "outline" else _at_height(shape, float(height)))
    except MemoryError:
        refuse("solid-memory", "it takes more memory than it may")
    except Exception as error:
        refuse("solid-file", f"{type(error).__name__}: {error}"[:400])


def _shape(path: str) -> Any:
    import FreeCAD
    import Part

    if not path.lower().endswith(".fcstd"):
        return Part.read(path)
    document = FreeCAD.openDocument(path, True)
    final = [each for each in document.Objects if getattr(each, "Shape", None) is not None and not _is_used(each)]
    shapes = [each.Shape for each in final if each.Visibility and each.Shape.Faces]
    if not shapes:
        refuse("solid-file", "it has no visible object with a face")
    return Part.makeCompound(shapes)


def _is_used(thing: Any) -> bool:
    """Return whether another object of the document, a group apart, is made of this one."""
    return any(getattr(user, "Shape", None) is not None for user in thing.InList)


def _level_faces(shape: Any) -> dict[float, list[Any]]:
    """Return the plane faces that lie level, by their heights, mm."""
    faces: dict[float, list[Any]] = {}
    for face in shape.Faces:
        if face.Surface.TypeId == "Part::GeomPlane" and abs(abs(face.Surface.Axis.z) - 1.0) <= LEVEL:
            faces.setdefault(round(face.Surface.Position.z, 6), []).append(face)
    return faces


def _at_height(shape: Any, height_mm: float) -> dict[str, Any]:
    import FreeCAD

    faces = [face for z, own in _level_faces(shape).items() if abs(z - height_mm) <= SAME_MM for face in own]
    if faces:
        return {"loops": [_edges(face) for face in faces]}
    return {"loops": [_edges(wire) for wire in shape.slice(FreeCAD.Vector(0, 0, 1), height_mm)]}


def _slices(shape: Any, axis: str, thickness_mm: float) -> dict[str, Any]:
    """Return the bounds and the volume of the solids, and the edges of each solid in the section of each sheet."""
    import FreeCAD
    import Part

    solids = [_upright(solid, axis) for solid in shape.Solids]
    loose = len(Part.makeCompound(shape.Solids).Faces) < len(shape.Faces)
    if loose or not solids:
        refuse("slice-open", "it has a face that belongs to no solid" if loose else "it has no solid")
    bounds = [solid.optimalBoundingBox(False) for solid in solids]
    low_mm, high_mm = min(box.ZMin for box in bounds), max(box.ZMax for box in bounds)
    if sheet_count(low_mm, high_mm, thickness_mm) > MOST_SLICES:
        refuse("slice-count", f"the stack has more than {MOST_SLICES} sheets; use thicker ones")
    levels = [level for solid in solids for level in _level_faces(solid)]
    up, sections = FreeCAD.Vector(0, 0, 1), []
    for height_mm in section_heights(low_mm, high_mm, thickness_mm, levels):
        sections.append([[edge for wire in solid.slice(up, height_mm) for edge in _edges(wire)] for solid in solids])
    volume_mm3 = sum(abs(solid.Volume) for solid in solids)
    return {"low_mm": low_mm, "high_mm": high_mm, "volume_mm3": volume_mm3, "sections": sections}


def _upright(shape: Any, axis: str) -> Any:
    """Return a copy of a shape with an axis as Z, the other two in their cyclic order as X and Y."""
    import FreeCAD

    rows = [[float(column == number) for column in range(3)] for number in AXES[axis]]
    turn = FreeCAD.Matrix(*(value for row in rows for value in (*row, 0.0)), 0.0, 0.0, 0.0, 1.0)
    copy = shape.copy()
    copy.transformShape(turn)
    return copy


def _outline(shape: Any, tolerance_mm: float) -> dict[str, Any]:
    points, facets = shape.tessellate(tolerance_mm)
    triangles = [[(points[corner].x, points[corner].y) for corner in facet] for facet in facets]
    levels = [[edge for face in faces for edge in _edges(face)] for faces in _level_faces(shape).values()]
    return {"triangles": triangles, "levels": levels}


def _edges(shape: Any) -> list[list[Any]]:
    """Return the edges of a shape in a level plane, as edge_curves.py takes them."""
    return [_edge(edge) for edge in shape.Edges]


def _edge(edge: Any) -> list[Any]:
    first, last = edge.ParameterRange
    curve = edge.Curve
    if curve.TypeId == "Part::GeomLine":
        begin, end = edge.valueAt(first), edge.valueAt(last)
        return ["line", begin.x, begin.y, end.x, end.y]
    if curve.TypeId in ("Part::GeomCircle", "Part::GeomEllipse"):
        major, minor = _radii(curve)
        centre, along = curve.Center, curve.XAxis
        across = curve.Axis.cross(along)
        axes = [major * along.x, major * along.y, minor * across.x, minor * across.y]
        return ["ellipse", centre.x, centre.y, *axes, first, last]
    spline = curve.toBSpline(first, last)
    if spline.isPeriodic():
        spline.setNotPeriodic()
    poles = [(pole.x, pole.y) for pole in spline.getPoles()]
    return ["spline", spline.Degree, poles, spline.getWeights(), spline.KnotSequence]


def _radii(curve: Any) -> tuple[float, float]:
    return (curve.Radius,) * 2 if curve.TypeId == "Part::GeomCircle" else (curve.MajorRadius, curve.MinorRadius)


if QUESTION in os.environ:  # freecadcmd gives a script another name than __main__
    main(*json.loads(os.environ.pop(QUESTION)))
