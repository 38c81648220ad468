# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command lines that only CNCStepper controllers take, after the line reader: in capitals, without blanks.

$T=25000      the trial of a rate, pulses/s: ok, or error:90 where this computer cannot keep it
$L=AAADD      pulse letters of source system D, at the profile's interval and without ramps
$P=FLOOD      a relay on, by its name or that of its device; $P=-FLOOD off
$N=-X200      so many pulses of one axis, in the direction of the sign, with the planner's ramps
"""

from __future__ import annotations

import re
from collections.abc import Callable
from threading import Thread

from CNCStepper.control.pulses.pacing import Jitter
from CNCStepper.controllers.ended_output import Output
from CNCStepper.controllers.port_signals import Relays
from CNCStepper.controllers.pulse_axes import PulseAxes
from CNCStepper.errors import CNCStepperError, MachineRefusal, ProgramError
from CNCStepper.machine.profile import AXIS_NAMES, Machine
from CNCStepper.motion.signals.step_letters import MOVES, read_letters
from CNCStepper.safe_text import printable
from CNCStepper.virtual.grbl.alarms_and_errors import refused
from CNCStepper.virtual.grbl.board import Waiting
from CNCStepper.virtual.grbl.machine import Grbl
from CNCStepper.virtual.grbl.states import State

RATE_NOT_KEPT = "error:90"
PULSES = re.compile(r"([+-]?)([XYZ])(\d{1,7})")
TEST_SHARE = 0.25  # of an axis' top speed, where the profile has no speed of cuts
LONGEST_MESSAGE = 200
LOCKED = (State.ALARM, State.SLEEP, State.CHECK)


def message(text: str) -> str:
    """Return a message line of grbl, in the characters that its link carries."""
    letters = printable(text, LONGEST_MESSAGE).replace("µ", "u").replace("[", "(").replace("]", ")")
    return f"[MSG:{letters.encode('ascii', 'replace').decode('ascii')}]"


class MachineTestLines:
    """Carries them out on a board; each is answered as any other line."""

    def __init__(self, machine: Machine, output: Output, axes: PulseAxes, relays: Relays):
        self._machine, self._output, self._axes, self._relays = machine, output, axes, relays
        self._commands: dict[str, Callable[[Grbl, str], Waiting]] = {
            "$T=": self._try_rate,
            "$L=": self._play_letters,
            "$P=": self._switch_relay,
            "$N=": self._send_pulses,
        }
        self._trial: Thread | None = None

    def takes(self, line: str) -> bool:
        """Return whether a line is one of these."""
        return line[:3] in self._commands

    def run(self, board: Grbl, line: str) -> Waiting:
        """Carry a line out; raises MachineRefusal."""
        yield from self._commands[line[:3]](board, line[3:])

    def wait_for_trial(self) -> Waiting:
        """Wait until a trial has ended: a reset ends its line, not the trial."""
        while self._trial and self._trial.is_alive():
            yield

    def _try_rate(self, board: Grbl, text: str) -> Waiting:
        rate_hz = _number(text)
        if board.state is not State.IDLE or not self._axes.idle:
            raise refused(8)
        yield from self.wait_for_trial()
        ended: list[Jitter | CNCStepperError] = []
        self._trial = Thread(target=lambda: ended.append(_outcome(self._output, rate_hz)), daemon=True)
        self._trial.start()
        yield from self.wait_for_trial()
        jitter = ended[0]
        if isinstance(jitter, MachineRefusal):
            board.send(message(str(jitter)))
            what = "this computer cannot keep the rate"
            advice = "end other programs, or lower max_rate_mm_min in the machine's profile"
            raise MachineRefusal(RATE_NOT_KEPT, what, value=f"{rate_hz:g} pulses/s", advice=advice)
        if isinstance(jitter, CNCStepperError):
            raise jitter
        board.send(
            message(f"Trial {rate_hz:g} pulses/s late mean {jitter.mean_us:.1f} us worst {jitter.worst_us:.1f} us")
        )

    def _play_letters(self, board: Grbl, text: str) -> Waiting:
        if set(text) - set(MOVES):
            raise refused(3)
        self._require_unlocked(board)
        yield from self.wait_for_trial()
        board.start_cycle()
        while self._axes.is_full or not self._axes.moves.idle:
            yield
        try:
            for chunk in read_letters([text.encode("ascii")]):
                self._check_axes(int(chunk.step.max(initial=0)))
                self._axes.play(chunk.step.copy(), chunk.back.copy(), self._interval_s)
        except ProgramError as error:
            raise refused(3) from error
        board.parser.position = self._axes.mm_of(self._axes.planned_steps)
        board.start_cycle()

    def _switch_relay(self, board: Grbl, text: str) -> Waiting:
        on = not text.startswith("-")
        device = self._relays.device_of(text.removeprefix("-"))
        if device is None:
            names = ", ".join(self._relays.names)
            board.send(message(f"there is no relay {text}; there are {names}" if names else "there are no relays"))
            raise refused(3)
        if board.state in LOCKED and on:
            raise refused(9)
        if board.state in (State.RUN, State.JOG):
            yield from board.wait_for_stop()
        self._relays.switch(device, on, board)

    def _send_pulses(self, board: Grbl, text: str) -> Waiting:
        match = PULSES.fullmatch(text)
        if not match:
            raise refused(3)
        self._require_unlocked(board)
        axis = "XYZ".index(match[2])
        self._check_axes(1 << axis)
        yield from self.wait_for_trial()
        yield from board.wait_for_stop()
        count = int(match[3]) * (-1 if match[1] == "-" else 1)
        target = [steps * self._axes.step_mm(n) for n, steps in enumerate(self._axes.planned_steps)]
        target[axis] += count * self._axes.step_mm(axis)
        own = self._machine.axes[axis].max_rate_mm_min
        self._axes.line(target, min(self._machine.feed_mm_min or TEST_SHARE * own, own), rapid=False)
        board.parser.position = target
        board.start_cycle()

    @property
    def _interval_s(self) -> float:
        return self._machine.signals.interval_s

    def _check_axes(self, step: int) -> None:
        """Raise the refusal of pulses for an axis that is not there."""
        if any(step >> n & 1 and name not in self._machine.own_axes for n, name in enumerate(AXIS_NAMES)):
            raise refused(20)

    def _require_unlocked(self, board: Grbl) -> None:
        if board.state in LOCKED:
            raise refused(9)
        if board.state not in (State.IDLE, State.RUN):
            raise refused(8)


def _number(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        raise refused(2) from None
    if not 0 < value < 1e7:
        raise refused(3)
    return value


def _outcome(output: Output, rate_hz: float) -> Jitter | CNCStepperError:
    try:
        return output.trial(rate_hz)
    except CNCStepperError as error:
        return error
