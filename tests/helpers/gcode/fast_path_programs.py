# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random plain programs with all that makes reading them hard, and what an interpreter has made of one."""

from __future__ import annotations

from contextlib import suppress
from math import isnan
from random import Random
from typing import Any

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.dialects import Dialect
from CNCStepper.gcode.interpreter.line_interpreter import Interpreter
from CNCStepper.gcode.syntax.words import program_lines
from CNCStepper.state import Start
from CNCStepper.toolpath import ARC_CW, PLANE_AXES, PLANE_NAMES

COLUMNS = ("kind", "end", "centre", "plane", "turns", "feed", "state", "line")
MODES = """G17 G18 G19 G20 G21 G90 G91 G90.1 G91.1 G93 G94 G54 G55 G59 G61 G64 G80 G0 G1 M3 M5 M0 T1 G40 G49 S1000 F100
F250.5 F0 F-1 G1F80 G92X1Y2 G92.1 G43.1Z1 G10L2P1X1Y-2Z.5 G10L20P1X0Y0Z0 G4P.1 G28 G53G0Z1"""
ODD = (
    "(a comment)",
    "(MSG, look)",
    "G1 X1 (between) Y2",
    "G1X1;to the end",
    "/G0X1",
    "%",
    "",
    "   ",
    "\t",
    "N10",
    "n 2 0",
    "G0 X1 N5",
    "G1 X1 X2",
    "G1 G0 X1",
    "G1 Q1",
    "X",
    "XY1",
    "1",
    "G1 X1.2.3",
    "G1 X1,5",
    "G1 X--1",
    "G1 X1e3",
    "G1 X1234567890123456",
    "G1 Xç1",
    "G1 X١",
    "G-0X1",
    "G1.5 X1",
    "G1.00000001X2",
    "G 0 1. x + 1 . 5 y - . 2 5",
    "N99999999999 X1",
    "N-1X1",
    "G81 X1 Y1 Z-1 R1 F100",
    "X2 Y2",
    "R5",
    "I1",
    "M2",
    "$$",
    "G1X1!",
    "g1\x0bx1",
    "#1=2",
    "O100 sub",
    "A1",
)


LASTING = {"M2", "%", "G93", "O100 sub"}  # what keeps the kernel away for long: rare, so that it has something to do


class PlainPrograms:
    """Writes programs line by line beside an interpreter, so that most arcs fit the place where the tool stands."""

    def __init__(self, seed: int, dialect: str | Dialect, start: Start):
        self.random = Random(seed)
        self.beside = Interpreter(start, dialect)
        self.lines: list[str] = []

    def program(self, count: int) -> str:
        """Return a program of `count` lines or a few more."""
        begin = self.random.choice(["G21 G90", "%", "N1 G90", "(first)", "G1 X0"])
        self._add(begin)
        self._add(self.random.choice(["G0 X1 Y2 Z3", "G0X1.5", "F100"]))
        while len(self.lines) < count:
            random = self.random.random()
            self._add(self._move() if random < 0.55 else self._arc() if random < 0.85 else self._other())
        ends = self.random.choice([["\n"], ["\r\n"], ["\r"], ["\n", "\r\n", "\r", "\n\r", "\n\n"]])
        body = "".join(line + self.random.choice(ends) for line in self.lines[:-1])
        mark = "\ufeff" if self.random.random() < 0.05 else ""
        return mark + body + self.lines[-1] + self.random.choice(["", ends[0]])

    def _add(self, line: str) -> None:
        self.lines.append(line)
        with suppress(ProgramError):
            self.beside.line(line)

    def _other(self) -> str:
        other = self.random.choice(MODES.split()) if self.random.random() < 0.6 else self.random.choice(ODD)
        return self._line("", ["G94 F100"]) if other in LASTING and self.random.random() < 0.8 else other

    def _move(self) -> str:
        motion = self.random.choice(["G0", "G1", "G1", "g01", "G 1", "G1.", "G00", "G90", "", "", "", ""])
        axes = self.random.sample("XYZ", self.random.randint(1, 3))
        return self._line(motion, [axis + self._number() for axis in axes])

    def _number(self) -> str:
        random = self.random
        kinds = (
            lambda: f"{random.uniform(-9, 9):.3f}",
            lambda: f"{random.randint(-9, 9)}",
            lambda: f"{random.uniform(-1, 1):.{random.randint(0, 24)}f}",
            lambda: f"{random.randint(0, 99):05d}.{random.randint(0, 9)}0",
            lambda: random.choice(["-0", "+1", ".5", "-.25", "5.", "0", "+ 3", "1 2.5", "-0.000"]),
            lambda: f"{random.randint(0, 10**15 - 1)}.{random.randint(0, 10**6)}",
        )
        return random.choices(kinds, [12, 4, 4, 2, 3, 0.3])[0]()

    def _line(self, motion: str, words: list[str]) -> str:
        random = self.random
        if random.random() < 0.25:
            words = [*words, random.choice(["F100", "F200", "F 1e2", "F250.5", "F0", "F-3", "f33.25"])]
        random.shuffle(words)
        if motion and random.random() < 0.1:
            words.append(motion)
        else:
            words = [motion, *words]
        if random.random() < 0.25:
            words = [f"N{random.randint(0, 99999)}", *words]
        line = random.choice(["", "", " ", "\t "]).join(words)
        return line.lower() if random.random() < 0.1 else line

    def _arc(self) -> str:
        """Return an arc from where the tool stands: half, quarter and full circles, helices, by centre or radius."""
        random, model = self.random, self.beside.model
        first, second, normal = PLANE_AXES[PLANE_NAMES.index(model.state.plane)]
        if any(isnan(model.position[axis]) for axis in (first, second)):
            return "G0 X1 Y1 Z1"
        here = [(model.position[axis] - model.offset[axis]) / model.scale for axis in range(3)]
        radius = random.choice([1.0, 2.5, 0.125, 10.0, 0.0004, 1e-5])
        x, y, i, j = random.choice(
            [(2, 0, 1, 0), (1, 1, 1, 0), (1, 1, 0, 1), (0, 0, 1, 0), (0, 0, -1, 2), (0, -2, 0, -1), (1e-6, 0, 1, 0)]
        )
        x, y, i, j = (value * radius for value in (x, y, i, j))
        if random.random() < 0.3:
            x += random.choice([1e-3, 4.9e-3, 5.1e-3, 0.02, 0.029, 0.6, 1e-7])
        words = self._coordinates(here, ((first, x), (second, y)))
        if random.random() < 0.3:
            words += self._coordinates(here, ((normal, random.choice([0.0, 1.0, -0.5])),))
        if random.random() < 0.35:
            words.append(f"R{random.choice([1, 1, -1, 0.5, 1.5]) * max(abs(x), abs(y), radius):.6f}")
        else:
            words += self._centre(here, ((first, i), (second, j)))
        motion = random.choice(["G2", "G3", "G02", "g3", "", ""])
        return self._line(motion, words if random.random() < 0.95 else words[1:])

    def _coordinates(self, here: list[float], ways: tuple[tuple[int, float], ...]) -> list[str]:
        absolute = self.beside.model.absolute
        return [f"{'XYZ'[axis]}{way + (here[axis] if absolute else 0.0):.6f}" for axis, way in ways]

    def _centre(self, here: list[float], ways: tuple[tuple[int, float], ...]) -> list[str]:
        absolute = self.beside.model.state.arc_centres == "absolute"
        words = [f"{'IJK'[axis]}{way + (here[axis] if absolute else 0.0):.6f}" for axis, way in ways]
        return words if absolute or self.random.random() < 0.8 else words[: self.random.randint(0, 1) + 1]


