# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_Shape: a shape of the library by its kind and its dimensions, as exact wires.

An object has a property for each dimension of its kind; they follow from the library's declaration
(`drawing/shape_library/declaration.py`). That needs packages that FreeCAD may lack: then a saved object stays as it is.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

from CNCStepper.workbench import packages
from CNCStepper.workbench.features.base import (
    ANGLE,
    DISTANCE,
    ENUMERATION,
    FLOAT,
    INTEGER,
    TEXT,
    Feature,
    Property,
    values,
)
from CNCStepper.workbench.features.parameters import UNIT
from CNCStepper.workbench.services.translation import later

if TYPE_CHECKING:
    from CNCStepper.drawing.shape_library.declaration import Dimension, LibraryShape

SHAPE, DIMENSIONS = later("Shape"), later("Dimensions")
KIND = Property("kind", "ShapeKind", TEXT, SHAPE, later("Kind"), later("Its name in job files"), "", output=True)
PART = Property("part", "Part", ENUMERATION, SHAPE, later("Curves"), later("All, the outline, or the holes in it"),
                "all", choices=("all", "outline", "holes"))  # fmt: skip
TYPES = {"length": DISTANCE, "angle": ANGLE, "count": INTEGER}


class Shape(Feature):
    """The proxy of a shape; its zero is that of the library's shape, which `Placement` moves and turns."""

    Type = "CNCStepper_Shape"
    PROPERTIES: tuple[Property, ...] = (KIND, PART)

    def add_properties(self, obj: Any) -> None:
        """Add the properties of every shape, and those of its kind where that is known."""
        super().add_properties(obj)
        if obj.ShapeKind and not packages.missing():
            self.become(obj, obj.ShapeKind)

    def become(self, obj: Any, kind: str) -> None:
        """Make the object one of a kind, with its usual dimensions where it has none; raises JobError for no kind."""
        from CNCStepper.drawing.shape_library.shape_families import library_shape

        self.PROPERTIES = (KIND, PART, *properties_of(library_shape(kind)))
        obj.ShapeKind = kind
        super().add_properties(obj)

    def make(self, obj: Any) -> None:
        """Make the wires; raises GeometryError for dimensions that do not go together."""
        packages.require()
        import Part

        from CNCStepper.job.shape_forms.library_form import LibraryForm
        from CNCStepper.workbench.drawings.wires import wire_of

        curves = LibraryForm.model_construct(kind=obj.ShapeKind, **values(obj)).curves()
        placement = obj.Placement
        obj.Shape = Part.makeCompound([wire_of(curve, 0.0) for curve in curves])
        obj.Placement = placement


def properties_of(shape: LibraryShape) -> tuple[Property, ...]:
    """Return the properties of the dimensions of a kind, in the order of their declaration."""
    return tuple(_property(key, dimension) for key, dimension in shape.dimensions.items())


def _property(key: str, dimension: Dimension) -> Property:
    name = UNIT.sub("", key).title().replace("_", "")
    type_ = TYPES.get(dimension.bounds.kind, FLOAT)
    usual = int(dimension.usual) if type_ == INTEGER else dimension.usual
    return replace(PART, key=key, name=f"Shape{name}", type=type_, group=DIMENSIONS, label=dimension.title,
                   text=dimension.title, default=usual, choices=())  # fmt: skip
