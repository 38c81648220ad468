# SPDX-License-Identifier: LGPL-2.1-or-later
"""The declaration of a cycle's parameter: all its properties are declared once, on its field.

    depth_mm: Annotated[Depth, Parameter(CUT, "Depth", "The depth below the top of the stock", 10.0)]

The name's suffix is the unit, the type has the bounds, `Parameter` the rest. From these follow the pydantic model of
the job file, FreeCAD's property, the panel's row with its translated texts, and docs/reference/job-file.md. The classes
that hold such fields, in modules `*_parameters.py`, load neither pydantic nor numpy: FreeCAD reads them when it opens
a document, also where these packages are missing. A cycle derives from its parameters and from BaseModel.
"""

from __future__ import annotations

import functools
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Annotated, Any, Literal, get_args, get_origin, get_type_hints

from CNCStepper.quantities import Bounds

if TYPE_CHECKING:
    from typing import dataclass_transform
else:

    def dataclass_transform(**_: Any) -> Any:
        """Change nothing: type checkers alone need to know that pydantic makes fields of a class's annotations."""
        return lambda cls: cls


CUT, TABS, LEADS, FINISH, PATH = "Cut", "Tabs", "Leads", "Finish", "Path"
GROUPS = (CUT, TABS, LEADS, FINISH, PATH)  # in this order in a panel; a group of a cycle's own comes before them


@dataclass(frozen=True)
class Parameter:
    """What a field is besides name, type and default.

    group, label, help: English texts of the panel's box, its row and its explanation. No window shows a field without a
    group; a label is empty where the table gives it. new: the value of a new object, where that is not the field's
    default. only: the key of another parameter, in the same table, and those of its values with which this one counts.
    name: FreeCAD's name of the property, where it is not that of the key. choices: in the window's order, where a job
    file has another. row: rows of lower numbers come first in their group.
    """

    group: str
    label: str
    help: str
    new: Any = None
    only: tuple[str, tuple[str, ...]] | tuple[()] = ()
    name: str = ""
    choices: tuple[str, ...] = ()
    row: int = 0


@dataclass(frozen=True)
class Table:
    """A field that is a table of parameters; texts: label and explanation of a row by key, where they are its own."""

    parameters: type
    texts: Mapping[str, tuple[str, str]] = field(default_factory=dict)


@dataclass(frozen=True)
class Declared:
    """A field as it was declared: key, type, default (None: required), bounds of a number, and how it is shown."""

    key: str
    type: Any
    default: Any
    bounds: Bounds | None
    shown: Parameter | None
    table: Table | None

    @property
    def choices(self) -> tuple[str, ...]:
        """The texts that a job file may hold, () where it holds none."""
        return get_args(self.type) if get_origin(self.type) is Literal else ()

    @property
    def rows(self) -> tuple[Declared, ...]:
        """What a window shows: itself, or the rows of its table with the texts that the table has for them."""
        if self.table is None:
            return (self,) if self.shown and self.shown.group else ()
        return tuple(row._with(*self.table.texts.get(row.key, ("", ""))) for row in declared(self.table.parameters))

    def _with(self, label: str, help: str) -> Declared:
        assert self.shown is not None, self.key
        return replace(self, shown=replace(self.shown, label=label or self.shown.label, help=help or self.shown.help))


@functools.cache
def declared(parameters: type) -> tuple[Declared, ...]:
    """Return the fields of a class of parameters, those of its bases first."""
    return tuple(_declared(parameters))


def _declared(parameters: type) -> Iterator[Declared]:
    for key, hint in get_type_hints(parameters, include_extras=True).items():
        kind, *notes = get_args(hint) if get_origin(hint) is Annotated else (hint,)
        by_type: dict[type, Any] = {type(note): note for note in notes}
        default = getattr(parameters, key, None)
        yield Declared(key, kind, default, by_type.get(Bounds), by_type.get(Parameter), by_type.get(Table))


@dataclass_transform(kw_only_default=True)
class Parameters:
    """The base of classes of parameters; each is made a pydantic model by the cycle that derives from it."""


OFFSET = Parameter("", "", "Moves what is drawn")
DEPTH = Parameter(CUT, "Depth", "The depth below the top of the stock", 10.0)
STEPDOWN = Parameter(CUT, "Depth per pass", "Stepdown (ap): the depth of one pass at most", 2.0)
STEPOVER = Parameter(CUT, "Width per pass", "Stepover (ae): the width of one pass at most", 2.4)
DIRECTION = Parameter(CUT, "Direction", "How the cutter turns against the feed")
PATTERN = Parameter(CUT, "Pattern", "How the area is cleared")
PATTERN_ANGLE = Parameter(CUT, "Angle", "From X to the lines of the pattern", only=("pattern", ("zigzag", "oneway")))
FINISH_STEPDOWN = Parameter(
    FINISH, "Last pass: depth", "Finishing stepdown (ap_acab): of the last pass in depth; 0: none", 0.2
)
FINISH_STEPOVER = Parameter(
    FINISH, "Last pass: width", "Finishing stepover (ae_acab): of the last pass at the wall; 0: none", 0.3
)
FINISH_FEED = Parameter(FINISH, "Wall feed", "The feed of the last pass at the wall; 0: the tool's own feed")
STOCK_TO_LEAVE = Parameter(FINISH, "Stock to leave", "Stock to leave at the wall for another operation")
TOLERANCE = Parameter(PATH, "Tolerance", "How far the wall may be off the drawing")
ENTRY = Parameter(PATH, "Entry", "How the tool goes down", row=1)
ENTRY_ANGLE = Parameter(
    PATH, "Entry angle", "How steeply a helix or ramp goes down", only=("entry", ("helix", "ramp")), row=1
)
Direction = Literal["climb", "conventional"]
EntryName = Literal["helix", "ramp", "plunge"]
