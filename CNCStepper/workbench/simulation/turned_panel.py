# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of a lathe's simulation: player, how the part is cut open, its diameter at a Z, the tools' colours."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from PySide import QtCore, QtGui

from CNCStepper.workbench.services.number_format import length_text
from CNCStepper.workbench.services.translation import later, tr
from CNCStepper.workbench.simulation.panel import SimulationPanel, findings_box, totals_grid
from CNCStepper.workbench.simulation.player import Player
from CNCStepper.workbench.simulation.player_controls import TURNED_STEPS, Controls
from CNCStepper.workbench.simulation.turned_scene import RAW_RGB, tool_rgb

if TYPE_CHECKING:
    from CNCStepper.workbench.proving.proof_process import TurnedResult

OPENINGS = ((90.0, later("Three quarters")), (180.0, later("Half")), (0.0, later("Whole part")))
FAR_MM = 10_000.0
SAMPLE_PX = 12


class TurnedPanel(SimulationPanel):
    """The widget of the task. opened: sent with the angle by which the part is to be cut open. z_chosen: with a Z."""

    opened = QtCore.Signal(float)
    z_chosen = QtCore.Signal(float)

    def load_turned(self, result: TurnedResult, player: Player, tools: dict[int, str]) -> Iterator[None]:
        """Show what was proven, made a few ms at a time; tools: the name of each by number."""
        self.say("")
        self._content = QtGui.QWidget()
        layout = QtGui.QVBoxLayout(self._content)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(Controls(player, steps=TURNED_STEPS))
        yield
        layout.addLayout(self._view_choices())
        layout.addLayout(self._reading_rows())
        layout.addWidget(_legend(tools))
        layout.addWidget(self._keep_button())
        layout.addLayout(totals_grid(result))
        yield
        self.findings.show(result.findings)
        self.program.show_program(result.program_lines)
        yield
        layout.addWidget(findings_box(result, self.program, self.findings), 1)
        self._layout.addWidget(self._content, 1)

    def show_z(self, z_mm: float) -> None:
        """Show a Z that was chosen elsewhere, without sending it."""
        self._z.blockSignals(True)
        self._z.setValue(z_mm)
        self._z.blockSignals(False)

    def show_reading(self, diameter_mm: float | None, bore_mm: float | None) -> None:
        """Show diameter and bore at the chosen Z."""
        if diameter_mm is None:
            text = tr("click on the part, or type a Z")
        elif not diameter_mm:
            text = tr("no material there")
        elif bore_mm:
            text = tr("⌀ {0}, bore ⌀ {1}").format(length_text(diameter_mm), length_text(bore_mm))
        else:
            text = tr("⌀ {0}").format(length_text(diameter_mm))
        self._reading.setText(text)

    def _view_choices(self) -> Any:
        column = QtGui.QVBoxLayout()
        box = QtGui.QComboBox()
        box.setObjectName("CNCStepper_Simulation_opening")
        box.setToolTip(tr("How much of the part is shown"))
        box.setAccessibleName(tr("How much of the part is shown"))
        for angle_deg, text in OPENINGS:
            box.addItem(tr(text), angle_deg)
        box.currentIndexChanged.connect(lambda place: self.opened.emit(OPENINGS[place][0]))
        column.addWidget(box)
        column.addWidget(self._path_box())
        return column

    def _reading_rows(self) -> Any:
        column, row = QtGui.QVBoxLayout(), QtGui.QHBoxLayout()
        self._z = QtGui.QDoubleSpinBox()
        self._z.setObjectName("CNCStepper_Simulation_z")
        self._z.setRange(-FAR_MM, FAR_MM)
        self._z.setMinimumWidth(1)  # else it is as wide as the farthest Z
        self._z.setDecimals(3)
        self._z.setSuffix(" mm")
        self._z.setKeyboardTracking(False)
        self._z.setToolTip(tr("Where along the axis the diameter is read; a click on the part sets it"))
        self._z.setAccessibleName(tr("Diameter at Z"))
        self._z.valueChanged.connect(self.z_chosen)
        self._reading = QtGui.QLabel()
        self._reading.setObjectName("CNCStepper_Simulation_reading")
        self._reading.setWordWrap(True)
        self._reading.setTextInteractionFlags(QtCore.Qt.TextInteractionFlag.TextSelectableByMouse)
        self.show_reading(None, None)
        row.addWidget(QtGui.QLabel(tr("Diameter at Z")))
        row.addWidget(self._z, 1)
        column.addLayout(row)
        column.addWidget(self._reading)
        return column


def _legend(tools: dict[int, str]) -> Any:
    """Return the colours of the raw surface and of what each tool has cut."""
    box = QtGui.QWidget()
    box.setObjectName("CNCStepper_Simulation_legend")
    grid = QtGui.QGridLayout(box)
    grid.setContentsMargins(0, 0, 0, 0)
    rows = [(RAW_RGB, tr("raw surface"))] + [(tool_rgb(number), name) for number, name in sorted(tools.items())]
    for place, (rgb, text) in enumerate(rows):
        sample, pixels = QtGui.QLabel(), QtGui.QPixmap(SAMPLE_PX, SAMPLE_PX)
        pixels.fill(QtGui.QColor.fromRgbF(*rgb))
        sample.setPixmap(pixels)
        grid.addWidget(sample, place, 0)
        grid.addWidget(QtGui.QLabel(text), place, 1)
    grid.setColumnStretch(1, 1)
    return box
