# SPDX-License-Identifier: LGPL-2.1-or-later
"""How motors and devices are wired: pulse times, the motors of each axis, and the pins of a parallel port.

DB25   2-9   data port, base + 0, bits 0 to 7          outputs
       1 14 16 17   control port, base + 2, bits 0 to 3   outputs; 1, 14 and 17 are inverted by the port itself
       10 11 12 13 15   status port, base + 1         inputs

The machine's own buttons and switches: the pin that each is on, and what it does.

[[input]]
pin = "P"            # a letter of `Pn:` in the controller's status, or a status pin of the parallel port in `port`
act = "pause"
level = "low"        # a contact that opens when it is pressed

What is switched by hand, under the name that the machine's people have for it:

[[relay]]
name = "oxygen"
device = "output_0"
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from typing import Annotated, Any, Literal, get_args

from pydantic import BaseModel, Field, StrictInt, model_serializer, model_validator

from CNCStepper.errors import Text
from CNCStepper.quantities import Bounds
from CNCStepper.safe_text import printable

DATA_PINS = (2, 3, 4, 5, 6, 7, 8, 9)
CONTROL_PINS = (1, 14, 16, 17)
INVERTED_PINS = (1, 14, 17)
INPUT_PINS = (10, 11, 12, 13, 15)
OUTPUT_PINS = (*DATA_PINS, *CONTROL_PINS)
Device = Literal["spindle_cw", "spindle_ccw", "mist", "flood", "output_0", "output_1", "output_2", "output_3"]
DEVICES: tuple[str, ...] = get_args(Device)
ENABLE = "enable"
STANDARD_PINS = {  # as most break-out boards have them
    **{f"{axis}_{what}": 2 + 2 * n + k for n, axis in enumerate("xyz") for k, what in enumerate(("step", "direction"))},
    "spindle_cw": 14,
    "spindle_ccw": 16,
    "enable": 17,
    "flood": 1,
    "mist": 8,
}
MOST_MOTORS = 8
BOARD_MOTORS = 4  # of a board that takes bytes
LONGEST_PULSE_US = 50_000.0  # as the thesis sets it

Turning = Literal["x", "y", "z", "-x", "-y", "-z"]


class Signals(BaseModel, extra="forbid", frozen=True, defer_build=True):
    """The signals of step and direction drives.

    pulse_us: a step pulse is on for at least this. gap_us: and off; also the least between any two edges.
    direction_setup_us: from a change of direction to the step. enable_lead_us: from switching the drives on to the
    first edge. motors: the axis that each motor turns, "-y" one that is mounted the other way round; an axis may
    have several, the second of x is called x2. pins: the pin of the parallel port for each signal (x_step,
    x_direction, enable, spindle_cw, flood, ...), STANDARD_PINS when left out; a pin below zero is active low. base:
    address of the data port. null_motor: of a board that takes bytes, the motor that a null pulse selects; "unused":
    one without an axis where there is one. interval_ms: from one pulse letter to the next, pulse_us and gap_us when
    left out.
    """

    pulse_us: Annotated[float, Bounds("pulse", most=LONGEST_PULSE_US)] = 10.0
    gap_us: Annotated[float, Bounds("pulse", most=LONGEST_PULSE_US)] = 10.0
    direction_setup_us: Annotated[float, Bounds("pulse", most=1000.0, zero=True)] = 10.0
    enable_lead_us: Annotated[float, Bounds("pulse", zero=True)] = 1000.0
    motors: tuple[Turning, ...] = Field(default=("x", "y", "z"), min_length=1, max_length=MOST_MOTORS)
    pins: dict[str, Annotated[int, Bounds("pin")]] = {}
    base: Annotated[int, Bounds("number", most=0xFFFF)] = 0x378
    null_motor: Annotated[StrictInt, Field(ge=0, lt=BOARD_MOTORS)] | Literal["unused"] = "unused"
    interval_ms: Annotated[float, Bounds("wait", most=1000.0)] | None = None

    @model_serializer(mode="wrap")
    def _without_what_is_usual(self, as_dict: Any) -> dict[str, Any]:
        """Leave out the null motor and the interval where they are the usual ones: certificates stay what they were."""
        usual = {"null_motor": "unused", "interval_ms": None}
        return {key: value for key, value in as_dict(self).items() if key not in usual or value != usual[key]}

    @property
    def interval_s(self) -> float:
        """The time from one pulse letter to the next."""
        return (self.pulse_us + self.gap_us) / 1e6 if self.interval_ms is None else self.interval_ms / 1e3

    @model_validator(mode="after")
    def _pins_are_outputs_of_known_signals(self) -> Signals:
        known = self.lines
        for name, pin in self.pins.items():
            if name not in known:
                raise ValueError(Text("pins.{name} is no signal; there are {known}", name=name, known=", ".join(known)))
            if abs(pin) in INPUT_PINS:
                raise ValueError(
                    Text("pins.{name}: pin {pin} is an input of the parallel port", name=name, pin=abs(pin))
                )
            if abs(pin) not in OUTPUT_PINS:
                raise ValueError(
                    Text(
                        "pins.{name}: pin {pin} is no output; outputs are 1 to 9, 14, 16 and 17",
                        name=name,
                        pin=abs(pin),
                    )
                )
        used = [abs(pin) for pin in self.pins.values()]
        if len(set(used)) < len(used):
            raise ValueError("pins: two signals are on one pin")
        return self

    @property
    def motor_names(self) -> tuple[str, ...]:
        """The name of each motor: its axis, and a number from the second one on."""
        letters = [turning[-1] for turning in self.motors]
        counts = [letters[: place + 1].count(letter) for place, letter in enumerate(letters)]
        return tuple(letter + (str(count) if count > 1 else "") for letter, count in zip(letters, counts, strict=True))

    @property
    def lines(self) -> tuple[str, ...]:
        """All signals by name: step and direction of each motor, enable, then the devices."""
        motors = [f"{motor}_{what}" for motor in self.motor_names for what in ("step", "direction")]
        return (*motors, ENABLE, *DEVICES)

    @property
    def wired(self) -> dict[str, int]:
        """The pin of each signal that has one."""
        return self.pins or {name: pin for name, pin in STANDARD_PINS.items() if name in self.lines}


CONTROLLER_PINS = "XYZABCPDHRS"  # limit switches, probe, door, hold, reset, cycle start
LONGEST_LINE = 70
LONGEST_NAME = 20  # of a key's label
_SWITCHING = re.compile(r"M(?:[345789]|6[234578])(?:[SPQE]\d+(?:\.\d+)?)*")

SENDERS_PINS = "ABC"  # by which a CNCStepper controller reports its pins for acts that only the sender can do
SENDERS_ACTS = ("back", "switch")
BOARDS_ACTS = ("limit", "door")  # that only the controller itself can do

Act = Literal["start", "pause", "back", "stop", "flood", "mist", "spindle_stop", "switch", "limit", "door"]


class Input(BaseModel, extra="forbid", frozen=True, defer_build=True):
    """One button or switch.

    pin: one of CONTROLLER_PINS, or one of INPUT_PINS of a parallel port. port: that port's device file; without it the
    port by which this computer drives the machine itself. act: what pressing does; limits and doors are on that port.
    level: "high" where the pin is on while it is pressed, else "low". debounce_ms: how long a contact must rest before
    it is believed. line: of act "switch", the block that switches an output; release_line: the one that is sent when
    the switch is let go. back_mm: of act "back", how far each pressing goes back along the cut.
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
        if isinstance(self.pin, str) and self.port:
            raise ValueError("only a pin with a number has a port: the device file of its parallel port")
        if self.act in BOARDS_ACTS and not self.is_own:
            raise ValueError("a limit or door is on a pin with a number, without port: on the machine's own")
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
    def is_own(self) -> bool:
        """Whether it is on the port by which this computer drives the machine."""
        return isinstance(self.pin, int) and not self.port

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


