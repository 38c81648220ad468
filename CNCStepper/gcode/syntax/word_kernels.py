# SPDX-License-Identifier: LGPL-2.1-or-later
"""Kernels that read words from the bytes of a line: letters and exact numbers, blanks anywhere.

A number m / 10^d with m <= 2^53 and d <= 22 is exact in both parts, so that one division rounds it correctly
(Clinger, "How to read floating point numbers accurately", 1990). Longer ones are left to the interpreter.
"""

from __future__ import annotations

import math

import numpy as np

from CNCStepper.kernels import njit_in_place

LETTERS = "XYZIJKRFN"  # a word's place among the values; the bit of its letter in a mask of words
G = len(LETTERS)
BLANK, LINE_END, OTHER = G + 1, G + 2, G + 3
N, N_LATE = LETTERS.index("N"), 1 << G  # an N word after another word
SHAPES = 1 << (G + 1)  # masks of words; the G word in front of them counts 0 for none, 1 for G0 ... 4 for G3
MOST_G = 3
MOST_WHOLE_DIGITS, MOST_DIGITS, MOST_MANTISSA = 15, 18, 1 << 53
LEFT = -1  # the place after the text that is left to the interpreter
POWERS = np.array([10.0**n for n in range(MOST_DIGITS + 1)])
MINUS, PLUS, POINT, ZERO, NINE = (ord(sign) for sign in "-+.09")
NEWLINE, RETURN = 10, 13


def new_roles() -> np.ndarray:
    """Return what each byte is, int64[256]: the place of a letter, BLANK, LINE_END, or OTHER."""
    roles = np.full(256, OTHER)  # plain Python calculates with its entries: in narrower integers they overflow
    for place, letter in enumerate(LETTERS + "G"):
        roles[[ord(letter), ord(letter.lower())]] = place
    roles[[ord(" "), ord("\t")]] = BLANK
    roles[[NEWLINE, RETURN]] = LINE_END
    return roles


@njit_in_place
def read_number(data, at, end, roles):
    """Return the number that begins at `at` and the place after it, LEFT where it cannot be read exactly here."""
    while at < end and roles[data[at]] == BLANK:
        at += 1
    negative = at < end and data[at] == MINUS
    if negative or (at < end and data[at] == PLUS):
        at += 1
    mantissa, digits, decimals, step = np.int64(0), 0, 0, 0
    while at < end:
        byte = np.int64(data[at])  # plain Python calculates in bytes with bytes, and these overflow
        if ZERO <= byte <= NINE:
            digits += 1
            if digits > MOST_DIGITS:
                return 0.0, LEFT
            mantissa = mantissa * 10 + (byte - ZERO)
            decimals += step
        elif byte == POINT and step == 0:
            step = 1
        elif roles[byte] != BLANK:
            break
        at += 1
    if digits == 0 or digits - decimals > MOST_WHOLE_DIGITS or mantissa > MOST_MANTISSA:
        return 0.0, LEFT
    value = mantissa / POWERS[decimals] if decimals else float(mantissa)
    return -value if negative else value, at


@njit_in_place
def read_words(data, at, end, roles, values):
    """Read the words of a line into `values`; return their shape and the place of the line's end, or LEFT."""
    shape = 0
    while at < end:
        role = roles[data[at]]
        if role == BLANK:
            at += 1
            continue
        if role == LINE_END:
            break
        if role == OTHER:
            return shape, LEFT
        if role == N and (at + 1 >= end or not ZERO <= data[at + 1] <= NINE):
            return shape, LEFT
        value, at = read_number(data, at + 1, end, roles)
        if at == LEFT:
            return shape, LEFT
        if role == G:
            if shape >= SHAPES or not 0 <= value <= MOST_G or value != int(value) or math.copysign(1.0, value) < 0:
                return shape, LEFT
            shape += (int(value) + 1) * SHAPES
        else:
            if shape & (1 << role):
                return shape, LEFT
            if role == N and shape != 0:
                shape |= N_LATE
            shape |= 1 << role
            values[role] = value
    return shape, at


@njit_in_place
def after_line_end(data, at, end):
    """Return the place after the line end at `at`: LF, CR LF or CR."""
    if at < end and data[at] == RETURN and at + 1 < end and data[at + 1] == NEWLINE:
        return at + 2
    return min(at + 1, end)
