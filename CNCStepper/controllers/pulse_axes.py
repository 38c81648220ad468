# SPDX-License-Identifier: LGPL-2.1-or-later
"""The axes of a board whose pulses are really sent: planned ahead of the played pulses, by a bounded time.

    line ──► moves (planned clock) ──pulses──► output (ring ──► port)
                 │<──── at most AHEAD_S ────────► │ played: position, speed, idle, held

Holds, and shares of the speed up to 1, act where pulses are played, so that they do not wait for what is queued. A
feed override above 100 % acts where they are planned: it is felt once what is queued then has been played.

Backlash is taken up in the wire text (`gcode/wire/backlash_compensation.py`) and not here; else it would be twice.
"""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Callable
from dataclasses import replace

import numpy as np

from CNCStepper.controllers.ended_output import EndedOutput, Output
from CNCStepper.machine.profile import Machine
from CNCStepper.motion.interpolation.dda_moves import DdaMoves
from CNCStepper.motion.interpolation.planner_moves import PlannerMoves
from CNCStepper.motion.planner.buffers import SEGMENT_PLACES, TICKS_PER_S, UNLIMITED
from CNCStepper.motion.planner.machine_limits import Limits
from CNCStepper.motion.signals.planned_pulses import MoveSource, PlannedPulses
from CNCStepper.virtual.grbl.planner import Axes
from CNCStepper.virtual.grbl.settings import Settings

AHEAD_S = 0.3  # of pulses appended: more than this process may sleep, less than a person waits for an override
AHEAD_MOVES = 32  # beside those in the planner: a sender counts all of them as not cut yet
BEGIN_AHEAD_S = 0.05  # at a begin: the blocks behind the first come now, and the planner must look at them
SLICE_S = 0.0025  # of planned time at once: few moves, so that AHEAD_MOVES is kept
NOTHING_QUEUED = ("idle", "failed")
AT_REST = (*NOTHING_QUEUED, "held")
MOST_SLICES = 2000  # at once

NewMoves = Callable[[Limits, tuple[int, ...]], MoveSource]


def moves_of(machine: Machine) -> NewMoves:
    """Return what makes the moves of a profile, by its `interpolation`."""
    if machine.interpolation == "planner":
        return PlannerMoves
    return lambda limits, steps: DdaMoves(limits, steps, published=machine.interpolation == "published")


def most_moves(look_ahead_blocks: int) -> int:
    """Return the largest number of moves under way, as reported by `$I`."""
    return look_ahead_blocks + SEGMENT_PLACES + AHEAD_MOVES


def load_kernels(machine: Machine) -> None:
    """Make a move that nobody plays, so that the first one of a program does not wait for kernels."""
    moves = moves_of(machine)(Limits.of(machine), (0, 0, 0))
    moves.line([1.0, 0.0, 0.0], machine.axes[0].max_rate_mm_min, rapid=True)
    if isinstance(moves, DdaMoves):
        moves.arc([0.0, 1.0, 0.0], (0.0, 0.0), 1.0, False, machine.axes[0].max_rate_mm_min)
    while not moves.idle:
        moves.make(SLICE_S)


