# SPDX-License-Identifier: LGPL-2.1-or-later
"""The base of the operations of all jobs: a tool, the drawings that it follows, and the parameters of a cycle."""

from __future__ import annotations

import functools
from typing import Any

from CNCStepper.errors import CNCStepperError, CycleError, Text
from CNCStepper.workbench.drawings.shapes import containers_of, edges_of, require_closed
from CNCStepper.workbench.features.base import (
    BOOL,
    CONTAINERS,
    DRAWINGS,
    LINK,
    PROBLEM,
    TEXT,
    Feature,
    Property,
    drawing_pairs,
    is_job,
    is_tool,
    require_parts,
)
from CNCStepper.workbench.services.translation import later

OPERATION_GROUP = later("Operation")
LINKS = ("tool", "active", "drawings")  # keys of every operation that are none of a cycle's
MARKED = "MarkDrawings"  # the property of the drawings that are marked, of operations that mark
DRAWN_BY = ("Drawings", MARKED)  # the properties whose drawings an operation stands on
OPERATION = (
    Property("tool", "Tool", LINK, OPERATION_GROUP, later("Tool"), later("The tool that cuts it")),
    Property("active", "Active", BOOL, OPERATION_GROUP, later("Active"), later("Whether the program holds it"), True),
)


def drawn(group: str, text: str, only: tuple[str, tuple[str, ...]] | tuple[()] = ()) -> tuple[Property, ...]:
    """Return the properties of an operation that follows drawings; only: when it does."""
    return (
        Property("drawings", "Drawings", DRAWINGS, group, later("Drawings"), text, (), only=only),
        Property("containers", "Containers", CONTAINERS, group, later("Containers"),
                 later("The parts and bodies that the drawings move with"), (), output=True),
        Property("deleted_drawing", "DeletedDrawing", TEXT, group, later("Deleted drawing"),
                 later("The drawing it followed, when that was deleted"), "", output=True),
    )  # fmt: skip


class CycleOperation(Feature):
    """The proxy of an operation: its properties are its cycle's parameters, under the same keys.

    TABLES: keys of tables within the cycle's own; "tabs_count" is then "count" in the table "tabs". OWN: keys that
    are none of the cycle's. CLOSED: whether all lines must close. PICKS_LINES: whether a click on a single line of a
    drawing means that line alone. NO_DRAWING: what it is to have no drawing. BY: the processes that cut it. SHAPE: keys
    whose values a drawing gives, where there is one. ONE_DRAWING: whether it follows one alone. TAKES_SOLIDS: whether a
    whole solid is a drawing for it.
    """

    CYCLE = ""
    TABLES: tuple[str, ...] = ()
    OWN: tuple[str, ...] = ()
    CLOSED = False
    PICKS_LINES = False
    SHAPE: tuple[str, ...] = ()
    ONE_DRAWING = False
    TAKES_SOLIDS = False
    NO_DRAWING = later("none yet")
    BY: tuple[str, ...] = ()
    removed_label = ""
    kept: Any = None  # what it was made into, until the object or what it stands on changes
    warnings: tuple[str, ...] = ()  # what the last cut says that a person should know
    unused: tuple[CNCStepperError, ...] = ()  # why what was selected with the drawings is none of them

    def add_properties(self, obj: Any) -> None:
        """Add what `obj` lacks, and let only those be typed that count."""
        super().add_properties(obj)
        self.show_what_counts(obj)

    def onDocumentRestored(self, obj: Any) -> None:
        """Let one of an older version catch up, and take a copied or pasted one into its job; FreeCAD calls this."""
        super().onDocumentRestored(obj)
        if self.is_copy:
            from CNCStepper.workbench.document.operation_order import take_in

            take_in(obj)

    @classmethod
    def look(cls, drawing: Any, picked: tuple[str, ...]) -> None:
        """Raise GeometryError when an operation of this kind cannot follow a drawing, or what is picked of it."""
        (require_closed if cls.CLOSED else edges_of)(drawing, picked)

    def given(self, found: dict[str, Any]) -> dict[str, Any]:
        """Return the parameters of the cycle among an object's values: those that count, in the cycle's tables."""
        entries = [entry for entry in self.PROPERTIES if entry.key in found and entry.key not in (*LINKS, *self.OWN)]
        return in_tables({entry.key: found[entry.key] for entry in entries if self.counts(entry, found)}, self.TABLES)

    def onChanged(self, obj: Any, name: str) -> None:
        """Stand on what the drawings move with, too; FreeCAD calls this at every change."""
        if name in self._inputs:
            self.kept = None
        if PROBLEM.name not in obj.PropertiesList or "Restore" in obj.State:
            return
        if name in DRAWN_BY and "DeletedDrawing" in obj.PropertiesList:
            holders = [holder for drawing in linked_drawings(obj) for holder in containers_of(drawing)]
            obj.Containers = list(dict.fromkeys(holders))
            kept = obj.DeletedDrawing if name == MARKED else ""  # until other drawings are chosen
            obj.DeletedDrawing = self.removed_label or kept
            self.removed_label, self.unused = "", ()
        if name in self._choosers:
            self.show_what_counts(obj)

    @functools.cached_property
    def _inputs(self) -> set[str]:
        """The names of the properties that the cycle is made from."""
        return {"Label", *(entry.name for entry in self.PROPERTIES if not entry.output)}

    @functools.cached_property
    def _choosers(self) -> set[str]:
        """The names of the properties whose values say which others count."""
        chosen_by = {entry.only[0] for entry in self.PROPERTIES if entry.only}
        return {"Drawings", *(entry.name for entry in self.PROPERTIES if entry.key in chosen_by)}

    def onBeforeChange(self, obj: Any, name: str) -> None:
        """Note which drawing is being deleted; FreeCAD calls this before every change."""
        if name in DRAWN_BY:
            removed = [drawing.Label for drawing, _ in drawing_pairs(getattr(obj, name)) if drawing.Removing]
            self.removed_label = removed[0] if removed else self.removed_label


