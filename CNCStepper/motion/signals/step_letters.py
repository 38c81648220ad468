# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pulse letters (source system D): one letter for one pulse of up to three axes, written and read.

    A +X   D −X   G +X+Y   M +X−Y   ...   one letter moves each of its axes by one step
    s t    spindle or beam on, off        our own, in small letters: the source has none that switch
                                          (M4 is `s` too, and read back as M3)
    m n    mist on, off                   devices, and its capitals are all taken
    f g    flood on, off

Blanks and line ends are ignored. Letters have no time: the board that reads them sets the interval.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import BinaryIO

import numpy as np

from CNCStepper.errors import Place, ProgramError, Text
from CNCStepper.machine.pulse_letters import MOVES
from CNCStepper.motion.signals.device_switching import Switch
from CNCStepper.motion.signals.pulse_stream import PULSE_ROWS, PulseChunk, PulseStream, check_axes, moved_steps

AXES = 3
LETTERS_A_LINE = 80
BLOCK_BYTES = 65_536
BLANKS = b" \t\r\n"
DEVICES = {
    "s": ("spindle_cw", True),
    "t": ("spindle_cw", False),
    "m": ("mist", True),
    "n": ("mist", False),
    "f": ("flood", True),
    "g": ("flood", False),
}
_CODE_OF = {("spindle" if name.startswith("spindle") else name, on): code for code, (name, on) in DEVICES.items()}


def _masks(move: str) -> tuple[int, int]:
    """Return the step and back bits of "+X-Y"."""
    bits = {sign + axis: 1 << place for place, axis in enumerate("XYZ") for sign in "+-"}
    moves = [move[at : at + 2] for at in range(0, len(move), 2)]
    return sum(bits[one] for one in moves), sum(bits[one] for one in moves if one.startswith("-"))


def _tables() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return letter uint8[8, 8] by step and back bits; step and back bits uint8[256] by letter."""
    letter, step, back = np.zeros((8, 8), np.uint8), np.zeros(256, np.uint8), np.zeros(256, np.uint8)
    for name, move in MOVES.items():
        bits, reverse = _masks(move)
        letter[bits, reverse] = ord(name)
        step[ord(name)], back[ord(name)] = bits, reverse
    return letter, step, back


_LETTER, _STEP, _BACK = _tables()
_DEVICE_CODES = np.frombuffer("".join(DEVICES).encode("ascii"), np.uint8)


def letters_of(stream: PulseStream) -> Iterator[bytes]:
    """Yield the letters of a stream, ASCII, in lines of LETTERS_A_LINE; raises MachineRefusal above three axes.

    Devices that have no letter (digital outputs) are left out.
    """
    check_axes(stream.axes, AXES)
    column = 0
    for chunk in stream:
        codes = _LETTER[chunk.step, chunk.back]
        on_rows = [(switch.row, _code(switch)) for switch in chunk.switches if _code(switch)]
        if on_rows:
            rows, devices = zip(*on_rows, strict=True)
            codes = np.insert(codes, rows, devices)
        text, column = _in_lines(codes, column)
        yield text
    if column:
        yield b"\n"


def _code(switch: Switch) -> int:
    """Return the letter that switches a device, 0 where there is none."""
    name = "spindle" if switch.device.startswith("spindle") else switch.device
    return ord(_CODE_OF.get((name, switch.on), "\0"))


def _in_lines(codes: np.ndarray, column: int) -> tuple[bytes, int]:
    """Return codes broken into lines, the first of which has `column` letters already, and the last one's letters."""
    ends = np.arange(LETTERS_A_LINE - column, len(codes) + 1, LETTERS_A_LINE)
    return np.insert(codes, ends, ord("\n")).tobytes(), (column + len(codes)) % LETTERS_A_LINE


def read_letters(pieces: Iterable[bytes], ticks_a_pulse: int = 1, file: str = "") -> Iterator[PulseChunk]:
    """Yield the pulses that letters mean, one every `ticks_a_pulse` ticks, as the bytes come.

    Raises ProgramError at the first byte that is no letter of this language.
    """
    rows = line = 0
    for piece in pieces:
        for first in range(0, len(piece), PULSE_ROWS):
            codes = np.frombuffer(piece[first : first + PULSE_ROWS], np.uint8)
            _check(codes, line, file)
            line += int(np.count_nonzero(codes == ord("\n")))
            chunk = _chunk_of(codes, rows, ticks_a_pulse)
            rows += len(chunk)
            yield chunk


