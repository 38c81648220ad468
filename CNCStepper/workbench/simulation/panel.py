# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel: first the progress of the proof, then totals, player, legend, program and findings."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

from PySide import QtCore, QtGui

from CNCStepper.workbench.help import f1_key
from CNCStepper.workbench.services.findings_list import FindingsList
from CNCStepper.workbench.services.icons import icon
from CNCStepper.workbench.services.number_format import length_text, totals
from CNCStepper.workbench.services.translation import tr
from CNCStepper.workbench.services.view_colours import FEED_RGB, RAPID_RGB
from CNCStepper.workbench.simulation.player import Player
from CNCStepper.workbench.simulation.player_controls import Controls
from CNCStepper.workbench.simulation.program_list import ProgramList
from CNCStepper.workbench.simulation.view_menu import DEPTH, ISOMETRIC, XY, ZY, view_button

if TYPE_CHECKING:
    from CNCStepper.workbench.proving.proof_process import ProofResult, ProvenProgram
    from CNCStepper.workbench.services.remedy_bar import Remedy

BAR_PX = 12
GAP_PX = 4


class Legend(QtGui.QWidget):
    """A bar of colours from the deepest cut to the top, labelled in the user's units, and the two kinds of lines."""

    def __init__(self, deepest_mm: float, top_mm: float, parent: Any = None):
        super().__init__(parent)
        self.setObjectName("CNCStepper_Simulation_legend")
        self._range_mm = (deepest_mm, top_mm)
        line_px = self.fontMetrics().height()
        self.setMinimumHeight(BAR_PX + 2 * line_px + 3 * GAP_PX)
        self.setToolTip(tr("Height above the top of the stock; lines: where the tool's tip goes"))

    def paintEvent(self, event: Any) -> None:
        """Paint it; Qt calls this."""
        painter = QtGui.QPainter(self)
        self._paint_bar(painter)
        self._paint_heights(painter)
        self._paint_lines(painter)
        painter.end()

    def _paint_bar(self, painter: Any) -> None:
        from CNCStepper.simulation.views.depth_colours import MATERIAL

        gradient = QtGui.QLinearGradient(0, 0, self.width(), 0)
        for place, colour in enumerate(MATERIAL):
            gradient.setColorAt(place / (len(MATERIAL) - 1), QtGui.QColor(colour))
        painter.fillRect(0, 0, self.width(), BAR_PX, gradient)

    def _paint_heights(self, painter: Any) -> None:
        low, high = self._range_mm
        height = self.fontMetrics().height()
        for share, side in ((0.0, "AlignLeft"), (0.5, "AlignHCenter"), (1.0, "AlignRight")):
            place = QtCore.QRect(0, BAR_PX + GAP_PX, self.width(), height)
            align = getattr(QtCore.Qt.AlignmentFlag, side)
            painter.drawText(place, align, length_text(low + (high - low) * share))

    def _paint_lines(self, painter: Any) -> None:
        metrics = self.fontMetrics()
        y, x, sample = BAR_PX + 2 * GAP_PX + metrics.height(), 0, 2 * metrics.height()
        for rgb, text in ((FEED_RGB, tr("feed")), (RAPID_RGB, tr("rapid"))):
            painter.setPen(QtGui.QPen(QtGui.QColor.fromRgbF(*rgb), 2))
            middle = y + metrics.height() // 2
            painter.drawLine(x, middle, x + sample, middle)
            painter.setPen(self.palette().color(QtGui.QPalette.ColorRole.WindowText))
            painter.drawText(x + sample + GAP_PX, y + metrics.ascent(), text)
            x += sample + metrics.boundingRect(text).width() + 5 * GAP_PX


