# SPDX-License-Identifier: LGPL-2.1-or-later
"""The fields that choose another object: the drawing that an operation follows, the tool that cuts it."""

from __future__ import annotations

from typing import Any

from PySide import QtGui

from CNCStepper.workbench.features.base import proxy_type
from CNCStepper.workbench.features.operation import jobs_of
from CNCStepper.workbench.panels.choices import words_of
from CNCStepper.workbench.panels.drawings import follows
from CNCStepper.workbench.panels.fields import NAME, ChoiceField
from CNCStepper.workbench.words import tr


class ToolField(ChoiceField):
    """One of the job's tools."""

    def choices(self) -> list[tuple[Any, str]]:
        """Return the tools of the job that holds the operation."""
        jobs = jobs_of(self.obj)
        return [(tool, tool_words(tool)) for tool in (jobs[0].Tools if jobs else [])]


class DrawingField(ChoiceField):
    """One of the drawings that the operation can follow, or the one that is selected."""

    def make(self) -> list[Any]:
        """Add the box and, below it, the button that takes the selection."""
        (box,) = super().make()
        self.button = QtGui.QPushButton(tr("Take selected"), self.widget)
        self.button.setObjectName(f"{NAME}_{self.entry.key}_take")
        self.button.setToolTip(tr("Follow the drawing that is selected in the tree or in the 3D view"))
        self.button.clicked.connect(lambda _: self.take())
        self._column.addWidget(self.button)
        return [box]

    def choices(self) -> list[tuple[Any, str]]:
        """Return no drawing, and all that the document has for this operation."""
        nothing = tr("none, the numbers count") if proxy_type(self.obj) == POCKET else tr("none yet")
        drawings = [other for other in self.obj.Document.Objects if follows(self.obj, other)]
        return [(None, nothing), *((drawing, drawing.Label) for drawing in drawings)]

    def take(self) -> None:
        """Choose the selected object; what is wrong with it is said as of any other."""
        import FreeCADGui

        selected = [other for other in FreeCADGui.Selection.getSelection() if other is not self.obj]
        if not selected:
            self.mark(tr("Select a drawing in the tree or in the 3D view first"))
            return
        self._offer(selected[0])
        self.editors[0].setCurrentIndex(self.values.index(selected[0]))
        self.touched()

    def write(self) -> None:
        """Show the operation's drawing, whether it can be followed or not."""
        self._offer(self.obj.Drawing)
        super().write()
        if self.obj.DeletedDrawing:
            self.editors[0].setCurrentIndex(-1)

    def differs(self, value: Any) -> bool:
        """Return whether it changes; to choose none after a deletion is a change, for it lets the numbers count."""
        return bool(self.obj.DeletedDrawing) or super().differs(value)

    def _offer(self, drawing: Any) -> None:
        if drawing not in self.values:
            self.values.append(drawing)
            self.editors[0].addItem(drawing.Label)


POCKET = "CNCStepper_EllipticalPocket"


def tool_words(tool: Any) -> str:
    """Return how a tool is listed: its number, form and diameter, and its own name where it was given one."""
    from CNCStepper.workbench.panels.measures import text_of

    diameter = next(entry for entry in tool.Proxy.PROPERTIES if entry.key == "diameter_mm")
    own = "" if tool.Label.startswith("Tool") else f" – {tool.Label}"
    return f"T{tool.Number}  {text_of(tool.Diameter.Value, diameter)}  {words_of(tool.ToolShape)}{own}"