class PulseAxes(Axes):
    """The machine's position by the played pulses, and the next pulses to play.

    Its time is that of the output; `advance` only sees to it that enough is queued there.
    """

    def __init__(self, settings: Settings, output: Output, new_moves: NewMoves = PlannerMoves):
        super().__init__(settings)
        self._output = output
        self._waiting: deque[PlannedPulses] = deque()  # made, and the output has had no room
        self._holding = False
        self._dropping = False  # a reset that has not come to its end
        self._ahead_s = BEGIN_AHEAD_S
        self._begins: deque[tuple[int, int]] = (
            deque()
        )  # the first pulse of each move that is not played, and its number
        self._appended = output.sent  # pulses, counted as the output counts those that it has played
        self._forgotten = 0  # the number of the newest move that a reset has forgotten
        self._answered: deque[int] = deque()  # the newest move at each answered line that is not known to be made
        self._has_letters = False  # among what is queued: their pulses have no moves of their own
        self._last_tick = 0
        self._shift = 0  # ticks by which the planner's clock is behind
        limits = self._limits()
        self._most_moves = most_moves(limits.look_ahead_blocks)
        self._moves = new_moves(limits, self.position_steps)

    @property
    def room(self) -> int:
        """Free blocks of the planner."""
        return self._moves.room

    @property
    def free_blocks(self) -> int:
        """How many more moves could be under way, planned or not, which a sender counts as not cut yet."""
        return max(0, self._most_moves - self._unplayed())

    @property
    def queued_lines(self) -> int:
        """How many of the answered lines are not made to their last pulse."""
        if self.idle:
            self._answered.clear()
            self._has_letters = False
        made = -1 if self._has_letters else self._moves.last_move - self._unplayed()
        while self._answered and self._answered[0] <= made:
            self._answered.popleft()
        return len(self._answered)

    def note_answer(self) -> None:
        """Note that a line is answered, of which all moves are queued."""
        self._answered.append(self._moves.last_move)

    @property
    def moves(self) -> MoveSource:
        """What makes the pulses."""
        return self._moves

    @property
    def idle(self) -> bool:
        """Whether every pulse of every move has been played."""
        return self._moves.idle and not self._waiting and not self._dropping and self._output.state in NOTHING_QUEUED

    @property
    def stopped(self) -> bool:
        """Whether nothing moves: all is played, or a hold has come to its end."""
        return self._output.state == "held" or self.idle or (self._holding and self._output.state in NOTHING_QUEUED)

    @property
    def until_change_s(self) -> float:
        """Time until there may be room: none is foretold, the board looks again at its next step."""
        return math.inf

    @property
    def rate_mm_min(self) -> float:
        """The speed along the path."""
        return self._output.rate_mm_min

    @property
    def position_steps(self) -> tuple[int, ...]:
        """Machine position in steps, by the pulses that were played."""
        return (*self._output.position_steps, 0, 0, 0)[:3]

    @property
    def is_full(self) -> bool:
        """Whether pulses wait for room in the output."""
        return bool(self._waiting)

    @property
    def planned_steps(self) -> tuple[int, ...]:
        """Where the axes will be, once no move is left in the planner."""
        return self._moves.end_steps

    def line(self, target_mm: list[float], feed_mm_min: float, rapid: bool) -> None:
        """Queue a straight move; there must be room."""
        self._moves.line(target_mm, feed_mm_min, rapid)

    def play(self, step: np.ndarray, back: np.ndarray, interval_s: float) -> None:
        """Queue pulses (masks as in `PlannedPulses`) at one interval, without ramps; the planner must be idle."""
        interval = round(interval_s * TICKS_PER_S)
        count = len(step)
        ticks = self._last_tick + interval * np.arange(1, count + 1)
        speed = min(map(self.step_mm, range(3))) / interval_s
        speeds, limits = (np.full(count, value, np.float32) for value in (speed, UNLIMITED))
        move = np.full(count, self._moves.last_move)
        self._waiting.append(PlannedPulses(ticks, step, back, speeds, limits, np.zeros(count, bool), move))
        self._last_tick = int(ticks[-1])
        self._has_letters = True
        self._shift += interval * count
        bits = np.arange(3)
        forward, backward = ((mask[:, None] >> bits & 1).sum(axis=0) for mask in (step & ~back, back))
        self._moves.stand_at(tuple((np.array(self.planned_steps) + forward - backward).tolist()), self._limits())

    def lose_output(self, ended: EndedOutput) -> None:
        """Let nothing move any more: the output has ended."""
        self._output = ended
        self._holding = self._dropping = False
        self._forget()

    def advance(self, dt_s: float) -> None:
        """See to it that the output has pulses for the next moments."""
        moving = self._output.state != "idle"
        self._ahead_s = min(self._ahead_s + dt_s, AHEAD_S) if moving else BEGIN_AHEAD_S
        if not self._holding or self._output.state == "hold":
            self._feed()

    def hold(self) -> None:
        """Begin to slow down to a stop on the path."""
        self._holding = True
        self._output.hold()

    def resume(self) -> None:
        """Go on after a hold."""
        if self._holding:
            self._holding = False
            self._output.resume()

    def reset(self) -> None:
        """Forget all moves; axes that still move are stopped without a ramp and lose steps."""
        if self._output.state not in AT_REST:
            self._output.stop_at_once()
        self._holding, self._dropping = False, True
        self.tend()

    def pressed_switches(self) -> list[str]:
        """Return none: switches are read where they are, and not guessed from positions."""
        return []

    def override(self, feed_percent: int, rapid_percent: int) -> None:
        """Change the speeds; up to 100 % at once, above it for moves that are not planned yet."""
        self._moves.quicken(max(feed_percent, 100) / 100)
        self._output.share(min(feed_percent, 100) / 100, rapid_percent / 100)

    def tend(self) -> bool:
        """Finish a reset once the output is at rest; return whether it was finished now. To be called again and again.

        Up to then the position is not known for good: pulses that were being written are still played.
        """
        if not self._dropping or self._output.state not in AT_REST:
            return False
        self._dropping = False
        self._output.drop()
        self._output.resume()
        self._forget()
        return True

    def _feed(self) -> None:
        for _ in range(MOST_SLICES):
            if self._output.queued_s >= self._ahead_s or not self._append():
                return
            if self._moves.idle or self._made_moves() >= AHEAD_MOVES:
                return
            self._waiting += map(self._shifted, self._moves.make(SLICE_S))
        self._append()

    def _append(self) -> bool:
        """Give the output what waits; returns False where it has no room for all."""
        while self._waiting:
            pulses = self._waiting.popleft()
            count = min(self._output.room, len(pulses))
            if count:
                self._give(pulses.cut(0, count))
            if count < len(pulses):
                self._waiting.appendleft(pulses.cut(count, len(pulses)))
                return False
        return True

    def _give(self, pulses: PlannedPulses) -> None:
        newest = self._begins[-1][1] if self._begins else 0
        for row in np.flatnonzero(np.diff(pulses.move, prepend=newest)).tolist():
            self._begins.append((self._appended + row, int(pulses.move[row])))
        self._appended += len(pulses)
        self._output.append(*pulses.columns)

    def _made_moves(self) -> int:
        """Return how many moves have pulses that were made and are not all played."""
        sent = self._output.sent
        while len(self._begins) > 1 and self._begins[1][0] <= sent:
            self._begins.popleft()
        return self._begins[-1][1] - self._begins[0][1] + 1 if self._begins else 0

    def _unplayed(self) -> int:
        """Return how many moves were queued and are not played to their end."""
        if self.idle:
            return 0
        self._made_moves()
        oldest = self._begins[0][1] if self._begins else self._forgotten + 1
        return self._moves.last_move - oldest + 1

    def _shifted(self, pulses: PlannedPulses) -> PlannedPulses:
        """Return pulses of the planner behind those that were played between its moves."""
        shifted = replace(pulses, ticks=pulses.ticks + self._shift)
        self._last_tick = int(shifted.ticks[-1])
        return shifted

    def _forget(self) -> None:
        self._clear()
        self._moves.stand_at(self.position_steps, self._limits())

    def _clear(self) -> None:
        self._waiting.clear()
        self._begins.clear()
        self._answered.clear()
        self._appended, self._forgotten = self._output.sent, self._moves.last_move

    def _stand_at(self, steps: tuple[int, ...]) -> None:
        self.declared += 1
        for axis, (there, here) in enumerate(zip(steps, self.position_steps, strict=True)):
            if there != here:
                self._output.declare(axis, there)
        self._clear()
        self._moves.stand_at(steps, self._limits())
