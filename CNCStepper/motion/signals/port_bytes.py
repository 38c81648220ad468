# SPDX-License-Identifier: LGPL-2.1-or-later
"""Board bytes (source system D): a byte sets the coils of one of four motors.

    0x 2 9      high nibble: motor 0 to 3, low nibble: coils L1 L2 L3 L4
       │ └ full step, two phases: A 9 5 6 forwards and again, 6 5 9 A backwards
       └── a change of this nibble is the clock edge that takes the coils in

Two pulses in a row for one motor need a null pulse between them: another motor, none of its coils. That is one with
no motor on it where there is one, since another one's coils drop out.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Literal

import numpy as np

from CNCStepper.errors import MachineRefusal, Text
from CNCStepper.kernels import njit
from CNCStepper.machine.profile import AXIS_NAMES
from CNCStepper.machine.wiring import BOARD_MOTORS
from CNCStepper.motion.signals.coils import BEFORE_FIRST, TWO_PHASES
from CNCStepper.motion.signals.pulse_stream import PulseStream

MOTOR_STEP = 0x10


class Board:
    """A writer of board bytes that keeps each motor's place and which motor is selected.

    motors: the axis that each motor of the board turns, "-x" the other way round; an axis may have several. null_motor:
    the one that a null pulse selects, the next one where that is selected already; "unused": one without an axis.
    """

    def __init__(self, motors: Sequence[str] = AXIS_NAMES, null_motor: int | Literal["unused"] = "unused"):
        if len(motors) > BOARD_MOTORS:
            limit = f"{BOARD_MOTORS} motors"
            what, advice = "the board has no such motors", "name fewer motors in the machine's profile"
            raise MachineRefusal("board-motors", what, value=f"{len(motors)}", limit=limit, advice=advice)
        self._axis = np.array([AXIS_NAMES.index(motor[-1]) for motor in motors], np.int64)
        self._sense = np.array([-1 if motor.startswith("-") else 1 for motor in motors], np.int64)
        self._places = np.full(len(motors), BEFORE_FIRST, np.int64)
        self._last = np.full(1, -1, np.int64)  # the motor that is selected
        self._null = null_motors(len(motors), null_motor)
        self._sequence = np.array(TWO_PHASES, np.uint8)

    def bytes_of(self, stream: PulseStream) -> Iterator[bytes]:
        """Yield the bytes of a stream; places and selection are kept for the next one.

        Devices have no byte on this board, and neither has an axis without a motor: they are left out.
        """
        for chunk in stream:
            yield self._bytes(chunk.step, chunk.back)

    def writes(self, due: np.ndarray, step: np.ndarray, back: np.ndarray) -> list[tuple[int, bytes, int]]:
        """Return (ns, bytes, their number) of pulses that are due at `due`, int64[k]; one of no axis moves nothing."""
        made = [self._bytes(step[row : row + 1], back[row : row + 1]) or self._nothing() for row in range(len(due))]
        return [(at, data, len(data)) for at, data in zip(due.tolist(), made, strict=True)]

    @property
    def places(self) -> tuple[int, ...]:
        """Each motor's place in the sequence, and behind them the motor that is selected, -1 for none."""
        return (*self._places.tolist(), int(self._last[0]))

    @places.setter
    def places(self, places: Sequence[int]) -> None:
        self._places[:], self._last[0] = places[:-1], places[-1]

    def _bytes(self, step: np.ndarray, back: np.ndarray) -> bytes:
        room = np.empty(2 * len(self._axis) * len(step), np.uint8)
        memory = (self._axis, self._sense, self._null, self._places, self._last)
        return room[: _write_board(step, back, self._sequence, *memory, room)].tobytes()

    def _nothing(self) -> bytes:
        """Return a byte for the selected motor, with its coils unchanged."""
        motor = int(self._last[0])
        return bytes((motor * MOTOR_STEP + TWO_PHASES[self._places[motor]],)) if motor >= 0 else b""


class BoardWriter(Board):
    """What a board is written, as pulses come some at a time; it has neither devices nor drives to be switched.

    lead_ns, keep_ns: as of a parallel port.
    """

    lead_ns = keep_ns = 0

    def late_ns(self) -> int:
        """Return 0: a byte takes its time in the board."""
        return 0

    def ready(self, now_ns: int) -> tuple[list[tuple[int, bytes, int]], int]:
        """Return that nothing needs to be switched on, and that pulses may come from now on."""
        return [], now_ns

    def device_bit(self, device: str) -> int:
        """Raise MachineRefusal: no byte switches a device."""
        raise MachineRefusal(
            "no-pin", Text("the board has no byte that switches {device}", device=device), advice="switch it by hand"
        )

    def relays(self, bits: int, now_ns: int) -> list[tuple[int, bytes, int]]:
        """Return nothing."""
        return []

    def off(self, now_ns: int) -> list[tuple[int, bytes, int]]:
        """Return nothing: the coils hold the axes where they are, and the places in the sequences stay true."""
        return []


def null_motors(motors: int, null_motor: int | Literal["unused"]) -> np.ndarray:
    """Return for each motor of a board the one that a null pulse between two of its pulses selects, int64[motors]."""
    every = np.arange(motors)
    if null_motor != "unused":
        return np.where(every == null_motor, (null_motor + 1) % BOARD_MOTORS, null_motor)
    return np.full(motors, motors) if motors < BOARD_MOTORS else (every + 1) % BOARD_MOTORS


@njit
def _write_board(step, back, sequence, axis_of, sense_of, null_of, places, last, written):
    """Write a byte for each step of each motor, and null pulses before those of the selected one."""
    count = 0
    for row in range(len(step)):
        for motor in range(len(axis_of)):
            axis = axis_of[motor]
            if not (step[row] >> axis) & 1:
                continue
            if motor == last[0]:
                written[count] = null_of[motor] * MOTOR_STEP
                count += 1
            turn = -sense_of[motor] if (back[row] >> axis) & 1 else sense_of[motor]
            places[motor] = (places[motor] + turn) % len(sequence)
            written[count] = motor * MOTOR_STEP + sequence[places[motor]]
            count += 1
            last[0] = motor
    return count


def read_board(data: bytes, motors: int = 3) -> np.ndarray:
    """Return the steps that a board's motors make on some bytes, int64[k, motors], one row a pulse.

    A byte that selects the motor selected already is no clock edge and moves nothing. Raises MachineRefusal where
    coils do not follow each other in the sequence, and at coils of a motor that is not there.
    """
    places = [BEFORE_FIRST] * motors
    selected, moves = -1, []
    for number, byte in enumerate(data):
        motor, word = byte >> 4, byte & 0x0F
        if word and motor >= motors:
            what, advice = "the board has no such motor", "read it with as many motors as its board has"
            raise MachineRefusal("board-motors", what, value=f"byte {number}: {byte:02X}", advice=advice)
        if motor != selected and word:
            place = TWO_PHASES.index(word) if word in TWO_PHASES else places[motor]
            turn = (place - places[motor]) % len(TWO_PHASES)
            if turn not in (1, len(TWO_PHASES) - 1):
                what, advice = "a motor misses a place", "record the pulses again"
                raise MachineRefusal("board-sequence", what, value=f"byte {number}: {byte:02X}", advice=advice)
            places[motor] = place
            moves.append([(1 if turn == 1 else -1) * (k == motor) for k in range(motors)])
        selected = motor
    return np.array(moves, np.int64).reshape(-1, motors)
