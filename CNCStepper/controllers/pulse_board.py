# SPDX-License-Identifier: LGPL-2.1-or-later
"""The board of a machine without a controller: grbl 1.1h in Python, with pulses in place of simulated axes.

It differs from grbl where the machine does: no homing, no probe, relays for spindle, coolant and M62 to M65, switches
on the port's own status pins, and the lines of `own_command_lines.py`. A machine without Z reports Z as 0 and refuses
moves of it. Where the output ends by itself, the position is lost as by a reset in motion: a message, and ALARM:3.
"""

from __future__ import annotations

from collections.abc import Callable, Generator
from contextlib import suppress
from dataclasses import replace

from CNCStepper.controllers.ended_output import EndedOutput, Output
from CNCStepper.controllers.own_command_lines import LOCKED, MachineTestLines, message
from CNCStepper.controllers.port_signals import Relays, Switches
from CNCStepper.controllers.pulse_axes import PulseAxes, most_moves, moves_of
from CNCStepper.errors import CNCStepperError, LinkError, MachineRefusal, Text
from CNCStepper.machine.controller_family import family_of
from CNCStepper.machine.profile import AXIS_NAMES, Machine
from CNCStepper.motion.interpolation.dda_moves import DdaMoves
from CNCStepper.virtual.grbl.alarms_and_errors import ALARM_RESET_IN_MOTION, refused
from CNCStepper.virtual.grbl.board import Waiting
from CNCStepper.virtual.grbl.firmware import GRBL, Firmware
from CNCStepper.virtual.grbl.gcode.block import ARC_CW, Block
from CNCStepper.virtual.grbl.machine import Grbl
from CNCStepper.virtual.grbl.planner import Axes
from CNCStepper.virtual.grbl.probe import Probe
from CNCStepper.virtual.grbl.settings import HARD_LIMITS, SOFT_LIMITS
from CNCStepper.virtual.grbl.states import State

CANNOT = ("home", "probe")
INVERSE_TIME, XY_PLANE = 93, 17
ALLOWED_WHEN_ENDED = ("$$", "$G", "$#", "$I", "$N")


class NoProbe(Probe):
    """A probe that is not there: a probing move ends in an alarm before it begins."""

    def await_change(self, axes: Axes, away: bool) -> bool:
        """Return that the pin is not as the move wants it."""
        return False


