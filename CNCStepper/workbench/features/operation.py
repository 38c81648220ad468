# SPDX-License-Identifier: LGPL-2.1-or-later
"""The base of the operations of milling and sheet cutting: drawings and numbers become a cycle, cut for trial."""

from __future__ import annotations

import functools
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

from CNCStepper.errors import CycleError, Text
from CNCStepper.job.request_digest import Content
from CNCStepper.machine.processes import MILLING
from CNCStepper.workbench import packages
from CNCStepper.workbench.document.input_limits import require_within_reach
from CNCStepper.workbench.drawings.shapes import DrawingSnapshot, all_same
from CNCStepper.workbench.features.base import (
    HIDDEN,
    NUMBERS,
    POSITION,
    entry_of,
    set_value,
    show,
)
from CNCStepper.workbench.features.cycle_operation import (
    CycleOperation,
    drawings_of,
    jobs_of,
    linked_drawings,
    marked_of,
    refuse_what_it_stands_on,
    tool_of,
)
from CNCStepper.workbench.services.translation import later


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


class Operation(CycleOperation):
    """The proxy of an operation of milling or sheet cutting; one with a SHAPE follows one drawing at most."""

    BY: tuple[str, ...] = (MILLING.name,)
    WHY_FIXED = later("The drawing gives this value")
    last_cut: Any = None  # a CycleCache
    kept: CachedCycle | None = None  # until the object or what it stands on changes
    drawn: Sequence[DrawingSnapshot] = ()  # its drawings when it was made
    lines: Lines | None = None  # of its drawings when it was made
    marks: Lines | None = None  # of the drawings that are marked
    remarks: tuple[str, ...] = ()  # what there is to know of the drawings

    def add_properties(self, obj: Any) -> None:
        """Add what `obj` lacks, and let it follow the one drawing of an older document."""
        super().add_properties(obj)
        _take_over_one_drawing(obj)
        self.show_what_counts(obj)

    def follow(self, obj: Any, origin_mm: tuple[float, ...]) -> None:
        """Take those parameters from the drawing that it gives; only while `obj` itself is recomputed."""

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
        cycle_of = (tool_of(obj).Number, tuple(origin_mm))
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
        refuse_what_it_stands_on(obj)
        show(obj, self.figures(obj))

    def question(self, obj: Any) -> dict[str, Any] | None:
        """Return what the cut process is asked for its figures; None while it belongs to no job."""
        self._look_at_drawings(obj)
        refuse_what_it_stands_on(obj)
        job, cycle = self._followed(obj)
        if job is None:
            return None
        from CNCStepper.workbench.document.core_job import cut_question

        return cut_question(job, obj, cycle)

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
