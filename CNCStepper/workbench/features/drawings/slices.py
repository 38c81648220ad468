# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_Slices: a solid as a stack of sheets, whose pieces are nested on sheets of material.

solid ──► BREP or STL ──► process ──► files: slice-NNN.dxf, sheet-N.dxf ──► a CNCStepper_Drawing of each sheet
  └── looked at when the object is made: Problem says when the sheets are not those of the solid and the values
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from CNCStepper import text_json
from CNCStepper.errors import JobError
from CNCStepper.workbench import packages
from CNCStepper.workbench.features.base import (
    DISTANCE,
    ENUMERATION,
    FLOAT,
    INTEGER,
    LINK,
    TEXT,
    Property,
    values,
)
from CNCStepper.workbench.features.drawings.made_files import SheetGroup, folder_of
from CNCStepper.workbench.services.translation import later

SOLID, MATERIAL, MADE = later("Solid"), later("Sheets of material"), later("What was made")
DECIMALS = 6  # of the figures by which a solid is known again


class Slices(SheetGroup):
    """The proxy of a stack of sheets: a group of the drawings of its nested sheets."""

    Type = "CNCStepper_Slices"
    PROPERTIES = (
        Property("solid", "Solid", LINK, SOLID, later("Solid"), later("What is cut into sheets")),
        Property("thickness_mm", "Thickness", DISTANCE, SOLID, later("Thickness"), later("Of the sheets"), 3.0),
        Property("axis", "Axis", ENUMERATION, SOLID, later("Axis"), later("Along which the sheets are stacked"), "z",
                 choices=("x", "y", "z")),
        Property("hole_mm", "RegistrationHole", DISTANCE, SOLID, later("Registration holes"),
                 later("Their diameter; pins through them align the sheets; 0: none"), 3.0),
        Property("sheet_x_mm", "SheetX", DISTANCE, MATERIAL, later("Length X"), later("Of a sheet of material"), 600.0),
        Property("sheet_y_mm", "SheetY", DISTANCE, MATERIAL, later("Width Y"), later("Of a sheet of material"), 400.0),
        Property("gap_mm", "Gap", DISTANCE, MATERIAL, later("Gap"), later("Between two pieces"), 2.0),
        Property("margin_mm", "Margin", DISTANCE, MATERIAL, later("Margin"),
                 later("From a piece to the edge of the sheet"), 3.0),
        Property("time_s", "SearchTime", FLOAT, MATERIAL, later("Search time"),
                 later("How many seconds a denser nest is looked for"), 10.0),
        Property("folder", "Folder", TEXT, MATERIAL, later("Folder"),
                 later("Where the drawings are written; empty: beside the document"), ""),
        Property("slices", "SliceCount", INTEGER, MADE, later("Slices"), later("Sheets of the stack"), 0, output=True),
        Property("sheets", "SheetCount", INTEGER, MADE, later("Sheets"),
                 later("Sheets of material that the pieces take"), 0, output=True),
        Property("made_of", "MadeOf", TEXT, MADE, later("Made of"), later("The solid and the values"), "", output=True),
        Property("report", "Report", TEXT, MADE, later("Report"), later("What was made"), "", output=True),
    )  # fmt: skip

    CHANGED = ("the solid or a value has changed since the sheets were made", "slice it again")
    OF_WINDOW = ("solid", "folder")

    def key_of(self, obj: Any) -> str:
        """Return a text that is the same for the same solid and the same values."""
        solid = obj.Solid
        shape = getattr(solid, "Mesh", None) or solid.Shape
        box = shape.BoundBox
        sides = (box.XMin, box.YMin, box.ZMin, box.XMax, box.YMax, box.ZMax, shape.Volume, shape.Area)
        figures = [round(float(side), DECIMALS) + 0.0 for side in sides]
        return json.dumps({"solid": figures, **self.given(values(obj))}, sort_keys=True)

    def make(self, obj: Any) -> None:
        """Say why the sheets are not those of the solid; they stay as they were made."""
        require_solid(obj)
        super().make(obj)

    def keep(self, obj: Any, answer: dict[str, Any], made_of: str) -> None:
        """Keep what was made of the solid and the values that `made_of` holds."""
        obj.SliceCount, obj.SheetCount = answer["slices"], len(answer["sheets"])
        obj.Report, obj.MadeOf = text_json.dumps(answer), made_of


def require_solid(obj: Any) -> Any:
    """Return the object that is to be cut into sheets; raises JobError where there is none with a closed solid."""
    solid = obj.Solid
    if solid is None or not is_solid(solid):
        raise _no_solid()
    return solid


def last_solid(objects: Sequence[Any]) -> Any:
    """Return the last of the objects that is a solid; raises JobError where none is."""
    found = next((each for each in reversed(objects) if is_solid(each)), None)
    if found is None:
        raise _no_solid()
    return found


def _no_solid() -> JobError:
    return JobError("slices-solid", "no solid is chosen", advice="choose a body or a mesh of the document")


def is_solid(obj: Any) -> bool:
    """Return whether an object holds a solid, or is a mesh."""
    if hasattr(obj, "Mesh"):
        return bool(obj.Mesh.CountFacets)
    return bool(obj.isDerivedFrom("Part::Feature") and obj.Shape.Solids)


def asked_of(obj: Any, folder: Path) -> dict[str, Any]:
    """Return what the process is asked, and write the solid into a folder for it, a body exactly, a mesh as triangles.

    Raises JobError where there is no solid, no folder for the drawings, or a bad value.
    """
    packages.require()
    from CNCStepper.job.slicing.slice_form import SliceForm
    from CNCStepper.machine.profile import validated

    solid = require_solid(obj)
    form = validated(SliceForm, obj.Proxy.given(values(obj)), obj.Label)
    asked = {"folder": str(folder_of(obj)), "title": obj.Label, "form": form.model_dump()}
    path = folder / ("solid.stl" if hasattr(solid, "Mesh") else "solid.brep")
    if hasattr(solid, "Mesh"):
        solid.Mesh.write(str(path))
    else:
        solid.Shape.exportBrep(str(path))
    return {"solid": str(path), **asked}
