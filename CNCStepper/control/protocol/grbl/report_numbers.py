# SPDX-License-Identifier: LGPL-2.1-or-later
"""The numbers in a controller's reports: plain decimals within bounds, so that noise is refused instead of believed.

Python's own `int` and `float` also take `1_0`, `nan`, `1e999`, and fail in their own way on 5000 digits.
"""

from __future__ import annotations

import re

from CNCStepper.errors import Text

MOST = 1e7  # of any position, speed or setting, in whatever unit
MOST_COUNT = 100_000  # of a code, of free blocks and bytes
_DECIMAL = re.compile(r"[-+]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)")
_COUNT = re.compile(r"[0-9]+")
_LONGEST = 24  # characters of the longest number that a firmware writes


def decimal(text: str) -> float:
    """Return a number as a firmware writes it, without exponent; raises ValueError beyond `MOST` or for other text."""
    value = float(_matched(_DECIMAL, text))
    if abs(value) > MOST:
        raise ValueError(Text("a number beyond {most:g}: {text}", most=MOST, text=text))
    return value


def count(text: str) -> int:
    """Return a whole number without sign; raises ValueError beyond `MOST_COUNT` or for other text."""
    value = int(_matched(_COUNT, text))
    if value > MOST_COUNT:
        raise ValueError(Text("a number beyond {most_count}: {text}", most_count=MOST_COUNT, text=text))
    return value


def code(text: str) -> int:
    """Return the number of an error or an alarm; -1 for text that is none."""
    try:
        return count(text.strip())
    except ValueError:
        return -1


def vector(text: str) -> tuple[float, ...]:
    """Return comma-separated numbers; raises ValueError."""
    return tuple(decimal(part) for part in text.split(","))


def sizes(options: str) -> tuple[int, int]:
    """Return planner blocks and receive bytes of `$I`'s "letters,blocks,bytes"; 0 for what it does not say."""
    blocks, size, *_ = [*map(code, options.split(",")[1:3]), 0, 0]
    return max(blocks, 0), max(size, 0)


def _matched(form: re.Pattern[str], text: str) -> str:
    if len(text) > _LONGEST or not form.fullmatch(text):
        raise ValueError(Text("not a number: {text}", text=text[:_LONGEST]))
    return text
