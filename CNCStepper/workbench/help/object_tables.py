# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tables of properties of all kinds of objects that have a page in the help.

Who presses F1 in a panel has its object's class loaded already; the others take a while, which the help window spends
in a thread.
"""

from __future__ import annotations

from collections.abc import Iterator

from CNCStepper.workbench import packages
from CNCStepper.workbench.features.base import Feature, Property

SHAPE = "CNCStepper_Shape"


def properties_of_type(type_name: str) -> tuple[Property, ...]:
    """Return the table of a type of object; of a shape of the library with the dimensions of all kinds."""
    kind = next((kind for kind in _loaded(Feature) if kind.Type == type_name), None) or classes_by_type()[type_name]
    return (*kind.PROPERTIES, *(_dimensions() if type_name == SHAPE else ()))


def classes_by_type() -> dict[str, type[Feature]]:
    """Return all classes by their types; the first time they are loaded."""
    from CNCStepper.workbench.help.feature_classes import CLASSES

    return {kind.Type: kind for kind in CLASSES}


def _loaded(kind: type[Feature]) -> Iterator[type[Feature]]:
    for below in kind.__subclasses__():
        yield below
        yield from _loaded(below)


def _dimensions() -> Iterator[Property]:
    """Yield the dimensions of the library's shapes, each key once; none where the library's packages are missing."""
    if packages.missing():
        return
    from CNCStepper.drawing.shape_library.shape_families import FAMILIES, shapes_of
    from CNCStepper.workbench.features.drawings.shape import properties_of

    shapes = (shape for title in FAMILIES for shape in shapes_of(title))
    by_key = {entry.key: entry for shape in shapes for entry in properties_of(shape)}
    yield from by_key.values()
