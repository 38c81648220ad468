# SPDX-License-Identifier: LGPL-2.1-or-later
"""The virtual board: bytes in, bytes out, and time that passes only when it is told to.

The firmware is one program that waits here and there: for a line, for room in the planner, for the end
of a dwell. So is this one: `_program` is a generator, each `yield` a place where it waits. Real-time bytes
act at once, whatever the program is doing; a soft reset throws the program away and begins a new one.

    receive(bytes) ─┬─ real-time bytes ──► realtime.COMMANDS
                    └─ the rest ──► ring ──► line reader ──► _program ──► parser ──► axes (planner, steps)
    advance(dt_s) ──► the axes move, then the program goes on to its next place of waiting
"""

from __future__ import annotations

from collections.abc import Callable, Generator
from math import inf

from CNCStepper.errors import MachineRefusal
from CNCStepper.machine.profile import Machine
from CNCStepper.virtual.grbl import gcode_execute, report, system
from CNCStepper.virtual.grbl.axes import Axes
from CNCStepper.virtual.grbl.eeprom import Memory
from CNCStepper.virtual.grbl.error_codes import (
    ALARM_HARD_LIMIT,
    ALARM_HOMING_NOT_FOUND,
    ALARM_HOMING_RESET,
    ALARM_RESET_IN_MOTION,
    ALARM_SOFT_LIMIT,
    refused,
)
from CNCStepper.virtual.grbl.firmware import GRBL, Firmware
from CNCStepper.virtual.grbl.gcode_block import Parser
from CNCStepper.virtual.grbl.input_pins import DOOR, InputPins
from CNCStepper.virtual.grbl.overrides import Overrides
from CNCStepper.virtual.grbl.probe import Probe
from CNCStepper.virtual.grbl.realtime import ACTING, COMMANDS, FIRST_EXTENDED
from CNCStepper.virtual.grbl.serial_buffer import TOO_LONG, LineReader, RxRing
from CNCStepper.virtual.grbl.settings import HARD_LIMITS, HOMING, SOFT_LIMITS, Settings
from CNCStepper.virtual.grbl.spindle_control import Spindle
from CNCStepper.virtual.grbl.states import AT_REST, MOVING, State
from CNCStepper.virtual.grbl.suspend import Suspension
from CNCStepper.virtual.grbl.tool_change import ToolChange

Waiting = Generator[None, None, None]
LOCKED = "[MSG:'$H'|'$X' to unlock]"
MOMENT_S = 1e-9
STARTS_UP_S = 0.066  # of an ATmega328P as the Arduino Uno's fuses have it: 16 384 clocks and 65 ms
LIMIT_ALARMS = (ALARM_HARD_LIMIT, ALARM_SOFT_LIMIT)


