# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the commands share that make an object: one undo step, and nothing left behind by a refusal."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

from CNCStepper.workbench.document import targets
from CNCStepper.workbench.services import missing_packages
from CNCStepper.workbench.services.command import Command
from CNCStepper.workbench.services.translation import tr


def create(document: Any, title: str, make: Callable[[], Any]) -> None:
    """Make an object inside one transaction and open its panel, which commits or aborts it; drawing ends.

    `title` stands in the list of undo steps. When the object cannot be made, or its panel not be opened, the
    document is as it was, and the reason is raised.
    """
    from CNCStepper.workbench import freehand
    from CNCStepper.workbench.panels import open_panel

    freehand.leave()
    document.openTransaction(title)
    try:
        open_panel(make())
    except Exception:
        document.abortTransaction()
        raise


def tool_for(job: Any) -> Any:
    """Return the tool with which a new operation of the job begins: a selected one, the last, or a new one."""
    from CNCStepper.workbench import api

    return targets.tool(job) or labelled(api.add_tool(job), tr("Tool"))


def labelled(obj: Any, label: str) -> Any:
    """Return the object, named in the tree in the user's language; FreeCAD adds a number where the name is taken."""
    obj.Label = label
    return obj


def show_all() -> None:
    """Let the active 3D view show all there is: the stock of a new job is seldom where the camera looks."""
    import FreeCADGui

    FreeCADGui.SendMsgToActiveView("ViewFit")


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
        return missing_packages.why_not() or targets.why_no_panel() or targets.why_no_job() or lacks_drawing

    def run(self) -> None:
        """Add the operation and open its panel, when the lines of its drawings are fitted."""
        from CNCStepper.workbench.commands.fitted import when_fitted
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
        from CNCStepper.workbench.document.selection import selected_drawings
        from CNCStepper.workbench.features.catalogue import operation_class

        found = selected_drawings(operation_class(self.cycle), pairs)
        if is_drawn:
            found.require()
        tool = tool_for(job)
        values = self.values(job, tool, bool(found.used))
        operation = api.add_operation(job, self.cycle, tool=tool, drawings=found.used, **values)
        operation.Proxy.unused = found.refusals
        return labelled(operation, tr(self.label))

    def values(self, job: Any, tool: Any, is_drawn: bool) -> dict[str, Any]:
        """Return the values with which the operation begins, by key."""
        raise NotImplementedError
