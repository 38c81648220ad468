# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of a freehand line: while it is open the line's points are handles in the 3D view."""

from __future__ import annotations

from typing import Any

from CNCStepper.workbench import freehand
from CNCStepper.workbench.document.targets import why_no_view
from CNCStepper.workbench.panels.object_form import Editor
from CNCStepper.workbench.panels.task_panel import Panel


class FreehandPanel(Panel):
    """Edits a line by its values and by its points; both belong to the panel's one undo step."""

    def __init__(self, obj: Any, editor: Editor):
        super().__init__(obj, editor)
        if not why_no_view():
            freehand.edit(obj, changed=editor.apply)

    def accept(self) -> bool:
        """Put the handles away when the panel closes."""
        closed = bool(super().accept())
        if closed:
            freehand.leave()
        return closed

    def reject(self) -> bool:
        """Put the handles away first: the line goes back to what it was."""
        freehand.leave()
        return bool(super().reject())