def drawings_of(obj: Any) -> tuple[tuple[Any, tuple[str, ...]], ...]:
    """Return the drawings that an operation follows, each with the names of its faces and edges that count, () for all.

    An operation that has no such property yet follows none.
    """
    return drawing_pairs(getattr(obj, "Drawings", ()))


def marked_of(obj: Any) -> tuple[tuple[Any, tuple[str, ...]], ...]:
    """Return the drawings that an operation marks, as `drawings_of` does; none of one that marks nothing."""
    return drawing_pairs(getattr(obj, MARKED, ()))


def linked_drawings(obj: Any) -> list[Any]:
    """Return all drawings that an operation stands on."""
    return [drawing for drawing, _ in (*drawings_of(obj), *marked_of(obj))]


def in_tables(found: dict[str, Any], tables: tuple[str, ...]) -> dict[str, Any]:
    """Return values by key, those whose key begins with the name of a table put into that table."""
    content: dict[str, Any] = {}
    for key, value in found.items():
        table = next((name for name in tables if key.startswith(f"{name}_")), "")
        if table:
            content.setdefault(table, {})[key.removeprefix(f"{table}_")] = value
        else:
            content[key] = value
    return content


def jobs_of(obj: Any) -> list[Any]:
    """Return the jobs that hold an operation (one, unless a user linked it twice)."""
    return [other for other in obj.InList if is_job(other)]


def refuse_what_it_stands_on(obj: Any) -> None:
    """Raise CycleError for a drawing that was deleted, JobError for a tool or a drawing with a problem."""
    if obj.DeletedDrawing:
        raise CycleError(
            "drawing-deleted",
            Text("the drawing '{deleted_drawing}' that it followed was deleted", deleted_drawing=obj.DeletedDrawing),
            advice="undo that, choose another drawing, or choose none",
        )
    parts = (obj.Tool, *linked_drawings(obj))
    require_parts(part for part in parts if part is not None)


def tool_of(obj: Any) -> Any:
    """Return the tool of an operation; raises CycleError where it has none."""
    if not is_tool(obj.Tool):
        raise CycleError(
            "tool-missing", Text("{obj} has no tool", obj=obj.Label), advice="choose one of the job's tools for it"
        )
    return obj.Tool
