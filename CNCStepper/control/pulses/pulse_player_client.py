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

Append at least as far ahead as the path takes to brake: where nothing more has come for 50 ms and what is queued
does not end at rest, the player brakes to its end, and goes on as soon as more comes.
"""

from __future__ import annotations

import json
import subprocess
import sys
import threading
import time
from contextlib import suppress
from math import hypot
from pathlib import Path
from typing import Any

import numpy as np

from CNCStepper.control.processes.python_finder import command, environment
from CNCStepper.control.pulses.output_ports import RECORD, SOCKET
from CNCStepper.control.pulses.pacing import (
    MOST_LONGER,
    NS_PER_S,
    TRIAL_S,
    WRITES_A_PULSE,
    Jitter,
    jitter_of,
    stall_ns,
)
from CNCStepper.control.pulses.parallel_port import high_pins, is_parallel_port
from CNCStepper.control.pulses.player_process import (
    StallWatch,
    answer,
    gone,
    is_board,
    leave_port_idle,
    line_of,
    places_file,
    stands,
    writer_of,
)
from CNCStepper.control.pulses.pulse_ring import (
    ACKNOWLEDGED,
    AHEAD,
    AT_HOLD,
    BACK,
    BEAT,
    CLOSE,
    COMMAND,
    FAILED,
    GOAL,
    HOLD,
    IDLE,
    INPUTS,
    KEPT,
    LATE_NS,
    NO_INPUTS,
    PEAK_PER_S,
    RELAYS,
    RESUME,
    ROWS,
    SERIAL,
    SPEED,
    STATE,
    STATES,
    STOP,
    TAKEN_S,
    TRIAL,
    TRIAL_PER_S,
    WORST_NS,
    WRITES,
    PulseRing,
)
from CNCStepper.control.pulses.pulse_ring import TRIAL_S as TRIAL_LENGTH
from CNCStepper.errors import MachineRefusal, Text
from CNCStepper.machine.profile import Machine
from CNCStepper.motion.planner.buffers import TICKS_PER_S
from CNCStepper.motion.signals.peak_rate import PeakRate
from CNCStepper.motion.signals.pulse_player import (
    ENDS_AT_REST,
    FEED_SHARE,
    HEAD,
    IS_RAPID,
    IS_REST,
    OLDEST,
    PLACE,
    PLAYED_AXES,
    POSITION,
    RAPID_SHARE,
    SENT,
)

LEAST_SHARE = 0.1
LEAST_ACCELERATION, MOST_ACCELERATION = 1e-3, 1e9  # mm/s²: sums of them stay exact enough
REST_STEPS = 3.0  # a path that went so many steps of all axes before a pulse has stood on the way
AT_REST_S = 0.025  # a path that is so near its stop may end
REAL_STILL_S, STILL_S = 1.5, 3.0  # a player whose motors follow waits a second for its device; others may starve
LONGER = 1.5  # of the time that a trial may take where no motor follows
ANSWER_LIMIT_S, END_LIMIT_S = 300.0, 10.0  # kernels may have to be compiled; a way to a stop may be long
LOOK_S = 0.002
NS_PER_TICK = NS_PER_S / TICKS_PER_S


class PulseOutput:
    """The player of pulses: its methods return at once and never wait for the port, save `launch`, `trial` and `close`.

    `state`: "idle" (nothing queued), "run" (also backwards), "hold" (it brakes), "held", "failed" (`check` says why).
    """

    def __init__(self, worker: subprocess.Popen, ring: PulseRing, port: str, machine: Machine, places: Path | None):
        self._worker, self._ring, self._port, self._machine, self._places = worker, ring, port, machine, places
        self._words, self._reals, self._rows = ring.words, ring.reals, ring.rows
        self._writer = writer_of(machine)
        self._declared = [0] * PLAYED_AXES
        self._is_first = True  # the next row is the first one, or the first one behind a `drop`
        self._tick = 0
        self._peak = PeakRate()
        self._step_mm = hypot(*(1.0 / axis.steps_per_mm for axis in machine.axes))
        self._stall_watch = StallWatch(REAL_STILL_S if self._port_is_real else STILL_S)
        self._error: Exception | None = None
        self._is_closed = False

    @classmethod
    def launch(cls, port: str, machine: Machine) -> PulseOutput:
        """Start the player at a port: /dev/parport0, `record:FILE`, `socket://host:port`, a serial device.

        Waits until the port is open and the kernels are loaded. Raises LinkError where the port cannot be had,
        MachineRefusal where a motor has no pin.
        """
        writer_of(machine)  # refuses pins before a process is started
        ring = PulseRing.create()
        places = places_file(port) if is_board(machine) else None
        starts = command(sys.executable, "CNCStepper.workers.pulse_output")
        worker = subprocess.Popen(starts, stdin=subprocess.PIPE, stdout=subprocess.PIPE, env=environment())
        output = cls(worker, ring, port, machine, places)
        try:
            output._tell_what()
            limit = threading.Timer(ANSWER_LIMIT_S, worker.kill)
            limit.start()
            try:
                answer(line_of(worker), "ready")
            finally:
                limit.cancel()
        except BaseException:
            output._end()
            raise
        finally:
            ring.forget_name()
        return output

    @property
    def process(self) -> int:
        """The number of the player's process."""
        return int(self._worker.pid)

    @property
    def room(self) -> int:
        """How many pulses may be appended now."""
        return max(0, AHEAD - self._queued)

    @property
    def queued_s(self) -> float:
        """The planned time of the rows that are appended and not played yet."""
        head, time_ns = int(self._words[HEAD]), self._rows.time_ns
        place = min(int(self._words[PLACE]), head)
        if place == head:
            return 0.0
        return float(time_ns[(head - 1) % ROWS] - time_ns[(place - 1) % ROWS]) / NS_PER_S

    @property
    def sent(self) -> int:
        """How many pulses were played, less those taken back."""
        return int(self._words[SENT])

    @property
    def position_steps(self) -> tuple[int, ...]:
        """Where the three axes are by the pulses played, in steps."""
        played = self._words[POSITION : POSITION + PLAYED_AXES].tolist()
        return tuple(steps + declared for steps, declared in zip(played, self._declared, strict=True))

    @property
    def rate_mm_min(self) -> float:
        """The path speed now."""
        return float(self._reals[SPEED]) * 60.0

    @property
    def state(self) -> str:
        """What it does, as in the class's text; a command that is not taken up yet counts as begun."""
        state = int(self._words[STATE])
        if state == FAILED or self._worker.poll() is not None:
            return STATES[FAILED]
        if self._words[ACKNOWLEDGED] != self._words[SERIAL]:
            pending = int(self._words[COMMAND])
            if pending in (HOLD, STOP, CLOSE):
                return "hold"
            return "run" if pending == BACK or self._queued else "idle"
        return "run" if state == IDLE and self._queued else STATES[state]

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
        count = len(ticks)
        if not count:
            return
        waits = np.diff(ticks, prepend=self._tick) * NS_PER_TICK
        if count > self.room or (waits[1:] <= 0.0).any() or (waits[0] <= 0.0 and not self._is_first):
            raise ValueError(Text("{count} pulses do not fit: no room, or ticks that do not rise", count=count))
        self._peak.add(ticks)
        self._reals[PEAK_PER_S] = max(self._reals[PEAK_PER_S], self._peak.per_s(TICKS_PER_S))
        speed = np.maximum(speed_mm_s, 0.0).astype(np.float64)
        way_mm = speed * waits / NS_PER_S
        rests = (speed == 0.0) | (way_mm > REST_STEPS * self._step_mm)
        if self._is_first:
            waits[0], rests[0] = 0.0, True
        acceleration = np.clip(acceleration_mm_s2, LEAST_ACCELERATION, MOST_ACCELERATION).astype(np.float64)
        changes = 2.0 * acceleration * np.where(rests, self._step_mm, np.minimum(way_mm, self._step_mm))
        self._write(step, back, speed, waits, changes, rests * IS_REST + np.asarray(is_rapid, bool) * IS_RAPID)
        stops_from = max(2.0 * changes[-1] ** 0.5, acceleration[-1] * AT_REST_S)
        self._words[ENDS_AT_REST] = speed[-1] <= stops_from
        self._words[HEAD] += count
        self._tick, self._is_first = int(ticks[-1]), False

    def declare(self, axis: int, steps: int) -> None:
        """Say where an axis is; nothing moves."""
        self._declared[axis] = steps - int(self._words[POSITION + axis])

    def hold(self) -> None:
        """Brake along the path, within the planned acceleration; also ends a retract."""
        self._command(HOLD)

    def resume(self) -> None:
        """Move forwards again from the present place; a retract brakes first."""
        self._command(RESUME)

    def share(self, feed: float, rapid: float) -> None:
        """Set the speeds of feeds and of rapids as shares of the planned ones, 0.1 to 1.0; above that it is 1.0."""
        self._reals[FEED_SHARE] = min(max(feed, LEAST_SHARE), 1.0)
        self._reals[RAPID_SHARE] = min(max(rapid, LEAST_SHARE), 1.0)

    def back(self, pulses: int) -> None:
        """From "held": play so many pulses backwards, then be held again; fewer where no more are kept (`kept`).

        Raises ValueError where it is not held.
        """
        if self.state != STATES[AT_HOLD]:
            raise ValueError(Text("pulses can be retracted only in a hold, not in state {state}", state=self.state))
        self._command(BACK, int(self._words[PLACE]) - min(pulses, self.kept))

    @property
    def kept(self) -> int:
        """How many pulses `back` can take back at most."""
        return min(int(self._words[PLACE] - self._words[OLDEST]), KEPT)

    def drop(self) -> None:
        """At rest ("idle" or "held"): discard the rows that are appended and not played.

        It stays "held" until `resume`, which finds nothing queued then. Raises ValueError where it is not at rest.
        """
        if self.state not in (STATES[IDLE], STATES[AT_HOLD]):
            raise ValueError(Text("pulses are forgotten at rest only, not in state {state}", state=self.state))
        self._words[HEAD] = self._words[PLACE]
        self._words[ENDS_AT_REST] = 1
        self._is_first = True

    def stop_at_once(self) -> None:
        """Stop without a ramp, everything off; steps may be lost. It is "held" then: `drop`, then `resume`."""
        self._words[RELAYS] = 0
        self._command(STOP)

    def switch(self, device: str, on: bool) -> None:
        """Switch a device of the signals' pins now; raises MachineRefusal where it has no pin."""
        bit = self._writer.device_bit(device)
        self._words[RELAYS] = self._words[RELAYS] | bit if on else self._words[RELAYS] & ~bit

    def inputs(self) -> frozenset[int]:
        """Return the pins of the status port that are high, as last read; none where the port has no inputs."""
        register = int(self._words[INPUTS])
        return frozenset() if register == NO_INPUTS else high_pins(register)

    def trial(self, pulses_per_s: float, trial_s: float = TRIAL_S) -> Jitter:
        """At rest: play that many pulses a second that move nothing, and return how late they were.

        Waits for as long as it takes. What is late by a pulse at this rate is a stall from now on. Raises
        MachineRefusal where this computer cannot keep the rate, ValueError where it is not at rest.
        """
        if self.state not in (STATES[IDLE], STATES[AT_HOLD]):
            raise ValueError(Text("a rate is tried at rest only, not in state {state}", state=self.state))
        self._reals[TRIAL_PER_S], self._reals[TRIAL_LENGTH] = pulses_per_s, trial_s
        self._reals[PEAK_PER_S], self._peak = pulses_per_s, PeakRate()
        self._command(TRIAL)
        while self._words[ACKNOWLEDGED] != self._words[SERIAL]:
            self.check()
            time.sleep(LOOK_S)
        tried = jitter_of(*self._lateness())
        wanted_s = tried.writes / (WRITES_A_PULSE * pulses_per_s) if not is_board(self._machine) else trial_s
        self._check_kept(tried, wanted_s, pulses_per_s)
        return tried

    def jitter(self) -> Jitter:
        """Return how late the writes were since the start or the last trial."""
        return jitter_of(*self._lateness())

    def check(self) -> None:
        """Raise what ended the player: LinkError "pulses-late", "port-lost" or "pulse-worker".

        A player that stands still is ended here. To be called every 0.1 s or more often.
        """
        if self._error:
            raise self._error
        if self._is_closed:
            return
        if self._words[STATE] != FAILED and self._worker.poll() is None:
            self._check_beat()
            return
        try:
            answer(line_of(self._worker), "done")
            self._error = gone()
        except Exception as error:
            self._error = error
        if self._worker.wait() < 0 or getattr(self._error, "code", "") == "pulse-worker":
            self._leave_port_idle()
        raise self._error

    def close(self) -> None:
        """Brake if it moves, switch everything off, end the process and give the port back."""
        if self._is_closed:
            return
        failed = self.state == STATES[FAILED]
        self._command(CLOSE)
        self._end()
        if (failed or self._worker.returncode) and not self._error:
            self._leave_port_idle()

    # --- inside --------------------------------------------------------------------------------

    @property
    def _queued(self) -> int:
        return int(self._words[HEAD] - self._words[PLACE])

    def _command(self, what: int, goal: int = 0) -> None:
        words = self._words
        words[COMMAND], words[GOAL] = what, goal
        words[SERIAL] += 1

    def _check_beat(self) -> None:
        watch = self._stall_watch
        still_s = watch.still_s(int(self._words[BEAT]), time.monotonic())
        if still_s > watch.limit_s:
            self._error = stands(still_s, watch.limit_s)
            self._worker.kill()
            self._worker.wait()
            self._leave_port_idle()
            raise self._error

    def _write(self, step: Any, back: Any, speed: Any, waits: Any, changes: Any, flags: Any) -> None:
        """Write rows behind the head, which the player does not read before the head is behind them."""
        head = int(self._words[HEAD])
        self._words[OLDEST] = max(int(self._words[OLDEST]), head + len(step) - ROWS)
        rows, before = self._rows, (head - 1) % ROWS
        places = np.arange(head, head + len(step)) % ROWS
        rows.time_ns[places] = rows.time_ns[before] + np.cumsum(waits)
        rows.energy[places] = rows.energy[before] + np.cumsum(changes)
        rows.speed[places], rows.step[places], rows.back[places], rows.flags[places] = speed, step, back, flags

    def _lateness(self) -> tuple[int, float, int, int, Any]:
        words = self._words
        counts = int(words[WRITES]), float(self._reals[TAKEN_S]), int(words[LATE_NS]), int(words[WORST_NS])
        return *counts, self._ring.bins

    def _check_kept(self, tried: Jitter, wanted_s: float, pulses_per_s: float) -> None:
        stall_us = stall_ns(WRITES_A_PULSE * pulses_per_s) / 1000
        follows = self._port_is_real
        if tried.taken_s <= wanted_s * (MOST_LONGER if follows else LONGER) and (
            tried.worst_us <= stall_us or not follows
        ):
            return
        raise MachineRefusal(
            "pulse-rate",
            "this computer cannot keep the rate of the program's pulses",
            value=Text(
                "{number:.0f} pulses/s, the worst {worst_us:.0f} µs late",
                number=tried.writes / WRITES_A_PULSE / tried.taken_s,
                worst_us=tried.worst_us,
            ),
            limit=Text("{per_s:.0f} pulses/s, {stall_us:.0f} µs", per_s=pulses_per_s, stall_us=stall_us),
            advice="end other programs, or lower max_rate_mm_min in the machine's profile",
        )

    @property
    def _port_is_real(self) -> bool:
        if self._port.startswith((RECORD, SOCKET)):
            return False
        return is_parallel_port(Path(self._port)) or self._places is not None

    def _tell_what(self) -> None:
        wanted = {
            "ring": str(self._ring.path),
            "port": self._port,
            "is_board": is_board(self._machine),
            "signals": self._machine.signals.model_dump(),
            "axes": len(self._machine.axes),
            "places_file": str(self._places) if self._places else "",
        }
        assert self._worker.stdin
        with suppress(OSError):  # it may have ended already: its answer has the reason
            self._worker.stdin.write(json.dumps(wanted).encode("ascii") + b"\n")
            self._worker.stdin.flush()

    def _end(self) -> None:
        """Let the worker end, which it does when its input closes; a worker that hangs is killed."""
        assert self._worker.stdin and self._worker.stdout
        self._is_closed = True
        with suppress(OSError):
            self._worker.stdin.close()
        try:
            self._worker.wait(END_LIMIT_S)
        except subprocess.TimeoutExpired:
            self._worker.kill()
            self._worker.wait()
        self._worker.stdout.close()

    def _leave_port_idle(self) -> None:
        leave_port_idle(self._port, self._machine, self._places, self._words)
