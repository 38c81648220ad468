# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands that make an object, and what they share: one undo step, and nothing left behind by a refusal.

Curved lines of the selected drawings are fitted beside the window before a new operation is made of them:

click ──► what of the drawings is not fitted? ── nothing ──► make it
                  ▲            │
                  └── answer ◄─┴─► the cut process (`cut_process.py`)
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import partial
from typing import Any

from CNCStepper.job import request_digest
from CNCStepper.job.deferred_fitting import Unfitted, only_looking
from CNCStepper.machine.processes import MILLING
from CNCStepper.machine.tools.tool_shapes import SHAPES, SUITED
from CNCStepper.workbench.calculation import result_cache
from CNCStepper.workbench.document import default_values, targets, undo_steps
from CNCStepper.workbench.document.selection import Pair, selected_drawings
from CNCStepper.workbench.features.cycle_operation import CycleOperation as Feature
from CNCStepper.workbench.services import missing_packages
from CNCStepper.workbench.services.command import Command
from CNCStepper.workbench.services.messages import guarded, note
from CNCStepper.workbench.services.translation import QT_TRANSLATE_NOOP, tr

WHO = object()  # one asks at a time: a newer click takes the place of the one before
_titles: list[str] = []  # of what is being made


def create(document: Any, title: str, make: Callable[[], Any]) -> None:
    """Make an object inside one transaction and open its panel, which commits or aborts it; drawing ends.

    `title` stands in the list of undo steps. When the object cannot be made, or its panel not be opened, the
    document is as it was, and the reason is shown. Object and panel come in an event each, for both take long
    together; the first is not that of the command either, at whose end FreeCAD commits what is open without a panel.
    What is asked for meanwhile, as by the second click of a double click, is not made.
    """
    from CNCStepper.workbench.services.event_steps import in_events  # needs Qt, without which the manual reads this

    if not _titles:
        _titles.append(title)
        in_events(_steps(document, title, make), lambda: None)


def _steps(document: Any, title: str, make: Callable[[], Any]) -> Iterator[None]:
    from CNCStepper.workbench import freehand
    from CNCStepper.workbench.panels import open_panel

    try:
        freehand.leave()
        undo_steps.begin(document, title)
        made = make()
        yield
        open_panel(made)
    except Exception:
        document.abortTransaction()
        raise
    finally:
        _titles.clear()


def tool_for(job: Any, cycle: str) -> Any:
    """Return the tool with which a new operation of the job begins: a selected one, the last, or a new one.

    It is of a shape that can cut the cycle. A process with a cut chart has a tool of its own, described by the chart.
    """
    from CNCStepper.workbench import api

    if job.Process != MILLING.name:
        selected = [obj for obj in targets.selected() if obj in job.Tools]
        return next(iter(selected), None) or api.chart_tool(job)
    shapes = SUITED.get(cycle, SHAPES)
    return targets.tool(job, shapes) or api.add_tool(job, shape=shapes[0], **default_values.tool(job))


def labelled(obj: Any, label: str) -> Any:
    """Return the object, named in the tree in the user's language; FreeCAD adds a number where the name is taken."""
    obj.Label = label
    return obj


