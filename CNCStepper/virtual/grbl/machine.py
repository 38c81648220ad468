# SPDX-License-Identifier: LGPL-2.1-or-later
"""The virtual board: bytes in, bytes out; its time passes only when it is advanced.

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
from CNCStepper.virtual.grbl import suspend, system
from CNCStepper.virtual.grbl.alarms_and_errors import (
    ALARM_HARD_LIMIT,
    ALARM_HOMING_NOT_FOUND,
    ALARM_HOMING_RESET,
    ALARM_RESET_IN_MOTION,
    ALARM_SOFT_LIMIT,
    refused,
)
from CNCStepper.virtual.grbl.board import MOMENT_S, Board, Waiting
from CNCStepper.virtual.grbl.firmware import GRBL, Firmware
from CNCStepper.virtual.grbl.gcode import execute
from CNCStepper.virtual.grbl.input_pins import LIMITS, PIN_BYTES, PROBE
from CNCStepper.virtual.grbl.planner import Axes, SimulatedAxes
from CNCStepper.virtual.grbl.realtime import ACTING, COMMANDS, FIRST_EXTENDED
from CNCStepper.virtual.grbl.serial_buffer import TOO_LONG
from CNCStepper.virtual.grbl.settings import HARD_LIMITS, HOMING, Settings
from CNCStepper.virtual.grbl.states import AT_REST, MOVING, State

LOCKED = "[MSG:'$H'|'$X' to unlock]"
STARTS_UP_S = 0.066  # of an ATmega328P as the Arduino Uno's fuses have it: 16 384 clocks and 65 ms


class Grbl(Board):
    """A board on a machine, with grbl 1.1h where no other firmware is given.

    `homing` sets $22 and so locks the machine at power-up.
    `probe_height_mm`: machine height of a plate that closes the probe's circuit at and below it.
    After ALARM:1 and ALARM:2 a status report is still answered, as the firmware's documents say.
    axes: what moves, made from the board's settings.
    starts_up: the supply has just come back; the board hears nothing, and has not said its greeting.
    """

    def __init__(
        self,
        machine: Machine,
        *,
        homing: bool = False,
        probe_height_mm: float | None = None,
        firmware: Firmware = GRBL,
        axes: Callable[[Settings], Axes] = SimulatedAxes,
    ):
        super().__init__(machine, homing, probe_height_mm, firmware, axes)
        self.time_s = 0.0
        self.starts_up = False
        self.on_step: Callable[[Grbl], None] | None = None  # told after each stretch of one pace
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

    def advance(self, dt_s: float) -> None:
        """Let `dt_s` seconds pass, from one moment at which something changes to the next."""
        end_s = self.time_s + dt_s
        while (left_s := end_s - self.time_s) > MOMENT_S:
            self._step(min(left_s, max(self._until_change_s(), MOMENT_S)))

    @property
    def quiet(self) -> bool:
        """Whether the board only waits for bytes: nothing moves, no line is in hand."""
        at_rest = self.state in AT_REST or (self.suspension.stopped and self.suspension.restoring_s is None)
        busy = self.starts_up or self._executing or self._afterwards
        return at_rest and not busy and self.ring.empty

    # -- what happens to it --------------------------------------------------------------------------

    def press(self, pin: str) -> None:
        """Switch an input pin on; raises MachineRefusal where there is none of that name."""
        if not self.inputs.press(pin):
            return
        self.probe.held = PROBE in self.inputs.held
        if pin in PIN_BYTES:
            self.receive(PIN_BYTES[pin])
        elif pin in LIMITS:
            self.reach_limit()

    def release(self, pin: str) -> None:
        """Switch an input pin off."""
        self.inputs.release(pin)
        self.probe.held = PROBE in self.inputs.held

    def reach_limit(self) -> None:
        """A limit switch is on: where they are watched ($21), stop and lock until a reset."""
        watched = self.memory.settings.on(HARD_LIMITS) and self.state is not State.HOME
        if watched and not self.critical:
            self.fail(ALARM_HARD_LIMIT)

    def reset(self) -> None:
        """Do a soft reset: position and memory stay, but in motion the position is declared lost."""
        code = self._alarm_of_reset()
        self.stop_at_once()
        if code:
            self.alarm(code)
        if self._executing:
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

    # -- inside --------------------------------------------------------------------------------------

    def _begin(self, starts_up_s: float = 0.0) -> None:
        """Begin as after power-up or a reset."""
        self.forget()
        self._executing = False
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
            answer = yield from self._execute_command(line)
            self.send(f">{line}:{answer}")

    def _answer(self, line: str) -> Waiting:
        self._executing = True
        answer = yield from self._execute_command(line)
        self._executing = False
        self.send(answer)
        if self._afterwards:
            yield

    def _execute_command(self, line: str) -> Generator[None, None, str]:
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
            yield from execute.run(self, line)

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
            suspend.advance(self, dt_s)
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
