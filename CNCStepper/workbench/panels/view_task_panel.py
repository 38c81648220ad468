# SPDX-License-Identifier: LGPL-2.1-or-later
"""A task panel that only shows something: document, view and selection stay free for the person."""

from __future__ import annotations

from PySide import QtGui

from CNCStepper.errors import JobError
from CNCStepper.workbench.services.standard_buttons import PanelButtons


def require_free() -> None:
    """Raise JobError when another task stands open in the task panel."""
    import FreeCADGui

    if FreeCADGui.Control.activeDialog():
        raise JobError("task-open", "another task is open in the task panel", advice="close it first")


class ViewTask(PanelButtons):
    """A task with Close alone; `end` takes away all that it shows."""

    def end(self) -> None:
        """Take away all that is shown."""
        raise NotImplementedError

    def getStandardButtons(self) -> int:
        """Show Close alone."""
        button = QtGui.QDialogButtonBox.StandardButton.Close
        return int(getattr(button, "value", button))

    def isAllowedAlterDocument(self) -> bool:
        """Let the document be edited meanwhile."""
        return True

    def isAllowedAlterView(self) -> bool:
        """Let the view be turned."""
        return True

    def isAllowedAlterSelection(self) -> bool:
        """Let things be selected."""
        return True

    def reject(self) -> bool:
        """Close, by the button or by Esc."""
        import FreeCADGui

        self.end()
        FreeCADGui.Control.closeDialog()
        return True
