# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the commands share that make an object: one undo step, and nothing left behind by a refusal."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from CNCStepper.workbench import missing
from CNCStepper.workbench.commands import choice
from CNCStepper.workbench.commands.base import Command
from CNCStepper.workbench.words import tr


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

    return choice.tool(job) or labelled(api.add_tool(job), tr("Tool"))


def labelled(obj: Any, label: str) -> Any:
    """Return the object, named in the tree in the user's language; FreeCAD adds a number where the name is taken."""
    obj.Label = label
    return obj


def show_all() -> None:
    """Let the active 3D view show all there is: the stock of a new job is seldom where the camera looks."""
    import FreeCADGui

    FreeCADGui.SendMsgToActiveView("ViewFit")


class Operation(Command):
    """A command that adds an operation to a job."""

    def why_not(self) -> str:
        """Return why no operation can be added."""
        return missing.why_not() or choice.why_no_panel() or choice.why_no_job()

    def run(self) -> None:
        """Add the operation and open its panel."""
        job, drawing = choice.job(), choice.drawing()
        create(job.Document, self.text(), lambda: self.add(job, drawing))

    def add(self, job: Any, drawing: Any) -> Any:
        """Return the new operation of the job, with what is drawn (None: nothing); raises a CNCStepperError."""
        raise NotImplementedError