class Grbl:
    """A board on a machine, with grbl 1.1h where no other firmware is given.

    `homing` sets $22 and so locks the machine at power-up.
    `probe_height_mm`: machine height of a plate that closes the probe's circuit at and below it.
    After ALARM:1 and ALARM:2 a status report is still answered, as the firmware's documents say.
    starts_up: the supply has just come back; the board hears nothing, and has not said its greeting.
    """

    def __init__(
        self,
        machine: Machine,
        *,
        homing: bool = False,
        probe_height_mm: float | None = None,
        firmware: Firmware = GRBL,
    ):
        self.firmware: Firmware = firmware
        self.memory: Memory = Memory(Settings(machine, homing, firmware), firmware)
        self.ring = RxRing(firmware.receive_bytes)
        self.reader = LineReader(firmware)
        self.axes = Axes(self.memory.settings)
        self.probe = Probe(probe_height_mm)
        self.inputs = InputPins()
        self.time_s = 0.0
        self.program_s = 0.0  # stands still while the machine is held
        self.state = State.ALARM if homing else State.IDLE
        self.flood = False
        self.starts_up = False
        self.on_step: Callable[[Grbl], None] | None = None  # told after each stretch of one pace
        self._output = bytearray()
        self._afterwards: Callable[[], None] | None = None
        self._running: Waiting
        self._begin()

    # -- the outside ---------------------------------------------------------------------------------

    def receive(self, data: bytes) -> None:
        """Take bytes from the wire; those that come while it starts up are lost."""
        if self.starts_up:
            return
        for part in filter(None, ACTING.split(data)):
            if part[0] in COMMANDS:
                COMMANDS[part[0]](self, part[0])
            elif part[0] < FIRST_EXTENDED:
                self.ring.put(part)

    def take_output(self) -> bytes:
        """Return what the board has sent since the last call."""
        output = bytes(self._output)
        self._output.clear()
        return output

    def advance(self, dt_s: float) -> None:
        """Let `dt_s` seconds pass, from one moment at which something changes to the next."""
        end_s = self.time_s + dt_s
        while (left_s := end_s - self.time_s) > MOMENT_S:
            self._step(min(left_s, max(self._until_change_s(), MOMENT_S)))

    @property
    def quiet(self) -> bool:
        """Whether the board only waits for bytes: nothing moves, no line is in hand."""
        at_rest = self.state in AT_REST or (self.suspension.stopped and self.suspension.restoring_s is None)
        busy = self.starts_up or self._obeying or self._afterwards
        return at_rest and not busy and self.ring.empty

    # -- what the modules of the board use -----------------------------------------------------------

    def send(self, line: str) -> None:
        """Print a line; messages as the firmware marks them."""
        if line.startswith("[MSG:"):
            line = f"[MSG:{self.firmware.message}{line.removeprefix('[MSG:')}"
        self._output += line.encode("ascii") + b"\r\n"

    def state_text(self) -> str:
        """Return the first field of the status report."""
        if self.state is State.HOLD:
            return f"Hold:{0 if self.suspension.stopped else 1}"
        if self.state is State.DOOR:
            return f"Door:{self.suspension.door_phase(ajar=DOOR in self.inputs.held)}"
        return self.state.value

    def pins(self) -> str:
        """Return the input pins that are on, as the status report names them."""
        on = set(self.axes.pressed_switches()) if self._has_switches else set()
        return self.inputs.letters(on | ({"P"} if self.probe.touches(self.axes) else set()))

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

    def wait(self, seconds: float) -> Waiting:
        """Wait while the program's clock runs, so that a hold lengthens the wait."""
        self._wake_s = self.program_s + seconds
        while self.program_s < self._wake_s - MOMENT_S:
            yield

    def alarm(self, code: int) -> None:
        """Enter the alarm state; after a limit nothing but a reset helps."""
        self.state = State.ALARM
        self.send(f"ALARM:{code}")
        if code in LIMIT_ALARMS:
            self.send("[MSG:Reset to continue]")
            self.critical = True

    def reach_limit(self) -> None:
        """A limit switch is on: where they are watched ($21), stop and lock until a reset."""
        watched = self.memory.settings.on(HARD_LIMITS) and self.state is not State.HOME
        if watched and not self.critical:
            self.fail(ALARM_HARD_LIMIT)

    def stop_at_once(self) -> None:
        """Stop the motors without a ramp, switch everything off and forget all moves."""
        self.axes.reset()
        self.spindle.switch(5, 0.0)
        self.flood = False

    def afterwards(self, action: Callable[[], None]) -> None:
        """Let `action` happen once the line in hand has been answered."""
        self._afterwards = action

    def pause(self) -> None:
        """Hold until cycle start, as `!` does."""
        self.suspension.hold(self)
        self.state = State.HOLD

    def sleep(self) -> None:
        """Switch everything off; only a reset wakes the machine, and it is locked then."""
        self.suspension.hold(self)
        self.suspension.switch_off(self)
        self.state = State.SLEEP
        self.send("[MSG:Sleeping]")

    @property
    def state_at_rest(self) -> State:
        """The state after moves, and after a jog while the tool is changed."""
        return State.TOOL if self.tool_change.pending else State.IDLE

    def finish_cycle(self) -> None:
        """Be idle again after moves."""
        self.state = self.state_at_rest
        self.override_motion()

    def end_tool_change(self) -> None:
        """Be idle after a change of tools, and read the lines that waited for its end."""
        self.tool_change.end(self.ring)
        self.state = State.IDLE

    def reset(self) -> None:
        """Do a soft reset: position and memory stay, but in motion the position is declared lost."""
        code = self._alarm_of_reset()
        self.stop_at_once()
        if code:
            self.alarm(code)
        if self._obeying:
            self.send("ok")  # the firmware leaves the line it was at as if it were done
        self._begin()

    def fail(self, code: int) -> None:
        """Raise ALARM:1 as a limit switch does, which stops dead, or ALARM:2 as a soft limit, after a ramp.

        While it homes it watches neither: there it is a switch that is not found, ALARM:9, and the board resets itself.
        """
        if self.state is State.HOME:
            self.break_homing(ALARM_HOMING_NOT_FOUND)
            return
        if code == ALARM_SOFT_LIMIT:
            self._running = self._stop_and_alarm()
            next(self._running)
            return
        self.stop_at_once()
        self._running = self._stand_still()
        self.alarm(code)

    def break_homing(self, code: int) -> None:
        """End a homing as the firmware does where it fails: an alarm, and a reset of its own."""
        self.stop_at_once()
        self.alarm(code)
        self.reset()

    def power_up(self) -> None:
        """Come back from a loss of supply: the place counts from 0 again, only the memory is kept.

        The boot loader waits for nobody then (it does after the reset pin), so that STARTS_UP_S is all the time lost:
        the least that a sender may count on.
        """
        self.stop_at_once()
        for axis in range(3):
            self.axes.set_position(axis, 0.0)
        self._output.clear()
        self.state = State.ALARM if self.memory.settings.on(HOMING) else State.IDLE
        self._begin(STARTS_UP_S)

    def sync_position(self) -> None:
        """Let the parser believe what the axes say."""
        self.parser.position = self.axes.position_mm

    def override_motion(self) -> None:
        """Hand the overrides to the planner; a jog, homing or a probing move runs at its own speed."""
        steady = self.state in (State.JOG, State.HOME) or self.probe.searching
        self.axes.override(100 if steady else self.overrides.feed, self.overrides.rapid)

    # -- inside --------------------------------------------------------------------------------------

    @property
    def _has_switches(self) -> bool:
        return self.memory.settings.on(HOMING) or self.memory.settings.on(HARD_LIMITS)

    def _begin(self, starts_up_s: float = 0.0) -> None:
        """Begin as after power-up or a reset."""
        self.ring.clear()
        self.reader.clear()
        self.parser = Parser(system_offset=list(self.memory.places[54]))
        self.overrides = Overrides()
        self.spindle = Spindle(self.memory.settings, self.overrides)
        self.suspension = Suspension()
        self.tool_change = ToolChange()
        self.status = report.StatusReport()
        self.probe.begin()
        self.critical = False
        self._obeying = False
        self._wake_s = 0.0
        self._afterwards = None
        self.axes.adopt_settings()
        self.sync_position()
        self.override_motion()
        self._running = self._program(starts_up_s)
        next(self._running)

    def _program(self, starts_up_s: float) -> Waiting:
        self.starts_up = starts_up_s > 0
        yield from self.wait(starts_up_s)
        self.starts_up = False
        self.send(f"\r\n{self.firmware.banner}")
        if self.state in (State.ALARM, State.SLEEP):
            self.state = State.ALARM
            self.send(LOCKED)
        else:
            self.state = State.IDLE
            yield from self.run_startup_lines()
        while True:
            line = None if self.tool_change.stops_reading else self.reader.next_line(self.ring)
            if line is None:
                self.start_cycle()
                yield
            else:
                yield from self._answer(line)

    def run_startup_lines(self) -> Waiting:
        """Run the stored start-up lines and print how they went."""
        for line in filter(None, self.memory.startup_lines):
            answer = yield from self._obey(line)
            self.send(f">{line}:{answer}")

    def _answer(self, line: str) -> Waiting:
        self._obeying = True
        answer = yield from self._obey(line)
        self._obeying = False
        self.send(answer)
        if self._afterwards:
            yield

    def _obey(self, line: str) -> Generator[None, None, str]:
        try:
            yield from self._carry_out(line)
        except MachineRefusal as refusal:
            return refusal.code
        return "ok"

    def _carry_out(self, line: str) -> Waiting:
        if line == TOO_LONG:
            raise refused(11)
        if line.startswith("$"):
            yield from system.run(self, line)
        elif line and self.state in (State.ALARM, State.JOG):
            raise refused(9)
        elif line:
            yield from gcode_execute.run(self, line)

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

    def _until_change_s(self) -> float:
        """Return the time until the planner may get room or the program's wait is over."""
        waits_s = self._wake_s - self.program_s
        wake_s = waits_s if waits_s > MOMENT_S and not self.suspension.active else inf
        return min(wake_s, self.axes.until_change_s) if self._moves else wake_s

    def _step(self, dt_s: float) -> None:
        self.time_s += dt_s
        self._move(dt_s)
        if self.on_step:
            self.on_step(self)
        if not self.suspension.active:
            self.program_s += dt_s
            next(self._running)
        if self._afterwards:
            action, self._afterwards = self._afterwards, None
            action()

    @property
    def _moves(self) -> bool:
        return self.state in MOVING or (self.suspension.active and not self.suspension.stopped)

    def _move(self, dt_s: float) -> None:
        if self._moves:
            self.axes.advance(dt_s)
            self._look_at_switches()
        if self.probe.searching:
            self.probe.watch(self.axes)
        if self.suspension.active:
            self.suspension.advance(self, dt_s)
        elif self.state in (State.RUN, State.JOG) and self.axes.idle:
            self.finish_cycle()

    def _look_at_switches(self) -> None:
        if self.memory.settings.on(HARD_LIMITS) and any(self.axes.pressed_switches()):
            self.reach_limit()

    def _stand_still(self) -> Waiting:
        while True:
            yield

    def _alarm_of_reset(self) -> int:
        if self.state is State.HOME:
            return ALARM_HOMING_RESET
        decelerating = self.suspension.active and not self.suspension.stopped
        return ALARM_RESET_IN_MOTION if self.state in MOVING or decelerating else 0
