# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers and words as the firmware reads them: 32-bit floats of at most eight digits."""

from __future__ import annotations

import re
import struct
from collections.abc import Iterator

from CNCStepper.virtual.grbl.alarms_and_errors import refused

DIGITS_READ = 8  # further digits only scale the number
NUMBER = re.compile(r"([+-]?)(\d*)(\.?)(\d*)")
SINGLE = struct.Struct("<f")


def f32(value: float) -> float:
    """Return `value` rounded to a 32-bit float, the only kind that the firmware knows."""
    return SINGLE.unpack(SINGLE.pack(value))[0]


TENTH, HUNDREDTH = f32(0.1), f32(0.01)


def read_number(text: str, position: int) -> tuple[float, int]:
    """Return the number that begins at `position` and the position after it.

    Raises error:2 where there are no digits, or more of them than a 32-bit float can carry (the
    firmware's own result is then undefined).
    """
    match = NUMBER.match(text, position)
    assert match  # the pattern matches nothing, too
    sign, whole, _, decimals = match.groups()
    digits = whole + decimals
    if not digits:
        raise refused(2)
    try:
        value = _scaled(int(digits[:DIGITS_READ]), max(len(whole) - DIGITS_READ, 0) - _decimals_kept(whole, decimals))
    except OverflowError as error:
        raise refused(2) from error
    return (-value if sign == "-" else value), match.end()


def read_words(text: str, position: int = 0) -> Iterator[tuple[str, float]]:
    """Yield the (letter, value) pairs of a line from which blanks and comments have been taken.

    Raises error:1 where a letter is missing and error:2 where its number is.
    """
    while position < len(text):
        letter = text[position]
        if not "A" <= letter <= "Z":
            raise refused(1)
        value, position = read_number(text, position + 1)
        yield letter, value


def _decimals_kept(whole: str, decimals: str) -> int:
    return min(len(decimals), max(DIGITS_READ - len(whole), 0))


def _scaled(digits: int, exponent: int) -> float:
    """Return digits * 10^exponent, rounded at each of the firmware's own multiplications."""
    value = f32(digits)
    while exponent <= -2:
        value, exponent = f32(value * HUNDREDTH), exponent + 2
    if exponent == -1:
        value = f32(value * TENTH)
    for _ in range(exponent):
        value = f32(value * 10.0)
    return value
