# SPDX-License-Identifier: LGPL-2.1-or-later
"""The port's relays and switches for the board.

spindle, coolant, M62 to M65 ──► Relays ──switch──► output          output ──inputs──► Switches ──► board

act           pressed: the board does what it would at this pin of its own          letter of `Pn:`
limit         stops and locks where $21 is on                                        XYZ
door stop pause start     0x84, 0x18, `!`, `~`                                       D R H S
flood mist spindle_stop   0xA0, 0xA1, 0x9E                                           -
back switch               nothing: the sender acts on them                           A B C, in the profile's order
"""

from __future__ import annotations

from collections.abc import Sequence

from CNCStepper.control.operator.hardware_buttons import Debouncer
from CNCStepper.controllers.ended_output import EndedOutput, Output
from CNCStepper.machine.controller_family import family_of
from CNCStepper.machine.processes import process_named
from CNCStepper.machine.profile import Machine
from CNCStepper.machine.wiring import ENABLE, Input, letters_of_own
from CNCStepper.virtual.grbl.board import Board
from CNCStepper.virtual.grbl.input_pins import LIMITS
from CNCStepper.virtual.grbl.machine import Grbl
from CNCStepper.virtual.grbl.spindle_control import OFF
from CNCStepper.virtual.grbl.states import State
from CNCStepper.virtual.grbl.suspend import SPINDLE_RETURNS_S

SPINDLES = {3: "spindle_cw", 4: "spindle_ccw"}
MOTOR_LINES = ("_step", "_direction")
OUTPUT = "output_"  # and its number: M62 P0 is output_0
PINS_OF_ACTS = {"door": "D", "stop": "R", "pause": "H", "start": "S"}
BYTES_OF_ACTS = {"flood": b"\xa0", "mist": b"\xa1", "spindle_stop": b"\x9e"}


class Relays:
    """The devices that have a pin; each change is given to the output once.

    further: those that are on and that no word of a program switches, by their names.
    """

    def __init__(self, machine: Machine, output: Output):
        lines = machine.signals.wired if family_of(machine) == "parport" else {}
        self.wired = frozenset(name for name in lines if not name.endswith(MOTOR_LINES) and name != ENABLE)
        self.further: set[str] = set()
        named = {_squeezed(relay.name): str(relay.device) for relay in machine.relay if relay.device in self.wired}
        self._by_name = {_squeezed(device): device for device in self.wired} | named
        self._output = output
        self._has_jet = any(process_named(name).pause_power == "off" for name in machine.processes)
        self._on: frozenset[str] = frozenset()
        self._was_dark = False  # the outputs are off behind an open door

    @property
    def digital_outputs(self) -> int:
        """How many M62 to M65 may name, from P0 on."""
        return max((int(name.removeprefix(OUTPUT)) + 1 for name in self.wired if name.startswith(OUTPUT)), default=0)

    @property
    def on(self) -> frozenset[str]:
        """The devices that are on."""
        return self._on

    @property
    def names(self) -> list[str]:
        """By which names relays can be switched, as the board's lines have them."""
        return sorted(self._by_name)

    def device_of(self, name: str) -> str | None:
        """Return the device of a relay's name: its own, or that of the profile; None where there is none."""
        return self._by_name.get(_squeezed(name))

    def switch(self, device: str, on: bool, board: Board) -> None:
        """Switch one of `wired` by its name, as its word of a program does where there is one."""
        modal = board.parser.modal
        if device in SPINDLES.values():
            direction = next(number for number, name in SPINDLES.items() if name == device)
            modal.spindle = direction if on else OFF
            board.spindle.switch(modal.spindle, board.parser.rpm)
        elif device == "flood":
            board.flood = modal.flood = on
        elif device == "mist":
            board.mist = modal.mist = on
        elif device.startswith(OUTPUT):
            (board.outputs.add if on else board.outputs.discard)(int(device.removeprefix(OUTPUT)))
        else:
            (self.further.add if on else self.further.discard)(device)
        board.status.overrides_changed()
        self.follow(board)

    def follow(self, board: Board) -> None:
        """Let every device be as the board has switched it; asleep everything is off, whatever switched it on.

        Behind an open door the outputs of a machine that cuts with a jet are off too: one of them may be its torch.
        """
        if board.state is State.SLEEP:
            board.outputs.clear()
            self.further.clear()
        wanted = {OUTPUT + str(number) for number in board.outputs} | self.further
        wanted |= {SPINDLES[board.spindle.direction]} if board.spindle.direction in SPINDLES else set()
        wanted |= {name for name, on in (("flood", board.flood), ("mist", board.mist)) if on}
        wanted = self._behind_door(wanted & self.wired, board)
        for device in sorted(wanted ^ self._on):
            self._output.switch(device, device in wanted)
        self._on = frozenset(wanted)

    def _behind_door(self, wanted: set[str], board: Board) -> set[str]:
        """Return what of the devices stays on while a door is open; those that come back are waited for."""
        suspension = board.suspension
        is_dark = self._has_jet and suspension.door and suspension.stopped and suspension.restoring_s is None
        jets = wanted & ({name for name in self.wired if name.startswith(OUTPUT)} | self.further)
        if self._was_dark and not is_dark and jets and suspension.restoring_s is not None:
            suspension.restoring_s = max(suspension.restoring_s, SPINDLE_RETURNS_S)
        self._was_dark = is_dark
        return wanted - jets if is_dark else wanted

    def lose_output(self, ended: EndedOutput) -> None:
        """Switch nothing any more: the output has ended, and everything is off."""
        self._output = ended

    def all_off(self, board: Board) -> None:
        """Switch everything off, as a reset does."""
        self.further.clear()
        self.follow(board)


def _squeezed(name: str) -> str:
    """Return a name as the line reader of a board leaves it."""
    return "".join(name.upper().replace("/", "").split())


class Switches:
    """The switches on the status pins of the board's own port; a switch that is pressed at the begin does nothing.

    now_s: of the caller's clock, whichever it is.
    """

    def __init__(self, inputs: Sequence[Input]):
        self._letters = letters_of_own(inputs)
        self._contacts = [(entry, Debouncer(entry.debounce_ms / 1000)) for entry in inputs if entry.is_own]
        self._pressed: set[int | str] = set()

    @property
    def has_limits(self) -> bool:
        """Whether one of them is a limit switch."""
        return any(entry.act == "limit" for entry, _ in self._contacts)

    @property
    def letters(self) -> str:
        """The letters of those that only the sender acts on."""
        return "".join(letter for pin, letter in self._letters.items() if pin in self._pressed)

    def look(self, high: frozenset[int], now_s: float, board: Grbl) -> None:
        """Take the pins that are high now, and let the board act on each change."""
        for entry, debouncer in self._contacts:
            is_on = (entry.pin in high) == (entry.level == "high")
            changed = debouncer.look(is_on, now_s)
            if changed is not None:
                self._change(entry, changed, board)

    def _change(self, entry: Input, pressed: bool, board: Grbl) -> None:
        (self._pressed.add if pressed else self._pressed.discard)(entry.pin)
        pins = LIMITS if entry.act == "limit" else PINS_OF_ACTS.get(entry.act, "")
        for pin in pins:
            (board.press if pressed else board.release)(pin)
        if pressed and entry.act in BYTES_OF_ACTS:
            board.receive(BYTES_OF_ACTS[entry.act])
