# SPDX-License-Identifier: LGPL-2.1-or-later
"""A key for each relay of the machine, on or off, as the controller reports it where it does."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

from PySide import QtGui

from CNCStepper.control.operator.machine_test_lines import is_on, switching
from CNCStepper.errors import CNCStepperError
from CNCStepper.machine.profile import Machine, load_machine
from CNCStepper.machine.relays import relays_of
from CNCStepper.workbench.dock.model.button_states import RULES, ControllerSnapshot, why_not
from CNCStepper.workbench.dock.model.relay_keys import Lines
from CNCStepper.workbench.dock.views import widgets
from CNCStepper.workbench.services.translation import later, tr

COLUMNS = 3
DEVICES = {
    "spindle_cw": later("Power (M3)"),
    "spindle_ccw": later("Reverse (M4)"),
    "mist": later("Mist"),
    "flood": later("Flood"),
}


class RelayView(QtGui.QWidget):
    """Keys by the profile's relays; send(line) types a line to the controller."""

    def __init__(self, send: Callable[[str], None]):
        super().__init__()
        widgets.named(self, "Relays")
        self._send, self._lines = send, Lines()
        self._machine: Machine | None = None
        self._outputs: str | None = None
        self.keys: dict[str, Any] = {}
        self._grid = widgets.grid(self)

    def show_machine(self, name: str) -> None:
        """Offer the relays of a profile; none where it cannot be read, which is said where it is chosen."""
        try:
            self._machine = load_machine(name)
        except CNCStepperError:
            self._machine = None
        for key in self.keys.values():
            self._grid.removeWidget(key)
            key.deleteLater()
        self.keys = {}
        for place, relay in enumerate(relays_of(self._machine) if self._machine else ()):
            words = tr(DEVICES[relay.device]) if relay.name == relay.device in DEVICES else relay.name
            key = widgets.button(f"Relay_{relay.name}", words, partial(self._switch, relay))
            key.setCheckable(True)
            self.keys[relay.device] = key
            self._grid.addWidget(key, place // COLUMNS, place % COLUMNS)

    def lock(self, moment: ControllerSnapshot) -> None:
        """Enable the keys while the machine is idle."""
        why = why_not("relay", moment)
        if not moment.connected:
            self._lines.forget()
        for key in self.keys.values():
            widgets.lock(key, why, RULES["relay"].does)

    def show_outputs(self, outputs: str | None) -> None:
        """Show what the controller says is on; of numbered outputs it says nothing: they stay as they were pressed."""
        self._outputs = outputs
        for device, key in self.keys.items():
            on = is_on(device, outputs)
            if on is not None and not self._lines.is_out:
                key.setChecked(on)

    def take(self, event: dict[str, Any]) -> None:
        """Follow the answers to the lines that were typed here."""
        if self._lines.is_out and (event["event"] == "answer" or event.get("command") == "line"):
            self._lines.answered(event["event"] == "answer" and event["text"] == "ok")
            self._next()

    def _switch(self, relay: Any) -> None:
        if self._machine is None:
            return
        on = self.keys[relay.device].isChecked()
        self._lines.put(switching(self._machine, relay.device, on, self._outputs or ""))
        self._next()

    def _next(self) -> None:
        if line := self._lines.due():
            self._send(line)
