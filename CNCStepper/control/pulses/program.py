# SPDX-License-Identifier: LGPL-2.1-or-later
"""A program whose pulses this computer sends itself: whether it may, how fast they come, and what is written when.

    program ── may it? ── checks ── dry pass: every pulse is made once, none is sent ── trial ── pulses

There is no controller that would wait or ask: what needs one is refused, and all that can be refused is so before the
first pulse. A hold is heard while pulses are made, half a second before they are sent.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import islice

import numpy as np

from CNCStepper.control.pulses.pacing import LEAST_PULSES_PER_S, WRITES_A_PULSE
from CNCStepper.control.pulses.sender import Pace
from CNCStepper.errors import JobError, Place
from CNCStepper.machine.backlash import Backlash
from CNCStepper.machine.profile import Machine
from CNCStepper.motion.planner.backlash import motor_moves
from CNCStepper.motion.planner.buffers import TICKS_PER_S
from CNCStepper.motion.planner.feed_hold import FeedHold
from CNCStepper.motion.signals.device_switching import DIGITAL_OUTPUTS
from CNCStepper.motion.signals.parallel_port import PortChunk, idle_registers, port_chunks, require_pin
from CNCStepper.motion.signals.pulse_stream import PulseChunk, PulseStream, pulse_stream
from CNCStepper.simulation.checks.check_program import check
from CNCStepper.simulation.finding import Finding
from CNCStepper.toolpath import Event, Toolpath, require_straight_axes

PASSING = ("dwell", "message", "comment", "warning", "tool_select", "override", "end")  # events that ask for nobody
BUSY_WRITES = 32 * WRITES_A_PULSE  # over which the fastest rate is taken
COMPILING_CHUNKS = 8


@dataclass(frozen=True)
class PulseProgram:
    """The tool's path, the motors' moves that lead it, and their machine."""

    path: Toolpath
    motors: Toolpath
    machine: Machine
    file: str

    @classmethod
    def of(cls, path: Toolpath, machine: Machine, file: str) -> PulseProgram:
        """Return a program that may be sent as pulses; raises JobError where it needs a hand or a controller."""
        require_straight_axes(path, file)
        for event in path.events:
            if not _passes(event):
                what = "the program waits or asks for what pulses cannot give"
                advice = "split it there, or send it to a controller"
                value = event.text or event.kind
                raise JobError("drive-stop", what, value=value, advice=advice, place=Place(file, event.line))
        return cls(path, motor_moves(path, Backlash.of(machine)), machine, file)

    def errors(self) -> list[Finding]:
        """Return what the machine cannot do of it."""
        found = check(self.path, self.machine, file=self.file, motors=self.motors)
        return [finding for finding in found if finding.severity == "error"]

    def chunks(self, reins: FeedHold | None = None) -> Iterator[PortChunk]:
        """Yield what is written to the port and when, in ticks of TICKS_PER_S; it follows the reins where there are."""
        stream = pulse_stream(self.motors, self.machine, reins=reins)
        return port_chunks(replace(stream, chunks=self._wired(stream)), self.machine.signals)

    def pace(self) -> Pace:
        """Return how its writes are sent, from a dry pass over all of them.

        Raises MachineRefusal for whatever would end the pulses on the way, and for a device that is on no pin.
        """
        busiest = PeakRate()
        for chunk in self.chunks():
            busiest.add(chunk.ticks)
        self._hold_unseen()
        signals = self.machine.signals
        keep_us = max(signals.pulse_us, signals.gap_us, signals.direction_setup_us)
        writes_per_s = max(busiest.per_s(TICKS_PER_S), WRITES_A_PULSE * LEAST_PULSES_PER_S)
        return Pace(writes_per_s, idle_registers(signals), keep_us)

    def _hold_unseen(self) -> None:
        """Hold once where nothing is sent: what it needs is compiled here and not between two pulses."""
        reins = FeedHold()
        reins.slow(0.5)
        reins.hold()
        for _ in islice(self.chunks(reins), COMPILING_CHUNKS):
            reins.resume()

    def _wired(self, stream: PulseStream) -> Iterator[PulseChunk]:
        """Yield chunks of which all devices have a pin."""
        for chunk in stream:
            for switch in chunk.switches:
                require_pin(self.machine.signals, switch.device)
            yield chunk


class PeakRate:
    """The fastest rate of moments that come in chunks, over BUSY_WRITES of them."""

    def __init__(self) -> None:
        self._last = np.empty(0, np.int64)  # at most BUSY_WRITES
        self._least: int | None = None  # ticks

    def add(self, ticks: np.ndarray) -> None:
        """Take up the next moments, int64[k], rising."""
        ticks = np.concatenate([self._last, ticks])
        if len(ticks) > BUSY_WRITES:
            least = int((ticks[BUSY_WRITES:] - ticks[:-BUSY_WRITES]).min())
            self._least = least if self._least is None else min(self._least, least)
        self._last = ticks[-BUSY_WRITES:]

    def per_s(self, ticks_per_s: int) -> float:
        """Return how many there are in a second where they are closest; of fewer than that, by all of them."""
        if self._least is not None:
            return BUSY_WRITES * ticks_per_s / self._least
        return (len(self._last) - 1) * ticks_per_s / int(np.ptp(self._last)) if len(self._last) > 1 else 0.0


def _passes(event: Event) -> bool:
    """Return whether pulses can go on over an event."""
    if event.kind == "output":  # a digital one; others have no line
        return event.text.split(" ")[0] in DIGITAL_OUTPUTS
    return event.kind in PASSING