def letters_of_own(inputs: Iterable[Input]) -> dict[int, str]:
    """Return the letter of `Pn:` for each pin of the machine's own port on whose change only the sender can act."""
    pins = [entry.pin for entry in inputs if entry.is_own and entry.act in SENDERS_ACTS]
    return {int(pin): letter for pin, letter in zip(pins, SENDERS_PINS, strict=False)}


def seen_by_sender(inputs: Sequence[Input]) -> list[Input]:
    """Return the inputs that the sender polls; those on the machine's own port by their letters in `Pn:`."""
    letters = letters_of_own(inputs)
    return [
        entry.model_copy(update={"pin": letters[int(entry.pin)], "level": "high", "debounce_ms": 0.0})
        if entry.is_own
        else entry
        for entry in inputs
        if not entry.is_own or entry.pin in letters
    ]


class Relay(BaseModel, extra="forbid", frozen=True, defer_build=True):
    """What a key of the dock switches. name: on the key. device: one of DEVICES."""

    name: Annotated[str, Field(min_length=1, max_length=LONGEST_NAME)]
    device: Device


def check_relays(relays: Sequence[Relay]) -> None:
    """Raise ValueError where two relays have one name, or switch one device."""
    names, devices = [str(entry.name) for entry in relays], [str(entry.device) for entry in relays]
    for values in (names, devices):
        twice = [value for value in values if values.count(value) > 1]
        if twice:
            raise ValueError(Text("relay: {twice} is there twice", twice=printable(twice[0])))
