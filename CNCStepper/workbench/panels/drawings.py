# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which objects of a document an operation can follow."""

from __future__ import annotations

from typing import Any

from CNCStepper.errors import CNCStepperError
from CNCStepper.workbench.features.base import proxy_type

MOST_EDGES = 2000  # more are no drawing that a list should look through


def follows(operation: Any, drawing: Any) -> bool:
    """Return whether an operation can follow a drawing: lines that lie flat; for a pocket, one ellipse."""
    if not _is_drawing(drawing) or operation in drawing.OutListRecursive:
        return False
    from CNCStepper.workbench.ellipses import ellipse_of
    from CNCStepper.workbench.shapes import edges_of

    look = ellipse_of if proxy_type(operation) == "CNCStepper_EllipticalPocket" else edges_of
    try:
        look(drawing)
    except CNCStepperError:
        return False
    return True


def _is_drawing(obj: Any) -> bool:
    """Return whether an object holds lines and no solid; datum planes, axes and origins are none."""
    if not obj.isDerivedFrom("Part::Feature") or obj.isDerivedFrom("Part::Datum"):
        return False
    shape = obj.Shape
    return not shape.isNull() and not shape.Solids and 0 < len(shape.Edges) <= MOST_EDGES
