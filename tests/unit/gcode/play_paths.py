# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random programs of grbl that turn back often: lines and arcs of three planes, in all modes of distance and unit.

And the tool that motors with play push along.
"""

from __future__ import annotations

import math
import random
from collections.abc import Sequence

import numpy as np

from CNCStepper.machine.backlash import Backlash
from CNCStepper.recovery.retract.move_curve import Move

PLANES = {"G17": ("X", "Y", "I", "J"), "G18": ("Z", "X", "K", "I"), "G19": ("Y", "Z", "J", "K")}
APART_MM = 0.01  # of the points at which the tool is looked at


def random_program(random_of: random.Random, moves: int) -> str:
    """Return a program that begins at the work zero and comes to all kinds of ends."""
    at = {"X": 0.0, "Y": 0.0, "Z": 0.0}  # in the unit of the text
    unit, places = random_of.choice((("G21", 3), ("G20", 4)))
    scale = 1.0 if unit == "G21" else 1 / 25.4
    lines = [f"{unit} G17 G90 G94", f"F{600 * scale:.3f}"]
    plane, absolute = "G17", True
    for _ in range(moves):
        chance = random_of.random()
        if chance < 0.1:
            plane = random_of.choice(list(PLANES))
            lines.append(plane)
        elif chance < 0.2:
            absolute = not absolute
            lines.append("G90" if absolute else "G91")
        elif chance < 0.55:
            lines.append(_line(random_of, at, scale, places, absolute))
        else:
            lines.append(_arc(random_of, at, plane, scale, places, absolute))
    return "\n".join([*lines, "M2", ""])


def program_of_places(random_of: random.Random, moves: int, codes: Sequence[str]) -> str:
    """Return a program in mm that goes to places by these codes, each line on one to three axes."""
    lines = ["G21 G90 G17\nG1 F300"]
    for _ in range(moves):
        words = "".join(
            f"{axis}{random_of.uniform(-9, 9):.3f}" for axis in random_of.sample("XYZ", random_of.randint(1, 3))
        )
        lines.append(random_of.choice(codes) + words)
    return "\n".join([*lines, "M2", ""])


def _line(random_of: random.Random, at: dict[str, float], scale: float, places: int, absolute: bool) -> str:
    words = random_of.choice(("G0", "G1", "G1"))
    for letter in random_of.sample("XYZ", random_of.randint(1, 3)):
        words += _to(at, letter, round(at[letter] + random_of.uniform(-9, 9) * scale, places), places, absolute)
    return words


def _arc(random_of: random.Random, at: dict[str, float], plane: str, scale: float, places: int, absolute: bool) -> str:
    one, two, i, j = PLANES[plane]
    angle, radius = random_of.uniform(0, math.tau), random_of.uniform(0.2, 8) * scale
    arm = (round(radius * math.cos(angle), places), round(radius * math.sin(angle), places))
    centre, radius = (at[one] + arm[0], at[two] + arm[1]), math.hypot(*arm)
    last = random_of.uniform(0, math.tau)
    whole = not absolute and random_of.random() < 0.3  # absolute ends may differ in their last bit
    ends = (at[one], at[two]) if whole else (centre[0] + radius * math.cos(last), centre[1] + radius * math.sin(last))
    words = random_of.choice(("G2", "G3"))
    words += "".join(
        _to(at, letter, round(end, places), places, absolute) for letter, end in zip((one, two), ends, strict=True)
    )
    if random_of.random() < 0.3:
        normal = next(letter for letter in "XYZ" if letter not in (one, two))
        words += _to(at, normal, round(at[normal] + random_of.uniform(-2, 2) * scale, places), places, absolute)
    return words + f"{i}{arm[0]:.{places}f}{j}{arm[1]:.{places}f}"


def _to(at: dict[str, float], letter: str, end: float, places: int, absolute: bool) -> str:
    number = end if absolute else end - at[letter]
    at[letter] = round(at[letter] + round(end - at[letter], places), places)
    return f"{letter}{number:.{places}f}"


def pushed(play: Backlash, tool_mm: np.ndarray, moves: list[Move]) -> np.ndarray:
    """Return where a tool comes to, which stands still until a side of its gap pushes it, float64[n, 3]."""
    gaps, sense = np.array(play.backlash_mm), np.array(play.true_sense)
    behind, ahead = np.where(sense < 0, gaps, 0.0), np.where(sense > 0, gaps, 0.0)
    points = [tool_mm]
    for move in moves:
        for share in np.linspace(0.0, 1.0, 2 + int(move.length_mm / APART_MM)):
            motors_mm = np.array(move.at(share))
            points.append(np.clip(points[-1], motors_mm - behind, motors_mm + ahead))
    return np.array(points)
