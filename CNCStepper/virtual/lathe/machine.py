# SPDX-License-Identifier: LGPL-2.1-or-later
"""The lathe: one byte a command in manual mode, records in automatic mode, and no way back.

manual     A B   X towards the centre, away from it, at rapid     C D   Z right (away from the chuck), left
           E F   the same at feed speed                           G H   the same at feed speed
           I number ?   the feed speed in mm/s      P   stop      Y   automatic mode      Z   quit
automatic  records ... # ... # ... ?      begins with the "?", cannot be stopped; M02 ends the program for good

The link has no answers. While a manual move runs only P is taken; a rapid then stops by its ramp.
"""

from __future__ import annotations

import math
from enum import Enum
from typing import Literal

import numpy as np

from CNCStepper.errors import MachineRefusal
from CNCStepper.machine.profile import Machine
from CNCStepper.virtual.faults.plan import Fault
from CNCStepper.virtual.lathe.receiver import BUFFER_BYTES, CHUNK_END, Buffer, SerialLine
from CNCStepper.virtual.lathe.records import Reader, Steps
from CNCStepper.virtual.lathe.stepping import (
    PULL_OUT_TICKS,
    TICK_S,
    braking_ticks,
    feed_wait_ticks,
    line,
    rapid_ticks,
)

STEPS_PER_MM = 80.0
MANUAL_FEED_MM_S = 1.0  # before the first I; the source does not say
WAYS = ((0, -1), (0, 1), (1, -1), (1, 1))  # axis and sense, in the order of the letters
MANUAL_MOVES = dict(zip("ABCDEFGH", WAYS * 2, strict=True))
RAPIDS = "ABCD"
LONGEST_NUMBER = 12


class Mode(Enum):
    """Which commands the controller takes."""

    MANUAL = "manual"
    AUTOMATIC = "automatic"
    ENDED = "ended"  # after M02 or Z: nothing, until its supply is switched off and on


