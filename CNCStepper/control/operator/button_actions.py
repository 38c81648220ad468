# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a button of the machine asks for: the same commands that a window and a terminal ask.

act            pressed                                   let go
start          resume; of an idle desk its last job      -
pause          hold                                      -
back           request_retract, back_mm farther                -
stop           stop                                      -
flood, mist    override coolant                          -
spindle_stop   override spindle stop                     -
switch         its line, while the machine is idle       its release_line
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from CNCStepper.control.session.command import Command
from CNCStepper.errors import JobError

COMMANDS = {
    "start": Command("resume"),
    "pause": Command("hold"),
    "stop": Command("stop"),
    "flood": Command("override", {"kind": "coolant", "step": "flood"}),
    "mist": Command("override", {"kind": "coolant", "step": "mist"}),
    "spindle_stop": Command("override", {"kind": "spindle", "step": "stop"}),
}


@dataclass(frozen=True)
class Button:
    """One button, as `machine.input_pins.Input` checked it; `pin` is a letter of `Pn:`, or a number on `port`."""

    pin: int | str
    act: str
    port: str = ""
    level: str = "high"
    debounce_ms: float = 30.0
    line: str = ""
    release_line: str = ""
    back_mm: float = 1.0

    @classmethod
    def from_content(cls, content: Mapping[str, Any]) -> Button:
        """Return the button of plain data; raises JobError where it is none."""
        try:
            button = cls(**content)
        except TypeError as error:
            raise JobError("input", f"this is no input of a machine: {error}", advice="make the job again") from error
        if button.act not in (*COMMANDS, "back", "switch"):
            raise JobError("input", f"there is no act '{str(button.act)[:40]}'", advice="make the job again")
        return button

    @property
    def name(self) -> str:
        """How a person finds it."""
        return f"pin {self.pin} of {self.port}" if self.port else f"pin {self.pin}"

    def command(self, pressed: bool) -> Command | None:
        """Return what it asks for when it was just pressed, or let go; None for nothing."""
        if self.act == "switch":
            line = self.line if pressed else self.release_line
            return Command("switch", {"line": line}) if line else None
        if self.act == "back":
            return Command("want_back", {"distance_mm": self.back_mm}) if pressed else None
        return COMMANDS[self.act] if pressed else None


def buttons_of(inputs: Iterable[Mapping[str, Any]]) -> tuple[Button, ...]:
    """Return the buttons of a job's `inputs`; raises JobError where one is none."""
    return tuple(map(Button.from_content, inputs))