class SimulationPanel(QtGui.QWidget):
    """The widget of the task.

    again: asks for a new proof, keep: for a mesh, restart: for a restart from the moment that is shown. path_shown:
    sent with whether to show lines. view_chosen: with an entry of the view's menu.
    """

    again = QtCore.Signal()
    keep = QtCore.Signal()
    restart = QtCore.Signal()
    path_shown = QtCore.Signal(bool)
    view_chosen = QtCore.Signal(str)

    def __init__(self, label: str, parent: Any = None):
        super().__init__(parent)
        self.setObjectName("CNCStepper_Simulation_panel")
        self.setWindowTitle(tr("Check and simulate"))  # a name in the title would make the panel as wide as it is
        self.setWindowIcon(icon("CNCStepper_Simulate"))
        f1_key.attach(self, "freecad.md")
        self._layout = QtGui.QVBoxLayout(self)
        name = QtGui.QLabel(label)
        name.setObjectName("CNCStepper_Simulation_name")
        name.setWordWrap(True)
        self._message = QtGui.QLabel()
        self._message.setObjectName("CNCStepper_Simulation_message")
        self._message.setWordWrap(True)
        self._message.setTextInteractionFlags(QtCore.Qt.TextInteractionFlag.TextSelectableByMouse)
        self._busy = QtGui.QProgressBar()
        self._busy.setObjectName("CNCStepper_Simulation_busy")
        self._busy.setRange(0, 0)
        self._busy.setTextVisible(False)
        self._again = QtGui.QPushButton(tr("Simulate again"))
        self._again.setObjectName("CNCStepper_Simulation_again")
        self._again.clicked.connect(self.again)
        for widget in (name, self._message, self._busy, self._again):
            self._layout.addWidget(widget)
        self._content: Any = None
        self.program = ProgramList()
        self.findings = FindingsList()
        self.say("", busy=True)

    def say(self, text: str, *, busy: bool = False, again: bool = False) -> None:
        """Show a sentence on top, or none; `busy`: the proof runs; `again`: offer to prove anew."""
        self._message.setText(text)
        self._message.setVisible(bool(text))
        self._busy.setVisible(busy)
        self._again.setVisible(again)

    def clear(self) -> None:
        """Take away what an earlier proof has shown."""
        if self._content is not None:
            self.program, self.findings = ProgramList(), FindingsList()
            self._content.hide()
            self._content.deleteLater()
            self._content = None

    def load_result(
        self,
        result: ProofResult,
        player: Player,
        height_range_mm: tuple[float, float],
        remedies: Sequence[Remedy | None],
    ) -> Iterator[None]:
        """Show what was proven, made a few ms at a time: run it on from a timer until it ends.

        remedies: what mends each finding.
        """
        self.say("")
        self._content = QtGui.QWidget()
        layout = QtGui.QVBoxLayout(self._content)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(Controls(player))
        yield
        layout.addWidget(Legend(*height_range_mm))
        layout.addWidget(self._path_box())
        layout.addWidget(view_button(self._choose_view))
        layout.addWidget(self._keep_button())
        layout.addWidget(self._restart_button())
        layout.addLayout(totals_grid(result))
        self.findings.show(result.findings, remedies)
        yield
        self.program.show_program(result.program_lines)
        yield
        layout.addWidget(findings_box(result, self.program, self.findings), 1)
        self._layout.addWidget(self._content, 1)

    def set_keeping(self, busy: bool) -> None:
        """Show whether a mesh is being made."""
        self._keep.setEnabled(not busy)

    def _keep_button(self) -> Any:
        self._keep = QtGui.QPushButton(tr("Keep as mesh"))
        self._keep.setObjectName("CNCStepper_Simulation_keep")
        self._keep.setToolTip(tr("Add the part in its present state to the document as a mesh"))
        self._keep.clicked.connect(self.keep)
        return self._keep

    def _restart_button(self) -> Any:
        button = QtGui.QPushButton(tr("Restart from here…"))
        button.setObjectName("CNCStepper_Simulation_restart")
        button.setToolTip(tr("Restart the program at the present line; everything before it counts as cut"))
        button.clicked.connect(self.restart)
        return button

    def _path_box(self) -> Any:
        box = QtGui.QCheckBox(tr("Show the tool's path"))
        box.setObjectName("CNCStepper_Simulation_path")
        box.setChecked(True)
        box.toggled.connect(self.path_shown)
        self._path = box
        return box

    def _choose_view(self, name: str) -> None:
        """Hand on an entry of the view's menu; the depths are seen without the path."""
        if name in (ISOMETRIC, XY, ZY, DEPTH):
            self._path.setChecked(name != DEPTH)
        self.view_chosen.emit(name)


def findings_box(result: ProvenProgram, program: Any, findings: Any) -> Any:
    """Return the lists of a program and of its findings, one over the other."""
    split = QtGui.QSplitter(QtCore.Qt.Orientation.Vertical)
    split.setChildrenCollapsible(False)
    split.addWidget(_titled(tr("Program"), program))
    split.addWidget(_titled(_findings_title(result), findings))
    return split


def totals_grid(result: ProvenProgram) -> Any:
    """Return what a program comes to."""
    grid = QtGui.QGridLayout()
    for row, (name, label, text) in enumerate(totals(result.report)):
        value = QtGui.QLabel(text)
        value.setObjectName(f"CNCStepper_Simulation_total_{name}")
        value.setTextInteractionFlags(QtCore.Qt.TextInteractionFlag.TextSelectableByMouse)
        grid.addWidget(QtGui.QLabel(tr("{0}:").format(label)), row, 0)
        grid.addWidget(value, row, 1)
    grid.setColumnStretch(1, 1)
    grid.setVerticalSpacing(2)
    return grid


def _findings_title(result: ProvenProgram) -> str:
    if result.refused:
        return tr("Findings ({0}): the program must not be sent").format(len(result.findings))
    return tr("Findings ({0})").format(len(result.findings))


def _titled(title: str, widget: Any) -> Any:
    box = QtGui.QWidget()
    layout = QtGui.QVBoxLayout(box)
    layout.setContentsMargins(0, 0, 0, 0)
    head = QtGui.QLabel(title)
    head.setWordWrap(True)
    layout.addWidget(head)
    layout.addWidget(widget, 1)
    return box