class Watched(Interpreter):
    """An interpreter that counts what kernels did for it."""

    def __init__(self, *arguments: Any):
        super().__init__(*arguments)
        self.lines_run = 0
        self.modes_run: set[str] = set()

    def ran(self, line_number: int, *results: Any) -> None:
        """Note the lines of a run and the modes that stood."""
        if line_number > self.line_number:
            self.lines_run += line_number - self.line_number
            state = self.model.state
            self.modes_run |= {state.plane, state.units, state.distance, f"{state.arc_centres} centres"}
        super().ran(line_number, *results)


def refusals(interpreter: Interpreter, text: str) -> list[ProgramError]:
    """Read a text line by line up to one that leads elsewhere, going on after refusals; return why they were."""
    errors = []
    for line in program_lines(text):
        if interpreter.leads(line):
            break
        try:
            interpreter.line(line)
        except ProgramError as error:
            errors.append(error)
    return errors


def outcome(interpreter: Interpreter, errors: list[ProgramError]) -> dict[str, Any]:
    """Return all that reading has led to, the columns of the table to the bit."""
    model = interpreter.model
    found: dict[str, Any] = {
        "errors": [(error.code, error.place, error.what, error.value, error.limit, error.advice) for error in errors],
        "place": (interpreter.line_number, repr(model.position), model.motion, repr(model.state), interpreter.ended),
    }
    try:
        path = interpreter.toolpath()
    except ProgramError as error:
        found["no end"] = str(error)
        path = interpreter.table.toolpath()
    found["rows"] = [(chunk.first, len(chunk)) for chunk in path.chunks]
    for name in COLUMNS:
        columns = [getattr(chunk, name) for chunk in path.chunks]
        found[name] = [(column.dtype.str, column.shape, column.tobytes()) for column in columns]
    return found | {"states": path.states, "events": path.events, "spans": path.spans}


def seen(text: str, interpreter: Interpreter) -> set[str]:
    """Return which of the hard cases a program and its table hold."""
    table = interpreter.table.toolpath().table()
    found = {f"kind {kind}" for kind in set(table.kind.tolist())} | {f"plane {plane}" for plane in table.plane.tolist()}
    found |= {"clockwise"} if (table.kind == ARC_CW).any() else set()
    return found | {mark for mark in ("R", "(", ";", "/", "\t", "x", "\r", "G93", "N") if mark in text}
