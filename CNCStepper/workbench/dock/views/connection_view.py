# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the dock connects to: the port list with its free text field, baud rate or speed, and the button."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from PySide import QtGui

from CNCStepper.machine.profile import profile_names
from CNCStepper.workbench.dock.model import settings
from CNCStepper.workbench.dock.model.button_states import ControllerSnapshot, why_not_connect, why_not_disconnect
from CNCStepper.workbench.dock.model.port_choices import (
    BAUDS,
    SPEEDS,
    VIRTUAL,
    VIRTUAL_TEXT,
    choices,
    needs_baud,
    port_of,
)
from CNCStepper.workbench.dock.views import widgets
from CNCStepper.workbench.dock.views.keyboard import KeyButton
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.translation import later, tr

BUTTON_PX = 24  # of a button besides its text
DISCONNECT_FIRST = later("Disconnect first: the dock is connected to this machine.")


class FreshBox(QtGui.QComboBox):
    """A list that refreshes its entries whenever it is opened."""

    def __init__(self, look: Callable[[], None]):
        super().__init__()
        self._look = look
        self.setSizeAdjustPolicy(QtGui.QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self.setMinimumContentsLength(12)

    def showPopup(self) -> None:
        """Open the list with what is there now."""
        self._look()
        super().showPopup()


class ConnectionView(QtGui.QWidget):
    """The port, how it is opened, and Connect or Disconnect."""

    def __init__(self, connect: Callable[[], None], disconnect: Callable[[], None], found: Callable[[], list]):
        super().__init__()
        self._connect, self._disconnect, self._found = connect, disconnect, found
        self._choices: list[Any] = []
        self._profile_file = ""  # of the job that is sent, where its profile is not among the names
        self._moment = ControllerSnapshot()
        self.box = widgets.named(FreshBox(self.look), "Port")
        self.box.setEditable(True)
        self.box.setInsertPolicy(QtGui.QComboBox.InsertPolicy.NoInsert)
        self.box.setAccessibleName(tr("Port"))
        self.baud = widgets.named(QtGui.QComboBox(), "Baud")
        self.baud.addItems([str(rate) for rate in BAUDS])
        self.baud.setCurrentText(str(settings.last_baud()))
        self.speed = widgets.named(QtGui.QComboBox(), "Speed")
        self.speed.addItems([tr("{0}× speed").format(speed) for speed in SPEEDS])
        self.machine = widgets.named(FreshBox(self.look_for_machines), "Machine")
        self.machine.setAccessibleName(tr("Machine profile"))
        self._tips = {
            self.machine: later("The profile of the machine at this port: its relays, and how it is driven"),
            self.box: later("A serial port, or an address as 192.168.0.7:23"),
            self.baud: later("The baud rate of the serial port"),
            self.speed: later("How many times faster than a real one the virtual machine moves"),
        }
        for box in (self.baud, self.speed):
            box.setAccessibleName(tr(self._tips[box]))
        self.button = widgets.named(KeyButton(), "Connect")
        letters = self.button.fontMetrics()
        widest = max(letters.boundingRect(text).width() for text in (tr("Connect"), tr("Disconnect")))
        self.button.setMinimumWidth(widest + BUTTON_PX)  # the dock keeps its width
        self.button.clicked.connect(guarded(self._clicked))
        layout = widgets.column(self)
        layout.addWidget(self.box)
        layout.addWidget(self.machine)
        layout.addLayout(widgets.row(self.baud, self.speed, self.button))
        self.box.editTextChanged.connect(guarded(self._choose))
        self.look(settings.last_port())
        self.look_for_machines()

    @property
    def profile(self) -> str:
        """The machine profile that is chosen: its name, or its file where a job has one that is not listed."""
        return str(self.machine.currentData() or "")

    def choose_machine(self, profile: str) -> None:
        """Choose a profile for the next connection; while there is a connection its machine stays."""
        if not self._connected:
            self._profile_file = "" if profile in profile_names() else profile
            self.look_for_machines(profile)

    def look_for_machines(self, wanted: str = "") -> None:
        """List the profiles that are there now; `wanted` is chosen, else what was."""
        files = [self._profile_file] if self._profile_file else []
        profiles = [*profile_names(), *files]
        wanted = wanted or self.profile or settings.last_machine()
        self.machine.blockSignals(True)
        if [self.machine.itemData(place) for place in range(self.machine.count())] != profiles:
            self.machine.clear()
            for profile in profiles:
                self.machine.addItem(Path(profile).name, profile)
        self.machine.setCurrentIndex(max(self.machine.findData(wanted), 0))
        self.machine.blockSignals(False)

    @property
    def port(self) -> str:
        """What is to be opened; `VIRTUAL` for the virtual grbl."""
        return port_of(self.box.currentText(), self._choices)

    @property
    def baud_rate(self) -> int:
        """The baud rate chosen."""
        return int(self.baud.currentText())

    @property
    def times_faster(self) -> int:
        """How many times faster than real the virtual grbl is to be."""
        return SPEEDS[self.speed.currentIndex()]

    def look(self, wanted: str = "") -> None:
        """List the ports that are there now; `wanted` is chosen, else what was."""
        wanted = wanted or self.port
        self._choices = choices(self._found(), tr(VIRTUAL_TEXT), wanted)
        self.box.blockSignals(True)
        self.box.clear()
        self.box.addItems([choice.text for choice in self._choices])
        self.box.setCurrentIndex([choice.port for choice in self._choices].index(wanted))
        self.box.blockSignals(False)
        self._choose()

    def lock(self, moment: ControllerSnapshot) -> None:
        """Let the button connect or disconnect, whichever can be done."""
        self._moment = moment
        self.button.setText(tr("Disconnect") if self._connected else tr("Connect"))
        if self._connected:
            widgets.lock(self.button, why_not_disconnect(moment), later("Disconnect from the controller."))
        else:
            widgets.lock(
                self.button, why_not_connect(moment, self.port), later("Connect to the controller at this port.")
            )
        for choice, does in self._tips.items():
            widgets.lock(choice, DISCONNECT_FIRST if self._connected else "", does)

    @property
    def _connected(self) -> bool:
        return self._moment.connected or self._moment.busy

    def _clicked(self) -> None:
        (self._disconnect if self._connected else self._connect)()

    def _choose(self) -> None:
        """Show the baud rate where there is one, the speed for the virtual grbl; no text is no port."""
        self.baud.setVisible(needs_baud(self.port))
        self.speed.setVisible(self.port == VIRTUAL)
        self.lock(self._moment)
