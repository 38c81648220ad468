# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all operations share: a tool, a cycle made from their properties, and a job that cuts them in order."""

from __future__ import annotations

import functools
from typing import Any

from CNCStepper.errors import CycleError
from CNCStepper.workbench import packages
from CNCStepper.workbench.features.base import (
    BOOL,
    CONTAINERS,
    DRAWING,
    HIDDEN,
    JOB,
    LINK,
    PICKED,
    PROBLEM,
    TEXT,
    Feature,
    Property,
    entry_of,
    proxy_type,
    require_parts,
    show,
    value_of,
    values,
)
from CNCStepper.workbench.shapes import containers_of, edges_of
from CNCStepper.workbench.words import later

OPERATION_GROUP = later("Operation")
LINKS = ("tool", "active", "drawing", "picked")  # keys of every operation that are none of a cycle's
OPERATION = (
    Property("tool", "Tool", LINK, OPERATION_GROUP, later("Tool"), later("The tool that cuts it")),
    Property("active", "Active", BOOL, OPERATION_GROUP, later("Active"), later("Whether the program holds it"), True),
)


def drawn(group: str, text: str, only: tuple[str, tuple[str, ...]] | tuple[()] = ()) -> tuple[Property, ...]:
    """Return the properties of an operation that follows a drawing; only: when it does."""
    return (
        Property("drawing", "Drawing", DRAWING, group, later("Drawing"), text, only=only),
        Property("picked", "Picked", PICKED, group, later("Picked"),
                 later("The faces and edges of the drawing that count; none: all of it"), only=only),
        Property("containers", "Containers", CONTAINERS, group, later("Containers"),
                 later("The parts and bodies that the drawing moves with"), (), output=True),
        Property("deleted_drawing", "DeletedDrawing", TEXT, group, later("Deleted drawing"),
                 later("The drawing it followed, when that was deleted"), "", output=True),
    )  # fmt: skip