class Operation(Command):
    """A command that adds an operation to a job.

    cycle: the operation's. label: how it is called in the tree, in English. no_drawing: what to select, where it
    cannot be without a drawing.
    """

    cycle = ""
    label = ""
    no_drawing = ""

    def why_not(self) -> str:
        """Return why no operation can be added."""
        lacks_drawing = tr(self.no_drawing) if self.no_drawing and targets.drawing() is None else ""
        no_job = missing_packages.why_not() or targets.why_no_panel() or targets.why_no_job()
        return no_job or targets.why_not_by_process(self.by()) or lacks_drawing

    def by(self) -> tuple[str, ...]:
        """Return the processes that cut such an operation."""
        from CNCStepper.workbench.features.catalogue import operation_class

        return operation_class(self.cycle).BY

    def run(self) -> None:
        """Add the operation and open its panel, when the lines of its drawings are fitted."""
        from CNCStepper.workbench.features.catalogue import operation_class

        job, is_drawn, kind = targets.job(), targets.drawing() is not None, operation_class(self.cycle)
        pairs = targets.drawings(kind.PICKS_LINES)
        make = partial(self.add, job, pairs, is_drawn)
        when_fitted(kind, job, pairs, partial(create, job.Document, self.text(), make))

    def add(self, job: Any, pairs: list[Any], is_drawn: bool) -> Any:
        """Return the new operation of the job, with those of the selected objects that it can follow.

        is_drawn: whether one of them must be; raises a CNCStepperError that says why none can.
        """
        from CNCStepper.workbench import api
        from CNCStepper.workbench.features.catalogue import operation_class

        found = selected_drawings(operation_class(self.cycle), pairs)
        if is_drawn:
            found.require()
        tool = self.tool(job)
        values = self.values(job, tool, bool(found.used))
        if found.used:  # some operations of a lathe have no place for any
            values = {**values, "drawings": found.used}
        operation = api.add_operation(job, self.cycle, tool=tool, **values)
        operation.Proxy.unused = found.refusals
        return labelled(operation, tr(self.label))

    def tool(self, job: Any) -> Any:
        """Return the tool with which it begins."""
        return tool_for(job, self.cycle)

    def values(self, job: Any, tool: Any, is_drawn: bool) -> dict[str, Any]:
        """Return the values with which the operation begins, by key."""
        raise NotImplementedError


class Freehand(Command):
    """Starts drawing a line in the 3D view."""

    name = "CNCStepper_Freehand"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_Freehand", "Freehand")
    tooltip = QT_TRANSLATE_NOOP("CNCStepper_Freehand", "Draws a line with the mouse: press, move, release")

    def why_not(self) -> str:
        """Return why there is nothing to draw on."""
        return missing_packages.why_not() or targets.why_no_panel() or targets.why_no_view()

    def run(self) -> None:
        """Let the mouse draw."""
        from CNCStepper.workbench import freehand

        freehand.start()


def when_fitted(kind: type[Feature], job: Any, pairs: Sequence[Pair], go_on: Callable[[], None]) -> None:
    """Call `go_on` when what an operation of a kind is to follow is fitted, which may be now.

    It is not called any more when the job or a drawing is gone by then, or another panel is open. Where the process
    could not fit something, `go_on` is called all the same.
    """
    from CNCStepper.workbench.calculation.cut_process import CutRequest, process

    parts = {} if process().unavailable else _unknown(kind, pairs)
    if not parts:
        go_on()
        return
    there = _present(job, pairs)

    def answered() -> None:
        if there() and not targets.why_no_panel():
            when_fitted(kind, job, pairs, go_on)

    process().ask(WHO, CutRequest(parts, lambda words: note(tr(words)), guarded(answered)))


def _unknown(kind: type[Feature], pairs: Sequence[Pair]) -> dict[str, dict[str, Any]]:
    """Return what the cut process is to be asked, by its keys."""
    with only_looking():
        refusals = selected_drawings(kind, pairs).refusals
    questions = [error.question for error in refusals if isinstance(error, Unfitted)]
    asked = {request_digest.key_of(question): question for question in questions}
    return {key: question for key, question in asked.items() if result_cache.may_ask(key)}


def _present(job: Any, pairs: Sequence[Pair]) -> Callable[[], bool]:
    """Return a function that tells whether the job and the drawings are still in their documents."""
    names = [(obj.Document.Name, obj.Name) for obj in (job, *(drawing for drawing, _ in pairs))]

    def there() -> bool:
        import FreeCAD

        documents = FreeCAD.listDocuments()
        return all(document in documents and documents[document].getObject(name) for document, name in names)

    return there
