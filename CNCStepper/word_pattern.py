# SPDX-License-Identifier: LGPL-2.1-or-later
"""The patterns of a decimal number and of a word (a letter and a number), for all texts but programs.

    T3 P3 D0.201 Z+1.273        a line of a tool table
    x10 y-5 f100                a jog as a person types it

The words of a program have more rules; `gcode/syntax/words.py` reads them.
"""

from __future__ import annotations

import re

DECIMAL = r"[-+]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)"
WORD = re.compile(rf"([A-Za-z])\s*({DECIMAL})")


def words_beside(text: str) -> tuple[list[tuple[str, str]], str]:
    """Return letter (in capitals) and number of each word of a text, and the rest of the text without its blanks."""
    return [(letter.upper(), number) for letter, number in WORD.findall(text)], WORD.sub("", text).strip()
