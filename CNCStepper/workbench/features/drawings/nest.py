# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_Nest: parts of the document on sheets, as a group of drawings of the sheets, which operations follow.

parts, counts, sheets ──► process ──► files: sheet-N.dxf ──► a CNCStepper_Drawing of each sheet
  └── looked at when the object is made: Problem says when the sheets are not those of the parts and the values
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import asdict, dataclass, fields
from typing import Any

from CNCStepper import text_json
from CNCStepper.errors import JobError, Text
from CNCStepper.workbench import packages
from CNCStepper.workbench.features.base import (
    BOOL,
    CONTAINERS,
    DISTANCE,
    ENUMERATION,
    FLOAT,
    INTEGER,
    TEXT,
    Property,
    drawing_pairs,
    values,
)
from CNCStepper.workbench.features.drawings.made_files import SheetGroup, folder_of
from CNCStepper.workbench.features.operation import Operation
from CNCStepper.workbench.services.translation import later

PARTS, SHEETS, MADE = later("Parts"), later("Sheets of material"), later("What was made")
TURNS: dict[str, Any] = {"fixed": [0.0], "half": [0.0, 180.0], "quarter": [0.0, 90.0, 180.0, 270.0], "any": "any"}
GRAINS = {"none": None, "x": 0.0, "y": 90.0}  # of the grain, degrees
DECIMALS = 5  # of the figures by which a drawing is known again
TOLERANCE_MM = 0.002  # in which curved lines of parts become lines and arcs


@dataclass
class PartValues:
    """What is wanted of one part; turn, grain: of TURNS and GRAINS; thickness_mm: 0 for that of the sheets."""

    count: int = 1
    turn: str = "quarter"
    grain: str = "none"
    priority: int = 0
    thickness_mm: float = 0.0


class Nest(SheetGroup):
    """The proxy of a nest: a group of the drawings of its sheets."""

    Type = "CNCStepper_Nest"
    PROPERTIES = (
        Property("parts", "Parts", CONTAINERS, PARTS, later("Parts"),
                 later("Drawings, sketches, shapes and operations whose outlines are nested"), ()),
        Property("part_values", "PartValues", TEXT, PARTS, later("Values"), later("Of each part"), "[]"),
        Property("kerf_mm", "Kerf", DISTANCE, PARTS, later("Kerf"), later("The width of the cut"), 0.0),
        Property("gap_mm", "Gap", DISTANCE, PARTS, later("Gap"), later("Material that stays between two cuts"), 2.0),
        Property("common_lines", "CommonLines", BOOL, PARTS, later("Common lines"),
                 later("Facing edges of neighbours are cut once, in the middle of the kerf; the gap must be 0"), False),
        Property("sheet_x_mm", "SheetX", DISTANCE, SHEETS, later("Length X"), later("Of a sheet of material"), 600.0),
        Property("sheet_y_mm", "SheetY", DISTANCE, SHEETS, later("Width Y"), later("Of a sheet of material"), 400.0),
        Property("sheet_count", "SheetsThere", INTEGER, SHEETS, later("Sheets"), later("How many there are"), 10),
        Property("thickness_mm", "Thickness", DISTANCE, SHEETS, later("Thickness"), later("Of the sheets"), 3.0),
        Property("sheet_grain", "SheetGrain", ENUMERATION, SHEETS, later("Grain"),
                 later("The direction of the material's grain"), "none", choices=tuple(GRAINS)),
        Property("margin_mm", "Margin", DISTANCE, SHEETS, later("Margin"),
                 later("From a cut to the edge of the sheet"), 5.0),
        Property("remnants", "Remnants", CONTAINERS, SHEETS, later("Remnants"),
                 later("Drawings of rests of sheets, which are used first"), ()),
        Property("time_s", "SearchTime", FLOAT, SHEETS, later("Search time"),
                 later("How many seconds a denser nest is looked for"), 20.0),
        Property("folder", "Folder", TEXT, SHEETS, later("Folder"),
                 later("Where the drawings are written; empty: beside the document"), ""),
        Property("sheets", "SheetCount", INTEGER, MADE, later("Sheets"), later("Sheets that carry parts"), 0,
                 output=True),
        Property("placed", "Placed", INTEGER, MADE, later("Placed"), later("Parts on all sheets"), 0, output=True),
        Property("missing", "Missing", INTEGER, MADE, later("Missing"), later("Parts without a place"), 0, output=True),
        Property("placements", "Placements", TEXT, MADE, later("Placements"), later("Where the parts lie"), "[]",
                 output=True),
        Property("made_of", "MadeOf", TEXT, MADE, later("Made of"), later("The parts and the values"), "", output=True),
        Property("report", "Report", TEXT, MADE, later("Report"), later("What was made"), "", output=True),
    )  # fmt: skip

    HIDDEN_NAMES = ("PartValues", "Placements", "MadeOf", "Report")
    CHANGED = ("a part or a value has changed since the parts were nested", "nest them again")
    OF_WINDOW = ("folder", "parts", "part_values", "remnants")

    def key_of(self, obj: Any) -> str:
        """Return a text that is the same for the same parts, remnants and values."""
        drawn = [[figures_of(each) for each in group] for group in (obj.Parts, obj.Remnants)]
        wanted = [asdict(each) for each in part_values(obj)]
        given = {key: value for key, value in self.given(values(obj)).items() if key != "time_s"}
        return json.dumps({"drawn": drawn, "wanted": wanted, **given}, sort_keys=True)

    def keep(self, obj: Any, answer: dict[str, Any], made_of: str) -> None:
        """Keep what was made of the parts and the values that `made_of` holds."""
        obj.SheetCount, obj.Placed, obj.Missing = len(answer["sheets"]), len(answer["parts"]), answer["missing"]
        obj.Placements = json.dumps(answer["parts"])
        told = {key: answer[key] for key in ("density", "unplaced", "saving")}
        obj.Report, obj.MadeOf = text_json.dumps(told), made_of


