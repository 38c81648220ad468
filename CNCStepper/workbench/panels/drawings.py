# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which objects of a document an operation can follow."""

from __future__ import annotations

from typing import Any

from CNCStepper.errors import CNCStepperError

MOST_EDGES = 2000  # more are no drawing that a list should look through


def follows(operation: Any, drawing: Any) -> bool:
    """Return whether an operation can follow a drawing: lines that lie flat, of which each kind wants its own."""
    if not _is_drawing(drawing) or operation in drawing.OutListRecursive:
        return False
    try:
        operation.Proxy.look(drawing, ())
    except CNCStepperError:
        return False
    return True


def _is_drawing(obj: Any) -> bool:
    """Return whether an object holds lines or points and no solid; datum planes, axes and origins are none."""
    if not obj.isDerivedFrom("Part::Feature") or obj.isDerivedFrom("Part::Datum"):
        return False
    shape = obj.Shape
    if shape.isNull():
        return bool(obj.isDerivedFrom("Sketcher::SketchObject"))
    return not shape.Solids and bool(shape.Vertexes) and len(shape.Edges) <= MOST_EDGES
