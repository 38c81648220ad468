# SPDX-License-Identifier: LGPL-2.1-or-later
"""How an operation looks in the tree: greyed when it is switched off."""

from __future__ import annotations

from functools import partial

from CNCStepper.workbench.document import undo_steps
from CNCStepper.workbench.services.translation import tr
from CNCStepper.workbench.viewproviders.base import Entry, ViewProvider


class Operation(ViewProvider):
    """The view of an operation."""

    BADGED_BY = ("Problem", "Active")

    def badge(self) -> str:
        """Return "Inactive" for one that is left out of the program, else what every object may say."""
        return super().badge() if self.obj.Active else "Inactive"

    def entries(self) -> list[Entry]:
        """Return the entries of every object, and one that switches it off or on."""
        text = tr("Leave out of the program") if self.obj.Active else tr("Take into the program")
        return [*super().entries(), Entry(text, "CNCStepper_Overlay_Inactive", self.switch), *self._ordering()]

    def _ordering(self) -> list[Entry]:
        """Return the entries that duplicate and move it, or all operations that are selected with it."""
        from CNCStepper.workbench.commands.reorder import COMMANDS, selected_operations

        meant = selected_operations(self.obj)
        commands = [kind() for kind in COMMANDS]
        return [Entry(each.text(), each.name, partial(each.act, meant), each.why_not_of(meant)) for each in commands]

    def switch(self) -> None:
        """Leave the operation out of the program, or take it in again."""
        document = self.obj.Document
        undo_steps.begin(document, tr("Switch {0}").format(self.obj.Label))
        self.obj.Active = not self.obj.Active
        document.commitTransaction()
        document.recompute()