def letters_back(file: BinaryIO, end: int, block_bytes: int = BLOCK_BYTES, name: str = "") -> Iterator[bytes]:
    """Yield the pulse letters that lead back from byte `end` of a file of letters to its begin; no devices.

    The file is read from its end in blocks, so that memory does not grow with it. Raises ProgramError at a byte that is
    no letter, with its line of `name`.
    """
    while end > 0:
        begin = max(0, end - block_bytes)
        file.seek(begin)
        codes = np.frombuffer(file.read(end - begin), np.uint8)
        if not _known(codes).all():
            _check(codes, _line_ends(file, begin, block_bytes), name)
        codes = codes[_STEP[codes] > 0][::-1]
        yield _LETTER[_STEP[codes], _STEP[codes] & ~_BACK[codes]].tobytes()
        end = begin


def byte_after(file: BinaryIO, pulses: int, block_bytes: int = BLOCK_BYTES) -> int:
    """Return the byte of a file of letters behind its first `pulses` pulses, its length where there are fewer."""
    file.seek(0)
    begin = 0
    while block := file.read(block_bytes):
        moves = np.flatnonzero(_STEP[np.frombuffer(block, np.uint8)])
        if len(moves) >= pulses:
            return begin + (int(moves[pulses - 1]) + 1 if pulses else 0)
        pulses -= len(moves)
        begin += len(block)
    return begin


def steps_to(file: BinaryIO, end: int, block_bytes: int = BLOCK_BYTES, name: str = "") -> tuple[int, ...]:
    """Return how far the letters before byte `end` of a file lead, in steps of X, Y and Z.

    Raises ProgramError at the first byte that is no letter, with its line of `name`.
    """
    file.seek(0)
    total, line = np.zeros(AXES, np.int64), 0
    for begin in range(0, end, block_bytes):
        codes = np.frombuffer(file.read(min(block_bytes, end - begin)), np.uint8)
        _check(codes, line, name)
        line += int(np.count_nonzero(codes == ord("\n")))
        total += moved_steps(_chunk_of(codes, 0, 1), AXES)
    return tuple(total.tolist())


def _line_ends(file: BinaryIO, end: int, block_bytes: int) -> int:
    """Return the number of line ends before byte `end` of a file."""
    file.seek(0)
    return sum(file.read(min(block_bytes, end - begin)).count(b"\n") for begin in range(0, end, block_bytes))


def _chunk_of(codes: np.ndarray, rows: int, ticks_a_pulse: int) -> PulseChunk:
    """Return what some letters mean, after `rows` pulses."""
    moves = _STEP[codes] > 0
    before = np.cumsum(moves) - moves
    switches = tuple(
        Switch(int(before[at]), (rows + int(before[at])) * ticks_a_pulse, *DEVICES[chr(codes[at])])
        for at in np.flatnonzero(np.isin(codes, _DEVICE_CODES))
    )
    letters = codes[moves]
    ticks = (rows + 1 + np.arange(len(letters))) * ticks_a_pulse
    return PulseChunk(ticks, _STEP[letters], _BACK[letters], switches)


def _known(codes: np.ndarray) -> np.ndarray:
    """Return which bytes are letters or blanks, bool[k]."""
    return (_STEP[codes] > 0) | np.isin(codes, _DEVICE_CODES) | np.isin(codes, np.frombuffer(BLANKS, np.uint8))


def _check(codes: np.ndarray, line: int, file: str) -> None:
    """Refuse bytes that are no letters, naming the line; `line` line ends came before."""
    known = _known(codes)
    if not known.all():
        at = int(np.argmin(known))
        number = line + 1 + int(np.count_nonzero(codes[:at] == ord("\n")))
        advice = Text("there are A to Z for pulses and {devices} for devices", devices=" ".join(DEVICES))
        raise ProgramError(
            "letter", "this is no pulse letter", value=repr(chr(codes[at])), advice=advice, place=Place(file, number)
        )
