# SPDX-License-Identifier: LGPL-2.1-or-later
"""The step that finds the port, connects by the dock's one connection, and asks what answers."""

from __future__ import annotations

from typing import Any

from PySide import QtGui

from CNCStepper.control.settings.controller_identity import identity_of
from CNCStepper.control.settings.settings_restore import ASK_IDENTITY, ASK_SETTINGS
from CNCStepper.errors import CNCStepperError
from CNCStepper.workbench.assistant.machine_setup import MachineSetup
from CNCStepper.workbench.assistant.widgets import NAME, Page, combo, label, row
from CNCStepper.workbench.dock import window as dock_window
from CNCStepper.workbench.dock.connection import error_text
from CNCStepper.workbench.dock.model import settings
from CNCStepper.workbench.dock.model.button_states import face
from CNCStepper.workbench.dock.model.port_choices import BAUDS, VIRTUAL_TEXT, choices, needs_baud, port_of
from CNCStepper.workbench.machines.machine_test_connection import Bench
from CNCStepper.workbench.services.message_translation import translated
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.translation import later, tr

TITLE = later("Port")


class ConnectPage(Page):
    """See the module."""

    title = TITLE

    def __init__(self, setup: MachineSetup, bench: Bench):
        super().__init__(setup, bench, tr("Plug the machine in and choose its port. Without a machine go to Next."))
        self._choices: list[Any] = []
        self._known: set[str] = set()
        self.port = QtGui.QComboBox()
        self.port.setObjectName(f"{NAME}_port")
        self.port.setEditable(True)
        self.port.setAccessibleName(tr("Port"))
        self.port.setToolTip(tr("A serial port, or an address as 192.168.0.7:23"))
        self.port.setSizeAdjustPolicy(QtGui.QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self.port.editTextChanged.connect(guarded(self.refresh))
        rates = [(str(rate), str(rate)) for rate in BAUDS]
        self.baud = combo("baud", tr("The baud rate of the serial port"), rates, self.refresh)
        self.baud.setCurrentText(str(settings.last_baud()))
        self.again = self.button("look", tr("Look again"), self._look)
        self.connecting = self.button("connect", tr("Connect"), self._connect)
        self.asking = self.button("ask", tr("Ask again"), self._ask)
        self.state, self.found = label("state"), label("found")
        self.column.addWidget(self.port)
        self.column.addLayout(row(self.baud, self.again, self.connecting, self.asking))
        for widget in (self.state, self.note, self.found):
            self.column.addWidget(widget)
        self.column.addStretch(1)
        self._was_connected = False
        self._fill(settings.last_port())

    def refresh(self) -> None:
        """Show whether something is connected, and what it said; a new connection is asked at once."""
        link = dock_window.link_here()
        connected = self.bench.status is not None
        if connected and not self.setup.identity and not self._was_connected and not self.bench.why_not(locked=True):
            self._was_connected = True
            self._ask()
        if not connected:
            self._was_connected = False
            self.setup.identity = None
        self.state.setText(tr(face(link.moment).sentence) if link else tr("Nothing is connected."))
        self.connecting.setEnabled(not (link and (link.moment.connected or link.moment.busy)))
        self.asking.setEnabled(connected and not self.bench.why_not(locked=True))
        why = self.bench.why_not(locked=True)
        self.asking.setToolTip(tr(why))
        self.baud.setVisible(needs_baud(self._port()))
        self.say_wrong(self.bench.trouble)
        self.found.setText(self._words())

    def _port(self) -> str:
        return port_of(self.port.currentText(), self._choices)

    def _look(self) -> None:
        """List the ports that are there now; one that has come since is chosen."""
        before = {choice.port for choice in self._choices}
        self._fill(self._port())
        new = [choice for choice in self._choices if choice.port not in before]
        if new:
            self.port.setCurrentText(new[0].text)
            self.found.setText(tr("{0} is new: that is your machine.").format(new[0].text))

    def _fill(self, wanted: str) -> None:
        from CNCStepper.control.transport.link import port_list

        try:
            ports = [(choice.name, choice.text) for choice in port_list()]
        except CNCStepperError as error:
            ports = []
            self.say_wrong(error_text(error))
        self._choices = choices(ports, tr(VIRTUAL_TEXT), wanted)
        self.port.blockSignals(True)
        self.port.clear()
        self.port.addItems([choice.text for choice in self._choices])
        self.port.setCurrentIndex([choice.port for choice in self._choices].index(wanted))
        self.port.blockSignals(False)

    def _connect(self) -> None:
        """Connect by the dock, as its own button does."""
        panel = dock_window.open_dock().widget()
        panel.connection.look(self._port())
        panel.connection.baud.setCurrentText(self.baud.currentText())
        if self.setup.is_own_controller:
            panel.connection.machine.setCurrentText(self.setup.saved or self.setup.base)
        panel.connect_chosen()
        self.window().raise_()
        self.refresh()

    def _ask(self) -> None:
        self.bench.run([ASK_IDENTITY, ASK_SETTINGS], lambda _: self._answered(), locked=True)

    def _answered(self) -> None:
        self.setup.answer(identity_of(word for _, words in self.bench.answered for word in words))
        self.refresh()

    def _words(self) -> str:
        found = self.setup.identity
        if found is None:
            return ""
        said = [tr("Answered: {0}.").format(translated(found.text))]
        if found.settings:
            said.append(tr("{0} settings, axes {1}.").format(len(found.settings), found.axes))
        if found.is_own:
            said.append(tr("This computer itself is the controller, by the machine's profile."))
        return "\n".join(said)
