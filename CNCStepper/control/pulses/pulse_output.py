# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pulses that a process of its own plays to a port, as this process appends them: hold, resume, share, back.

    append ──► ring in shared memory ──► workers/pulse_output.py ──► port
                        ▲ commands, relays      │ place, state, inputs, jitter
                        └───────────────────────┘

The planned clock only gives the times BETWEEN pulses. The first pulse after a start, after `drop` and wherever nothing
was queued comes at once, or as long after the last one as planned if that is later.

A row whose speed is 0, or before which the path would have gone farther than a step of every axis together, has a
rest before it: a dwell, or the begin of a move. It keeps its planned time. Everywhere else the player stretches time:
a row's speed is the path speed over the time that ends with its pulse.

Append at least as far ahead as the path takes to brake: where nothing more has come for STALE_S and what is queued
does not end at rest, the player brakes to its end, and goes on as soon as more comes.
"""

from __future__ import annotations

import numpy as np

from CNCStepper.control.pulses.pacing import Jitter
from CNCStepper.machine.profile import Machine


class PulseOutput:
    """The player of pulses: its methods return at once and never wait for the port, save `launch` and `trial`.

    `state`: "idle" (nothing queued), "run" (also backwards), "hold" (it brakes), "held", "failed" (`check` says why).
    """

    @classmethod
    def launch(cls, port: str, machine: Machine) -> PulseOutput:
        """Start the player at a port: /dev/parport0, `record:FILE`, `socket://host:port`, a serial device.

        Waits until the port is open and the kernels are loaded. Raises LinkError where the port cannot be had,
        MachineRefusal where a motor has no pin.
        """
        raise NotImplementedError

    @property
    def room(self) -> int:
        """How many pulses may be appended now."""
        raise NotImplementedError

    @property
    def queued_s(self) -> float:
        """The planned time of what is appended and not played yet."""
        raise NotImplementedError

    @property
    def sent(self) -> int:
        """How many pulses were played, less those taken back."""
        raise NotImplementedError

    @property
    def position_steps(self) -> tuple[int, ...]:
        """Where the three axes are by the pulses played, in steps."""
        raise NotImplementedError

    @property
    def rate_mm_min(self) -> float:
        """The path speed now."""
        raise NotImplementedError

    @property
    def state(self) -> str:
        """What it does, as in the class's text; a command that is not heard yet counts as begun."""
        raise NotImplementedError

    def append(
        self,
        ticks: np.ndarray,
        step: np.ndarray,
        back: np.ndarray,
        speed_mm_s: np.ndarray,
        acceleration_mm_s2: np.ndarray,
        is_rapid: np.ndarray,
    ) -> None:
        """Append k pulses, k at most `room`.

        ticks int64[k]: of TICKS_PER_S on the planned clock, strictly rising over the whole life. step, back uint8[k]:
        masks of axes as in PulseChunk. speed_mm_s float32[k]: of the path. acceleration_mm_s2 float32[k]: allowed along
        the path; UNLIMITED where the motors start and stop at once. is_rapid bool[k].
        Raises ValueError where they do not fit.
        """
        raise NotImplementedError

    def declare(self, axis: int, steps: int) -> None:
        """Say where an axis is; nothing moves."""
        raise NotImplementedError

    def hold(self) -> None:
        """Brake along the path, within the planned acceleration; also ends a way back."""
        raise NotImplementedError

    def resume(self) -> None:
        """Go forwards again from wherever it is; a way back brakes first."""
        raise NotImplementedError

    def share(self, feed: float, rapid: float) -> None:
        """Set the speeds of feeds and of rapids as shares of the planned ones, 0.1 to 1.0; above that it is 1.0."""
        raise NotImplementedError

    def back(self, pulses: int) -> None:
        """From "held": play so many pulses backwards, then be held again; fewer where no more are kept (`kept`)."""
        raise NotImplementedError

    @property
    def kept(self) -> int:
        """How many pulses `back` can take back at most."""
        raise NotImplementedError

    def drop(self) -> None:
        """At rest ("idle" or "held"): forget what is appended and not played.

        It stays "held" until `resume`, which finds nothing queued then. Raises ValueError where it is not at rest.
        """
        raise NotImplementedError

    def stop_at_once(self) -> None:
        """Stop without a ramp and switch everything off; steps may be lost. It is "held" then: `drop`, then `resume`."""
        raise NotImplementedError

    def switch(self, device: str, on: bool) -> None:
        """Switch a device of the signals' pins now; raises MachineRefusal where it has no pin."""
        raise NotImplementedError

    def inputs(self) -> frozenset[int]:
        """Return the pins of the status port that are high, as last read."""
        raise NotImplementedError

    def trial(self, pulses_per_s: float, trial_s: float = 3.0) -> Jitter:
        """At rest: play that many pulses a second that move nothing, and return how late they were.

        Waits for as long as it takes. Raises MachineRefusal where this computer cannot keep the rate.
        """
        raise NotImplementedError

    def jitter(self) -> Jitter:
        """Return how late the writes were since the start or the last trial."""
        raise NotImplementedError

    def check(self) -> None:
        """Raise what ended the player: LinkError "pulses-late", "port-lost" or "pulse-worker"."""
        raise NotImplementedError

    def close(self) -> None:
        """Switch everything off, end the process and give the port back."""
        raise NotImplementedError