def part_values(obj: Any) -> list[PartValues]:
    """Return what is wanted of each part, in their order."""
    known = {field.name for field in fields(PartValues)}
    told = [PartValues(**{key: row[key] for key in known & set(row)}) for row in json.loads(obj.PartValues)]
    return (told + [PartValues() for _ in obj.Parts])[: len(obj.Parts)]


def set_parts(obj: Any, parts: Sequence[Any], wanted: Sequence[PartValues]) -> None:
    """Let these be the parts of a nest, each with its values."""
    if list(obj.Parts) != list(parts):
        obj.Parts = list(parts)
    text = json.dumps([asdict(each) for each in wanted])
    if obj.PartValues != text:
        obj.PartValues = text


def pairs_of(part: Any) -> tuple[tuple[Any, tuple[str, ...]], ...]:
    """Return the drawings of a part: an operation's, what a group holds, or the object itself."""
    if isinstance(getattr(part, "Proxy", None), Operation):
        return drawing_pairs(part.Drawings)
    if hasattr(part, "Group") and not part.isDerivedFrom("Part::Feature"):
        return tuple((each, ()) for each in part.Group if each.isDerivedFrom("Part::Feature"))
    return ((part, ()),)


def is_part(obj: Any) -> bool:
    """Return whether an object may be a part: its lines lie flat, and it is no solid."""
    shapes = [each.Shape for each, _ in pairs_of(obj) if hasattr(each, "Shape")]
    return bool(shapes) and any(shape.Edges for shape in shapes) and not any(shape.Solids for shape in shapes)


def figures_of(part: Any) -> list[list[float]]:
    """Return the length and the middle of each edge of a part, by which a change of its outline is seen.

    Where the part lies does not count.
    """
    edges = [edge for each, _ in pairs_of(part) for edge in each.Shape.Edges if not edge.Degenerated]
    if not edges:
        return []
    middles = [edge.CenterOfMass for edge in edges]
    left, low = min(middle.x for middle in middles), min(middle.y for middle in middles)
    rows = ((edge.Length, middle.x - left, middle.y - low) for edge, middle in zip(edges, middles, strict=True))
    return [[round(float(figure), DECIMALS) + 0.0 for figure in row] for row in rows]