class PulseBoard(Grbl):
    """A board that moves a machine through an output, on the caller's clock.

    Call `advance` about every 2 ms while it moves. Raises MachineRefusal for a machine with a laser.
    """

    axes: PulseAxes

    def __init__(self, machine: Machine, output: Output):
        if machine.spindle.laser:
            raise MachineRefusal(
                "laser-pulses",
                Text("{machine} has a laser, whose beam would not be in time with its moves", machine=machine.name),
                advice="drive a laser by a controller with grbl's laser mode",
            )
        self._machine, self._player = machine, output
        self._relays, self._switches = Relays(machine, output), Switches(machine.input)
        self._has_ended = False
        super().__init__(
            machine,
            firmware=firmware_of(machine, self._relays),
            axes=lambda settings: PulseAxes(settings, output, moves_of(machine)),
        )
        self.probe = NoProbe(None)
        self._tests = MachineTestLines(machine, output, self.axes, self._relays)
        if self._switches.has_limits:
            self.memory.settings.values[HARD_LIMITS] = 1.0

    @property
    def quiet(self) -> bool:
        """Whether it only waits for bytes: nothing moves, no line is in hand."""
        return super().quiet and self.axes.stopped

    @property
    def at_rest(self) -> bool:
        """Whether no axis moves."""
        return self.axes.stopped

    def receive(self, data: bytes) -> None:
        """Take bytes from the sender."""
        self._unless_ended(lambda: self._take(data))

    def pins(self) -> str:
        """Return the input pins that are on, as the status report names them."""
        return super().pins() + self._switches.letters

    def own_fields(self) -> list[str]:
        """Return how many answered lines are not made yet; of a parallel port the pins and relays that are on too."""
        fields = [] if self.state in LOCKED else [f"Queue:{self.axes.queued_lines}"]
        if family_of(self._machine) == "parport":
            high = ",".join(map(str, sorted(self._player.inputs())))
            fields += [f"In:{high}", f"Out:{','.join(sorted(self._relays.on))}"]
        return fields

    def stop_at_once(self) -> None:
        """Stop the motors without a ramp where they move, switch everything off and forget all moves."""
        super().stop_at_once()
        self._relays.all_off(self)

    def come_to_rest(self) -> None:
        """Begin to brake, whatever moves, for the end of the process."""
        if not self.axes.stopped:
            self.receive(b"!")

    def close(self) -> None:
        """Switch everything off and end the output."""
        self._unless_ended(self.stop_at_once)
        self._player.close()

    # -- moves ---------------------------------------------------------------------------------------

    def queue(self, target_mm: list[float], feed_mm_min: float, rapid: bool = False) -> Waiting:
        """Queue a straight move once there is room; raises MachineRefusal where it needs an axis that is not there."""
        self._check_axes(target_mm)
        yield from self._tests.wait_for_trial()
        yield from super().queue(target_mm, feed_mm_min, rapid)

    def queue_arc(self, block: Block, begin_mm: list[float]) -> Waiting:
        """Queue an arc: whole where the thesis's interpolator makes it, else as its chords."""
        moves, modal = self.axes.moves, block.modal
        is_plain = modal.feed_mode != INVERSE_TIME and not self.memory.settings.on(SOFT_LIMITS)
        can_be_whole = isinstance(moves, DdaMoves) and moves.takes_arc(block.target, modal.plane - XY_PLANE)
        if not can_be_whole or not is_plain or self.state is State.CHECK:
            yield from super().queue_arc(block, begin_mm)
            return
        assert isinstance(moves, DdaMoves)
        self._check_axes(block.target)
        while not moves.room:
            self.start_cycle()
            yield
        centre = [begin_mm[axis] + block.centre[axis] for axis in (0, 1)]
        moves.arc(block.target, centre, block.radius, modal.motion == ARC_CW, block.feed)

    # -- inside --------------------------------------------------------------------------------------

    def _execute_command(self, line: str) -> Generator[None, None, str]:
        answer = yield from super()._execute_command(line)
        self.axes.note_answer()  # before the answer goes out
        return answer

    def _carry_out(self, line: str) -> Waiting:
        if self._has_ended and line not in ALLOWED_WHEN_ENDED:
            raise refused(9)
        if line.startswith("$H") or (line.startswith("$22=") and line != "$22=0"):
            raise refused(5)
        if self._tests.takes(line):
            yield from self._tests.run(self, line)
        else:
            yield from super()._carry_out(line)

    def _step(self, dt_s: float) -> None:
        self._unless_ended(lambda: self._act(dt_s))

    def _take(self, data: bytes) -> None:
        super().receive(data)
        self._relays.follow(self)  # before time passes: what comes back behind a door is waited for

    def _act(self, dt_s: float) -> None:
        self._player.check()
        if self.axes.tend():
            self.sync_position()
        self._switches.look(self._player.inputs(), self.time_s, self)
        super()._step(dt_s)
        self._relays.follow(self)

    def _unless_ended(self, action: Callable[[], None]) -> None:
        """Do something with the output; where that has ended by itself, say why and be locked."""
        try:
            action()
        except LinkError as error:
            self._end(error)

    def _end(self, error: LinkError) -> None:
        self._has_ended = True
        ended = EndedOutput(self.axes.position_steps)
        with suppress(CNCStepperError):
            self._player.close()
        self._player = ended
        self._relays.lose_output(ended)
        self.axes.lose_output(ended)
        self.stop_at_once()
        self._running = self._stand_still()
        self.send(message(str(error)))
        self.alarm(ALARM_RESET_IN_MOTION)

    def _check_axes(self, target_mm: list[float]) -> None:
        for axis, name in enumerate(AXIS_NAMES):
            moves = abs(target_mm[axis] - self.parser.position[axis]) > self.axes.step_mm(axis) / 2
            if moves and name not in self._machine.own_axes:
                raise refused(20)


def firmware_of(machine: Machine, relays: Relays) -> Firmware:
    """Return the firmware of a CNCStepper board, as reported by `$I`."""
    blocks = most_moves(machine.planner.look_ahead_blocks)
    lacks = tuple(f"axis-{axis}" for axis in AXIS_NAMES if axis not in machine.own_axes)
    own = (f"[FIRMWARE:CNCStepper {family_of(machine)}]", *(f"[CANNOT:{what}]" for what in (*CANNOT, *lacks)))
    return replace(
        GRBL,
        build=(GRBL.build[0], f"[OPT:V,{blocks},{GRBL.receive_bytes}]", *own),
        mist="mist" in relays.wired,
        digital_outputs=relays.digital_outputs,
        planning_s=0.0,
    )
