# SPDX-License-Identifier: LGPL-2.1-or-later
"""The machine's own buttons and switches: the pin that each is on, and what it does.

[[input]]
pin = "P"            # a letter of `Pn:` in the controller's status, or a status pin of the parallel port in `port`
act = "pause"
level = "low"        # a contact that opens when it is pressed
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Annotated, Literal

from pydantic import BaseModel, StrictInt, model_validator

from CNCStepper.errors import Text
from CNCStepper.machine.wiring import INPUT_PINS
from CNCStepper.quantities import Bounds

CONTROLLER_PINS = "XYZABCPDHRS"  # limit switches, probe, door, hold, reset, cycle start
LONGEST_LINE = 70
_SWITCHING = re.compile(r"M(?:[345789]|6[234578])(?:[SPQE]\d+(?:\.\d+)?)*")

Act = Literal["start", "pause", "back", "stop", "flood", "mist", "spindle_stop", "switch"]


class Input(BaseModel, extra="forbid", frozen=True):
    """One button or switch.

    pin: one of CONTROLLER_PINS, or one of INPUT_PINS of a parallel port. port: that port's device file. act: what
    pressing does. level: "high" where the pin is on while it is pressed, else "low". debounce_ms: how long a contact
    must rest before it is believed. line: of act "switch", the block that switches an output; release_line: the one
    that is sent when the switch is let go. back_mm: of act "back", how far each pressing goes back along the cut.
    """

    pin: StrictInt | str
    act: Act
    port: str = ""
    level: Literal["high", "low"] = "high"
    debounce_ms: Annotated[float, Bounds("wait", most=1000.0, zero=True)] = 30.0
    line: str = ""
    release_line: str = ""
    back_mm: Annotated[float, Bounds("length", most=1000.0)] = 1.0

    @model_validator(mode="after")
    def _pin_is_one_that_is_there(self) -> Input:
        if isinstance(self.pin, int) and self.pin not in INPUT_PINS:
            raise ValueError(
                Text("pin {pin} is no input of a parallel port; inputs are 10, 11, 12, 13 and 15", pin=self.pin)
            )
        if isinstance(self.pin, str) and (len(self.pin) != 1 or self.pin not in CONTROLLER_PINS):
            raise ValueError(
                Text(
                    "pin '{pin}' is no pin of a controller; there are {controller_pins}",
                    pin=self.pin[:20],
                    controller_pins=", ".join(CONTROLLER_PINS),
                )
            )
        if isinstance(self.pin, int) != bool(self.port):
            raise ValueError("a pin with a number, and only that, has a port: the device file of its parallel port")
        return self

    @model_validator(mode="after")
    def _lines_only_switch(self) -> Input:
        if (self.act == "switch") != bool(self.line):
            raise ValueError('act = "switch" and line belong together')
        if self.release_line and not self.line:
            raise ValueError("release_line goes with line")
        for line in filter(None, (self.line, self.release_line)):
            if len(line) > LONGEST_LINE or not _SWITCHING.fullmatch(line):
                raise ValueError(
                    Text("'{line}' is no block that only switches, as M8, M3S9000 or M64P0", line=line[:20])
                )
        return self

    @property
    def name(self) -> str:
        """How a person finds it: "pin P", "pin 11 of /dev/parport0"."""
        return Text("pin {pin} of {port}", pin=self.pin, port=self.port) if self.port else f"pin {self.pin}"


def check_apart(inputs: Sequence[Input]) -> None:
    """Raise ValueError where two inputs are on one pin."""
    names = [entry.name for entry in inputs]
    twice = [name for name in names if names.count(name) > 1]
    if twice:
        raise ValueError(Text("input: two inputs are on {twice}", twice=twice[0]))
