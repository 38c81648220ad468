# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a drawing object of a FreeCAD document shows: its shape in the document's coordinates, checked to lie flat.

Only X and Y of a drawing count: depths are measured from the top of the stock, at whatever height it was drawn.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from CNCStepper.errors import GeometryError, Text
from CNCStepper.tolerances import SAME_HEIGHT_MM

CURVE_POINTS = 64  # of an edge, where its distance from the middle is looked for


@dataclass(frozen=True)
class DrawingSnapshot:
    """A drawing as it was seen: its shape, which lives as long as this, where that lies, and its label."""

    shape: Any
    placement: Any
    label: str

    @classmethod
    def of(cls, drawing: Any) -> DrawingSnapshot:
        """Return how a drawing is now."""
        placed = drawing.getGlobalPlacement() if hasattr(drawing, "getGlobalPlacement") else None
        return cls(getattr(drawing, "Shape", None), placed, str(drawing.Label))

    def same(self, other: DrawingSnapshot) -> bool:
        """Return whether two drawings are the same one, unchanged."""
        if self.shape is None or other.shape is None or (self.label, self.placement) != (other.label, other.placement):
            return False
        return bool(self.shape.isSame(other.shape))


def all_same(some: Sequence[DrawingSnapshot], others: Sequence[DrawingSnapshot]) -> bool:
    """Return whether several drawings are the same ones, unchanged."""
    return len(some) == len(others) and all(map(DrawingSnapshot.same, some, others))


def edges_of(drawing: Any, picked: Sequence[str] = ()) -> list[Any]:
    """Return the edges of a sketch, wire or face in the document's coordinates; raises GeometryError when it has none.

    picked: the faces and edges of it that count ("Face3"), all where there is none. Construction lines of a sketch are
    no part of its shape.
    """
    edges = [edge for part in parts_of(drawing, picked) for edge in part.Edges if not edge.Degenerated]
    if not edges:
        raise GeometryError(
            "drawing-empty",
            Text("the drawing '{drawing}' holds no lines", drawing=drawing.Label),
            advice="draw something in it, or choose another drawing",
        )
    refuse_unflat(edges, drawing.Label)
    return edges


def line_groups(drawing: Any, picked: Sequence[str] = ()) -> list[list[Any]]:
    """Return the edges of a drawing by face, because neighbouring faces share some.

    The edges that are no face's are one group. A drawing of which all counts must lie flat; raises GeometryError.
    """
    if not picked:
        edges_of(drawing)
    parts = parts_of(drawing, picked)
    faces = [face for part in parts for face in part.Faces]
    held = {edge.hashCode() for face in faces for edge in face.Edges}
    loose = [edge for part in parts for edge in part.Edges if edge.hashCode() not in held]
    groups = [*([face.Edges for face in faces]), *([loose] if loose else [])]
    return [sound for group in groups if (sound := [edge for edge in group if not edge.Degenerated])]


def sorted_chains(edges: Sequence[Any], shortest_mm: float) -> list[list[Any]]:
    """Return edges as chains in which each touches the next, without those that are shorter than a length."""
    import Part

    return list(Part.sortEdges([edge for edge in edges if edge.Length > shortest_mm]))


def require_closed(drawing: Any, picked: Sequence[str] = ()) -> None:
    """Raise GeometryError, with the place, unless all lines of a drawing close, so that they enclose something."""
    import Part

    for chain in Part.sortEdges(edges_of(drawing, picked)):
        wire = Part.Wire(chain)
        if not wire.isClosed():
            raise open_line(drawing.Label, tuple(wire.OrderedVertexes[-1].Point)[:2])


def open_line(label: str, end_mm: tuple[float, ...]) -> GeometryError:
    """Return the refusal of a drawing's line that ends at a place and does not close."""
    return GeometryError(
        "outline-open",
        Text("a line in '{label}' is open and encloses nothing", label=label),
        value=Text("it ends at X {end_mm:.4g} Y {end_mm2:.4g}", end_mm=end_mm[0], end_mm2=end_mm[1]),
        advice="close it, or leave only closed lines in the drawing",
    )


