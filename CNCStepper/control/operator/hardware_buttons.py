# SPDX-License-Identifier: LGPL-2.1-or-later
"""The machine's hardware buttons: levels of input pins become commands, on the thread that polls the pins.

Pn: in a status ──► hear ──┐
                           ├──► Debouncer ──► edge ──► told, and asked of the sender or the service
PinWatch of a port ────────┘

A contact that bounces, followed until it rests.

looked at   0   0 | 1   0   1   1   1 | 1   1
steady      0   0   0   0   0   0   1   1   1      after debounce_s without a change
edge                                ^ True

The command of a hardware button, one of those that a window and a terminal send.

act            pressed                                   let go
start          resume; of an idle service its last job      -
pause          hold                                      -
back           request_retract, back_mm farther                -
stop           stop                                      -
flood, mist    override coolant                          -
spindle_stop   override spindle stop                     -
switch         its line, while the machine is idle       its release_line

The status pins of a parallel port, polled by a thread; or a file in place of a port.

base + 1   status    bits 3 to 7   pins 15 13 12 10 11; the port turns 11 round: a 1 is low
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, Protocol

from CNCStepper.control.protocol.grbl.driver import Received
from CNCStepper.control.protocol.grbl.status_reports import Greeting, Status
from CNCStepper.control.protocol.grbl.timeouts import Timing
from CNCStepper.control.pulses.parallel_port import CLAIM, READ_STATUS, RELEASE, high_pins, is_parallel_port, no_port
from CNCStepper.control.session.command import Command
from CNCStepper.errors import JobError, LinkError, Text


class Debouncer:
    """Debounces one contact; the first steady level gives no edge, so a button held at the start does nothing.

    debounce_s: how long a level must last to count, at two polls at least; at 0 every poll counts.
    """

    def __init__(self, debounce_s: float):
        self._debounce_s = debounce_s
        self._steady: bool | None = None
        self._seen: bool | None = None
        self._since_s = 0.0

    def look(self, level: bool, now_s: float) -> bool | None:
        """Take the contact's level now; return the new level at a change, else None."""
        if level != self._seen:
            self._seen, self._since_s = level, now_s
            if self._debounce_s > 0:
                return None
        if level == self._steady or now_s - self._since_s < self._debounce_s:
            return None
        is_first, self._steady = self._steady is None, level
        return None if is_first else level


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
            raise JobError(
                "input", Text("this is no input of a machine: {error}", error=error), advice="make the job again"
            ) from error
        if button.act not in (*COMMANDS, "back", "switch"):
            raise JobError(
                "input", Text("there is no act '{act}'", act=str(button.act)[:40]), advice="make the job again"
            )
        return button

    @property
    def name(self) -> str:
        """How a person finds it."""
        return Text("pin {pin} of {port}", pin=self.pin, port=self.port) if self.port else f"pin {self.pin}"

    def command(self, pressed: bool) -> Command | None:
        """Return the command of a press or a release; None where it has none."""
        if self.act == "switch":
            line = self.line if pressed else self.release_line
            return Command("switch", {"line": line}) if line else None
        if self.act == "back":
            return Command("want_back", {"distance_mm": self.back_mm}) if pressed else None
        return COMMANDS[self.act] if pressed else None


def buttons_of(inputs: Iterable[Mapping[str, Any]]) -> tuple[Button, ...]:
    """Return the buttons of a job's `inputs`; raises JobError where one is none."""
    return tuple(map(Button.from_content, inputs))


LOOK_EVERY_S = 0.005
CLOSE_LIMIT_S = 1.0  # another program may have claimed the port

Pins = frozenset[int]


class StatusPins(Protocol):
    """Inputs of one port."""

    def high(self) -> Pins:
        """Return the pins that are high now; raises LinkError where they cannot be read."""


class ParallelStatus:
    """The status pins of a parallel port by its device file, which others may use between two looks."""

    def __init__(self, path: Path):
        self._path = path
        self.high()

    def high(self) -> Pins:
        """Return the pins that are high now."""
        from fcntl import ioctl

        try:
            with self._path.open("rb", buffering=0) as port:
                ioctl(port, CLAIM)
                register = ioctl(port, READ_STATUS, b"\0")
                ioctl(port, RELEASE)
        except OSError as error:
            raise no_port(self._path, error) from error
        return high_pins(register[0])


class FilePins:
    """A text file with the numbers of the pins that are high: a port for trials."""

    def __init__(self, path: Path):
        self._path = path
        self.high()

    def high(self) -> Pins:
        """Return the pins that are high now."""
        try:
            return frozenset(map(int, self._path.read_text("utf-8").split()))
        except (OSError, ValueError) as error:
            advice = "name a parallel port (/dev/parport0), or a text file with the numbers of the pins that are high"
            raise LinkError(
                "input-port", Text("{path} has no pins to read: {error}", path=self._path, error=error), advice=advice
            ) from error


def open_pins(port: str) -> StatusPins:
    """Return the pins of a port's device file, or those of a text file; raises LinkError where they cannot be read."""
    path = Path(port)
    return ParallelStatus(path) if is_parallel_port(path) else FilePins(path)


class PinWatch:
    """Looks at the pins of one port again and again, on a thread of its own, until `close`.

    look: gets the pins that are high. lost: gets the reason when they cannot be read any more; the watch ends then.
    """

    def __init__(self, pins: StatusPins, look: Callable[[Pins], None], lost: Callable[[LinkError], None]):
        self._pins = pins
        self._look = look
        self._lost = lost
        self._closed = threading.Event()
        self._thread = threading.Thread(target=self._run, name="pins", daemon=True)
        self._thread.start()

    def close(self) -> None:
        """Look no more."""
        self._closed.set()
        self._thread.join(CLOSE_LIMIT_S)

    def _run(self) -> None:
        try:
            while not self._closed.wait(LOOK_EVERY_S):
                self._look(self._pins.high())
        except LinkError as error:
            self._lost(error)


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

    ask: gets what is pressed, from any thread. tell(kind, text): is called with it. start: what a start button asks for
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
        """Hold the machine, because none of its buttons can stop it now."""
        self._tell("warning", Text("the buttons are not heard any more, so the machine is held: {error}", error=error))
        self._ask(Command("hold"))


def quicker(timing: Timing, inputs: Sequence[Mapping[str, Any]]) -> Timing:
    """Return the waits with which a job's `inputs` on pins of the controller are seen often enough."""
    if all(entry.get("port") for entry in inputs):
        return timing
    return replace(timing, poll_s=min(timing.poll_s, POLL_S))
