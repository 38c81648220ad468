# SPDX-License-Identifier: LGPL-2.1-or-later
"""The machine's own buttons: what their pins show becomes commands, on the thread that looks at the pins.

Pn: in a status ──► hear ──┐
                           ├──► Debouncer ──► edge ──► told, and asked of the sender or the desk
PinWatch of a port ────────┘
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from CNCStepper.control.operator.button_actions import Button
from CNCStepper.control.operator.debounce import Debouncer
from CNCStepper.control.operator.status_pins import PinWatch, StatusPins, open_pins
from CNCStepper.control.protocol.grbl.driver import Received
from CNCStepper.control.protocol.grbl.report import Greeting, Status
from CNCStepper.control.protocol.grbl.timeouts import Timing
from CNCStepper.control.session.command import Command
from CNCStepper.errors import LinkError, Text

POLL_S = 0.1  # between two `?`, so that a button need not be pressed for long
WORDS = {
    "start": "start",
    "pause": "pause",
    "back": "back along the cut",
    "stop": "stop",
    "flood": "flood coolant",
    "mist": "mist coolant",
    "spindle_stop": "spindle stop",
    "switch": "switching",
}


@dataclass
class _Contact:
    button: Button
    debouncer: Debouncer = field(init=False)

    def __post_init__(self) -> None:
        self.forget()

    def forget(self) -> None:
        self.debouncer = Debouncer(self.button.debounce_ms / 1000)


class Buttons:
    """The buttons of one machine, none until `wire`.

    ask: gets what is pressed, from any thread. tell(kind, text): hears of it. start: what a start button asks for
    while the machine is idle, None to resume.
    """

    def __init__(
        self,
        ask: Callable[[Command], None],
        tell: Callable[[str, str], None],
        clock: Callable[[], float],
        start: Callable[[], Command | None] = lambda: None,
        opener: Callable[[str], StatusPins] = open_pins,
    ):
        self._ask = ask
        self._tell = tell
        self._clock = clock
        self._start = start
        self._opener = opener
        self._wired: tuple[Button, ...] = ()
        self._contacts: list[_Contact] = []  # on pins of the controller
        self._watches: list[PinWatch] = []

    def wire(self, buttons: Sequence[Button]) -> None:
        """Look at these buttons from now on; raises LinkError where a port cannot be read: then at none."""
        if tuple(buttons) == self._wired:
            return
        self.close()
        ports = {button.port: self._opener(button.port) for button in buttons if button.port}
        self._contacts = [_Contact(button) for button in buttons if not button.port]
        self._watches = [self._watch(pins, [b for b in buttons if b.port == port]) for port, pins in ports.items()]
        self._wired = tuple(buttons)

    def close(self) -> None:
        """Look at none any more."""
        for watch in self._watches:
            watch.close()
        self._wired, self._contacts, self._watches = (), [], []

    def on_message(self, received: Sequence[Received]) -> None:
        """Take a controller's message: a status shows its pins, a restart makes them unknown."""
        for report in received:
            if isinstance(report, Status):
                self._look(self._contacts, report.pins)
            elif isinstance(report, Greeting):
                for contact in self._contacts:
                    contact.forget()

    # --- inside --------------------------------------------------------------------------------

    def _watch(self, pins: StatusPins, buttons: Sequence[Button]) -> PinWatch:
        contacts = [_Contact(button) for button in buttons]
        return PinWatch(pins, lambda high: self._look(contacts, high), self._lost)

    def _look(self, contacts: Sequence[_Contact], pins_on: Collection[int | str]) -> None:
        for contact in contacts:
            is_on = contact.button.pin in pins_on
            pressed = contact.debouncer.look(is_on == (contact.button.level == "high"), self._clock())
            command = None if pressed is None else contact.button.command(pressed)
            if command:
                self._press(contact.button, command)

    def _press(self, button: Button, command: Command) -> None:
        self._tell("message", Text("{word} by the button on {button}", word=WORDS[button.act], button=button.name))
        self._ask((button.act == "start" and self._start()) or command)

    def _lost(self, error: LinkError) -> None:
        """Hold: whoever works the machine by buttons can stop it by none of them now."""
        self._tell("warning", Text("the buttons are not heard any more, so the machine is held: {error}", error=error))
        self._ask(Command("hold"))


def quicker(timing: Timing, inputs: Sequence[Mapping[str, Any]]) -> Timing:
    """Return the waits with which a job's `inputs` on pins of the controller are seen often enough."""
    if all(entry.get("port") for entry in inputs):
        return timing
    return replace(timing, poll_s=min(timing.poll_s, POLL_S))