def parts_of(drawing: Any, picked: Sequence[str] = ()) -> list[Any]:
    """Return the picked faces, edges and points of an object, the whole of it where nothing is picked.

    Raises GeometryError for one that is not there any more.
    """
    shape = placed_shape(drawing)
    try:
        return [shape.getElement(name) for name in picked] or [shape]
    except (ValueError, IndexError, RuntimeError) as error:
        raise GeometryError(
            "picked-missing",
            Text("the elements picked of '{drawing}' no longer exist", drawing=drawing.Label),
            value=", ".join(picked),
            advice="pick it again",
        ) from error


def box_of(obj: Any) -> Any:
    """Return the bounding box of an object's shape in the document's coordinates, not valid when it has none."""
    import FreeCAD

    shape = placed_shape(obj)
    return FreeCAD.BoundBox() if shape.isNull() else shape.optimalBoundingBox(False)


def box_round(shapes: list[Any]) -> Any:
    """Return the bounding box of several shapes, of curves themselves and not of the chords that show them."""
    return box_of_boxes([shape.optimalBoundingBox(False) for shape in shapes])


def box_of_boxes(boxes: list[Any]) -> Any:
    """Return the bounding box of several boxes."""
    import FreeCAD

    around = FreeCAD.BoundBox()
    for box in boxes:
        around.add(box)
    return around


def round_box(shapes: list[Any]) -> Any:
    """Return the bounding box of the standing cylinder round several shapes, its axis in the middle of their own."""
    import FreeCAD

    box = box_round(shapes)
    x, y = box.Center.x, box.Center.y
    edges = [edge for shape in shapes for edge in shape.Edges if not edge.Degenerated]
    points = [point for edge in edges for point in edge.discretize(CURVE_POINTS)]
    radius = max(math.hypot(point.x - x, point.y - y) for point in points)
    return FreeCAD.BoundBox(x - radius, y - radius, box.ZMin, x + radius, y + radius, box.ZMax)


def containers_of(drawing: Any) -> list[Any]:
    """Return the parts and bodies that hold an object, innermost first: when one of them moves, so does the object."""
    found: list[Any] = []
    holder = drawing.getParentGeoFeatureGroup() if drawing is not None else None
    while holder is not None and holder not in found:
        found.append(holder)
        holder = holder.getParentGeoFeatureGroup()
    return found


def placed_shape(drawing: Any) -> Any:
    """Return an object's shape where the user sees it, an empty one where it has none.

    An object inside a part or body moves with that.
    """
    import Part

    shape = getattr(drawing, "Shape", None)
    if shape is None or shape.isNull():
        return Part.Shape()
    if hasattr(drawing, "getGlobalPlacement"):
        moved = drawing.getGlobalPlacement().multiply(drawing.Placement.inverse())  # by what holds the object
        # a Draft point is a bare vertex: FreeCAD 1.0 copies its placement twice
        shape = Part.Compound([shape]) if shape.ShapeType == "Vertex" else shape.copy()
        shape.Placement = moved.multiply(shape.Placement)
    return shape


def refuse_unflat(edges: list[Any], label: str) -> None:
    """Raise GeometryError when the edges do not lie in one plane parallel to XY."""
    heights = [point.z for edge in edges for point in edge.discretize(9)]
    rise = max(heights) - min(heights)
    if rise > SAME_HEIGHT_MM:
        raise GeometryError(
            "drawing-not-flat",
            Text("the drawing '{label}' does not lie flat", label=label),
            value=Text("heights differ by {rise:.4g} mm", rise=rise),
            limit=f"{SAME_HEIGHT_MM} mm",
            advice="draw it on the XY plane or on one parallel to it",
        )
