# SPDX-License-Identifier: LGPL-2.1-or-later
"""The player's buttons, its slider over time and its speed."""

from __future__ import annotations

from typing import Any

from PySide import QtCore, QtGui

from CNCStepper.workbench.services.icons import icon as icon_named
from CNCStepper.workbench.services.number_format import clock_text, steps_text
from CNCStepper.workbench.services.translation import later, tr
from CNCStepper.workbench.simulation.player import LINE, MOVE, OPERATION, PULSE, Player

FINEST = 10_000  # steps of the slider over time
FASTEST = 100.0
SPEED_STEPS = 100  # of the speed's slider, from 1 to FASTEST, each the same factor
ICON = "CNCStepper_Player_"
ICON_PX, BETWEEN_PX = 18, 2  # of a button: a dark theme makes it wide
BUTTONS = (
    ("start", "ToStart", later("To the begin")),
    ("back", "StepBack", later("One step back")),
    ("play", "Play", later("Play or pause")),
    ("forward", "StepForward", later("One step on")),
    ("end", "ToEnd", later("To the end")),
)
STEPS = ((LINE, later("Line")), (MOVE, later("Move")), (PULSE, later("Pulse")))
TURNED_STEPS = ((LINE, later("Line")), (MOVE, later("Move")), (OPERATION, later("Operation")))


class Controls(QtGui.QWidget):
    """The controls of the player; they follow its state."""

    def __init__(self, player: Player, parent: Any = None, steps: tuple[tuple[str, str], ...] = STEPS):
        super().__init__(parent)
        self._player, self._kinds = player, steps
        self._buttons = {name: self._button(name, icon, text) for name, icon, text in BUTTONS}
        self._steps = self._step_choice()
        self._place = _slider("CNCStepper_Simulation_time", FINEST, tr("Time in the program"))
        self._place.valueChanged.connect(self._seek)
        self._clock = QtGui.QLabel()
        self._clock.setObjectName("CNCStepper_Simulation_clock")
        self._motors = QtGui.QLabel()
        self._motors.setObjectName("CNCStepper_Simulation_motors")
        self._speed = _slider("CNCStepper_Simulation_speed", SPEED_STEPS, tr("How many times faster than the machine"))
        self._speed.valueChanged.connect(self._set_speed)
        self._speed_text = QtGui.QLabel()
        self._speed_text.setObjectName("CNCStepper_Simulation_speed_text")
        self._speed_text.setMinimumWidth(self.fontMetrics().boundingRect(f"{FASTEST:g} ×  ").width())
        self._lay_out()
        self._connect()
        self._speed.setValue(SPEED_STEPS // 2)
        self._follow()

    def _lay_out(self) -> None:
        layout = QtGui.QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self._place)
        row = QtGui.QHBoxLayout()
        row.setSpacing(BETWEEN_PX)
        for button in self._buttons.values():
            row.addWidget(button)
        row.addStretch(1)
        layout.addLayout(row)
        row = QtGui.QHBoxLayout()
        row.addWidget(self._clock, 1)
        row.addWidget(self._steps)
        layout.addLayout(row)
        layout.addWidget(self._motors)
        row = QtGui.QHBoxLayout()
        row.addWidget(QtGui.QLabel(tr("Speed")))
        row.addWidget(self._speed, 1)
        row.addWidget(self._speed_text)
        layout.addLayout(row)

    def _connect(self) -> None:
        player = self._player
        player.moved.connect(self._follow)
        player.playing_changed.connect(self._show_playing)
        actions = {
            "start": lambda: player.seek(0.0),
            "back": lambda: player.step(-1, self._steps.currentData()),
            "play": lambda: player.pause() if player.playing else player.play(),
            "forward": lambda: player.step(1, self._steps.currentData()),
            "end": lambda: player.seek(player.moves.duration_s),
        }
        for name, action in actions.items():
            self._buttons[name].clicked.connect(action)

    def _button(self, name: str, icon: str, text: str) -> Any:
        button = QtGui.QToolButton()
        button.setObjectName(f"CNCStepper_Simulation_{name}")
        button.setIcon(icon_named(f"{ICON}{icon}"))
        button.setIconSize(QtCore.QSize(ICON_PX, ICON_PX))
        button.setToolTip(tr(text))
        button.setAccessibleName(tr(text))
        return button

    def _step_choice(self) -> Any:
        box = QtGui.QComboBox()
        box.setObjectName("CNCStepper_Simulation_step_by")
        box.setToolTip(tr("What is one step, on or back"))
        box.setAccessibleName(tr("One step is"))
        for name, text in self._kinds:
            box.addItem(tr(text), name)
        return box

    def _follow(self) -> None:
        """Show where the player stands."""
        player = self._player
        duration_s = player.moves.duration_s
        self._place.blockSignals(True)
        self._place.setValue(round(FINEST * player.time_s / duration_s) if duration_s else 0)
        self._place.blockSignals(False)
        self._clock.setText(f"{clock_text(player.time_s)} / {clock_text(duration_s)}")
        self._motors.setVisible(bool(player.steps))
        self._motors.setText(steps_text(player.steps))

    def _show_playing(self, playing: bool) -> None:
        self._buttons["play"].setIcon(icon_named(ICON + ("Pause" if playing else "Play")))

    def _seek(self, place: int) -> None:
        self._player.seek(self._player.moves.duration_s * place / FINEST)

    def _set_speed(self, place: int) -> None:
        self._player.speed = FASTEST ** (place / SPEED_STEPS)
        self._speed_text.setText(tr("{0} ×").format(f"{self._player.speed:.3g}"))


def _slider(name: str, last: int, text: str) -> Any:
    slider = QtGui.QSlider(QtCore.Qt.Orientation.Horizontal)
    slider.setObjectName(name)
    slider.setRange(0, last)
    slider.setPageStep(last // 20)
    slider.setToolTip(text)
    slider.setAccessibleName(text)
    return slider
