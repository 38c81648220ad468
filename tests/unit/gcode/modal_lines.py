# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines that hold several codes, all pairs and random ones, read by `rs274` and by us in one run each.

Each line is a case: `rs274 -n 0` goes on after a refusal, so that one process judges thousands. Between two cases
stand lines that bring both interpreters back to the same state, also from a line that only one of them took.
"""

from __future__ import annotations

import os
import re
import subprocess
from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import pairwise
from pathlib import Path
from random import Random

from rs274_runs import same_call

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.dialects.codes import RS274
from CNCStepper.gcode.interpreter.canonical_trace import _Calls, default_start
from CNCStepper.gcode.interpreter.line_interpreter import Interpreter

ENDS = {"M2", "M30", "M99"}  # nothing is read after them
PROFILES = {"G70", "G71", "G71.1", "G71.2", "G72", "G72.1", "G72.2"}  # need a subroutine, a program of their own
# Of codes that the grammar does not tell apart only one is in the pairs; random lines have them all.
TWINS = {
    *("G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3", "G38.3", "G38.4", "G38.5", "G73", "G82", "G88", "G89"),
    *("G30", "G28.1", "G18.1", "G19", "G19.1", "G42", "G42.1", "G61.1", "G92.2", "G92.3"),
    *("M1", "M60", "M4", "M7", "M51", "M53", "M63", "M64", "M65", "M67", "M71", "M73"),
}
ALL = [name for name in RS274 if name not in ENDS | PROFILES] + list("FST")
PAIRED = [name for name in ALL if name not in TWINS]
WORDS = {  # that a code needs, or that make it say something
    "F": "F200",
    "S": "S200",
    "T": "T1",
    "G1": "F100",
    "G2": "X1 I0.5",
    "G3": "X1 I0.5",
    "G81": "Z1 R2",
    "G82": "Z1 R2 P1",
    "G83": "Z1 R2 Q1",
    "G73": "Z1 R2 Q1",
    "G74": "Z1 R2",
    "G84": "Z1 R2",
    "G85": "Z1 R2",
    "G86": "Z1 R2 P1",
    "G87": "Z1 R2 I1 J1 K2",
    "G88": "Z1 R2 P1",
    "G89": "Z1 R2 P1",
    "G33": "Z1 K1",
    "G33.1": "Z1 K1",
    "G76": "Z-1 P1 I-1 J1 K2 R1",
    "G38.2": "Z-1",
    "G38.3": "Z-1",
    "G38.4": "Z-1",
    "G38.5": "Z-1",
    "G5": "X1 Y1 I1 J1 P1 Q1",
    "G5.1": "X1 Y1 I1 J1",
    "G5.2": "X1 Y1 P1",
    "G41": "D1",
    "G42": "D1",
    "G41.1": "D1",
    "G42.1": "D1",
    "G4": "P1",
    "G10": "L2 P1",
    "G43": "H1",
    "G43.1": "Z1",
    "G43.2": "H1",
    "G52": "X1",
    "G92": "X1",
    "G96": "S100",
    "M61": "Q1",
    "M62": "P1",
    "M63": "P1",
    "M64": "P1",
    "M65": "P1",
    "M66": "P1 L0",
    "M67": "E1 Q1",
    "M68": "E1 Q1",
    "M19": "R1",
}
MODES = "G49 G94 G17 G21 G90 G91.1 G97 G54 G8 G64 G98 M9 M48 M3 S100 F100"
MOVING_GROUPS = {"motion", "offsets", "length", "compensation"}
SPLINE_ENDS = ["G40 G17 G94 F100", "G80", "G5.2 X2 Y1 P1", "X3 Y2 P1", "G5.3"]
MOVES_BACK = ["G80", "G40", MODES, "G92.1", "G10 L2 P1 X0 Y0 Z0 R0", "G0 X0 Y0 Z0", "G80"]
UNDO = {  # behind the way back, where the machine is at zero
    "M6": ["M61 Q0"],
    "M61": ["M61 Q0"],
    "T": ["T0"],
    "M70": ["M71"],
    "M73": ["M71"],
    "G28.1": ["G28.1"],
    "G30.1": ["G30.1"],
}
BEFORE = (  # a line that random cases come after; most come after none
    *("", "", "", "", "G1 X0.5", "G0 X0.5", "G81 X.5 Z1 R2", "G98 G83 X1 Z-1 R1 Q.5", "G2 X.5 I.25", "G33 Z1 K1"),
    *("G91", "G1 X0.5 G91", "G7", "G20", "G93 G1 X.5 F10", "G95 F1", "G96 S100 D500", "G90.1", "G99", "G61", "G18"),
    *("G19", "G17.1", "M5", "M4", "M49", "M50 P0", "G92 X3", "G52 X2", "G10 L2 P1 X4 R20", "G43 H1", "G43.1 Z2"),
    *("G41.1 D1", "G5.2 X1 Y1 P1", "G38.2 X1 Z-1", "T1 M6", "M61 Q2"),
)


@dataclass(frozen=True)
class Case:
    """A line with several codes; `before`: the line that it comes after. more: an axis word, where it has none."""

    names: tuple[str, ...]
    more: str = ""
    before: str = ""

    @property
    def line(self) -> str:
        """The codes and then the words that they need, each letter once."""
        words: dict[str, str] = {}
        for word in [*" ".join(WORDS.get(name, "") for name in self.names).split(), *self.more.split()]:
            words.setdefault(word[0], word)
        return " ".join([*(name for name in self.names if name not in "FST"), *words.values()])

    def undo(self) -> list[str]:
        """Return the lines behind which everything is as it was."""
        codes = [RS274[name] for name in self.names if name in RS274]
        stays = not self.before and MOVING_GROUPS.isdisjoint(code.group for code in codes)
        spline = SPLINE_ENDS if "G5.2" in self.names or self.before.startswith("G5.2") else []
        tool = ["M61 Q0", "T0"] if self.before.startswith(("T1", "M61")) else []
        own = [line for name in self.names for line in UNDO.get(name, [])]
        return [*spline, *([MODES] if stays else MOVES_BACK), *tool, *own]


@dataclass
class Answers:
    """What one interpreter said: the calls of each case by its number, and why it refused one."""

    calls: dict[int, list[str]] = field(default_factory=lambda: defaultdict(list))
    refused: dict[int, str] = field(default_factory=dict)


def pairs() -> Iterator[Case]:
    """Yield every pair of codes in both orders, and once with an axis word; a modal G1 then moves what no code does."""
    for place, one in enumerate(PAIRED):
        for other in PAIRED[:place] + PAIRED[place + 1 :]:
            yield Case((one, other))
        for other in PAIRED[place + 1 :]:
            takes = any(RS274[name].axes or RS274[name].group == "motion" for name in (one, other) if name in RS274)
            yield Case((one, other), "X1", "" if takes else "G1 X0.5")


def random_cases(seed: int, count: int) -> Iterator[Case]:
    """Yield lines with one to five codes, behind lines that set all kinds of modes."""
    random = Random(seed)
    for _ in range(count):
        names = random.sample(ALL, random.choice([1, 2, 2, 3, 3, 3, 4, 5]))
        yield Case(tuple(names), random.choice(["", "X1", "X1", "Y1", "Z3"]), random.choice(BEFORE))


def program_of(cases: list[Case]) -> list[str]:
    """Return the lines of all cases, each case with its number as N word."""
    lines = list(MOVES_BACK)
    for number, case in enumerate(cases, start=1):
        lines += [*([case.before] if case.before else []), f"N{number} {case.line}", *case.undo()]
    return lines


def rs274_answers(lines: list[str], folder: Path) -> Answers:
    """Run a program by `rs274`, which goes on after what it refuses."""
    (folder / "lines.ngc").write_text("\n".join([*lines, "M2", ""]), "ascii")
    command = ["rs274", "-n", "0", "-g", "lines.ngc"]
    environment = {**os.environ, "HOME": str(folder)}
    run = subprocess.run(command, cwd=folder, env=environment, capture_output=True, encoding="latin-1", timeout=120)
    answers = Answers()
    for line in run.stdout.splitlines():
        if match := re.match(r" *\d+ N(\d+) +(.*)", line):
            answers.calls[int(match[1])].append(match[2].rstrip())
    told = run.stderr.splitlines()
    for sentence, line in pairwise(told):
        if match := re.match(r"N(\d+) ", line):
            answers.refused[int(match[1])] = sentence
    return answers


class _Listener(_Calls):
    """Keeps the calls of each case."""

    def __init__(self, calls: dict[int, list[str]]):
        super().__init__()
        self.by_case = calls

    def call(self, text: str) -> None:
        """Keep a call of a line that has a number."""
        if self.interpreter.sequence:
            self.by_case[int(self.interpreter.sequence)].append(text.rstrip())

    def printed(self, text: str) -> None:
        """Nothing is printed here."""


def our_answers(lines: list[str]) -> Answers:
    """Read a program, and go on after what is refused."""
    answers = Answers()
    listener = _Listener(answers.calls)
    interpreter = listener.interpreter = Interpreter(default_start(), "linuxcnc", canon=listener)
    for line in lines:
        try:
            interpreter.line(line)
        except ProgramError as error:
            if match := re.match(r"N(\d+) ", line):
                answers.refused[int(match[1])] = f"{error.code}: {error.what}"
    return answers


@dataclass(frozen=True)
class Difference:
    """A case that the two read differently. ours, theirs: why it is refused, "" where it is read."""

    case: Case
    ours: str
    theirs: str
    calls: tuple[str, str] = ("", "")  # the first ones that differ


def differences(cases: list[Case], folder: Path) -> list[Difference]:
    """Return the cases that are refused by one only, or whose calls differ."""
    lines, found = program_of(cases), []
    theirs, ours = rs274_answers(lines, folder), our_answers(lines)
    for number, case in enumerate(cases, start=1):
        mine, real = ours.refused.get(number, ""), theirs.refused.get(number, "")
        if bool(mine) != bool(real):
            found.append(Difference(case, mine, real))
        elif not mine and (calls := _first_difference(ours.calls[number], theirs.calls[number])):
            found.append(Difference(case, "", "", calls))
    return found


def _first_difference(ours: list[str], theirs: list[str]) -> tuple[str, str] | None:
    for mine, real in zip([*ours, ""], [*theirs, ""], strict=False):
        if mine != real and not (mine and real and same_call(mine, real)):
            return mine, real
    return None if len(ours) == len(theirs) else ("", "")
