# SPDX-License-Identifier: LGPL-2.1-or-later
"""The loop of the process that plays pulses: read commands, plan the next time slice, write it, repeat.

    look ──► plan SLICE_NS ahead (motion/signals/pulse_player.py) ──► registers or bytes ──► write each when it is due
      ▲                                                                                          │
      └──────────────────────── state, place, lateness for the other process ◄───────────────────┘

A command counts from the next look on, so that a hold begins to brake at most one moment and the direction's set-up
later. Where nothing is due the process sleeps. It ends, at rest and with everything off, when it is told to, when the
other process is gone and when it gets SIGTERM; it ends at once, with everything off, when pulses come too late.
"""

from __future__ import annotations

import time
from collections.abc import Sequence
from typing import Any, Protocol

import numpy as np

from CNCStepper.control.pulses.output_ports import WRITE_LIMIT_S, OutputPort
from CNCStepper.control.pulses.pacing import (
    LEAST_PULSES_PER_S,
    NS_PER_S,
    WRITES_A_PULSE,
    ZERO_AGAIN,
    Pacer,
    Write,
    stall_ns,
)
from CNCStepper.control.pulses.pulse_ring import (
    ACKNOWLEDGED,
    AT_HOLD,
    BACK,
    BEAT,
    BRAKING,
    CLOSE,
    COMMAND,
    GOAL,
    HOLD,
    IDLE,
    INPUTS,
    LATE_NS,
    PEAK_PER_S,
    PLACES,
    RELAYS,
    RESUME,
    RUN,
    SERIAL,
    SPEED,
    STATE,
    STOP,
    TAKEN_S,
    TRIAL,
    TRIAL_PER_S,
    TRIAL_S,
    WORST_NS,
    WRITES,
    PulseRing,
)
from CNCStepper.errors import LinkError, Text
from CNCStepper.motion.signals.pulse_player import (
    BOUNDARY,
    BRAKES,
    DUE_NS,
    HEAD,
    IS_STALE,
    PLACE,
    PLANNED,
    SCALE,
    SENSE,
    STANDS,
    STARVES,
    TARGET,
    PulseRows,
    new_state,
    play,
)

SLICE_NS = 2_000_000
MOST_PULSES = 1024  # of a slice
STALE_S = 0.05
MOST_STARVED_NS = 250_000_000
WAIT_S, REST_S, LONG_REST_S = 0.001, 0.002, 0.004
LONG_NS = NS_PER_S  # of rest, after which it looks less often
SLIP_NS = 1_000_000  # by which the signals' own times may delay pulses before all later ones come later too
MOST_QUEUED_BYTES = 16
MOST_TRIAL_PULSES = 1_000_000


class Writer(Protocol):
    """Makes the writes of pulses: motion/signals/parallel_port_registers.py or port_bytes.py."""

    @property
    def lead_ns(self) -> int:
        """By how much pulses are written later than they are due."""

    @property
    def keep_ns(self) -> int:
        """Writes that are due no farther apart are kept apart."""

    def writes(self, due: np.ndarray, step: np.ndarray, back: np.ndarray) -> list[Any]:
        """Return the writes of pulses."""

    def late_ns(self) -> int:
        """Return by how much the signals' times delayed them."""

    def ready(self, now_ns: int) -> tuple[list[Any], int]:
        """Return what switches the drives on, and from when on pulses may come."""

    def relays(self, bits: int, now_ns: int) -> list[Any]:
        """Return what switches the devices."""

    def off(self, now_ns: int) -> list[Any]:
        """Return what switches everything off."""


