# SPDX-License-Identifier: LGPL-2.1-or-later
"""Jogging: steps as they are asked for, and a press-and-hold that lives only while it is renewed.

A held jog is fed in short pieces, so far ahead that the machine can brake at their end and no further:

    |== done ==|== planned by the controller ==|           <- 0x85 brakes at once and forgets the rest
               ^ machine                       ^ v t + v (v / 2a + AHEAD_S) from the start

One piece at most has no answer yet: after 0x85 grbl still runs the lines in its receive buffer.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from math import hypot, inf
from typing import Protocol

from CNCStepper.control.protocol.grbl.capabilities import check_axes
from CNCStepper.control.protocol.grbl.driver import JOG_CANCEL, Answered, Grbl
from CNCStepper.control.protocol.grbl.settings import ACCELERATION, MAX_RATE
from CNCStepper.control.session.command import Command
from CNCStepper.errors import MachineRefusal, Text

LAPSE_S = 0.3  # a held jog that nobody renews for so long is cancelled
AHEAD_S = 0.2  # how much longer than its braking the planned way lasts
PIECES = 8  # of the planned way; grbl plans 15
LEAST_MM = 0.00005  # that a jog's four decimals can hold
SHORTEST_MM = 0.1  # of a piece: a few steps
SLOWEST_MM_MIN = 30.0  # of a held jog; grbl makes 30 steps/s at least, and runs away from slower pacing
STEPS_LIMIT = 5  # steps that wait for the controller
MAY_JOG = ("Idle", "Jog")


class JogLine(Protocol):
    """A jog that fits one `$J=` line."""

    def line(self) -> str:
        """Return the jog command of grbl 1.1."""


@dataclass(frozen=True)
class JogMove:
    """A way in mm, or a direction, and the speed along it."""

    x_mm: float
    y_mm: float
    z_mm: float
    feed_mm_min: float

    @property
    def length_mm(self) -> float:
        """Its length."""
        return hypot(self.x_mm, self.y_mm, self.z_mm)

    @property
    def axes(self) -> str:
        """The axes that move."""
        ways = zip("XYZ", (self.x_mm, self.y_mm, self.z_mm), strict=True)
        return "".join(axis for axis, way_mm in ways if abs(way_mm) >= LEAST_MM)

    def scaled(self, length_mm: float, feed_mm_min: float) -> JogMove:
        """Return a way in the same direction."""
        factor = length_mm / self.length_mm
        return JogMove(self.x_mm * factor, self.y_mm * factor, self.z_mm * factor, feed_mm_min)

    def line(self) -> str:
        """Return the jog command of grbl 1.1."""
        ways_mm = {"X": self.x_mm, "Y": self.y_mm, "Z": self.z_mm}
        moves = "".join(f"{axis}{ways_mm[axis]:.4f}" for axis in self.axes)
        return f"$J=G91G21{moves}F{self.feed_mm_min:.1f}"


@dataclass
class ContinuousJog:
    """A jog that lasts while its button is pressed; press: the number of this press."""

    press: str
    way: JogMove
    renewed_s: float
    begin_s: float
    piece_mm: float
    ahead_mm: float
    sent_mm: float = 0.0

    def due(self, now_s: float) -> bool:
        """Return whether the next piece may go out."""
        return self.sent_mm < self.way.feed_mm_min / 60 * (now_s - self.begin_s) + self.ahead_mm


def check_in_time(command: Command, now_s: float) -> None:
    """Raise MachineRefusal for a jog asked too long ago: the operator may have turned away."""
    late_s = now_s - command.asked_s
    if command.name in ("jog", "jog_on") and late_s > LAPSE_S:
        advice = "look at the machine, and jog again"
        raise MachineRefusal("jog-late", "the jog came too late to be safe", value=f"{late_s:.1f} s", advice=advice)


class Jogger:
    """Jogs one machine; `turn` is called at least every `wait_s`.

    refuse: called with the reason when a jog is given up. tell: called with "warning". states: that allow a jog.
    """

    def __init__(
        self,
        driver: Grbl,
        refuse: Callable[[MachineRefusal], None],
        tell: Callable[[str, str], None],
        states: Sequence[str] = MAY_JOG,
    ):
        self._driver = driver
        self._states = states
        self._refuse = refuse
        self._tell = tell
        self._steps: deque[JogLine] = deque()
        self._held: ContinuousJog | None = None
        self._over = ""  # the press that ended before its button was released
        self._under_way = False  # a line without its answer
        self._cancelled_s = inf  # when 0x85 was written last, while its effect is awaited

    @property
    def active(self) -> bool:
        """Whether anything is to be sent, answered or cancelled still."""
        return bool(self._steps or self._held or self._under_way) or self._cancelling

    @property
    def wait_s(self) -> float:
        """How long the next turn may be away."""
        return 0.01 if self.active else inf

    def step(self, way: JogMove) -> None:
        """Jog this way once; raises MachineRefusal when the machine is not in the state for it."""
        self._check(way)
        if len(self._steps) >= STEPS_LIMIT:
            raise MachineRefusal("jog-busy", "the jogs before this one are not done yet", advice="wait a moment")
        self._steps.append(way)

    def keep(self, press: str, way: JogMove) -> None:
        """Start or continue to jog in this direction; call again within LAPSE_S."""
        if press == self._over:
            return
        try:
            self._check(way)
        except MachineRefusal:
            self._over = press  # said once
            raise
        unit = self._limited(way)
        if self._held and (self._held.press, self._held.way) == (press, unit):
            self._held.renewed_s = self._driver.clock()
        elif self._held:
            self.cancel()
        elif not self._cancelling and not self._under_way:
            self._held = self._begun(press, unit, self._driver.clock())

    def cancel(self) -> None:
        """Stop jogging now: the machine brakes on its path, its position is kept."""
        self._driver.realtime(JOG_CANCEL)
        self._cancelled_s = self._driver.clock()
        self._give_up()

    def follow(self, ways: Iterable[JogLine]) -> None:
        """Go these ways one after the other."""
        self._steps.extend(ways)

    def turn(self) -> None:
        """Cancel jogs that are not renewed, then send due ones."""
        now_s = self._driver.clock()
        if self._held and now_s - self._held.renewed_s > LAPSE_S:
            self.cancel()
            self._tell(
                "warning", Text("the jog was stopped: its button was not heard of for {lapse_s:g} s", lapse_s=LAPSE_S)
            )
        if self._cancelling:
            self._look_after_cancel(now_s)
        elif not self._under_way:
            self._send_next(now_s)

    def answered(self, answer: Answered) -> None:
        """Take the answer to a jog line; a refused one ends all jogs that were asked for."""
        self._under_way = False
        if answer.error:
            self._give_up()
            firmware = self._driver.firmware
            code = firmware.error(answer.error)
            words = Text("{meaning} (error:{error})", meaning=code.meaning, error=answer.error)
            self._refuse(MachineRefusal(f"{firmware.key}-error-{answer.error}", words, advice=code.advice))

    def forget(self) -> None:
        """The controller was reset or raised an alarm: nothing is under way any more."""
        self._give_up()
        self._under_way = False
        self._cancelled_s = inf

    # --- inside --------------------------------------------------------------------------------

    @property
    def _cancelling(self) -> bool:
        return self._cancelled_s < inf

    def _check(self, way: JogMove) -> None:
        status = self._driver.status
        if status is None or status.state not in self._states:
            raise MachineRefusal(
                "jog-state",
                "the machine jogs only while it is idle",
                value=status.name if status else "",
                advice="wait until it is idle; after an alarm home it or unlock it",
            )
        check_axes(way.axes, self._driver.cannot)
        if not (0 < way.feed_mm_min < inf and LEAST_MM <= way.length_mm < 1e5):
            raise MachineRefusal(
                "jog-way",
                "a jog needs a way and a feed",
                value=Text(
                    "{length_mm:g} mm, {feed_mm_min:g} mm/min", length_mm=way.length_mm, feed_mm_min=way.feed_mm_min
                ),
                advice="give a way of 0.0001 mm or more and a feed above 0",
            )

    def _limited(self, way: JogMove) -> JogMove:
        """Return the direction, 1 mm long, with the feed that the machine's axes can follow."""
        unit = way.scaled(1.0, way.feed_mm_min)
        return unit.scaled(1.0, max(SLOWEST_MM_MIN, min(way.feed_mm_min, self._along(unit, MAX_RATE))))

    def _along(self, unit: JogMove, first_setting: int) -> float:
        """Return the limit along a direction that the axes' settings leave."""
        shares = (abs(unit.x_mm), abs(unit.y_mm), abs(unit.z_mm))
        limits = (self._driver.settings.get(first_setting + axis, inf) for axis in range(3))
        return min((limit / share for limit, share in zip(limits, shares, strict=True) if share > 1e-9), default=inf)

    def _begun(self, press: str, unit: JogMove, now_s: float) -> ContinuousJog:
        speed_mm_s = unit.feed_mm_min / 60
        ahead_mm = speed_mm_s * (AHEAD_S + speed_mm_s / (2 * self._along(unit, ACCELERATION)))
        return ContinuousJog(press, unit, now_s, now_s, max(ahead_mm / PIECES, SHORTEST_MM), ahead_mm)

    def _send_next(self, now_s: float) -> None:
        if self._steps:
            self._send(self._steps.popleft())
        elif self._held and self._held.due(now_s):
            self._held.sent_mm += self._held.piece_mm
            self._send(self._held.way.scaled(self._held.piece_mm, self._held.way.feed_mm_min))

    def _send(self, way: JogLine) -> None:
        self._driver.send(way.line())
        self._driver.flush()
        self._under_way = True

    def _look_after_cancel(self, now_s: float) -> None:
        """Cancel again a jog that the controller started after the cancel."""
        if self._under_way or self._driver.status_asked_s <= self._cancelled_s or not self._driver.status:
            return
        if self._driver.status.state == "Jog":
            self._driver.realtime(JOG_CANCEL)
            self._cancelled_s = now_s
        else:
            self._cancelled_s = inf

    def _give_up(self) -> None:
        self._steps.clear()
        if self._held:
            self._over = self._held.press
            self._held = None
