# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random programs as people write them, for the tests of editing: comments, gaps, both modes, arcs of all planes."""

from __future__ import annotations

import math
from random import Random

PLANES = ((0, 1, 2, "G17", "IJ"), (2, 0, 1, "G18", "KI"), (1, 2, 0, "G19", "JK"))


class _Text:
    """Grows a program; at: the place on the grid of its last digit, in that digit."""

    def __init__(self, random: Random, decimals: int, inch: bool, flat_arcs: bool):
        self.random = random
        self.decimals = decimals
        self.unit = 10**decimals
        self.lines: list[str] = []
        self.at = [0, 0, 5 * self.unit]
        self.absolute = True
        self.plane = 0
        self.motion = ""
        self.flat_arcs = flat_arcs
        self.feed = 20.0 if inch else 500.0

    def word(self, letter: str, count: int) -> str:
        """Write a number in one of the ways in which people write it."""
        value = count / self.unit
        text = self.random.choice([f"{value:.{self.decimals}f}", f"{value:.{self.decimals}f}".rstrip("0").rstrip(".")])
        if text in ("-0", "") or float(text) == 0:
            text = "0"
        if text.startswith("0.") and self.random.random() < 0.2:
            text = text[1:]
        return (letter.lower() if self.random.random() < 0.1 else letter) + text

    def line(self, *words: str) -> None:
        gap = self.random.choice([" ", " ", ""])
        comment = self.random.choice(["", "", "", " (so)", " ; X1 F2"])
        number = f"N{len(self.lines) + 1}{gap}" if self.random.random() < 0.15 else ""
        self.lines.append(number + gap.join(word for word in words if word) + comment)

    def motion_word(self, name: str) -> str:
        said = name != self.motion or self.random.random() < 0.2
        self.motion = name
        return (f"G0{name[1:]}" if self.random.random() < 0.2 else name) if said else ""

    def axes(self, end: list[int], must: tuple[int, ...] = ()) -> list[str]:
        words = []
        for axis in range(3):
            if end[axis] != self.at[axis] or axis in must:
                value = end[axis] if self.absolute else end[axis] - self.at[axis]
                words.append(self.word("XYZ"[axis], value))
        self.at = end
        return words

    def straight(self) -> None:
        end = [
            value if self.random.random() < 0.4 else self.random.randint(-40 * self.unit, 40 * self.unit)
            for value in self.at
        ]
        if end == self.at:
            return
        rapid = self.random.random() < 0.25
        feed = "" if rapid else self.feed_word()
        word = self.motion_word("G0" if rapid else "G1")
        self.line(word, *self.axes(end), feed)

    def feed_word(self) -> str:
        return f"F{self.feed * self.random.choice([1, 2, 0.5]):g}" if self.random.random() < 0.3 else ""

    def arc(self) -> None:
        """An arc whose ends lie on the grid and on one circle: a whole, half or quarter, or by its radius."""
        plane = 0 if self.flat_arcs else self.random.randint(0, 2)
        first, second, normal, code, centres = PLANES[plane]
        radius = self.random.randint(1, 9) * self.unit
        whole = (
            [] if "G91" in " ".join(self.lines) else [(0, 0)]
        )  # adding up ways leaves no exact place to come back to
        quarter = self.random.choice([*whole, (1, 1), (1, -1), (2, 0), (-1, 1)])
        end = list(self.at)
        end[first] += quarter[0] * radius
        end[second] += quarter[1] * radius
        if self.random.random() < 0.3:
            end[normal] += self.random.randint(-3, 3) * self.unit
        if plane != self.plane:
            self.plane = plane
            self.line(code)
        name = self.random.choice(["G2", "G3"])
        chord = math.hypot(end[first] - self.at[first], end[second] - self.at[second])
        by_radius = chord > 0 and self.random.random() < 0.3
        if by_radius:
            size = self.random.randint(math.ceil(chord / 2), 3 * radius) * self.random.choice([1, 1, -1])
            tail = [self.word("R", size)]
        else:
            tail = [self.word(centres[0], quarter[0] * radius if abs(quarter[0]) == 1 else radius)]
            if abs(quarter[0]) == 1:
                tail = [self.word(centres[0], quarter[0] * radius)]
            elif quarter == (2, 0):
                tail = [self.word(centres[0], radius), self.word(centres[1], 0)]
        self.line(self.motion_word(name), *self.axes(end, (first, second)), *tail, self.feed_word())


def random_program(seed: int, decimals: int = 3, inch: bool = False, flat_arcs: bool = False) -> str:
    """Return a program that grbl and LinuxCNC read; flat_arcs: those of G17 alone."""
    random = Random(seed)
    text = _Text(random, decimals, inch, flat_arcs)
    text.line("G20" if inch else "G21", "G17 G90 G94")
    text.line("G54")
    text.line(f"F{text.feed:g}")
    text.line("M3 S1000")
    text.line(text.motion_word("G0"), *text.axes([0, 0, 5 * text.unit], (0, 1, 2)))
    for _ in range(random.randint(4, 25)):
        choice = random.random()
        if choice < 0.08:
            text.absolute = not text.absolute
            text.line("G90" if text.absolute else "G91")
        elif choice < 0.14:
            text.lines.append(random.choice(["", "(only a comment X5)", "M8", "G4 P0.5", "; F99"]))
        elif choice < 0.45:
            text.arc()
        else:
            text.straight()
    text.line("M5")
    text.lines.append("M2")
    return "\n".join(text.lines) + random.choice(["\n", ""])