class PulseLoop:
    """Plays the pulses of a ring to a port.

    is_left: set from outside when nobody appends or commands any more.
    """

    def __init__(self, ring: PulseRing, writer: Writer, port: OutputPort, begin_ns: int):
        self._ring, self._writer, self._port, self._begin_ns = ring, writer, port, begin_ns
        self._words, self._reals = ring.words, ring.reals
        self._pacer = self._new_pacer(ring.bins.data)
        self._due = np.empty(MOST_PULSES, np.int64)
        self._steps, self._backs = np.empty(MOST_PULSES, np.uint8), np.empty(MOST_PULSES, np.uint8)
        self._columns = ring.rows.columns
        self._wanted = 0  # RESUME or BACK, until the axes stand
        self._goal = self._heard = self._relays = self._last_head = 0
        self._head_since_ns = self._rest_since_ns = 0
        self._took_ns = 0  # when the device had last taken what it was given
        self._flowed = self._was_tried = False
        self.is_left = False

    def run(self) -> None:
        """Play until the end, which leaves everything off; raises LinkError for a lost port and for late pulses."""
        try:
            while self.goes_on():
                pass
        finally:
            self._pacer.write(self._writer.off(self._pacer.now_ns()))

    def goes_on(self) -> bool:
        """Read commands and play the next time slice; return False at the end, at rest."""
        if self._look() and self._is_at_rest():
            return False
        moved = self._slice()
        self._publish()
        if not moved:
            self._rest()
        return True

    # --- commands ------------------------------------------------------------------------------

    def _look(self) -> bool:
        """Execute the commands of the other process; return whether this one is to end."""
        words, serial = self._words, int(self._words[SERIAL])
        if serial != self._heard:
            self._take_command(int(words[COMMAND]), int(words[GOAL]))
            self._heard = serial
        if self.is_left:
            words[BRAKES], self._wanted = 1, 0
        self._turn()
        words[INPUTS] = self._port.status()
        self._switch_relays()
        return self.is_left

    def _switch_relays(self) -> None:
        if self._words[RELAYS] != self._relays:
            self._relays = int(self._words[RELAYS])
            self._pacer.write(self._writer.relays(self._relays, self._pacer.now_ns()))

    def _take_command(self, command: int, goal: int) -> None:
        self._wanted = 0
        if command in (RESUME, BACK):
            self._wanted, self._goal = command, goal
        elif command == TRIAL:
            self._try_rate()
        elif command in (HOLD, STOP, CLOSE):
            self._words[BRAKES] = 1
            self.is_left |= command == CLOSE
        if command == STOP:
            self._words[STANDS], self._words[STARVES] = 1, 0
            self._pacer.write(self._writer.off(self._pacer.now_ns()))
            self._relays = 0

    def _turn(self) -> None:
        """Begin to move as it is wanted, once the axes stand; going back ends at its goal."""
        words = self._words
        forwards = self._wanted == RESUME
        if self._wanted and (words[STANDS] or (forwards and words[SENSE] > 0)):
            if words[STANDS]:
                self._reals[DUE_NS] = max(self._reals[DUE_NS], self._pacer.now_ns())
            words[SENSE], words[TARGET], words[BRAKES] = 1 if forwards else -1, self._goal, 0
            self._wanted = 0
        elif self._wanted or (words[SENSE] < 0 and words[STANDS] and words[PLACE] <= words[TARGET]):
            words[BRAKES] = 1

    # --- pulses --------------------------------------------------------------------------------

    def _slice(self) -> bool:
        """Plan and write the next time slice; return whether it has pulses."""
        words, now = self._words, self._pacer.now_ns()
        is_at_rest = self._is_at_rest()
        if is_at_rest or self._is_jammed(now):
            words[BOUNDARY] = 0
            self._flowed = False
            if is_at_rest:
                self._took_ns = now
                words[STANDS] |= words[BRAKES]  # a hold that comes while nothing is queued
            return False
        if self._was_tried:
            self._new_jitter()
        self._note_stale(now)
        switched, ready = self._writer.ready(now)
        stall = stall_ns(WRITES_A_PULSE * max(self._reals[PEAK_PER_S], LEAST_PULSES_PER_S))
        earliest = max(ready, now - stall if self._flowed else now)
        writes = self._play_to(self._columns, words, self._reals, earliest, now + SLICE_NS)
        self._flowed = bool(writes)
        if (late := self._writer.late_ns()) > SLIP_NS:
            self._reals[DUE_NS] += late
        self._pacer.write(switched + writes, max(stall, self._port.patience_ns))
        if words[STARVES]:
            self._check_starved(stall)
        return self._flowed

    def _play_to(
        self, columns: Sequence[np.ndarray], words: np.ndarray, reals: np.ndarray, earliest: int, until: int
    ) -> list[Write]:
        due, step, back = self._due, self._steps, self._backs
        count = play(*columns, words, reals, earliest, until, due, step, back)
        return self._writer.writes(due[:count], step[:count], back[:count]) if count else []

    def _is_jammed(self, now: int) -> bool:
        """Return whether the device has not taken yet what it was given; raises LinkError where that lasts too long."""
        if self._port.queued() <= MOST_QUEUED_BYTES:
            self._took_ns = now
            return False
        if now - self._took_ns > WRITE_LIMIT_S * NS_PER_S:
            what = Text("the device has accepted nothing for {limit:g} s; steps may be lost", limit=WRITE_LIMIT_S)
            raise LinkError("port-lost", what, advice=ZERO_AGAIN)
        return True

    def _note_stale(self, now: int) -> None:
        head = int(self._words[HEAD])
        if head != self._last_head:
            self._last_head, self._head_since_ns = head, now
        self._words[IS_STALE] = now - self._head_since_ns > STALE_S * NS_PER_S

    def _check_starved(self, stall: int) -> None:
        """Raise LinkError where pulses are wanting while the axes move, longer than a motor can wait.

        No motor follows a recording: it continues from rest.
        """
        late = self._pacer.now_ns() - self._reals[DUE_NS] - self._writer.lead_ns
        limit = max(2 * stall, min(self._port.patience_ns, MOST_STARVED_NS))
        if late > limit and self._port.patience_ns > MOST_STARVED_NS:
            self._words[STARVES], self._words[STANDS] = 0, 1
        elif late > limit:
            raise LinkError(
                "pulses-late",
                "the pulses were stopped: no more of them came in time; everything is off, and steps may be lost",
                value=Text("{late_ms:.0f} ms without a pulse", late_ms=late / 1e6),
                limit=Text("{limit_ms:.0f} ms", limit_ms=limit / 1e6),
                advice=ZERO_AGAIN,
            )

    # --- state ---------------------------------------------------------------------------------

    def _is_at_rest(self) -> bool:
        """Return whether nothing is to be played: held, or nothing is queued and the path has ended."""
        words = self._words
        if words[BRAKES] and words[STANDS]:
            return True
        return bool(words[SENSE] > 0 and words[PLACE] >= words[HEAD] and not words[STARVES])

    def _state(self) -> int:
        words = self._words
        if words[BRAKES]:
            return AT_HOLD if words[STANDS] else BRAKING
        return IDLE if self._is_at_rest() else RUN

    def _publish(self) -> None:
        words, pacer = self._words, self._pacer
        state = self._state()
        words[WRITES], words[LATE_NS], words[WORST_NS] = pacer.writes, pacer.late_ns, pacer.worst_ns
        moves = state in (RUN, BRAKING) and not words[STANDS]
        self._reals[SPEED] = self._reals[SCALE] * self._reals[PLANNED] if moves else 0.0
        if places := getattr(self._writer, "places", ()):
            words[PLACES : PLACES + len(places)] = places
        words[STATE] = state
        words[ACKNOWLEDGED] = self._heard
        words[BEAT] += 1

    def _rest(self) -> None:
        """Sleep until it is time to look again."""
        self._port.rest()
        now = self._pacer.now_ns()
        if not self._is_at_rest():
            self._rest_since_ns = now
            time.sleep(WAIT_S)
        else:
            time.sleep(LONG_REST_S if now - self._rest_since_ns > LONG_NS else REST_S)

    # --- trial ---------------------------------------------------------------------------------

    def _try_rate(self) -> None:
        """Play pulses of no axis at a rate, all when they are due however late; the counts are of the trial then."""
        per_s, begin = float(self._reals[TRIAL_PER_S]), self._pacer.now_ns()
        words, reals = new_state()
        words[HEAD] = min(int(per_s * self._reals[TRIAL_S]) + 1, MOST_TRIAL_PULSES)
        rows = _still_rows(int(words[HEAD]), NS_PER_S / per_s)
        self._new_jitter()
        while words[PLACE] < words[HEAD] and not self.is_left:
            self._switch_relays()  # a reset must not wait for the trial's end
            self._words[BEAT] += 1
            now = self._pacer.now_ns()
            writes = self._play_to(rows, words, reals, begin, now + SLICE_NS)
            self._pacer.write(writes)
            if not writes:
                time.sleep(WAIT_S)
        self._reals[TAKEN_S] = (self._pacer.now_ns() - begin) / NS_PER_S
        self._was_tried = True
        self._writer.late_ns()

    def _new_jitter(self) -> None:
        self._was_tried = False
        self._ring.bins[:] = 0
        self._pacer = self._new_pacer(self._ring.bins.data)

    def _new_pacer(self, bins: memoryview) -> Pacer:
        return Pacer(self._port, self._writer.keep_ns, self._begin_ns, bins, self._port.sleep_ns)


def load_kernels(writer: Writer) -> None:
    """Call the kernels once, so that their machine code is there before the first pulse; the writer is as it was."""
    words, reals = new_state()
    words[HEAD] = 1
    due, masks = np.empty(1, np.int64), np.empty((2, 1), np.uint8)
    play(*_still_rows(1, 1.0), words, reals, 0, SLICE_NS, due, *masks)
    writer.writes(due, *masks)
    writer.late_ns()


def _still_rows(count: int, wait_ns: float) -> tuple[np.ndarray, ...]:
    """Return rows of no axis at a steady rate."""
    kinds = (np.float64, np.float64, np.float32, np.uint8, np.uint8, np.uint8)
    rows = PulseRows(*(np.zeros(count, kind) for kind in kinds))
    rows.time_ns[:] = np.arange(count) * wait_ns
    rows.speed[:] = 1.0
    return rows.columns
