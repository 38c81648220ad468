# SPDX-License-Identifier: LGPL-2.1-or-later
"""The board as the modules of its firmware use it: its parts, its output, and where it waits for its axes.

What a line or a real-time byte does is told above, in the modules that change a `Board`; which of them is called, and
how time passes, is told by the machine, which is the one kind of board there is.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Generator

import numpy as np

from CNCStepper.machine.profile import Machine
from CNCStepper.motion.planner.arc_segments import arc_points
from CNCStepper.virtual.grbl.alarms_and_errors import ALARM_HARD_LIMIT, ALARM_SOFT_LIMIT
from CNCStepper.virtual.grbl.firmware import Firmware
from CNCStepper.virtual.grbl.gcode.block import FIRST_PLANE, Block, Parser
from CNCStepper.virtual.grbl.input_pins import DOOR, PINS, InputPins
from CNCStepper.virtual.grbl.occasional_fields import OccasionalFields
from CNCStepper.virtual.grbl.overrides import Overrides
from CNCStepper.virtual.grbl.planner import Axes
from CNCStepper.virtual.grbl.probe import Probe
from CNCStepper.virtual.grbl.serial_buffer import LineReader, RxRing
from CNCStepper.virtual.grbl.settings import ARC_TOLERANCE, HARD_LIMITS, HOMING, SOFT_LIMITS, Eeprom, Settings
from CNCStepper.virtual.grbl.spindle_control import Spindle
from CNCStepper.virtual.grbl.states import State, SuspendState
from CNCStepper.virtual.grbl.tool_change import ToolChange

Waiting = Generator[None, None, None]
MOMENT_S = 1e-9
LIMIT_ALARMS = (ALARM_HARD_LIMIT, ALARM_SOFT_LIMIT)


class Board(ABC):
    """The parts of a board and their interaction; see `Grbl` for the parameters. It begins with `forget`."""

    pin_names: tuple[str, ...] = tuple(PINS)

    def __init__(
        self,
        machine: Machine,
        homing: bool,
        probe_height_mm: float | None,
        firmware: Firmware,
        axes: Callable[[Settings], Axes],
    ):
        self.firmware: Firmware = firmware
        self.memory: Eeprom = Eeprom(Settings(machine, homing, firmware), firmware)
        self.ring = RxRing(firmware.receive_bytes)
        self.reader = LineReader(firmware)
        self.axes: Axes = axes(self.memory.settings)
        self.probe = Probe(probe_height_mm)
        self.inputs = InputPins()
        self.program_s = 0.0  # stands still while the machine is held
        self.state = State.ALARM if homing else State.IDLE
        self.flood = self.mist = False
        self.outputs: set[int] = set()  # digital outputs that are on
        self._output = bytearray()

    def forget(self) -> None:
        """Forget what no reset keeps: lines that wait, modal words, overrides, holds."""
        self.ring.clear()
        self.reader.clear()
        self.parser = Parser(system_offset=list(self.memory.places[54]))
        self.overrides = Overrides()
        self.spindle = Spindle(self.memory.settings, self.overrides)
        self.suspension = SuspendState()
        self.tool_change = ToolChange()
        self.status = OccasionalFields()
        self.probe.begin()
        self.critical = False
        self._wake_s = 0.0
        self._afterwards: Callable[[], None] | None = None
        self.axes.adopt_settings()
        self.sync_position()
        self.override_motion()

    @abstractmethod
    def reset(self) -> None:
        """Do a soft reset: position and memory stay, but in motion the position is declared lost."""

    @abstractmethod
    def run_startup_lines(self) -> Waiting:
        """Run the stored start-up lines and print how they went."""

    # -- what it says --------------------------------------------------------------------------------

    def send(self, line: str) -> None:
        """Print a line; messages as the firmware marks them."""
        if line.startswith("[MSG:"):
            line = f"[MSG:{self.firmware.message}{line.removeprefix('[MSG:')}"
        self._output += line.encode("ascii") + b"\r\n"

    def take_output(self) -> bytes:
        """Return what the board has sent since the last call."""
        output = bytes(self._output)
        self._output.clear()
        return output

    def state_text(self) -> str:
        """Return the first field of the status report."""
        if self.state is State.HOLD:
            return f"Hold:{0 if self.suspension.stopped else 1}"
        if self.state is State.DOOR:
            return f"Door:{self.suspension.door_phase(ajar=DOOR in self.inputs.held)}"
        return self.state.value

    def own_fields(self) -> list[str]:
        """Return fields of the status report that grbl does not have; grbl's own board has none."""
        return []

    def pins(self) -> str:
        """Return the input pins that are on, as the status report names them."""
        on = set(self.axes.pressed_switches()) if self._has_switches else set()
        return self.inputs.letters(on | ({"P"} if self.probe.touches(self.axes) else set()))

    def alarm(self, code: int) -> None:
        """Enter the alarm state; after a limit nothing but a reset helps."""
        self.state = State.ALARM
        self.send(f"ALARM:{code}")
        if code in LIMIT_ALARMS:
            self.send("[MSG:Reset to continue]")
            self.critical = True

    # -- its moves -----------------------------------------------------------------------------------

    def start_cycle(self) -> None:
        """Begin to move where moves wait and nothing speaks against it."""
        if self.state is State.IDLE and not self.axes.idle:
            self.state = State.RUN

    def wait_for_stop(self) -> Waiting:
        """Wait until every move that was queued has been made."""
        self.start_cycle()
        while not self.axes.idle or self.state is State.RUN:
            yield

    def queue(self, target_mm: list[float], feed_mm_min: float, rapid: bool = False) -> Waiting:
        """Queue a straight move, machine coordinates, once the planner has room for it."""
        if self.memory.settings.on(SOFT_LIMITS) and self.state is not State.JOG:
            yield from self._check_soft_limits(target_mm)
        if self.state is State.CHECK:
            return
        while not self.axes.room:
            self.start_cycle()
            yield
        yield from self.wait(self.firmware.planning_s)
        self.axes.line(target_mm, feed_mm_min, rapid)

    def queue_arc(self, block: Block, begin_mm: list[float]) -> Waiting:
        """Queue an arc from `begin_mm` to the block's target as its chords, one block of the planner each."""
        modal, begin = block.modal, np.array(begin_mm)
        centre = (begin + block.centre).astype(np.float32)
        plane, tolerance_mm = modal.plane - FIRST_PLANE, self.memory.settings[ARC_TOLERANCE]
        points = arc_points(begin, np.array(block.target), centre, modal.motion, plane, 1, tolerance_mm)
        # in G93 the firmware multiplies F by the number of chords and then takes it for mm/min
        feed = block.feed * len(points) if modal.feed_mode == 93 else block.feed
        for point in points.tolist():
            yield from self.queue(point, feed)

    def wait(self, seconds: float) -> Waiting:
        """Wait while the program's clock runs, so that a hold lengthens the wait."""
        self._wake_s = self.program_s + seconds
        while self.program_s < self._wake_s - MOMENT_S:
            yield

    @property
    def state_at_rest(self) -> State:
        """The state after moves, and after a jog while the tool is changed."""
        return State.TOOL if self.tool_change.pending else State.IDLE

    def finish_cycle(self) -> None:
        """Be idle again after moves."""
        self.state = self.state_at_rest
        self.override_motion()

    def stop_at_once(self) -> None:
        """Stop the motors without a ramp, switch everything off and forget all moves."""
        self.axes.reset()
        self.spindle.switch(5, 0.0)
        self.flood = self.mist = False
        self.outputs.clear()

    def sync_position(self) -> None:
        """Let the parser believe what the axes say."""
        self.parser.position = self.axes.position_mm

    def override_motion(self) -> None:
        """Hand the overrides to the planner; a jog, homing or a probing move runs at its own speed."""
        steady = self.state in (State.JOG, State.HOME) or self.probe.searching
        self.axes.override(100 if steady else self.overrides.feed, self.overrides.rapid)

    # -- what ends -----------------------------------------------------------------------------------

    def afterwards(self, action: Callable[[], None]) -> None:
        """Let `action` happen once the line in hand has been answered."""
        self._afterwards = action

    def break_homing(self, code: int) -> None:
        """End a homing as the firmware does where it fails: an alarm, and a reset of its own."""
        self.stop_at_once()
        self.alarm(code)
        self.reset()

    def end_tool_change(self) -> None:
        """Be idle after a change of tools, and read the lines that waited for its end."""
        self.tool_change.end(self.ring)
        self.state = State.IDLE

    # -- inside --------------------------------------------------------------------------------------

    @property
    def _has_switches(self) -> bool:
        return self.memory.settings.on(HOMING) or self.memory.settings.on(HARD_LIMITS)

    def _check_soft_limits(self, target_mm: list[float]) -> Waiting:
        """Stop with an alarm where a target lies outside; never comes back then."""
        if self.memory.settings.outside_travel(target_mm):
            yield from self._stop_and_alarm()

    def _stop_and_alarm(self) -> Waiting:
        """Come to a controlled stop and raise the alarm of the soft limits; never comes back."""
        if self.state is State.RUN:
            self.axes.hold()
            while not self.axes.stopped:
                yield
        self.stop_at_once()
        self.alarm(ALARM_SOFT_LIMIT)
        while True:
            yield
