# SPDX-License-Identifier: LGPL-2.1-or-later
"""Prints the canonical calls of a run of plain lines, byte for byte as `canonical_trace.py` prints them one by one.

    bytes of the run ──read_words──► N, F ──► SET_FEED_RATE(...)
    rows of the run  ───────────────────────► STRAIGHT_TRAVERSE · STRAIGHT_FEED · ARC_FEED

`compiled_reader.run_lines` has made the rows: a line has moved if the next row bears its number.
"""

from __future__ import annotations

import math

import numpy as np

from CNCStepper.gcode.syntax.word_kernels import BLANK, LETTERS, NINE, ZERO, N, after_line_end, read_words
from CNCStepper.kernels import njit_in_place
from CNCStepper.toolpath import ARC_CW, LINE, RAPID

PRINTED = np.dtype(  # how far the text of a run is
    [
        ("at", "i8"),  # byte of the program
        ("line", "i8"),  # lines read
        ("row", "i8"),  # rows printed
        ("count", "i8"),  # calls printed since the program began
        ("written", "i8"),  # bytes written
    ]
)
ROOM = 1 << 20  # bytes written at once
LONGEST_LINE = 1024  # bytes that the calls of one line take at most: some 20 numbers of 25 digits
FEED = LETTERS.index("F")
BEGIN_NUMBER = np.frombuffer(b"Nn", np.uint8)
PADDED_COUNT, PADDED_NAME = 5, 7
SPACE, DASH, DOT = (ord(sign) for sign in " -.")
NO_NUMBER = np.frombuffer(b"N.....", np.uint8)
SET_FEED = np.frombuffer(b"SET_FEED_RATE(", np.uint8)
TRAVERSE = np.frombuffer(b"STRAIGHT_TRAVERSE(", np.uint8)
FEED_MOVE = np.frombuffer(b"STRAIGHT_FEED(", np.uint8)
ARC_MOVE = np.frombuffer(b"ARC_FEED(", np.uint8)
COMMA = np.frombuffer(b", ", np.uint8)
CLOSE = np.frombuffer(b")\n", np.uint8)
UNIT_1E4 = 10_000  # the four decimals of a printed number
SPLIT_27_BITS = float((1 << 27) + 1)  # T. J. Dekker's factor: two halves whose products are exact


@njit_in_place
def put_text(out, at, text):
    """Append bytes; return the place after them."""
    for byte in text:
        out[at] = byte
        at += 1
    return at


@njit_in_place
def put_whole(out, at, whole, width):
    """Append a whole number that is not negative, right-aligned in `width`; return the place after it."""
    digits, rest = 1, whole // 10
    while rest:
        digits, rest = digits + 1, rest // 10
    for _ in range(width - digits):
        out[at] = SPACE
        at += 1
    for place in range(at + digits - 1, at - 1, -1):
        out[place] = ZERO + whole % 10
        whole //= 10
    return at + digits


@njit_in_place
def put_number(out, at, value):
    """Append a number below 2^62 as "%.4f" prints it: its exact value rounded half to even; return the place after it.

    rest * 10^4 = scaled + error, both exact (T. J. Dekker, "A floating-point technique for extending the available
    precision", 1971), so that what lies at a half, or beside it by less than `scaled` can say, falls on the right side.
    """
    if math.copysign(1.0, value) < 0:
        out[at] = DASH
        at += 1
    value = abs(value)
    whole = np.int64(value)
    rest = value - whole
    high = rest * SPLIT_27_BITS - (rest * SPLIT_27_BITS - rest)
    scaled = rest * UNIT_1E4
    error = (high * UNIT_1E4 - scaled) + (rest - high) * UNIT_1E4
    decimals = np.int64(scaled)
    beyond_half = (scaled - decimals - 0.5) + error
    if beyond_half > 0 or (beyond_half == 0 and decimals % 2):
        decimals += 1
    whole += decimals // UNIT_1E4
    decimals %= UNIT_1E4
    at = put_whole(out, at, whole, 0)
    out[at] = DOT
    for place in range(at + 4, at, -1):
        out[place] = ZERO + decimals % 10
        decimals //= 10
    return at + 5


@njit_in_place
def put_name(out, at, count, data, begin, end, roles, numbered):
    """Append the number of a call and the N word of its line, bytes [begin, end); return the place after them."""
    at = put_whole(out, at, count, PADDED_COUNT)
    out[at] = SPACE
    at += 1
    first = at
    if numbered:
        out[at] = BEGIN_NUMBER[0]
        at += 1
        while data[begin] != BEGIN_NUMBER[0] and data[begin] != BEGIN_NUMBER[1]:
            begin += 1
        begin += 1
        while begin < end and (ZERO <= data[begin] <= NINE or roles[data[begin]] == BLANK):
            if roles[data[begin]] != BLANK:
                out[at] = data[begin]
                at += 1
            begin += 1
    else:
        at = put_text(out, at, NO_NUMBER)
    while at - first < PADDED_NAME:
        out[at] = SPACE
        at += 1
    return at


@njit_in_place
def put_move(out, at, facts, offset, kind, target, centre, tail):
    """Append a move in the units and the coordinates of the program; return the place after it."""
    if kind in (RAPID, LINE):
        at = put_text(out, at, TRAVERSE if kind == RAPID else FEED_MOVE)
        for axis in range(3):
            if axis:
                at = put_text(out, at, COMMA)
            at = put_number(out, at, (target[axis] - offset[axis]) / facts.scale)
        return put_text(out, at, tail)
    at = put_text(out, at, ARC_MOVE)
    for axis in (facts.first, facts.second):
        at = put_number(out, at, (target[axis] - offset[axis]) / facts.scale)
        at = put_text(out, at, COMMA)
    for axis in (facts.first, facts.second):
        at = put_number(out, at, (centre[axis] - offset[axis]) / facts.scale)
        at = put_text(out, at, COMMA)
    if kind == ARC_CW:
        out[at] = DASH
        at += 1
    at = put_text(out, put_whole(out, at, 1, 0), COMMA)
    at = put_number(out, at, (target[facts.normal] - offset[facts.normal]) / facts.scale)
    return put_text(out, at, tail)


@njit_in_place
def write_calls(data, end, printed, rows, facts, offset, roles, values, columns, tail, out):
    """Print the calls of the lines from `printed.at` to byte `end` until `out` is full; `printed` says how far it came.

    rows: how many the run has made. columns: as those of `compiled_reader.run_lines`. tail: what each move ends with,
    its turning axes. out: uint8[ROOM].
    """
    kind, ends, centres, row_line = columns
    while printed.at < end and printed.written + LONGEST_LINE < len(out):
        begin, at = printed.at, printed.written
        shape, line_end = read_words(data, begin, end, roles, values)
        printed.line += 1
        numbered = shape & (1 << N) != 0
        if shape & (1 << FEED):
            printed.count += 1
            at = put_name(out, at, printed.count, data, begin, line_end, roles, numbered)
            at = put_text(out, at, SET_FEED)
            at = put_text(out, put_number(out, at, values[FEED] * facts.scale / facts.scale), CLOSE)
        row = printed.row
        if row < rows and row_line[row] == printed.line:
            printed.count += 1
            at = put_name(out, at, printed.count, data, begin, line_end, roles, numbered)
            at = put_move(out, at, facts, offset, kind[row], ends[row], centres[row], tail)
            printed.row = row + 1
        printed.written = at
        printed.at = after_line_end(data, line_end, end)
