# SPDX-License-Identifier: LGPL-2.1-or-later
"""The first move of what is sent names its motion: which one is in force at the controller depends on what ran before.

program   X10            proven as the rapid of a fresh controller
sent      G0X10          after M2 of another program a bare X10 would be a cut (G1)
"""

from __future__ import annotations

import re

from CNCStepper.gcode.codes import ALL_AXES, MOTION_NAMES, NO_MOTION
from CNCStepper.gcode.dialects import Dialect
from CNCStepper.gcode.wire_lines import WireLines
from CNCStepper.gcode.words import words_of

_AXIS = re.compile(f"[{ALL_AXES}]")


def bare_first_move(lines: WireLines, dialect: Dialect) -> int | None:
    """Return the index of the first line that moves, where no line up to it names a motion; else None."""
    if dialect.first_motion == NO_MOTION:
        return None
    for index, line in enumerate(lines):
        codes = [dialect.codes[word.name] for word in words_of(line) if word.name in dialect.codes]
        if any(code.motion is not None for code in codes):
            return None
        if _AXIS.search(line) and not any(code.axes for code in codes):
            return index
    return None


def with_first_motion(lines: WireLines, index: int, dialect: Dialect) -> WireLines:
    """Return the lines with the dialect's first motion before the line `index`."""
    begin = sum(len(line) + 1 for line in lines[:index])
    name = MOTION_NAMES[dialect.first_motion].encode("ascii")
    return WireLines(lines.data[:begin] + name + lines.data[begin:])
