# SPDX-License-Identifier: LGPL-2.1-or-later
"""How an imported drawing looks in the tree: a group whose badge says when its file has changed or is gone."""

from __future__ import annotations

from functools import partial
from typing import Any

from CNCStepper.workbench.document import drawing_files, targets
from CNCStepper.workbench.services.translation import tr
from CNCStepper.workbench.viewproviders.base import Entry, ViewProvider


class Drawing(ViewProvider):
    """The view of an imported drawing."""

    def __init__(self, view: Any):
        super().__init__(view)
        drawing_files.watch()

    def attach(self, view: Any) -> None:
        """Look at the file from now on; FreeCAD calls this when a document is opened."""
        super().attach(view)
        drawing_files.watch()

    def entries(self) -> list[Entry]:
        """Return the entries of every object, and one that reads the file again."""
        reload = partial(drawing_files.reload, self.obj)
        why_not = targets.why_no_panel()
        return [
            *super().entries(),
            Entry(tr("Reload"), "CNCStepper_ImportDrawing", reload, why_not),
            Entry(tr("Template…"), "CNCStepper_Template", self._template, why_not or targets.why_no_view()),
        ]

    def _template(self) -> None:
        import FreeCADGui

        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(self.obj)
        FreeCADGui.runCommand("CNCStepper_Template")
