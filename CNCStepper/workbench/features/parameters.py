# SPDX-License-Identifier: LGPL-2.1-or-later
"""The properties of operations: made from what cycles declare (CNCStepper/cycles/parameter.py); shared results."""

from __future__ import annotations

import re
from typing import get_args, get_origin

from CNCStepper.cycles.parameter import GROUPS, Declared, declared
from CNCStepper.workbench.features.base import (
    ANGLE,
    BOOL,
    DISTANCE,
    ENUMERATION,
    FLOAT,
    INTEGER,
    POINTS,
    POSITION,
    SPEED,
    TEXT,
    Property,
)
from CNCStepper.workbench.services.translation import later

UNIT = re.compile("_(mm_min|mm|deg|s)$")
NUMBER = {"mm_min": SPEED, "mm": DISTANCE, "deg": ANGLE}
TYPES = {int: INTEGER, bool: BOOL, str: TEXT}

RESULT = later("In whole passes")
MADE = later("Result")
LEVELS = (
    Property("ap_mm", "StepdownUsed", DISTANCE, RESULT, later("Depth per pass"),
             later("Stepdown (ap), recalculated to whole passes"), 0.0, output=True),
    Property("levels", "Levels", INTEGER, RESULT, later("Levels"), later("How many passes in depth"), 0, output=True),
)  # fmt: skip
PASSES = (
    *LEVELS,
    Property("ae_mm", "StepoverUsed", DISTANCE, RESULT, later("Width per pass"),
             later("Stepover (ae), recalculated to whole passes"), 0.0, output=True),
    Property("passes", "Passes", INTEGER, RESULT, later("Passes"), later("How many passes at each depth"), 0,
             output=True),
)  # fmt: skip
REST = (
    Property("rest_corners", "RestCorners", INTEGER, RESULT, later("Rest corners"),
             later("How many corners and narrow places the tool does not reach into"), 0, output=True),
    Property("rest_corner_mm", "RestCorner", DISTANCE, RESULT, later("Rest at most"),
             later("The thickest material left in them"), 0.0, output=True),
)  # fmt: skip


def properties_of(parameters: type, *own: Property) -> tuple[Property, ...]:
    """Return the properties of a cycle's parameters by group; those of the operation's own come first in theirs."""
    found = [(0, entry) for entry in own]
    for field in declared(parameters):
        table = f"{field.key}_" if field.table else ""
        found += [(row.shown.row, property_of(row, table)) for row in field.rows if row.shown]
    found.sort(key=lambda each: (GROUPS.index(each[1].group) if each[1].group in GROUPS else -1, each[0]))
    return tuple(entry for _, entry in found)


def property_of(field: Declared, table: str = "", prefix: str = "") -> Property:
    """Return the property of a field that is shown; a table's is "tabs_", before its key and those of `only`.

    The key without the unit gives the name in FreeCAD; there the prefix comes in place of the table's name.
    """
    assert field.shown is not None, field.key
    shown, type_ = field.shown, _type_of(field)
    name = shown.name or UNIT.sub("", (prefix or table) + field.key).title().replace("_", "")
    return Property(
        table + field.key,
        name,
        type_,
        shown.group,
        shown.label,
        shown.help,
        field.default if shown.new is None else shown.new,
        shown.choices or field.choices,
        only=(table + shown.only[0], shown.only[1]) if shown.only else (),
        plane=type_ in (POSITION, POINTS),
    )


def _type_of(field: Declared) -> str:
    if field.choices:
        return ENUMERATION
    if get_origin(field.type) is tuple:
        return POINTS if ... in get_args(field.type) else POSITION
    unit = UNIT.search(field.key)
    return TYPES.get(field.type) or (NUMBER.get(unit[1], FLOAT) if unit else FLOAT)
