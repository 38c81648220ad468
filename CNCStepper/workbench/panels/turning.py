# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panels of the lathe: its job, tools, profiles, and operations with a picture of what their values mean."""

from __future__ import annotations

from typing import Any

from PySide import QtGui

from CNCStepper.cycles.parameter import PATH
from CNCStepper.workbench import packages
from CNCStepper.workbench.features.base import proxy_type, value_of
from CNCStepper.workbench.features.program_job import PROGRAM
from CNCStepper.workbench.features.turning.lathe_job import CHUCK, START, TAILSTOCK, LatheJob
from CNCStepper.workbench.features.turning.turning_profile import TurningProfile
from CNCStepper.workbench.features.turning.turning_tool import LIMITS, TurningTool
from CNCStepper.workbench.panels.drawing_fields import DrawingField
from CNCStepper.workbench.panels.fields import NAME, ChoiceField, Field
from CNCStepper.workbench.panels.job import DialectField
from CNCStepper.workbench.panels.number_input import Refused
from CNCStepper.workbench.panels.object_form import Editor
from CNCStepper.workbench.panels.process_fields import MachineField
from CNCStepper.workbench.panels.program_job_panel import ProgramJobPanel
from CNCStepper.workbench.panels.task_panel import Panel
from CNCStepper.workbench.panels.tools.tool_field import ToolField
from CNCStepper.workbench.services.choice_labels import words_of
from CNCStepper.workbench.services.icons import picture_painter
from CNCStepper.workbench.services.translation import later, tr
from CNCStepper.workbench.templates.turning_template import TurningBeginning, choices

PICTURES = packages.ROOT / "resources" / "pictures" / "turning"
LEAST_PX, MOST_PX = (100, 50), 360
ROWS = 8  # of a profile that are seen at once
FOLDED = (PROGRAM, CHUCK, TAILSTOCK, START)
HIDDEN = ("operations", "tools", "process")


def turning_panel(obj: Any) -> Panel:
    """Return a new panel that edits one of the lathe's objects."""
    name = proxy_type(obj)
    if name == LatheJob.Type:
        return LatheJobPanel(obj)
    if name == TurningTool.Type:
        return Panel(obj, Editor(obj, {}, (LIMITS,)))
    if name == TurningProfile.Type:
        return Panel(obj, Editor(obj, {"points": RowsField}))
    return OperationPanel(obj)


class LatheMachineField(MachineField):
    """A lathe that ships with us, or a profile's file."""

    def shipped(self) -> list[tuple[Any, str]]:
        """Return the profiles that are a lathe's."""
        return [(name, words) for name, words in super().shipped() if _is_lathe(name)]


def _is_lathe(name: str) -> bool:
    """Return whether a profile is that of a machine with X and Z alone; one that cannot be read is none."""
    from CNCStepper.errors import JobError
    from CNCStepper.machine.profile import load_machine

    try:
        return set(load_machine(name).own_axes) == {"x", "z"}
    except JobError:
        return False


class TurnedMaterialField(ChoiceField):
    """One of the materials whose forces are known, or none."""

    def choices(self) -> list[tuple[Any, str]]:
        """Return none, and the materials of turning."""
        from CNCStepper.machine.materials import turned_materials

        return [("", words_of("none")), *((name, words_of(name)) for name in turned_materials())]


class LatheJobPanel(ProgramJobPanel):
    """The panel of a lathe's job."""

    def __init__(self, job: Any):
        kinds = {"machine": LatheMachineField, "dialect": DialectField, "material": TurnedMaterialField}
        super().__init__(job, kinds, FOLDED, HIDDEN)
        if job.Proxy.take_around() is not None:
            self.offer_beginnings(TurningBeginning(job), choices())

    def tool_form(self, tool: Any) -> Editor:
        """Return the editor of a tool."""
        return Editor(tool, {}, (LIMITS,), (), self.tools)


class OperationPanel(Panel):
    """The panel of an operation, its picture on top."""

    def __init__(self, operation: Any):
        editor = Editor(operation, {"tool": ToolField, "drawings": DrawingField}, (PATH,))
        super().__init__(operation, editor)
        editor.layout().insertWidget(0, CyclePicture(operation.Proxy.CYCLE, editor))


class CyclePicture(QtGui.QWidget):
    """The picture of a turning cycle, as wide as the panel."""

    def __init__(self, cycle: str, parent: Any):
        super().__init__(parent)
        self.setObjectName(f"{NAME}_picture")
        self._paint = picture_painter(PICTURES / f"{cycle}.svg")
        self.setMinimumSize(*LEAST_PX)

    def resizeEvent(self, event: Any) -> None:
        """Be half as high as wide, as the pictures are."""
        self.setFixedHeight(min(self.width(), MOST_PX) // 2)

    def paintEvent(self, event: Any) -> None:
        """Draw the picture in the middle; Qt calls this."""
        painter = QtGui.QPainter(self)
        self._paint(painter, self.rect())
        painter.end()


class RowsField(Field):
    """The rows of a profile, one a line."""

    def make(self) -> list[Any]:
        """Add the lines to type into."""
        lines = self.add(QtGui.QPlainTextEdit(self.widget))
        lines.setFixedHeight(ROWS * lines.fontMetrics().lineSpacing() + 2 * lines.frameWidth() + 8)
        lines.setTabChangesFocus(True)
        lines.setPlaceholderText(tr("X; Z; chamfer 1 – one point a line"))
        lines.textChanged.connect(self._typed)
        return [lines]

    def _typed(self) -> None:
        if self.has_focus():
            self.touched()

    def read(self) -> tuple[str, ...]:
        """Return the rows; raises Refused for fewer than two, or one that is none."""
        from CNCStepper.errors import JobError
        from CNCStepper.job.turning.profile_rows import content_of_lines
        from CNCStepper.workbench.services.message_translation import translated

        rows = tuple(row.strip() for row in self.editors[0].toPlainText().splitlines() if row.strip())
        if len(rows) < 2:
            raise Refused(later("A profile needs two points or more"))
        try:
            content_of_lines(rows)
        except JobError as error:
            raise Refused("{0}", translated(error.sentence)) from error
        return rows

    def differs(self, value: Any) -> bool:
        """Return whether the rows are others than the object's."""
        return tuple(value) != tuple(value_of(self.obj, self.entry))

    def write(self) -> None:
        """Show the object's rows."""
        self.editors[0].setPlainText("\n".join(value_of(self.obj, self.entry)))
