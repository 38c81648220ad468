# SPDX-License-Identifier: LGPL-2.1-or-later
"""The first move of what is sent names its motion: which one is in force at the controller depends on what ran before.

program   X10            proven as the rapid of a fresh controller
sent      G0X10          after M2 of another program a bare X10 would be a cut (G1)
"""

from __future__ import annotations

import re

from CNCStepper.gcode.dialects import Dialect
from CNCStepper.gcode.dialects.codes import ALL_AXES, MOTION_NAMES, NO_MOTION
from CNCStepper.gcode.syntax.words import words_of
from CNCStepper.gcode.wire.wire_lines import WireLines

_AXIS = re.compile(f"[{ALL_AXES}]")


class FirstMove:
    """Looks for the first move of a program in lines that come piece by piece."""

    def __init__(self, dialect: Dialect):
        self._dialect = dialect
        self._is_known = dialect.first_motion == NO_MOTION

    def without_motion(self, lines: WireLines) -> int | None:
        """Return the index of the first line that moves, where no line up to it names a motion; else None."""
        codes_of = self._dialect.codes
        for index, line in enumerate(() if self._is_known else lines):
            codes = [codes_of[word.name] for word in words_of(line) if word.name in codes_of]
            names_motion = any(code.motion is not None for code in codes)
            if names_motion or (_AXIS.search(line) and not any(code.axes for code in codes)):
                self._is_known = True
                return None if names_motion else index
        return None


def with_first_motion(lines: WireLines, index: int, dialect: Dialect) -> WireLines:
    """Return the lines with the dialect's first motion before the line `index`."""
    begin = sum(len(line) + 1 for line in lines[:index])
    name = MOTION_NAMES[dialect.first_motion].encode("ascii")
    return WireLines(lines.data[:begin] + name + lines.data[begin:])
