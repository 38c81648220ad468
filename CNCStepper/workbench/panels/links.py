# SPDX-License-Identifier: LGPL-2.1-or-later
"""The fields that choose another object: the drawing that an operation follows, the tool that cuts it."""

from __future__ import annotations

from typing import Any

from PySide import QtGui

from CNCStepper.workbench.commands.choice import picked
from CNCStepper.workbench.features.base import value_of
from CNCStepper.workbench.features.operation import jobs_of
from CNCStepper.workbench.panels.choices import words_of
from CNCStepper.workbench.panels.drawings import follows
from CNCStepper.workbench.panels.fields import NAME, ChoiceField, Field
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
        drawings = [other for other in self.obj.Document.Objects if follows(self.obj, other)]
        return [(None, tr(self.obj.Proxy.NO_DRAWING)), *((drawing, drawing.Label) for drawing in drawings)]

    def touched(self) -> None:
        """Note the choice: of another drawing all counts."""
        self.pick(())

    def pick(self, names: tuple[str, ...]) -> None:
        """Note the choice, and which faces and edges of the drawing count."""
        self.parent().fields["picked"].take(names)
        super().touched()

    def take(self) -> None:
        """Choose the selected object, or its selected faces and edges; what is wrong is said as of any other."""
        import FreeCADGui

        selected = [other for other in FreeCADGui.Selection.getSelection() if other is not self.obj]
        if not selected:
            self.mark(tr("Select a drawing in the tree or in the 3D view first"))
            return
        self._offer(selected[0])
        self.editors[0].setCurrentIndex(self.values.index(selected[0]))
        self.pick(picked(selected[0], self.obj.Proxy.PICKS_LINES))

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


class PickedField(Field):
    """The faces and edges of the drawing that count; not seen where all of it does."""

    def make(self) -> list[Any]:
        """Add the label that names them."""
        self.names: tuple[str, ...] = ()
        names = self.add(QtGui.QLabel(self.widget))
        names.setWordWrap(True)
        return [names]

    def take(self, names: tuple[str, ...]) -> None:
        """Let these count."""
        self.names = names
        self.edited = True

    def read(self) -> tuple[str, ...]:
        """Return their names."""
        return self.names

    def write(self) -> None:
        """Show their names."""
        self.names = value_of(self.obj, self.entry)
        self.editors[0].setText(", ".join(self.names))

    def counts(self) -> bool:
        """Return whether there are some."""
        return super().counts() and bool(value_of(self.obj, self.entry))


def tool_words(tool: Any) -> str:
    """Return how a tool is listed: its number, form and diameter, and its own name where it was given one."""
    from CNCStepper.workbench.panels.measures import text_of

    diameter = next(entry for entry in tool.Proxy.PROPERTIES if entry.key == "diameter_mm")
    own = "" if tool.Label.startswith("Tool") else f" – {tool.Label}"
    return f"T{tool.Number}  {text_of(tool.Diameter.Value, diameter)}  {words_of(tool.ToolShape)}{own}"
