# SPDX-License-Identifier: LGPL-2.1-or-later
"""The kernel that writes runs of plain lines as they are sent: no blanks, no N words, the shortest numbers."""

from __future__ import annotations

import numpy as np

from CNCStepper.gcode.syntax.word_kernels import (
    BLANK,
    LEFT,
    LINE_END,
    MINUS,
    MOST_WHOLE_DIGITS,
    NEWLINE,
    NINE,
    OTHER,
    PLUS,
    POINT,
    ZERO,
    G,
    N,
    after_line_end,
)
from CNCStepper.kernels import njit_in_place

UPPER = 0xDF  # takes the lower case off a letter

NOW = np.dtype(  # where the writing is
    [
        ("at", "i8"),  # byte of the text
        ("line", "i8"),  # lines read
        ("out", "i8"),  # byte of the output
        ("lines", "i8"),  # lines written
        ("words", "i8"),  # whether any line held words
    ]
)


@njit_in_place
def write_number(data, at, end, roles, out, to):
    """Write the number that begins at `at` in its shortest form; return the places behind both, LEFT for none."""
    begin, whole, decimals, point, longest = to, 0, 0, False, to
    while at < end and roles[data[at]] == BLANK:
        at += 1
    if at < end and (data[at] == MINUS or data[at] == PLUS):
        if data[at] == MINUS:
            out[to] = MINUS
            to += 1
        at += 1
    first = to
    while at < end:
        byte = data[at]
        if ZERO <= byte <= NINE:
            if point:
                decimals += 1
            else:
                whole += 1
            if point or byte != ZERO or to > first:
                out[to] = byte
                to += 1
                if point and byte != ZERO:
                    longest = to
        elif byte == POINT and not point:
            point = True
            if to == first:
                out[to] = ZERO
                to += 1
            longest = to
            out[to] = POINT
            to += 1
        elif roles[byte] != BLANK:
            break
        at += 1
    if whole + decimals == 0 or whole > MOST_WHOLE_DIGITS:
        return LEFT, to
    if to == first:
        out[to] = ZERO
        to += 1
    if point:
        to = longest
    if to == first + 1 and out[first] == ZERO:  # zero has no sign
        out[begin] = ZERO
        to = begin + 1
    return at, to


@njit_in_place
def write_lines(data, now, roles, longest_line, out, numbers):
    """Write lines from `now.at` on, each with its newline, up to one that needs the encoder (comments, codes).

    out: uint8, room for twice the text. numbers: int32, the line of the text of each line that is written.
    """
    end = len(data)
    while now.at < end:
        at, to, words, codes = now.at, now.out, 0, 0
        while at < end and roles[data[at]] != LINE_END:
            role, begin = roles[data[at]], to
            if role == BLANK:
                at += 1
                continue
            codes += role == G
            if role == OTHER or codes > 1:
                return
            out[to] = data[at] & UPPER
            at, to = write_number(data, at + 1, end, roles, out, to + 1)
            if at == LEFT:
                return
            words += 1
            if role == N:
                to = begin
        if to - now.out >= longest_line:
            return
        now.line += 1
        if to > now.out:
            numbers[now.lines] = now.line
            out[to] = NEWLINE
            now.out, now.lines = to + 1, now.lines + 1
        now.words |= words > 0
        now.at = after_line_end(data, at, end)
