# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of a job of milling or sheet cutting: its stock, process and clamps besides what every job has."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

from PySide import QtGui

from CNCStepper.workbench.document.default_values import stock_of_drawing, stock_of_solid, untyped_feeds
from CNCStepper.workbench.document.preferred_values import thickness_mm
from CNCStepper.workbench.document.stock_of_job import CYLINDER
from CNCStepper.workbench.drawings.shapes import box_round, placed_shape, round_box
from CNCStepper.workbench.features.base import edit
from CNCStepper.workbench.features.cut_values import CHART
from CNCStepper.workbench.features.cycle_operation import linked_drawings
from CNCStepper.workbench.features.job import HEIGHTS
from CNCStepper.workbench.features.program_job import MACHINE, PROGRAM, STOCK
from CNCStepper.workbench.features.tool import FORM, LIMITS
from CNCStepper.workbench.panels.axis_calculator import AxisSheet
from CNCStepper.workbench.panels.fields import NAME, ChoiceField, VectorField
from CNCStepper.workbench.panels.form import MARGINS, Box
from CNCStepper.workbench.panels.job_lists import ClampList, ObjectList
from CNCStepper.workbench.panels.object_form import Editor
from CNCStepper.workbench.panels.process_fields import PROCESS_KINDS, ChartNote, MachineField, tool_hidden
from CNCStepper.workbench.panels.program_job_panel import ProgramJobPanel
from CNCStepper.workbench.panels.tools.tip_angle_field import TipAngleField
from CNCStepper.workbench.panels.tools.tool_field import ShapeField
from CNCStepper.workbench.services.choice_labels import words_of
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.translation import later, tr
from CNCStepper.workbench.templates.job_template import JobBeginning, choices

FOLDED = (PROGRAM, HEIGHTS)
HIDDEN = ("operations", "tools", "clamps")
CLAMPS = later("Clamps")
AXIS = later("Axis arithmetic")


class DialectField(ChoiceField):
    """The machine's own dialect, or another one that we write."""

    def choices(self) -> list[tuple[Any, str]]:
        """Return the machine's own and the dialects that programs are written in."""
        from CNCStepper.gcode.dialects import dialect, dialect_names

        names = [name for name in dialect_names() if dialect(name).writing is not None]
        return [("", words_of("")), *((name, dialect(name).title) for name in names)]


class StockSizeField(VectorField):
    """The width along Y is not asked of a cylinder; it is kept for the next box."""

    def refresh(self) -> None:
        """Show what the form that is chosen needs."""
        round_one = self.obj.StockForm == CYLINDER
        self.editors[1].setVisible(not round_one)
        self.label.setText(tr("Diameter and height") if round_one else tr(self.entry.label))
        super().refresh()


TOOL_KINDS = {"shape": ShapeField, "tip_angle_deg": TipAngleField}
KINDS = {
    **PROCESS_KINDS,
    "machine": MachineField,
    "dialect": DialectField,
    "stock_size_mm": StockSizeField,
}


class JobPanel(ProgramJobPanel):
    """The panel of a job of milling or sheet cutting."""

    def __init__(self, job: Any):
        self.process = job.Process  # for which the tool's editor was made
        self.material = job.Material  # for which the tools have their feeds
        super().__init__(job, KINDS, FOLDED, HIDDEN)
        if (around := job.Proxy.take_around()) is not None:
            self.offer_beginnings(JobBeginning(job, around), choices())

    def add_own_parts(self) -> None:
        """Add the button that fits the stock, the chart's note and the sheet of the axes."""
        self._add_stock_button()
        self.chart_note = ChartNote(self.job, self.editor)
        self.editor.form.add_widget(CHART, self.chart_note)
        self.editor.applied.connect(guarded(self.follow_process))
        self._add_axis_sheet()

    def own_lists(self) -> tuple[ObjectList, ...]:
        """Return the list of the clamps."""
        self.clamps = ClampList(self.job, self.editor)
        self.editor.form.box(CLAMPS, folded=not self.job.Clamps)
        self.editor.form.add_widget(CLAMPS, self.clamps)
        return (self.clamps,)

    def tool_form(self, tool: Any) -> Editor:
        """Return the editor of a tool, with the forms that the process has."""
        return Editor(tool, TOOL_KINDS, (FORM, LIMITS), tool_hidden(self.job), self.tools)

    def follow_process(self) -> None:
        """Show what the chart says, and the marked tool anew where the process was changed."""
        self.chart_note.refresh()
        if self.job.Material != self.material:
            self.material = self.job.Material
            self.give_feeds()
        if self.job.Process != self.process:
            self.process = self.job.Process
            self.tools.refresh()
            self.drop_tool()
            self.show_tool()

    def has_begun(self) -> None:
        """Note the material and process for which the tools have come."""
        self.material, self.process = self.job.Material, self.job.Process

    def give_feeds(self) -> None:
        """Let the material's feeds count for all tools whose own nobody has typed."""
        changes = {tool: untyped_feeds(tool, self.job) for tool in self.job.Tools}
        for tool, values in changes.items():
            if values:
                edit(tool, **values)
        if any(changes.values()):
            self.remake()
            for editor in self.editors[1:]:
                editor.remake()

    def fit_stock(self) -> None:
        """Put the stock around what is selected, or around all drawings of the operations."""
        import FreeCADGui

        drawn = [drawing for operation in self.job.Operations for drawing in linked_drawings(operation)]
        shapes = [placed_shape(obj) for obj in FreeCADGui.Selection.getSelection() or drawn]
        shapes = [shape for shape in shapes if not shape.isNull() and shape.BoundBox.isValid()]
        if not shapes:
            self.editor.form.mark("stock_size_mm", tr("Select a drawing or a solid first"))
            return
        around = round_box(shapes) if self.job.StockForm == CYLINDER else box_round(shapes)
        solid = any(shape.Solids for shape in shapes)
        self.editor.take(stock_of_solid(around) if solid else stock_of_drawing(around, thickness_mm()))

    def _add_stock_button(self) -> None:
        button = QtGui.QPushButton(tr("Fit to drawing"), self.editor)
        button.setObjectName(f"{NAME}_stock_fit")
        button.setToolTip(tr("Put the stock around the selection, or around the drawings of the operations"))
        button.setAutoDefault(False)
        button.clicked.connect(guarded(self.fit_stock))
        self.editor.form.add_widget(STOCK, button)

    def _add_axis_sheet(self) -> None:
        box = Box(tr(AXIS), "axis", True, self.editor)
        box.fill_when_opened(guarded(lambda: self._fill_axis_sheet(box)))
        self.editor.form.add_widget(MACHINE, box)

    def _fill_axis_sheet(self, box: Box) -> None:
        axis = AxisSheet(self.job, box.body)
        column = QtGui.QVBoxLayout(box.body)
        column.setContentsMargins(*MARGINS)
        column.addWidget(axis)
        for before, after in pairwise((box.head, *axis.boxes.values(), *axis.lines.values())):
            QtGui.QWidget.setTabOrder(before, after)  # Qt puts what is made later behind all of the window
        self.editor.applied.connect(guarded(axis.follow))
