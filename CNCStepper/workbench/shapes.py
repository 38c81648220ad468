# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a drawing object of a FreeCAD document shows: its shape in the document's coordinates, checked to lie flat.

Only X and Y of a drawing count: depths are measured from the top of the stock, at whatever height it was drawn.
"""

from __future__ import annotations

from typing import Any

from CNCStepper.errors import GeometryError

FLAT_MM = 1e-4  # a drawing whose heights differ by less is flat


def edges_of(drawing: Any) -> list[Any]:
    """Return the edges of a sketch, wire or face in the document's coordinates; raises GeometryError when it has none.

    Construction lines of a sketch are no part of its shape.
    """
    edges = [edge for edge in _placed_shape(drawing).Edges if not edge.Degenerated]
    if not edges:
        raise GeometryError(
            "drawing-empty",
            f"the drawing '{drawing.Label}' holds no lines",
            advice="draw something in it, or choose another drawing",
        )
    refuse_unflat(edges, drawing.Label)
    return edges


def box_of(obj: Any) -> Any:
    """Return the bounding box of an object's shape in the document's coordinates, not valid when it has none."""
    import FreeCAD

    shape = _placed_shape(obj)
    return FreeCAD.BoundBox() if shape.isNull() else shape.optimalBoundingBox(False)


def containers_of(drawing: Any) -> list[Any]:
    """Return the parts and bodies that hold an object, innermost first: when one of them moves, so does the object."""
    found: list[Any] = []
    holder = drawing.getParentGeoFeatureGroup() if drawing is not None else None
    while holder is not None and holder not in found:
        found.append(holder)
        holder = holder.getParentGeoFeatureGroup()
    return found


def _placed_shape(drawing: Any) -> Any:
    """Return the shape where the user sees it: an object inside a part or body moves with that."""
    import Part

    shape = getattr(drawing, "Shape", None)
    if shape is None or shape.isNull():
        return Part.Shape()
    if hasattr(drawing, "getGlobalPlacement"):
        shape = shape.copy()
        shape.Placement = drawing.getGlobalPlacement()
    return shape


def refuse_unflat(edges: list[Any], label: str) -> None:
    """Raise GeometryError when the edges do not lie in one plane parallel to XY."""
    heights = [point.z for edge in edges for point in edge.discretize(9)]
    rise = max(heights) - min(heights)
    if rise > FLAT_MM:
        raise GeometryError(
            "drawing-not-flat",
            f"the drawing '{label}' does not lie flat",
            value=f"heights differ by {rise:.4g} mm",
            limit=f"{FLAT_MM} mm",
            advice="draw it on the XY plane or on one parallel to it",
        )
