# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_Duplicate, _MoveUp and _MoveDown: copies of the selected operations, and their place in the job."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from CNCStepper.workbench.document import targets, undo_steps
from CNCStepper.workbench.document.operation_order import can_step, duplicate, is_operation, job_of, step
from CNCStepper.workbench.services.command import Command
from CNCStepper.workbench.services.translation import QT_TRANSLATE_NOOP, later, tr


def selected_operations(operation: Any) -> list[Any]:
    """Return all selected operations of a job where an operation of it is one of them, else that one alone."""
    meant = [obj for obj in targets.selected() if is_operation(obj) and job_of(obj) is job_of(operation)]
    return meant if operation in meant else [operation]


class Ordering(Command):
    """A command for the selected operations of one job."""

    def why_not(self) -> str:
        """Return why nothing can be done."""
        return self.why_not_of([obj for obj in targets.selected() if is_operation(obj)])

    def why_not_of(self, operations: Sequence[Any]) -> str:
        """Return why nothing can be done with these operations."""
        if not operations:
            return tr("Select one or more operations in the tree")
        jobs = {job_of(each) for each in operations}
        if len(jobs) > 1 or None in jobs:
            return tr("Select operations of one job")
        return targets.why_no_panel()

    def run(self) -> None:
        """Do it with the selected operations."""
        self.act([obj for obj in targets.selected() if is_operation(obj)])

    def act(self, operations: Sequence[Any]) -> None:
        """Do it with these operations, in one undo step."""
        document = operations[0].Document
        undo_steps.begin(document, self.text())
        try:
            self.change(operations)
        except Exception:
            document.abortTransaction()
            raise
        document.commitTransaction()
        document.recompute()

    def change(self, operations: Sequence[Any]) -> None:
        """Change the job; the transaction is open."""
        raise NotImplementedError


class Duplicate(Ordering):
    """Copies operations."""

    name = "CNCStepper_Duplicate"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_Duplicate", "Duplicate")
    tooltip = QT_TRANSLATE_NOOP("CNCStepper_Duplicate", "Puts a copy of each selected operation behind it in the job")

    def change(self, operations: Sequence[Any]) -> None:
        """Copy them, and select the copies."""
        import FreeCADGui

        copies = duplicate(operations)
        FreeCADGui.Selection.clearSelection()
        for copy in copies:
            FreeCADGui.Selection.addSelection(copy)


class _Step(Ordering):
    BY = 0
    AT_END = ""

    def why_not_of(self, operations: Sequence[Any]) -> str:
        """Return why they cannot be moved."""
        why_not = super().why_not_of(operations)
        return why_not or ("" if can_step(operations, self.BY) else tr(self.AT_END))

    def change(self, operations: Sequence[Any]) -> None:
        """Move them a place."""
        step(operations, self.BY)


class MoveUp(_Step):
    """Moves operations a place up."""

    name = "CNCStepper_MoveUp"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_MoveUp", "Move up")
    tooltip = QT_TRANSLATE_NOOP("CNCStepper_MoveUp", "Cuts the selected operations before the one above them")
    BY = -1
    AT_END = later("It is cut first already")


class MoveDown(_Step):
    """Moves operations a place down."""

    name = "CNCStepper_MoveDown"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_MoveDown", "Move down")
    tooltip = QT_TRANSLATE_NOOP("CNCStepper_MoveDown", "Cuts the selected operations after the one below them")
    BY = 1
    AT_END = later("It is cut last already")


COMMANDS: tuple[type[Ordering], ...] = (Duplicate, MoveUp, MoveDown)
