# SPDX-License-Identifier: LGPL-2.1-or-later
"""A player of pulses in simulated time, with the interface of `control.pulses.pulse_player_client.PulseOutput`.

It plays each pulse after its planned wait, stretched by the path speed that a hold, a resume or a share leaves of the
planned one; `advance` lets its time pass.
"""

from __future__ import annotations

from collections import deque
from math import inf, sqrt

from CNCStepper.control.pulses.pacing import Jitter
from CNCStepper.errors import CNCStepperError, MachineRefusal
from CNCStepper.motion.planner.buffers import TICKS_PER_S
from CNCStepper.units import mm_min_from_mm_s

RING = 65_536
REST_STEPS = 2.5  # of the way that a speed covers in a wait: longer is a rest


class FakeOutput:
    """played: (time_s, step, back, place in steps) of each pulse. log: what was switched, when."""

    def __init__(self, steps_per_mm=(40.0, 40.0, 100.0), wired=("spindle_cw", "flood"), best_hz=50_000.0):
        self.time_s = 0.0
        self.played: list[tuple[float, int, int, tuple[int, ...]]] = []
        self.switched: list[tuple[float, str, bool]] = []
        self.on: set[str] = set()
        self.high: frozenset[int] = frozenset()
        self.error: CNCStepperError | None = None
        self.closed = False
        self.commands: list[tuple[float, str]] = []
        self._wired, self._best_hz = wired, best_hz
        self._step_mm = max(1 / per_mm for per_mm in steps_per_mm[:2])
        self._queue: deque[tuple[int, int, int, float, float, bool]] = deque()
        self._place = [0, 0, 0]
        self._last_tick = 0
        self._appended = -1
        self._due_s = -inf  # when the next pulse of the queue comes; -inf where it is not decided
        self._last_s = 0.0
        self._speed = 0.0
        self._mode = "run"  # or "hold", "held"
        self._recovers = False  # it gathers speed after a hold
        self._shares = (1.0, 1.0)

    # -- what the controller sees ---------------------------------------------------------------------

    @property
    def room(self) -> int:
        return RING - len(self._queue)

    @property
    def queued_s(self) -> float:
        return (self._queue[-1][0] - self._last_tick) / TICKS_PER_S if self._queue else 0.0

    @property
    def sent(self) -> int:
        return len(self.played)

    @property
    def position_steps(self) -> tuple[int, ...]:
        return tuple(self._place)

    @property
    def rate_mm_min(self) -> float:
        return mm_min_from_mm_s(self._speed)

    @property
    def state(self) -> str:
        if self.error:
            return "failed"
        if self._mode != "run":
            return self._mode
        return "run" if self._queue else "idle"

    def append(self, ticks, step, back, speed_mm_s, acceleration_mm_s2, is_rapid) -> None:
        assert len(ticks) <= self.room
        for row in zip(
            *(column.tolist() for column in (ticks, step, back, speed_mm_s, acceleration_mm_s2, is_rapid)), strict=True
        ):
            assert row[0] > self._appended, "the planned clock rises"
            assert row[1] and not row[2] & ~row[1] and row[3] > 0 and row[4] > 0
            self._appended = row[0]
            self._queue.append(row)

    def declare(self, axis: int, steps: int) -> None:
        self._place[axis] = steps

    def hold(self) -> None:
        self._note("hold")
        self._mode = "hold" if self._queue and self._speed > 0 else "held"

    def resume(self) -> None:
        self._note("resume")
        self._recovers = self._mode != "run"
        self._mode = "run"
        self._due_s = -inf

    def share(self, feed: float, rapid: float) -> None:
        assert 0.1 <= feed <= 2.0 and 0.1 <= rapid <= 2.0
        self._shares = (min(feed, 1.0), min(rapid, 1.0))

    def drop(self) -> None:
        assert self.state in ("idle", "held")
        self._note("drop")
        self._queue.clear()
        self._due_s = -inf

    def stop_at_once(self) -> None:
        self._note("stop_at_once")
        self._mode, self._speed = "held", 0.0
        for device in tuple(self.on):
            self.switch(device, False)

    def switch(self, device: str, on: bool) -> None:
        if device not in self._wired:
            raise MachineRefusal("no-pin", f"{device} has no pin")
        self.switched.append((self.time_s, device, on))
        (self.on.add if on else self.on.discard)(device)

    def inputs(self) -> frozenset[int]:
        return self.high

    def trial(self, pulses_per_s: float, trial_s: float = 3.0) -> Jitter:
        if pulses_per_s > self._best_hz:
            raise MachineRefusal("pulse-rate", "this computer cannot keep the rate", value=f"{pulses_per_s:g} Hz")
        return Jitter(1000, trial_s, 1.0, 2.0, 3.0)

    def check(self) -> None:
        if self.error:
            raise self.error

    def close(self) -> None:
        self.closed = True
        self.on.clear()

    # -- its time -------------------------------------------------------------------------------------

    def advance(self, dt_s: float) -> None:
        """Let time pass and play what is due."""
        end_s = self.time_s + dt_s
        while self._queue and self._mode != "held" and not self.error:
            if self._due_s == -inf:
                self._due_s = max(self._last_s + self._wait_s(), self.time_s)
            if self._due_s > end_s or self._mode == "held":
                break
            self.time_s = self._due_s
            self._play()
        if not self._queue and self._mode == "hold":
            self._mode = "held"
        if not self._queue or self._mode == "held":
            self._speed = 0.0
        self.time_s = end_s

    def _wait_s(self) -> float:
        """Return how long the next pulse comes after the one before, and take up its speed; or be held."""
        tick, _, _, planned, most, rapid = self._queue[0]
        planned_s = (tick - self._last_tick) / TICKS_PER_S
        if planned * planned_s > REST_STEPS * self._step_mm:
            self._speed = planned * self._shares[rapid]
            if self._mode == "hold":
                self._mode = "held"
            return planned_s
        way_mm, before, wanted = planned * planned_s, self._speed, planned * self._shares[rapid]
        if self._mode == "hold":
            squares = before**2 - 2 * most * way_mm
            if squares <= 0.0:
                self._mode = "held"
                return inf
            self._speed = min(sqrt(squares), wanted)
            return 2 * way_mm / (before + self._speed)
        faster = sqrt(before**2 + 2 * most * way_mm)
        self._recovers = self._recovers and faster < wanted
        self._speed = faster if self._recovers else wanted
        return way_mm / self._speed

    def _play(self) -> None:
        tick, step, back, *_ = self._queue.popleft()
        for axis in range(3):
            if step >> axis & 1:
                self._place[axis] += -1 if back >> axis & 1 else 1
        self.played.append((self.time_s, step, back, tuple(self._place)))
        self._last_tick, self._last_s, self._due_s = tick, self.time_s, -inf

    def _note(self, command: str) -> None:
        self.commands.append((self.time_s, command))