class Operation(Feature):
    """The proxy of an operation: its properties are its cycle's parameters, under the same keys.

    TABLES: keys of tables within the cycle's own; "tabs_count" is then "count" in the table "tabs". OWN: keys that
    are none of the cycle's. SHAPE: keys whose values the drawing gives, where there is one. PICKS_LINES: whether a
    click on a single line of a drawing means that line alone. NO_DRAWING: what it is to have no drawing.
    """

    CYCLE = ""
    TABLES: tuple[str, ...] = ()
    OWN: tuple[str, ...] = ()
    SHAPE: tuple[str, ...] = ()
    PICKS_LINES = False
    NO_DRAWING = later("none yet")
    WHY_FIXED = later("The drawing gives this value")
    removed_label = ""
    last_cut: Any = None  # a CutOnce
    warnings: tuple[str, ...] = ()  # what the last cut says that a person should know

    def add_properties(self, obj: Any) -> None:
        """Add what `obj` lacks, and let only those be typed that count."""
        super().add_properties(obj)
        self.show_what_counts(obj)

    @classmethod
    def look(cls, drawing: Any, picked: tuple[str, ...]) -> None:
        """Raise GeometryError when an operation of this kind cannot follow a drawing, or what is picked of it."""
        edges_of(drawing, picked)

    def follow(self, obj: Any, origin_mm: tuple[float, ...]) -> None:
        """Take those parameters from the drawing that it gives; only while `obj` itself is recomputed."""

    def given(self, found: dict[str, Any]) -> dict[str, Any]:
        """Return the parameters of the cycle among an object's values: those that count, in the cycle's tables."""
        entries = [entry for entry in self.PROPERTIES if entry.key in found and entry.key not in (*LINKS, *self.OWN)]
        return in_tables({entry.key: found[entry.key] for entry in entries if self.counts(entry, found)}, self.TABLES)

    def counts(self, entry: Property, found: dict[str, Any]) -> bool:
        """Return whether a property counts beside an object's other values, by key."""
        if not entry.only:
            return True
        chooser, choices = entry.only
        return found.get(chooser) in choices and self.counts(entry_of(self, chooser), found)

    def show_what_counts(self, obj: Any) -> None:
        """Hide the properties that do not count, and let only those be typed that no drawing gives."""
        found = values(obj)
        for entry in self.PROPERTIES:
            if entry.only or entry.key in self.SHAPE:
                is_drawn = entry.key in self.SHAPE and obj.Drawing is not None
                obj.setEditorMode(entry.name, int(is_drawn) if self.counts(entry, found) else HIDDEN)

    def cycle_values(self, obj: Any, origin_mm: tuple[float, ...]) -> dict[str, Any]:
        """Return the cycle's parameters; `origin_mm` is where the work zero lies in the document."""
        return self.given(values(obj))

    def cycle(self, obj: Any, origin_mm: tuple[float, ...]) -> Any:
        """Return the checked cycle of `obj` in work coordinates; raises CycleError, GeometryError or JobError."""
        packages.require()
        from CNCStepper.cycles.catalogue import cycle_class
        from CNCStepper.machine.profile import validated

        content = {"cycle": self.CYCLE, "tool": _tool(obj).Number, **self.cycle_values(obj, origin_mm)}
        return validated(cycle_class(self.CYCLE), content, obj.Label)

    def cut_once(self, cycle: Any, setup: Any) -> Any:
        """Return the cycle with its cut, which is kept for the next who asks for the same; raises CycleError."""
        from CNCStepper.workbench.cut_once import CutOnce

        if self.last_cut is None or not self.last_cut.fits(cycle, setup):
            self.last_cut = CutOnce(cycle, setup)
        return self.last_cut

    def make(self, obj: Any) -> None:
        """Cut it for trial, as its job would, and show the figures."""
        self.warnings = ()
        _refuse_deleted(obj)
        require_parts(part for part in (obj.Tool, obj.Drawing) if part is not None)
        show(obj, self.figures(obj))

    def onChanged(self, obj: Any, name: str) -> None:
        """Stand on what the drawing moves with, too; FreeCAD calls this at every change."""
        if PROBLEM.name not in obj.PropertiesList or "Restore" in obj.State:
            return
        if name == "Drawing":
            obj.Containers = containers_of(obj.Drawing)
            obj.DeletedDrawing = self.removed_label
            self.removed_label = ""
            if obj.Picked and obj.Picked[0] is not obj.Drawing:
                obj.Picked = None
        if name in self._choosers:
            self.show_what_counts(obj)

    @functools.cached_property
    def _choosers(self) -> set[str]:
        """The names of the properties whose values say which others count."""
        return {"Drawing", *(entry_of(self, entry.only[0]).name for entry in self.PROPERTIES if entry.only)}

    def onBeforeChange(self, obj: Any, name: str) -> None:
        """Note which drawing is being deleted; FreeCAD calls this before every change."""
        if name == "Drawing" and obj.Drawing is not None and obj.Drawing.Removing:
            self.removed_label = obj.Drawing.Label

    def figures(self, obj: Any) -> dict[str, float]:
        """Return what the cycle reports (recalculated ae and ap, passes); nothing while it belongs to no job."""
        jobs = jobs_of(obj)
        origin_mm = tuple(jobs[0].WorkOrigin) if jobs else (0.0, 0.0, 0.0)
        self.follow(obj, origin_mm)
        cycle = self.cycle(obj, origin_mm)
        if not jobs:
            return {}
        from CNCStepper.workbench.feeds import remarks
        from CNCStepper.workbench.making import setup_of

        setup = setup_of(jobs[0], obj, cycle)
        answer = self.cut_once(cycle, setup).answer
        self.warnings = (*answer.warnings, *remarks(setup.tool, jobs[0]))
        return answer.figures


def picked_of(obj: Any) -> tuple[str, ...]:
    """Return the names of the faces and edges of an operation's drawing that count; none: all."""
    return tuple(value_of(obj, entry_of(obj.Proxy, "picked")))


def drawn_curves(obj: Any, origin_mm: tuple[float, ...], wanted: str) -> tuple[Any, ...]:
    """Return the curves of an operation's drawing; raises CycleError where it has none, `wanted` says what to choose.

    Raises GeometryError for a drawing that cannot be followed.
    """
    from CNCStepper.workbench.curves import curves_of

    if obj.Drawing is None:
        raise CycleError("drawing-missing", f"{obj.Label} has no drawing", advice=wanted)
    return curves_of(obj.Drawing, origin_mm, float(obj.Tolerance), picked_of(obj))


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
    return [other for other in obj.InList if proxy_type(other) == JOB]


def _refuse_deleted(obj: Any) -> None:
    if obj.DeletedDrawing:
        raise CycleError(
            "drawing-deleted",
            f"the drawing '{obj.DeletedDrawing}' that it followed was deleted",
            advice="undo that, choose another drawing, or choose none",
        )


def _tool(obj: Any) -> Any:
    if proxy_type(obj.Tool) != "CNCStepper_Tool":
        raise CycleError("tool-missing", f"{obj.Label} has no tool", advice="choose one of the job's tools for it")
    return obj.Tool
