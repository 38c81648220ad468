# SPDX-License-Identifier: LGPL-2.1-or-later
"""The surviving test programs of the PC control of stepper tables, and a judge of the pulses that they should make.

The programs are in the thesis's own language: modal words, centres as absolute places, absent words keep their axis.
"""

from __future__ import annotations

import math
import re
from typing import NamedTuple

PROGRAMS = {
    1: """g90|y-80|G2 x-80 y0 i0 j0|G90|x-160 y0|G2 x0 y160 i0 j0|G90|y80|G2 x80 y0 i0 j0|G90|x160|G2 x0 y-160 i0 j0
        |g90|y-80""",
    2: """g90|y-160|G3 x160 y0 i0 j0|G90|x80|G3 x0 y80 i0 j0|G90|y160|G3 x-160 y0 i0 j0|G90|x-80|G3 x0 y-80 i0 j0""",
    3: """g90|y-160|G2 x-160 y0 i0 j0|G90|x-80|G2 x0 y80 i0 j0|G90|y160|G2 x160 y0 i0 j0|G90|x80|G2 x0 y-80 i0 j0""",
    4: """g90|y-80|G3 x80 y0 i0 j0|G90|x160|G3 x0 y160 i0 j0|G90|y80|G3 x-80 y0 i0 j0|G90|x-160|G3 x0 y-160 i0 j0
        |g90|y-80""",
}


class Move(NamedTuple):
    """A move from one place to another; centre: of an arc."""

    begin: tuple[float, float]
    end: tuple[float, float]
    clockwise: bool = False
    centre: tuple[float, float] | None = None

    def words(self) -> str:
        """Return the move as grbl's language has it, centre from the begin."""
        end = f"X{self.end[0]:g}Y{self.end[1]:g}"
        if self.centre is None:
            return "G1" + end
        i, j = (there - here for there, here in zip(self.centre, self.begin, strict=True))
        return f"G{2 if self.clockwise else 3}{end}I{i:g}J{j:g}"

    def distance(self, place: tuple[float, float]) -> float:
        """Return how far a place is from the line or the circle of the move."""
        if self.centre is not None:
            return abs(math.dist(place, self.centre) - math.dist(self.begin, self.centre))
        way = [there - here for there, here in zip(self.end, self.begin, strict=True)]
        off = [there - here for there, here in zip(place, self.begin, strict=True)]
        return abs(way[0] * off[1] - way[1] * off[0]) / math.hypot(*way)


def moves_of(number: int) -> list[Move]:
    """Return the moves of a program from X0 Y0, in mm."""
    here, code, moves = (0.0, 0.0), 90, []
    for block in PROGRAMS[number].replace("\n", "").split("|"):
        words = {letter: float(value) for letter, value in re.findall(r"([GXYIJ])(-?\d+)", block.upper())}
        code = int(words.get("G", code))
        there = (words.get("X", here[0]), words.get("Y", here[1]))
        if there != here or "I" in words:
            centre = (words["I"], words["J"]) if code in (2, 3) else None
            moves.append(Move(here, there, code == 2, centre))
            here = there
    return moves


def line_pulses(way: tuple[int, int]) -> list[tuple[int, int]]:
    """Return (step, back) of each pulse of a straight move as the thesis prints it: sums begin at the counts."""
    counts, back = [abs(way[0]), abs(way[1])], (way[0] < 0) + 2 * (way[1] < 0)
    limit, sums, sent = int(math.sqrt(counts[0] ** 2 + counts[1] ** 2)), list(counts), [0, 0]
    pulses = []
    while sent != counts:
        step = 0
        for axis in (0, 1):
            sums[axis] += counts[axis]
            if sums[axis] > limit:
                sums[axis] -= limit
                sent[axis] += 1
                step |= 1 << axis
        if step:
            pulses.append((step, back & step))
    return pulses
