# SPDX-License-Identifier: LGPL-2.1-or-later
"""The kernel of `o_words.is_plain`: whether a program holds more than words, at the speed of its bytes."""

from __future__ import annotations

from CNCStepper.gcode.syntax.word_kernels import NEWLINE, NINE, PLUS, POINT, RETURN, ZERO
from CNCStepper.kernels import njit_in_place

SPACE, TAB, SLASH, HASH, BRACKET = (ord(sign) for sign in " \t/#[")
OPENS, CLOSES, SEMICOLON, EIGHT = (ord(sign) for sign in "();8")
LOWER = ord("a") - ord("A")
LETTER_M, LETTER_N, LETTER_O = (ord(letter) for letter in "mno")
BEGIN, SKIPPED, NUMBER, M_WORD, M_NINE, WORDS = range(6)  # how far a line is read: nothing, "/", "N1", "M", "M9", more


@njit_in_place
def end_of_comment(data, at, end):
    """Return the place behind the comment that opens at `at`; a line end is none of it."""
    is_closed = data[at] == OPENS
    while at < end and data[at] != NEWLINE and data[at] != RETURN:
        at += 1
        if is_closed and data[at - 1] == CLOSES:
            break
    return at


@njit_in_place
def stage_after(stage, byte):
    """Return how far the beginning of a line is read after one more byte; -1 once it leads elsewhere."""
    if byte in (SPACE, TAB):
        return stage
    letter = byte | LOWER
    if stage <= NUMBER:
        if letter == LETTER_O:
            return -1
        if letter == LETTER_M:
            return M_WORD
        if stage == NUMBER:
            return NUMBER if byte == POINT or ZERO <= byte <= NINE else WORDS
        if letter == LETTER_N:
            return NUMBER
        return SKIPPED if byte == SLASH and stage == BEGIN else WORDS
    if stage == M_WORD:
        if byte == NINE:
            return M_NINE
        return M_WORD if byte in (ZERO, POINT, PLUS) else WORDS
    return -1 if byte in (EIGHT, NINE) else WORDS


@njit_in_place
def needs_interpreter(data):
    """Whether a text, uint8[n], holds parameters, expressions or lines that lead elsewhere, outside its comments."""
    at, end, stage = 0, len(data), BEGIN
    while at < end:
        byte = data[at]
        if byte in (OPENS, SEMICOLON):
            at = end_of_comment(data, at, end)
            continue
        if byte in (HASH, BRACKET):
            return True
        if byte in (NEWLINE, RETURN):
            stage = BEGIN
        elif stage != WORDS:
            stage = stage_after(stage, byte)
            if stage < BEGIN:
                return True
        at += 1
    return False