def asked_of(obj: Any, verb: str, **more: Any) -> dict[str, Any]:
    """Return what the process is asked (`job/nesting/nest_question.py`); raises CNCStepperError."""
    packages.require()
    from CNCStepper.job.nesting.nest_form import NestForm
    from CNCStepper.machine.profile import validated

    if not obj.Parts:
        raise JobError("nest-parts", "there are no parts", advice="select drawings or sketches and add them")
    found = validated(NestForm, obj.Proxy.given(values(obj)), obj.Label).model_dump()
    wanted = part_values(obj)
    rows = [_part_row(part, number, wanted[number]) for number, part in enumerate(obj.Parts)]
    usual_mm = found["thickness_mm"]
    rests = [{"name": each.Label, "drawing": f"rest-{number}"} for number, each in enumerate(obj.Remnants)]
    sheets = [{**row, "thickness_mm": usual_mm} for row in rests] + _whole_sheets(found, wanted)
    grain = {"grain_deg": GRAINS[found["sheet_grain"]]}
    order = {
        **{key: found[key] for key in ("kerf_mm", "gap_mm", "margin_mm", "common_lines")},
        "sheet": [row | grain for row in sheets],
        "part": [
            {**row, "thickness_mm": each.thickness_mm or usual_mm} for row, each in zip(rows, wanted, strict=True)
        ],
    }
    drawn = {f"part-{number}": packed_drawing(part) for number, part in enumerate(obj.Parts)}
    drawn |= {f"rest-{number}": packed_drawing(part) for number, part in enumerate(obj.Remnants)}
    told = {"verb": verb, "order": order, "drawings": drawn, "time_s": found["time_s"]}
    return {"parts": json.loads(obj.Placements), "folder": str(folder_of(obj)), **told, **more}


def _whole_sheets(found: dict[str, Any], wanted: Sequence[PartValues]) -> list[dict[str, Any]]:
    """Return the whole sheets of each thickness, the usual one first: as many of each."""
    usual_mm = found["thickness_mm"]
    thicknesses_mm = list(dict.fromkeys([usual_mm, *(each.thickness_mm or usual_mm for each in wanted)]))
    whole = {"size_mm": [found["sheet_x_mm"], found["sheet_y_mm"]], "count": found["sheet_count"]}
    return [
        {"name": f"sheet {each:g} mm" if len(thicknesses_mm) > 1 else "sheet", "thickness_mm": each, **whole}
        for each in thicknesses_mm
    ]


def _part_row(part: Any, number: int, wanted: PartValues) -> dict[str, Any]:
    return {
        "name": part.Label,
        "drawing": f"part-{number}",
        "count": wanted.count,
        "rotations_deg": TURNS[wanted.turn],
        "grain_deg": GRAINS[wanted.grain],
        "priority": wanted.priority,
    }


def packed_drawing(part: Any) -> dict[str, Any]:
    """Return the lines of a part as plain data, moved so that its box begins at 0, 0; raises GeometryError."""
    from CNCStepper.drawing.drawing import Attributes, Chain
    from CNCStepper.job.nesting.nest_data import packed_chains
    from CNCStepper.workbench.drawings.joined_curves import drawn_of

    found = drawn_of(pairs_of(part), TOLERANCE_MM).curves
    if not found:
        raise JobError("nest-open", Text("'{name}' holds no lines", name=part.Label), advice="take it out of the parts")
    left, low = (min(each.curve.box_mm[axis] for each in found) for axis in (0, 1))
    return packed_chains(
        [
            Chain(each.curve.moved(-left, -low), Attributes(layer=getattr(each.drawings[0], "Layer", "") or "CUT"))
            for each in found
        ]
    )
