# SPDX-License-Identifier: LGPL-2.1-or-later
"""The base of all operations: a tool, a cycle made from their properties, and a job that cuts them in order."""

from __future__ import annotations

import functools
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

from CNCStepper.errors import CNCStepperError, CycleError, Text
from CNCStepper.job.request_digest import Content
from CNCStepper.machine.processes import MILLING
from CNCStepper.workbench import packages
from CNCStepper.workbench.document.input_limits import require_within_reach
from CNCStepper.workbench.drawings.shapes import DrawingSnapshot, all_same, containers_of, edges_of, require_closed
from CNCStepper.workbench.features.base import (
    BOOL,
    CONTAINERS,
    DRAWINGS,
    HIDDEN,
    JOB,
    LINK,
    NUMBERS,
    POSITION,
    PROBLEM,
    TEXT,
    Feature,
    Property,
    drawing_pairs,
    entry_of,
    proxy_type,
    require_parts,
    set_value,
    show,
    values,
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


@dataclass(frozen=True)
class CachedCycle:
    """The cycle that an operation was made into with that tool's number, work zero and process, and the remarks on it.

    measures: those of the operation's values by key that stock and machine limit.
    """

    made_with: tuple[Any, ...]
    cycle: Any
    remarks: tuple[str, ...]
    measures: dict[str, Any]

    @functools.cached_property
    def content(self) -> Content:
        """The cycle as plain data."""
        return Content(self.cycle.model_dump(mode="json"))

    @functools.cached_property
    def most(self) -> dict[str, float]:
        """The largest of the measures of each kind that is limited."""
        from CNCStepper.job.input_limits import largest

        return largest(self.measures)


@dataclass(frozen=True)
class Lines:
    """The curves of an operation's drawings, and of what they were made."""

    made_of: tuple[Any, ...]
    drawings: Sequence[DrawingSnapshot]
    curves: list[Any]
    remarks: tuple[str, ...]

    @functools.cached_property
    def nested(self) -> tuple[tuple[Any, ...], tuple[Any, ...]]:
        """The closed curves as outlines and islands; raises GeometryError for an open one or two that cross."""
        from CNCStepper.workbench.drawings.islands import nested

        return nested(self.curves)


class Operation(Feature):
    """The proxy of an operation: its properties are its cycle's parameters, under the same keys.

    TABLES: keys of tables within the cycle's own; "tabs_count" is then "count" in the table "tabs". OWN: keys that
    are none of the cycle's. SHAPE: keys whose values the drawing gives, where there is one, of which it follows no
    more. CLOSED: whether all lines must close. PICKS_LINES: whether a click on a single line of a drawing means that
    line alone. NO_DRAWING: what it is to have no drawing. BY: the processes that cut it.
    """

    CYCLE = ""
    TABLES: tuple[str, ...] = ()
    OWN: tuple[str, ...] = ()
    SHAPE: tuple[str, ...] = ()
    CLOSED = False
    PICKS_LINES = False
    NO_DRAWING = later("none yet")
    BY: tuple[str, ...] = (MILLING.name,)
    WHY_FIXED = later("The drawing gives this value")
    removed_label = ""
    last_cut: Any = None  # a CycleCache
    kept: CachedCycle | None = None  # until the object or what it stands on changes
    drawn: Sequence[DrawingSnapshot] = ()  # its drawings when it was made
    lines: Lines | None = None  # of its drawings when it was made
    marks: Lines | None = None  # of the drawings that are marked
    warnings: tuple[str, ...] = ()  # what the last cut says that a person should know
    remarks: tuple[str, ...] = ()  # what there is to know of the drawings
    unused: tuple[CNCStepperError, ...] = ()  # why what was selected with the drawings is none of them

    def add_properties(self, obj: Any) -> None:
        """Add what `obj` lacks, and let only those be typed that count."""
        super().add_properties(obj)
        _take_over_one_drawing(obj)
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

    def follow(self, obj: Any, origin_mm: tuple[float, ...]) -> None:
        """Take those parameters from the drawing that it gives; only while `obj` itself is recomputed."""

    def given(self, found: dict[str, Any]) -> dict[str, Any]:
        """Return the parameters of the cycle among an object's values: those that count, in the cycle's tables."""
        entries = [entry for entry in self.PROPERTIES if entry.key in found and entry.key not in (*LINKS, *self.OWN)]
        return in_tables({entry.key: found[entry.key] for entry in entries if self.counts(entry, found)}, self.TABLES)

    def counts(self, entry: Property, found: dict[str, Any]) -> bool:
        """Return whether a property counts with an object's other values, by key."""
        if not entry.only:
            return True
        chooser, choices = entry.only
        return found.get(chooser) in choices and self.counts(entry_of(self, chooser), found)

    def show_what_counts(self, obj: Any) -> None:
        """Hide the properties that do not count, and let only those be typed that no drawing gives."""
        found = self.known(obj)
        for entry in self.PROPERTIES:
            if entry.only or entry.key in self.SHAPE:
                is_drawn = entry.key in self.SHAPE and bool(drawings_of(obj))
                obj.setEditorMode(entry.name, int(is_drawn) if self.counts(entry, found) else HIDDEN)

    def cycle_values(self, obj: Any, origin_mm: tuple[float, ...]) -> dict[str, Any]:
        """Return the cycle's parameters; `origin_mm` is where the work zero lies in the document."""
        return self.given(self.known(obj))

    def known(self, obj: Any) -> dict[str, Any]:
        """Return the object's values by key, and what else decides which of them count."""
        return values(obj)

    def process(self, obj: Any) -> str:
        """Return the process of its job where values count by it; "" where they do not, or there is no job."""
        return ""

    def cycle(self, obj: Any, origin_mm: tuple[float, ...]) -> Any:
        """Return the checked cycle of `obj` in work coordinates; raises CycleError, GeometryError or JobError."""
        return self._keep(obj, origin_mm).cycle

    def content(self, obj: Any, origin_mm: tuple[float, ...]) -> Content:
        """Return the cycle of `obj` as plain data; raises what `cycle` raises."""
        return self._keep(obj, origin_mm).content

    def _keep(self, obj: Any, origin_mm: tuple[float, ...]) -> CachedCycle:
        """Return what the object was made into, made anew where anything has changed: its job asks after each edit."""
        packages.require()
        cycle_of = (_tool(obj).Number, tuple(origin_mm))
        made_with = (*cycle_of, self.process(obj))
        if self.kept is None or self.kept.made_with != made_with:
            self.remarks = ()
            self.kept = CachedCycle(made_with, self._checked(obj, *cycle_of), self.remarks, self._measures(obj))
        self.remarks = self.kept.remarks
        return self.kept

    def _look_at_drawings(self, obj: Any) -> None:
        """Keep the cycle only where the drawings are as they were when it was made."""
        drawn = [DrawingSnapshot.of(drawing) for drawing in linked_drawings(obj)]
        if not all_same(drawn, self.drawn):
            self.kept = None
        self.drawn = drawn

    def _measures(self, obj: Any) -> dict[str, Any]:
        found = self.known(obj)
        measured = [entry for entry in self.PROPERTIES if entry.type in (*NUMBERS, POSITION) and entry.key in found]
        return {entry.key: found[entry.key] for entry in measured if self.counts(entry, found)}

    def _checked(self, obj: Any, tool: int, origin_mm: tuple[float, ...]) -> Any:
        from CNCStepper.cycles.catalogue import cycle_class
        from CNCStepper.machine.profile import validated

        content = {"cycle": self.CYCLE, "tool": tool, **self.cycle_values(obj, origin_mm)}
        return validated(cycle_class(self.CYCLE), content, obj.Label)

    def cut_once(self, cycle: Any, setup: Any) -> Any:
        """Return the cycle with its cut, cached for equal requests; raises CycleError."""
        from CNCStepper.job.cycle_cache import CycleCache

        if self.last_cut is None or not self.last_cut.fits(cycle, setup):
            self.last_cut = CycleCache(cycle, setup)
        return self.last_cut

    def make(self, obj: Any) -> None:
        """Cut it for trial, as its job would, and show the figures."""
        self.warnings = ()
        self._look_at_drawings(obj)
        _refuse_what_it_stands_on(obj)
        show(obj, self.figures(obj))

    def question(self, obj: Any) -> dict[str, Any] | None:
        """Return what the cut process is asked for its figures; None while it belongs to no job."""
        self._look_at_drawings(obj)
        _refuse_what_it_stands_on(obj)
        job, cycle = self._followed(obj)
        if job is None:
            return None
        from CNCStepper.workbench.document.core_job import cut_question

        return cut_question(job, obj, cycle)

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

    def figures(self, obj: Any) -> dict[str, float]:
        """Return what the cycle reports (recalculated ae and ap, passes); nothing while it belongs to no job."""
        job, cycle = self._followed(obj)
        if job is None:
            return {}
        from CNCStepper.workbench.document.core_job import setup_of
        from CNCStepper.workbench.document.cut_chart_of_job import fed
        from CNCStepper.workbench.document.machine_of_job import remarks
        from CNCStepper.workbench.features.tool import model_of

        answer = self._known(job, obj, cycle) or self.cut_once(cycle, setup_of(job, obj, cycle)).answer
        self.warnings = (*self.remarks, *answer.warnings, *remarks(fed(model_of(obj.Tool), job), job))
        return dict(answer.figures)

    def _followed(self, obj: Any) -> tuple[Any, Any]:
        """Return the job of `obj`, None where it has none, and the cycle, whose shape follows the drawing."""
        jobs = jobs_of(obj)
        origin_mm = tuple(jobs[0].WorkOrigin) if jobs else (0.0, 0.0, 0.0)
        if jobs:
            self.require_process(obj, jobs[0])
        self.follow(obj, origin_mm)
        job, kept = (jobs[0] if jobs else None), self._keep(obj, origin_mm)
        require_within_reach(job, kept.measures, kept.most)
        return job, kept.cycle

    def require_process(self, obj: Any, job: Any) -> None:
        """Raise CycleError where the process of its job does not cut such an operation."""
        if job.Process not in self.BY:
            raise CycleError(
                "operation-process",
                Text("{obj} is not cut by {process}", obj=obj.Label, process=job.Process),
                limit=", ".join(self.BY),
                advice="choose another process in the job, or delete the operation",
            )

    def _known(self, job: Any, obj: Any, cycle: Any) -> Any:
        """Return what the cut process has answered about this cut, None where it was not asked."""
        from CNCStepper.workbench.calculation import result_cache
        from CNCStepper.workbench.document.core_job import cut_question

        return result_cache.answer_to(cut_question(job, obj, cycle)) if result_cache.any_known() else None


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


def the_drawing(obj: Any) -> tuple[Any, tuple[str, ...]] | None:
    """Return the one drawing that gives an operation's shape, None for numbers; raises CycleError for several."""
    pairs = drawings_of(obj)
    if len(pairs) > 1:
        raise CycleError(
            "drawings-several",
            Text("{obj} follows one drawing", obj=obj.Label),
            value=", ".join(drawing.Label for drawing, _ in pairs),
            advice="choose one of them, or cut them all with a pocket",
        )
    return pairs[0] if pairs else None


def drawn_lines(obj: Any, origin_mm: tuple[float, ...], wanted: str) -> Lines:
    """Return the curves of an operation's drawings from the work zero; its proxy collects remarks on them.

    Raises CycleError where it has none, `wanted` says what to choose; GeometryError for what cannot be followed.
    """
    pairs = drawings_of(obj)
    if not pairs:
        raise CycleError("drawing-missing", Text("{obj} has no drawing", obj=obj.Label), advice=wanted)
    obj.Proxy.lines = _lines(obj.Proxy.lines, pairs, float(obj.Tolerance), origin_mm)
    obj.Proxy.remarks = obj.Proxy.lines.remarks
    return obj.Proxy.lines  # type: ignore[no-any-return]


def marked_lines(obj: Any, origin_mm: tuple[float, ...]) -> Lines:
    """Return the curves that an operation marks, from the work zero; its proxy collects remarks on them too.

    Raises GeometryError for what cannot be followed.
    """
    obj.Proxy.marks = _lines(obj.Proxy.marks, marked_of(obj), float(obj.Tolerance), origin_mm)
    obj.Proxy.remarks += obj.Proxy.marks.remarks
    return obj.Proxy.marks  # type: ignore[no-any-return]


def _lines(kept: Lines | None, pairs: Any, tolerance_mm: float, origin_mm: tuple[float, ...]) -> Lines:
    """Return the curves of drawings; those kept, where drawings and zero are as they were."""
    from CNCStepper.workbench.drawings.joined_curves import drawn_of

    made_of = (pairs, tolerance_mm, tuple(origin_mm))
    seen = [DrawingSnapshot.of(drawing) for drawing, _ in pairs]
    if kept is not None and kept.made_of == made_of and all_same(seen, kept.drawings):
        return kept
    x_mm, y_mm, _ = origin_mm
    drawn = drawn_of(pairs, tolerance_mm)
    curves = [replace(each, curve=each.curve.moved(-x_mm, -y_mm)) for each in drawn.curves]
    return Lines(made_of, seen, curves, tuple(drawn.remarks()))


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


def _take_over_one_drawing(obj: Any) -> None:
    """Let an operation of a document from before there could be several drawings follow its one."""
    if "Drawing" not in obj.PropertiesList:
        return
    deleted = obj.DeletedDrawing
    if obj.Drawing is not None:
        picked = obj.Picked[1] if "Picked" in obj.PropertiesList and obj.Picked else ()
        set_value(obj, entry_of(obj.Proxy, "drawings"), [(obj.Drawing, tuple(picked))])
    obj.DeletedDrawing = deleted
    for name in {"Drawing", "Picked"} & set(obj.PropertiesList):
        obj.removeProperty(name)


def _refuse_what_it_stands_on(obj: Any) -> None:
    """Raise CycleError for a drawing that was deleted, JobError for a tool or a drawing with a problem."""
    if obj.DeletedDrawing:
        raise CycleError(
            "drawing-deleted",
            Text("the drawing '{deleted_drawing}' that it followed was deleted", deleted_drawing=obj.DeletedDrawing),
            advice="undo that, choose another drawing, or choose none",
        )
    parts = (obj.Tool, *linked_drawings(obj))
    require_parts(part for part in parts if part is not None)


def _tool(obj: Any) -> Any:
    if proxy_type(obj.Tool) != "CNCStepper_Tool":
        raise CycleError(
            "tool-missing", Text("{obj} has no tool", obj=obj.Label), advice="choose one of the job's tools for it"
        )
    return obj.Tool
