# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tables of properties of all kinds of objects that have a page in the help."""

from __future__ import annotations

from collections.abc import Iterator

from CNCStepper.workbench import packages
from CNCStepper.workbench.features.base import Feature, Property
from CNCStepper.workbench.features.catalogue import KINDS
from CNCStepper.workbench.features.drawings.drawing import Drawing
from CNCStepper.workbench.features.drawings.nest import Nest
from CNCStepper.workbench.features.drawings.shape import Shape, properties_of
from CNCStepper.workbench.features.drawings.slices import Slices
from CNCStepper.workbench.features.drawings.text import Text
from CNCStepper.workbench.features.freehand import Freehand
from CNCStepper.workbench.features.job import Job
from CNCStepper.workbench.features.program import Program
from CNCStepper.workbench.features.programs.arrangement import Arrangement
from CNCStepper.workbench.features.tool import Tool
from CNCStepper.workbench.features.turning.lathe_job import LatheJob
from CNCStepper.workbench.features.turning.turning_operation import TURNING_KINDS
from CNCStepper.workbench.features.turning.turning_profile import TurningProfile
from CNCStepper.workbench.features.turning.turning_tool import TurningTool

DRAWN = (Drawing, Text, Shape, Freehand, Slices, Nest)
CLASSES: tuple[type[Feature], ...] = (
    *(Job, Tool, Program, Arrangement, LatheJob, TurningTool, TurningProfile),
    *(*KINDS, *TURNING_KINDS, *DRAWN),
)
TABLES = {kind.Type: kind.PROPERTIES for kind in CLASSES}


def properties_of_type(type_name: str) -> tuple[Property, ...]:
    """Return the table of a type of object; of a shape of the library with the dimensions of all kinds."""
    return (*TABLES[type_name], *(_dimensions() if type_name == Shape.Type else ()))


def _dimensions() -> Iterator[Property]:
    """Yield the dimensions of the library's shapes, each key once; none where the library's packages are missing."""
    if packages.missing():
        return
    from CNCStepper.drawing.shape_library.shape_families import FAMILIES, shapes_of

    shapes = (shape for title in FAMILIES for shape in shapes_of(title))
    by_key = {entry.key: entry for shape in shapes for entry in properties_of(shape)}
    yield from by_key.values()
