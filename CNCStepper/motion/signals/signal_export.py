# SPDX-License-Identifier: LGPL-2.1-or-later
"""Signals as text: VCD for logic-analyser viewers, CSV of positions, of coils and of port writes; piece by piece.

Times are exact: a tick is written as a whole number of the largest decimal part of a second that divides it
(62.5 ns of the planner's clock are 625 × 100 ps).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

import numpy as np

from CNCStepper.errors import MachineRefusal
from CNCStepper.kernels import njit
from CNCStepper.motion.signals.coils import coil_words
from CNCStepper.motion.signals.device_switching import Switch
from CNCStepper.motion.signals.parallel_port_registers import PortChunk
from CNCStepper.motion.signals.pulse_stream import PulseStream
from CNCStepper.motion.signals.step_direction import Timeline

SCALES = {9: "1 ns", 10: "100 ps", 11: "10 ps", 12: "1 ps"}  # by the decimals of a second
DIGITS = 20  # room for one number and its sign
FIRST_ID = ord("!")  # of VCD's identifiers, one character a line
NEW_LINE, ZERO, COMMA, POINT, MINUS, HASH = (ord(character) for character in "\n0,.-#")


def decimals_of(ticks_per_s: int) -> int:
    """Return how many decimals of a second resolve every tick; raises MachineRefusal where 12 do not."""
    for decimals in SCALES:
        if 10**decimals % ticks_per_s == 0:
            return decimals
    raise MachineRefusal(
        "clock", "this clock's ticks are no whole picoseconds", value=f"{ticks_per_s} ticks/s", advice="use 16000000"
    )


def vcd(timeline: Timeline) -> Iterator[bytes]:
    """Yield the value change dump (IEEE 1364) of all lines of a timeline."""
    decimals = decimals_of(timeline.ticks_per_s)
    parts = 10**decimals // timeline.ticks_per_s
    ids = [chr(FIRST_ID + place) for place in range(len(timeline.lines))]
    wires = [f"$var wire 1 {id_} {name} $end\n" for id_, name in zip(ids, timeline.lines, strict=True)]
    zeros = [f"0{id_}\n" for id_ in ids]
    head = [f"$timescale {SCALES[decimals]} $end\n$scope module motion $end\n", *wires, "$upscope $end\n"]
    yield "".join([*head, "$enddefinitions $end\n$dumpvars\n", *zeros, "$end\n"]).encode("ascii")
    level = np.zeros(1, np.int64)
    for edges in timeline:
        text = np.empty(len(edges) * (DIGITS + 2 + 3 * len(ids)), np.uint8)
        yield text[: _write_vcd(edges.ticks, edges.levels, parts, level, text)].tobytes()


def position_csv(stream: PulseStream, names: Iterable[str] = "xyz") -> Iterator[bytes]:
    """Yield a table of every pulse: time in s, position of each axis in steps after it, and the outputs."""
    names = list(names)[: stream.axes]
    decimals = _decimals(stream)
    yield ("time_s," + "".join(f"{name}_steps," for name in names) + "switch\n").encode("ascii")
    position = np.array(stream.begin_steps, np.int64)
    for chunk in stream:
        done = 0
        for row, switch in [*((switch.row, switch) for switch in chunk.switches), (len(chunk), None)]:
            columns = (chunk.ticks[done:row], chunk.step[done:row], chunk.back[done:row])
            text = np.empty((row - done) * (DIGITS + 2) * (2 + len(position)), np.uint8)
            yield text[: _write_csv(*columns, _parts(stream, decimals), decimals, position, text)].tobytes()
            if switch:
                yield _switch_row(switch, stream, decimals, position)
            done = row


def coil_csv(stream: PulseStream, wires: Sequence[str], motors: Sequence[str], names: Sequence[str]) -> Iterator[bytes]:
    """Yield a table of every pulse: time in s, and the currents of each motor's coils after it.

    wires: of each place of the sequence, all as long. motors: as `coil_words` takes them; names: of their columns.
    """
    decimals, table = _decimals(stream), np.array([list(place.encode("ascii")) for place in wires], np.uint8)
    yield f"time_s,{','.join(names)}\n".encode("ascii")
    for chunk in coil_words(stream, range(len(wires)), motors=motors):
        text = np.empty(len(chunk.ticks) * (DIGITS + 2 + len(motors) * (1 + table.shape[1])), np.uint8)
        yield text[: _write_coils(chunk.ticks, chunk.words, table, _parts(stream, decimals), decimals, text)].tobytes()


def port_csv(chunks: Iterable[PortChunk], ticks_per_s: int, base: int) -> Iterator[bytes]:
    """Yield a table of every write to a parallel port: time in s, data and control register in hexadecimal."""
    decimals = decimals_of(ticks_per_s)
    yield f"time_s,0x{base:03X},0x{base + 2:03X}\n".encode("ascii")
    for chunk in chunks:
        text = np.empty(len(chunk) * (DIGITS + 10), np.uint8)
        columns = (chunk.ticks, chunk.data, chunk.control)
        yield text[: _write_port(*columns, 10**decimals // ticks_per_s, decimals, text)].tobytes()


def _decimals(stream: PulseStream) -> int:
    """Return the decimals of times; 0 for a stream whose ticks are counts."""
    return decimals_of(stream.ticks_per_s) if stream.ticks_per_s else 0


def _parts(stream: PulseStream, decimals: int) -> int:
    return 10**decimals // stream.ticks_per_s if stream.ticks_per_s else 1


def _switch_row(switch: Switch, stream: PulseStream, decimals: int, position: np.ndarray) -> bytes:
    text = np.empty(2 * DIGITS, np.uint8)
    time = text[: _write_time(switch.tick * _parts(stream, decimals), decimals, text, 0)].tobytes().decode("ascii")
    places = ",".join(map(str, position.tolist()))
    what = f"{switch.device} {'on' if switch.on else 'off'}{f' {switch.rpm:g}' if switch.rpm else ''}"
    return f"{time},{places},{what}\n".encode("ascii")


@njit
def _write_vcd(ticks, levels, parts, level, text):
    """Return edges as VCD; `level` has the levels of the lines before, and then after."""
    at = 0
    for row in range(len(ticks)):
        changed = level[0] ^ np.int64(levels[row])
        level[0] = levels[row]
        text[at] = HASH
        at = _write_number(ticks[row] * parts, text, at + 1)
        text[at] = NEW_LINE
        at += 1
        line = 0
        while changed:
            if changed & 1:
                text[at] = ZERO + ((level[0] >> line) & 1)
                text[at + 1] = FIRST_ID + line
                text[at + 2] = NEW_LINE
                at += 3
            changed >>= 1
            line += 1
    return at


@njit
def _write_csv(ticks, step, back, parts, decimals, position, text):
    """Write pulses as rows; `position` is where the axes are before, and then after; returns the bytes."""
    at = 0
    for row in range(len(ticks)):
        at = _write_time(ticks[row] * parts, decimals, text, at)
        text[at] = COMMA
        at += 1
        for axis in range(len(position)):
            if (step[row] >> axis) & 1:
                position[axis] += -1 if (back[row] >> axis) & 1 else 1
            at = _write_number(position[axis], text, at)
            text[at] = COMMA
            at += 1
        text[at] = NEW_LINE
        at += 1
    return at


@njit
def _write_coils(ticks, places, wires, parts, decimals, text):
    """Write the wires of each motor, at places of its sequence, as rows; returns the bytes."""
    at = 0
    for row in range(len(ticks)):
        at = _write_time(ticks[row] * parts, decimals, text, at)
        for place in places[row]:
            text[at] = COMMA
            text[at + 1 : at + 1 + wires.shape[1]] = wires[place]
            at += 1 + wires.shape[1]
        text[at] = NEW_LINE
        at += 1
    return at


@njit
def _write_port(ticks, data, control, parts, decimals, text):
    """Write port bytes as rows; returns the bytes."""
    at = 0
    for row in range(len(ticks)):
        at = _write_time(ticks[row] * parts, decimals, text, at)
        for value in (data[row], control[row]):
            text[at] = COMMA
            text[at + 1] = _hexadecimal(value >> 4)
            text[at + 2] = _hexadecimal(value & 15)
            at += 3
        text[at] = NEW_LINE
        at += 1
    return at


@njit
def _hexadecimal(value):
    return ZERO + value if value < 10 else 55 + value  # 55 + 10 is A


@njit
def _write_time(parts, decimals, text, at):
    """Write a number of decimal parts as seconds with all their decimals; returns the place behind."""
    if decimals == 0:
        return _write_number(parts, text, at)
    whole = 10**decimals
    at = _write_number(parts // whole, text, at)
    text[at] = POINT
    rest = parts % whole
    for place in range(decimals, 0, -1):
        text[at + place] = ZERO + rest % 10
        rest //= 10
    return at + decimals + 1


@njit
def _write_number(number, text, at):
    """Write a whole number; returns the place behind it."""
    if number < 0:
        text[at] = MINUS
        at += 1
        number = -number
    digits = 1
    bound = 10
    while digits < 19 and number >= bound:
        digits += 1
        bound *= 10
    for place in range(digits - 1, -1, -1):
        text[at + place] = ZERO + number % 10
        number //= 10
    return at + digits