class Lathe:
    """The lathe at its line; see `CNCStepper.virtual.server.twin_faults.Twin` for how it is driven.

    machine: whose x and z have the steps per mm; 80 when left out. buffer_bytes: of its receive buffer. thread_start:
    whether each run of G01 begins at the encoder's index. spindle_rpm: set by hand, 0 while it stands.
    refused: the records left out, with the reason.
    """

    columns: tuple[str, ...] = ("x", "z")

    def __init__(
        self,
        machine: Machine | None = None,
        *,
        buffer_bytes: int = BUFFER_BYTES,
        g20: Literal["radius", "diameter"] = "radius",
        g70: Literal["mm", "inch"] = "mm",
        thread_start: bool = False,
        spindle_rpm: float = 0.0,
    ):
        self.time_s = 0.0
        self.mode = Mode.MANUAL
        self.spindle_rpm = spindle_rpm
        self.refused: list[str] = []
        self.line = SerialLine()
        self.buffer = Buffer(buffer_bytes)
        self.places = [0, 0]  # steps of X and Z
        axes = machine.own_axes if machine else {}
        steps = tuple(axes[name].steps_per_mm if name in axes else STEPS_PER_MM for name in "xz")
        self.reader = Reader(g20, g70, (steps[0], steps[1]))
        self._thread_start = thread_start
        self._feed_mm_s = MANUAL_FEED_MM_S
        self._number: str | None = None  # of an I that has begun
        self._times, self._way = np.empty(0), np.empty((0, 2), np.int64)  # of the move under way: steps to come
        self._manual = ""  # its letter
        self._made = 0  # steps of a manual move
        self._next_s = math.inf  # of a manual move: its next step
        self._brakes: list[int] = []  # waits that stop it, the next one last
        self._stalled_until_s = [0.0, 0.0]
        self._path, self._notes = list[tuple[float, ...]](), list[tuple[float, str]]()
        self._blocks: list[np.ndarray] = []

    # -- the outside ---------------------------------------------------------------------------------

    @property
    def room(self) -> int:
        """How many bytes it takes now."""
        return self.line.room

    @property
    def moving(self) -> bool:
        """Whether a motor is to turn."""
        return bool(self._manual) or len(self._times) > 0

    @property
    def quiet(self) -> bool:
        """Whether nothing moves and no byte is on its way."""
        return not self.moving and self.line.next_s is None and not self._has_work

    @property
    def places_mm(self) -> tuple[float, ...]:
        """Where X (as a radius) and Z are, from where they began."""
        return tuple(place / steps for place, steps in zip(self.places, self.reader.steps_per_mm, strict=True))

    def open(self) -> None:
        """Let a client come: the lathe does not notice."""

    def receive(self, data: bytes, since_s: float, now_s: float) -> None:
        """Take bytes that came not after `now_s`: no more than there is room."""
        self.line.put(data, max(now_s, self.time_s))

    def advance(self, now_s: float) -> None:
        """Let time pass up to `now_s`, from one byte or step to the next."""
        while (event_s := self._until_s()) <= now_s:
            self.time_s = max(event_s, self.time_s)
            if self.line.next_s is not None and self.line.next_s <= event_s:
                self._hear(self.line.get())
            elif self._manual:
                self._step_by_hand()
            else:
                self._run_program_steps(now_s)
            self._work()
        self.time_s = now_s

    def take_output(self) -> bytes:
        """Return nothing: the lathe never says anything."""
        return b""

    def take_path(self) -> list[np.ndarray]:
        """Return the places since the last call, float64[k, 3]: t_s, x_mm, z_mm."""
        self._close_block()
        blocks, self._blocks = self._blocks, []
        return blocks

    def take_notes(self) -> list[tuple[float, str]]:
        """Return what happened since the last call: time in s and a sentence."""
        notes, self._notes = self._notes, []
        return notes

    def inject(self, fault: Fault) -> None:
        """Let a motor stall, or the supply fail for a moment: the lathe then begins anew, in manual mode."""
        if fault.kind == "stall" and fault.motor in self.columns:
            self._stalled_until_s[self.columns.index(fault.motor)] = self.time_s + fault.for_s
        elif fault.kind == "power":
            self._begin_anew()

    # -- bytes ---------------------------------------------------------------------------------------

    def _hear(self, byte: int) -> None:
        if self.mode is Mode.ENDED:
            return
        if self._manual and not self._brakes and byte != ord("P"):
            return
        if self._manual and byte == ord("P"):
            self._stop_by_hand()
        elif not self.buffer.put(byte):
            self._note(f"the buffer of {self.buffer.size} bytes is full: a byte is lost")

    @property
    def _has_work(self) -> bool:
        return self.buffer.has_chunk if self.mode is Mode.AUTOMATIC else len(self.buffer) > 0

    def _work(self) -> None:
        """Do what waits in the buffer, while nothing moves."""
        while self._has_work and not self.moving:
            if self.mode is Mode.AUTOMATIC:
                self._run_record()
            elif self.mode is Mode.MANUAL:
                self._take_command(self.buffer.take_byte())
            else:
                self.buffer.clear()

    # -- manual mode ---------------------------------------------------------------------------------

    def _take_command(self, byte: int) -> None:
        letter = chr(byte)
        if self._number is not None:
            self._take_digit(letter)
        elif letter in MANUAL_MOVES:
            self._manual, self._made = letter, 0
            self._next_s = self.time_s + self._manual_ticks() * TICK_S
        elif letter == "I":
            self._number = ""
        elif letter == "Y":
            self.mode = Mode.AUTOMATIC
            self.reader.places = [0, 0]  # the zero of a program is where the tool was driven to by hand
            self.reader.begin()
            self._note("automatic mode")
        elif letter == "Z":
            self._end("the controller was quit")
        elif letter != "P":
            self._note(f"byte {byte:02X} is no command of the manual mode")

    def _take_digit(self, letter: str) -> None:
        assert self._number is not None
        if letter != chr(CHUNK_END) and len(self._number) < LONGEST_NUMBER:
            self._number += letter
            return
        text, self._number = self._number, None
        try:
            feed_mm_s = float(text)
        except ValueError:
            feed_mm_s = 0.0
        if 0.0 < feed_mm_s < math.inf:
            self._feed_mm_s = feed_mm_s
        else:
            self._note(f"I{text}: this is no feed speed")

    def _manual_ticks(self) -> int:
        if self._manual in RAPIDS:
            return int(PULL_OUT_TICKS[min(self._made, len(PULL_OUT_TICKS) - 1)])
        return feed_wait_ticks(self._feed_mm_s, self.reader.steps_per_mm[MANUAL_MOVES[self._manual][0]])

    def _step_by_hand(self) -> None:
        axis, way = MANUAL_MOVES[self._manual]
        self._made += 1
        self._step(axis, way)
        if self._brakes:
            self._brakes.pop()
            if not self._brakes:
                self._manual, self._next_s = "", math.inf
                return
            ticks = self._brakes[-1]
        else:
            ticks = self._manual_ticks()
        self._next_s = self.time_s + ticks * TICK_S

    def _stop_by_hand(self) -> None:
        """Stop a manual move: a feed at once, a rapid by its ramp."""
        if self._brakes:
            return
        if self._manual in RAPIDS:
            self._brakes = braking_ticks(self._made)[::-1].tolist()
        if not self._brakes:
            self._manual, self._next_s = "", math.inf

    # -- automatic mode ------------------------------------------------------------------------------

    def _run_record(self) -> None:
        record, ends = self.buffer.take_record()
        try:
            move = self.reader.read(record)
        except MachineRefusal as refusal:
            move = None
            self.refused.append(str(refusal))
            self._note(str(refusal))
        if self.reader.ended:
            self._end("M02: the program has ended")
        elif move:
            self._begin_move(move)
        if ends:
            self.reader.end_chunk()

    def _begin_move(self, move: Steps) -> None:
        self._way = np.diff(line(move.x, move.z), axis=0, prepend=np.zeros((1, 2), np.int64))
        count = len(self._way)
        if move.feed_mm_s is None:
            ticks = rapid_ticks(count)
        else:
            longer = 0 if abs(move.x) >= abs(move.z) else 1
            ticks = np.full(count, feed_wait_ticks(move.feed_mm_s, self.reader.steps_per_mm[longer]), np.int64)
        begin_s = self._index_s() if move.begins_feed and self._thread_start else self.time_s
        self._times = begin_s + np.cumsum(ticks) * TICK_S

    def _index_s(self) -> float:
        """Return when the encoder's index comes by next; never while the spindle stands."""
        if self.spindle_rpm <= 0.0:
            self._note("the spindle stands: the thread waits for the encoder's index")
            return math.inf
        turn_s = 60.0 / self.spindle_rpm
        return math.ceil(self.time_s / turn_s - 1e-9) * turn_s

    def _run_program_steps(self, now_s: float) -> None:
        """Make the steps of a move up to `now_s` or to the next byte."""
        until_s = min(now_s, self.line.next_s if self.line.next_s is not None else now_s)
        count = max(int(np.searchsorted(self._times, until_s, side="right")), 1)
        times, way = self._times[:count], self._way[:count].copy()
        for axis, stalled_s in enumerate(self._stalled_until_s):
            way[times < stalled_s, axis] = 0
        places = self.places + np.cumsum(way, axis=0)
        self.places = [int(place) for place in places[-1]]
        self._close_block()
        self._blocks.append(np.column_stack((times, places / np.array(self.reader.steps_per_mm))))
        self.time_s = float(times[-1])
        self._times, self._way = self._times[count:], self._way[count:]

    # -- inside --------------------------------------------------------------------------------------

    def _until_s(self) -> float:
        """Return when the next byte or step comes."""
        step_s = self._next_s if self._manual else float(self._times[0]) if len(self._times) else math.inf
        return min(step_s, math.inf if self.line.next_s is None else self.line.next_s)

    def _step(self, axis: int, way: int) -> None:
        if self.time_s >= self._stalled_until_s[axis]:
            self.places[axis] += way
        self._path.append((self.time_s, *self.places_mm))

    def _close_block(self) -> None:
        if self._path:
            self._blocks.append(np.array(self._path))
            self._path = []

    def _end(self, why: str) -> None:
        self.mode = Mode.ENDED
        self.buffer.clear()
        self._note(why)

    def _begin_anew(self) -> None:
        """Begin as after switching on; the motors keep their places."""
        self.line.clear()
        self.buffer.clear()
        self.mode, self._number, self._feed_mm_s = Mode.MANUAL, None, MANUAL_FEED_MM_S
        self._manual, self._next_s, self._brakes = "", math.inf, []
        self._times, self._way = np.empty(0), np.empty((0, 2), np.int64)
        self._note("the supply came back: manual mode")

    def _note(self, text: str) -> None:
        self._notes.append((self.time_s, text))
