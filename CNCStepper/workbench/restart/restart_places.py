# SPDX-License-Identifier: LGPL-2.1-or-later
"""The places from which a program can be restarted, as a list for a person: no Qt, no FreeCAD."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from heapq import merge
from operator import attrgetter
from typing import Any

from CNCStepper.recovery.restart.restart_places import RequestedPlace
from CNCStepper.workbench.help.topics import TOPIC_OF
from CNCStepper.workbench.services.translation import later, tr

OPERATION, CONTOUR = "operation", "contour"
CHOSEN = {
    "line": later("From line {0}"),
    "run": later("From line {0}, the time that it is run: {1}"),
    OPERATION: later("From the operation {0}"),
    CONTOUR: later("From contour {0}"),
    "point": later("From the place that was clicked, {0}"),
}


@dataclass(frozen=True)
class Row:
    """An operation or a contour of the list; number: from 1, each kind counted by itself. line: of its first move."""

    kind: str
    number: int
    line: int
    name: str
    begins_at: str = ""
    length_mm: float = 0.0

    @property
    def where(self) -> RequestedPlace:
        """The place that it names."""
        return (
            RequestedPlace(contour=self.number) if self.kind == CONTOUR else RequestedPlace(operation=str(self.number))
        )


def rows_of(told: Mapping[str, Any]) -> list[Row]:
    """Return the rows of `recovery/restart/description.py`: each operation before its contours."""
    operations = [Row(OPERATION, number, line, name) for number, line, name in told["operations"]]
    contours = [Row(CONTOUR, *contour) for contour in told["contours"]]
    return list(merge(operations, contours, key=attrgetter("line")))


def title_of(name: str) -> str:
    """Return an operation's name in FreeCAD's language, as it is where it is not that of a cycle."""
    topic = TOPIC_OF.get(f"CNCStepper_{name.title().replace(' ', '')}")
    return tr(topic.title) if topic else name


def chosen(where: RequestedPlace, rows: Sequence[Row]) -> tuple[str, tuple[object, ...]]:
    """Return the sentence for the chosen place, still to be translated, and its values."""
    if where.at_mm:
        return CHOSEN["point"], (" ".join(f"{axis}{mm:.3f}" for axis, mm in zip("XYZ", where.at_mm, strict=False)),)
    if where.contour:
        return CHOSEN[CONTOUR], (where.contour,)
    if where.operation:
        names = (row.name for row in rows if row.kind == OPERATION and row.where == where)
        return CHOSEN[OPERATION], (next(names, where.operation),)
    if where.time:
        return CHOSEN["run"], (where.line, where.time)
    return CHOSEN["line"], (where.line,)


def row_of(where: RequestedPlace, rows: Sequence[Row]) -> int | None:
    """Return which row of the list a place is; None for a line or a point."""
    return next((index for index, row in enumerate(rows) if row.where == where), None)


def line_of(where: RequestedPlace, rows: Sequence[Row]) -> int:
    """Return the line of the file whose way shows a place; 0 where that is a point."""
    index = row_of(where, rows)
    return rows[index].line if index is not None else where.line
