# SPDX-License-Identifier: LGPL-2.1-or-later
"""The shapes of the library by the names that job files use."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from CNCStepper.drawing.shape_library import brackets, flanges, parts, polygons, round_shapes, slots
from CNCStepper.drawing.shape_library.declaration import SHAPES, Figure, LibraryShape
from CNCStepper.errors import JobError, Text
from CNCStepper.quantities import shown

FAMILIES = {  # title: the module that declares them
    "Round shapes": round_shapes,
    "Slots and holes": slots,
    "Polygons": polygons,
    "Brackets": brackets,
    "Flanges and plates": flanges,
    "Parts and signs": parts,
}


def shapes_of(title: str) -> list[LibraryShape]:
    """Return the shapes of a family, in the order of their declarations."""
    return [shape for shape in SHAPES.values() if shape.draw.__module__ == FAMILIES[title].__name__]


def library_shape(kind: object) -> LibraryShape:
    """Return the declaration of a shape; raises JobError for a kind that is none."""
    if not isinstance(kind, str) or kind not in SHAPES:
        raise JobError(
            "library-kind",
            Text("the library has no shape '{kind}'", kind=kind[:60] if isinstance(kind, str) else shown(kind)),
            advice=Text("use one of: {kinds}", kinds=", ".join(SHAPES)),
        )
    return SHAPES[kind]


def figure_of(kind: object, values: Mapping[str, Any]) -> Figure:
    """Return the figure of a shape; dimensions left out have their usual values. Raises as `LibraryShape.figure`."""
    return library_shape(kind).figure(values)
