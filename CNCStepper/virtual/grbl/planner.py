# SPDX-License-Identifier: LGPL-2.1-or-later
"""The axes of the firmware, and simulated axes: the planner's live motion and the limit switches."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable
from dataclasses import replace

from CNCStepper.machine.profile import AXIS_NAMES
from CNCStepper.motion.planner.live_motion import Motion
from CNCStepper.motion.planner.machine_limits import Limits
from CNCStepper.virtual.grbl.gcode.words import f32
from CNCStepper.virtual.grbl.settings import ALWAYS_ON_MS, IDLE_DELAY_MS, STEPS, TRAVEL, Settings

COASTING_STEPS = 3  # of every axis, when motors that turn are stopped without a ramp


class Axes(ABC):
    """Position in steps and motion of the machine; subclasses make the moves.

    lost_steps: true place minus reported place. declared: how often a place was declared rather than reached.
    """

    def __init__(self, settings: Settings):
        self._settings = settings
        self._steps_per_mm, self._travels_mm = self._resolutions(), self._travels()
        self.declared = 0
        self.lost_steps = [0, 0, 0]

    @property
    @abstractmethod
    def room(self) -> int:
        """Free blocks of the planner."""

    @property
    @abstractmethod
    def idle(self) -> bool:
        """Whether no move is left to make."""

    @property
    @abstractmethod
    def stopped(self) -> bool:
        """Whether a hold has come to its end."""

    @property
    @abstractmethod
    def until_change_s(self) -> float:
        """Time until the planner next takes up new work, and so may have room."""

    @property
    @abstractmethod
    def rate_mm_min(self) -> float:
        """The speed along the path."""

    @property
    @abstractmethod
    def position_steps(self) -> tuple[int, ...]:
        """Machine position in steps."""

    @abstractmethod
    def line(self, target_mm: list[float], feed_mm_min: float, rapid: bool) -> None:
        """Queue a straight move; there must be room."""

    @abstractmethod
    def advance(self, dt_s: float) -> None:
        """Move on by `dt_s` seconds."""

    @abstractmethod
    def hold(self) -> None:
        """Begin to slow down to a stop on the path."""

    @abstractmethod
    def resume(self) -> None:
        """Go on after a hold."""

    @abstractmethod
    def reset(self) -> None:
        """Stop at once and forget all moves."""

    @abstractmethod
    def override(self, feed_percent: int, rapid_percent: int) -> None:
        """Change the speeds, also of moves under way."""

    @abstractmethod
    def _stand_at(self, steps: tuple[int, ...]) -> None:
        """Let the axes be at a place, with the settings in force; no move may be queued."""

    @property
    def free_blocks(self) -> int:
        """Free blocks as the status report has them: how many more moves could be under way."""
        return self.room

    @property
    def idle_delay_s(self) -> float:
        """How long the drivers stay under current after the last step; the longest value means for ever."""
        delay_ms = self._settings[IDLE_DELAY_MS]
        return 0.0 if delay_ms == ALWAYS_ON_MS else delay_ms / 1000

    @property
    def position_mm(self) -> list[float]:
        """Machine position in mm, as 32-bit floats."""
        return self.mm_of(self.position_steps)

    def mm_of(self, steps: Iterable[int]) -> list[float]:
        """Return a position in mm."""
        return [f32(count / per_mm) for count, per_mm in zip(steps, self._steps_per_mm, strict=True)]

    def step_mm(self, axis: int) -> float:
        """Return the length of one step."""
        return 1 / self._steps_per_mm[axis]

    def adopt_settings(self) -> None:
        """Take over resolutions, rates, accelerations and travels; the place in steps stays. No move may be queued."""
        self._steps_per_mm, self._travels_mm = self._resolutions(), self._travels()
        self._stand_at(self.position_steps)

    def set_position(self, axis: int, position_mm: float) -> None:
        """Declare where an axis is; it does not move."""
        steps = list(self.position_steps)
        before = steps[axis]
        steps[axis] = round(position_mm * self._steps_per_mm[axis])
        self.lost_steps[axis] += before - steps[axis]
        self._stand_at(tuple(steps))

    def to_switch_mm(self, axis: int, low: bool) -> float:
        """Return the way from here to the switch at the low or the high end of an axis, signed."""
        end_steps = -self._travels_mm[axis] * self._steps_per_mm[axis] if low else 0.0
        return (end_steps - self.position_steps[axis] - self.lost_steps[axis]) / self._steps_per_mm[axis]

    def pressed_switches(self) -> list[str]:
        """Return the names of the axes that stand on or beyond one of their switches."""
        return [
            name.upper()
            for axis, name in enumerate(AXIS_NAMES)
            if self.to_switch_mm(axis, low=True) >= 0 or self.to_switch_mm(axis, low=False) <= 0
        ]

    def _limits(self) -> Limits:
        return replace(Limits.of(self._settings.profile()), idle_delay_s=self.idle_delay_s)

    def _resolutions(self) -> list[float]:
        return [self._settings[STEPS + axis] for axis in range(3)]

    def _travels(self) -> list[float]:
        return [self._settings[TRAVEL + axis] for axis in range(3)]


class SimulatedAxes(Axes):
    """Axes that are only counted.

    At power-up the table stands in the middle of its travel and reports 0, until homing finds the truth; a dead stop
    in motion loses some steps more.
    """

    def __init__(self, settings: Settings):
        super().__init__(settings)
        self._motion = Motion(self._limits())
        self._place = self._motion.position_steps
        self.lost_steps = [
            round(-travel / 2 * steps) for travel, steps in zip(self._travels_mm, self._steps_per_mm, strict=True)
        ]

    @property
    def room(self) -> int:
        """Free blocks of the planner."""
        return self._motion.room

    @property
    def idle(self) -> bool:
        """Whether no move is left to make."""
        return self._motion.idle

    @property
    def stopped(self) -> bool:
        """Whether a hold has come to its end."""
        return self._motion.idle or self._motion.held

    @property
    def until_change_s(self) -> float:
        """Time until the planner next takes up new work, and so may have room."""
        return self._motion.until_change_s

    @property
    def rate_mm_min(self) -> float:
        """The speed along the path."""
        return self._motion.rate_mm_min

    @property
    def position_steps(self) -> tuple[int, ...]:
        """Machine position in steps."""
        return self._place

    def line(self, target_mm: list[float], feed_mm_min: float, rapid: bool) -> None:
        """Queue a straight move; there must be room."""
        self._motion.line(target_mm, feed_mm_min, rapid)

    def advance(self, dt_s: float) -> None:
        """Move on by `dt_s` seconds."""
        self._motion.advance(dt_s)
        self._place = self._motion.position_steps

    def hold(self) -> None:
        """Begin to slow down to a stop on the path."""
        self._motion.hold()

    def resume(self) -> None:
        """Go on after a hold."""
        self._motion.resume()

    def reset(self) -> None:
        """Stop at once and forget all moves; axes that were moving coast on, and nobody counts that."""
        if self._motion.reset():
            self.lost_steps = [lost + COASTING_STEPS for lost in self.lost_steps]
        self._place = self._motion.position_steps

    def override(self, feed_percent: int, rapid_percent: int) -> None:
        """Change the speeds, also of moves under way."""
        self._motion.override(feed_percent / 100, rapid_percent / 100)

    def _stand_at(self, steps: tuple[int, ...]) -> None:
        self.declared += 1
        self._motion = Motion(self._limits(), steps)
        self._place = steps
