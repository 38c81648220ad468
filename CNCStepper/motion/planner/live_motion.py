# SPDX-License-Identifier: LGPL-2.1-or-later
"""`Motion`: the controller's planner and step generator as a live object with a clock of its own.

It plans and steps through the same kernels as `plan.py`. Blocks are taken up as they come: motion begins
with the first, and where the blocks come too slowly the axes brake and stop, as on the controller.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from CNCStepper.errors import MachineRefusal
from CNCStepper.kernels import bare
from CNCStepper.motion.planner import stepper_interrupt
from CNCStepper.motion.planner.buffers import TICKS_PER_S, new_planner
from CNCStepper.motion.planner.look_ahead import push_line, set_overrides
from CNCStepper.motion.planner.machine_limits import Limits
from CNCStepper.motion.planner.step_timeline import ends, step_table
from CNCStepper.units import mm_min_from_mm_s, mm_s_from_mm_min

RECORD_ROWS = 1024


class Motion:
    """A planner and the axes behind it.

    position_steps: where the axes stand at the begin (0 when left out), one value an axis.
    record: keep the path that the axes take, for `path()`, `step_path()` and `segments()`.
    """

    def __init__(self, limits: Limits, position_steps: Sequence[int] | None = None, record: bool = False):
        self.limits = limits
        planner = new_planner(limits, (0.0,) * limits.axes)
        if position_steps is not None:
            planner.position[:] = position_steps
        idle_ticks = round(limits.idle_delay_s * TICKS_PER_S)
        self._runner = bare(stepper_interrupt.new_runner(planner, idle_ticks, RECORD_ROWS if record else 0))
        self._clockwork = self._runner.clockwork[0]
        self._queue, self._ramp = self._runner.planner.queue[0], self._runner.planner.ramp[0]
        self._overrides = (1.0, 1.0)
        self._overdue_ticks = 0.0  # the fraction of a tick that `advance` was asked for and did not run
        self._recorded: list[np.recarray] = []

    @property
    def time_s(self) -> float:
        """The simulated time since the begin."""
        return self._clockwork["clock"] / TICKS_PER_S

    @property
    def room(self) -> int:
        """Blocks that can be queued now."""
        return self.limits.look_ahead_blocks - self.blocks

    @property
    def blocks(self) -> int:
        """Blocks that are queued, the one being cut into segments included."""
        return int(self._queue["head"] - self._queue["tail"]) % len(self._runner.planner.blocks)

    @property
    def position_steps(self) -> tuple[int, ...]:
        """Where the axes are, in steps."""
        return tuple(self._runner.position.tolist())

    @property
    def position_mm(self) -> tuple[float, ...]:
        """Where the axes are, in mm."""
        return tuple((self._runner.position / self._runner.planner.steps_per_mm).tolist())

    @property
    def rate_mm_min(self) -> float:
        """The speed along the path, as the controller reports it: that of the newest segment, 0 at rest."""
        return mm_min_from_mm_s(float(self._ramp["speed"])) if self._clockwork["running"] else 0.0

    @property
    def tag(self) -> int | None:
        """The tag of the line that is running, None at rest."""
        return int(self._runner.ring["tag"][self._clockwork["oldest"]]) if self._clockwork["running"] else None

    @property
    def state(self) -> str:
        """One of "idle", "run", "hold" (braking), "held"."""
        if self.held:
            return "held"
        if self.holding:
            return "hold"
        return "idle" if self.idle else "run"

    @property
    def idle(self) -> bool:
        """Whether all moves are done, the drivers' idle delay has passed and nothing is held."""
        clockwork = self._clockwork
        waiting = self.blocks or clockwork["waiting"] or clockwork["ready_at"] > clockwork["clock"]
        return not waiting and not self._ramp["hold"]

    @property
    def holding(self) -> bool:
        """Whether a hold is braking and has not come to its stop."""
        return bool(self._ramp["hold"]) and not self.held

    @property
    def held(self) -> bool:
        """Whether a hold has come to its stop."""
        return bool(self._clockwork["held"])

    @property
    def until_change_s(self) -> float:
        """The time until the running segment, or the drivers' idle delay, is over; infinite at rest."""
        clockwork = self._clockwork
        if self.held:
            return math.inf
        delay = max(int(clockwork["ready_at"] - clockwork["clock"]), 0)
        if not clockwork["waiting"]:
            return (delay or 1) / TICKS_PER_S if delay or self.blocks else math.inf
        segment = self._runner.ring[clockwork["oldest"]]
        length = int(segment["ticks"] * segment["cycles"])
        if clockwork["running"]:
            return (int(segment["start"]) + length - int(clockwork["clock"])) / TICKS_PER_S
        return (delay + length) / TICKS_PER_S

    def line(self, target_mm: Sequence[float], feed_mm_min: float, rapid: bool = False, tag: int = 0) -> bool:
        """Queue a straight move in machine coordinates; returns False when it is shorter than a step.

        A rapid goes as fast as the axes allow, whatever `feed_mm_min` says. Raises
        MachineRefusal, and queues nothing, when there is no room or the target or feed is not a finite number.
        """
        if not self.room:
            limit = f"{self.limits.look_ahead_blocks} blocks"
            raise MachineRefusal("planner-full", "the planner has no free block", limit=limit, advice="wait for room")
        target = np.array(target_mm, float)
        if not (all(map(math.isfinite, target_mm)) and math.isfinite(feed_mm_min)):
            raise MachineRefusal(
                "not-finite", "a move to no known place", value=f"{list(target_mm)}", advice="give every axis a number"
            )
        return bool(push_line(self._runner.planner, target, mm_s_from_mm_min(float(feed_mm_min)), bool(rapid), tag))

    def advance(self, dt_s: float) -> None:
        """Let `dt_s` seconds pass."""
        ticks = dt_s * TICKS_PER_S + self._overdue_ticks
        whole = int(ticks)
        self._overdue_ticks = ticks - whole
        until = int(self._clockwork["clock"]) + whole
        stepper_interrupt.run_until(self._runner, until)
        while self._record_full:
            self._keep_record()
            stepper_interrupt.run_until(self._runner, until)

    def hold(self) -> None:
        """Begin to brake along the path; `held` once the axes are at rest."""
        stepper_interrupt.hold(self._runner)

    def resume(self) -> bool:
        """Go on after a hold; returns False, and does nothing, unless held, as the controller does."""
        return bool(stepper_interrupt.resume(self._runner))

    def reset(self) -> bool:
        """Stop at once and forget all moves and any hold; returns whether the axes were moving.

        Steps are lost when they were. After a hold nothing is lost: hold and then reset cancels a jog.
        """
        moving = bool(stepper_interrupt.stop_dead(self._runner))
        self._overdue_ticks = 0.0
        return moving

    def override(self, feed: float, rapid: float) -> None:
        """Run queued and coming moves at these factors (1.0 = as programmed) of their speeds."""
        if (feed, rapid) != self._overrides:
            self._overrides = (feed, rapid)
            set_overrides(self._runner.planner, float(feed), float(rapid))

    def path(self) -> np.ndarray:
        """Return the motion since the last call, float64[k, 1 + axes]: t_s and position in steps.

        One row for the end of every segment (about every 10 ms); between two rows the axes go straight, so
        that every point of the true path is within one step. Only complete segments are in it.
        """
        return self._drain(lambda segments: (segments.start + segments.ticks * segments.cycles, ends(segments)))

    def step_path(self) -> np.ndarray:
        """Return the same as `path()`, with one row for every time at which an axis steps."""
        return self._drain(step_table)

    def segments(self) -> list[np.recarray]:
        """Return the complete segments since the last call, oldest first; of a `record` only."""
        self._keep_record()
        recorded, self._recorded = self._recorded, []
        return recorded

    def _drain(self, fold) -> np.ndarray:
        pieces = [np.zeros((0, 1 + self.limits.axes))]
        for segments in self.segments():
            clocks, positions = fold(segments)
            pieces.append(np.column_stack([clocks / TICKS_PER_S, positions]))
        return np.concatenate(pieces)

    @property
    def _record_full(self) -> bool:
        return 0 < len(self._runner.record) == self._clockwork["recorded"]

    def _keep_record(self) -> None:
        if self._clockwork["recorded"]:
            self._recorded.append(self._runner.record[: self._clockwork["recorded"]].copy().view(np.recarray))
            self._clockwork["recorded"] = 0
