# SPDX-License-Identifier: LGPL-2.1-or-later
"""The canonical calls of a program, printed as `rs274 -g` prints them.

The calls are LinuxCNC's seam between language and machine: coordinates are the program's own, in its units and
without its offsets. The machine stands at its zero when the program begins.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator
from dataclasses import replace

from CNCStepper.gcode.dialects import Dialect
from CNCStepper.gcode.interpret import Interpreter
from CNCStepper.gcode.model import HOMES, Model, Point
from CNCStepper.gcode.moves import Arc
from CNCStepper.gcode.words import program_lines
from CNCStepper.state import Start
from CNCStepper.toolpath import ARC_CW, LINE, PLANE_AXES, RAPID

_SIX_ZEROS = ", ".join(["0.0000"] * 6)
_BEGIN = (
    "USE_LENGTH_UNITS(CANON_UNITS_MM)",
    f"SET_G5X_OFFSET(1, {_SIX_ZEROS})",
    f"SET_G92_OFFSET({_SIX_ZEROS})",
    "SET_XY_ROTATION(0.0000)",
    "SET_FEED_REFERENCE(CANON_XYZ)",
    "ON_RESET()",
)
MOTION_CALLS = ("STRAIGHT_TRAVERSE", "STRAIGHT_FEED", "ARC_FEED", "DWELL")


def canonical_calls(text: str, dialect: str | Dialect = "linuxcnc", file: str = "") -> Iterator[str]:
    """Yield the canonical calls of a program as `rs274 -g` numbers and prints them.

    Raises ProgramError at the line that is refused, after the calls of the lines before it.
    """
    calls = _Calls()
    interpreter = Interpreter(_at_zero(), dialect, file, canon=calls)
    calls.interpreter = interpreter
    for call in _BEGIN:
        calls.call(call)
    for line in program_lines(text):
        interpreter.line(line)
        yield from calls.taken()
    interpreter.toolpath()
    calls.end()
    yield from calls.taken()


def motion_calls(lines: Iterator[str] | list[str]) -> list[str]:
    """Return only the calls that move or wait, without their numbers: the path that a trace describes."""
    calls = (line[13:] for line in lines)
    return [call for call in calls if call.startswith(MOTION_CALLS)]


def traced_path(text: str, dialect: str | Dialect = "linuxcnc") -> list[str]:
    """Return the motion calls of a program."""
    return motion_calls(canonical_calls(text, dialect))


def _at_zero() -> Start:
    """Return the start of a bare interpreter: all at zero, the stored positions too."""
    stored = {first + axis: 0.0 for first in HOMES.values() for axis in range(3)}
    return replace(Start.at_zero(), parameters=stored)


class _Calls:
    """Numbers and formats the calls as they come."""

    interpreter: Interpreter

    def __init__(self) -> None:
        self._count = 0
        self._lines: deque[str] = deque()

    def taken(self) -> Iterator[str]:
        """Yield and forget the calls since last time."""
        while self._lines:
            yield self._lines.popleft()

    def call(self, text: str) -> None:
        """Print a call."""
        self._count += 1
        number = self.interpreter.sequence
        name = f"N{number}" if number and not self.interpreter.ended else "N....."
        self._lines.append(f"{self._count:5d} {name:<7s}{text}")

    def lengths(self, template: str, values: tuple[float, ...], model: Model) -> None:
        """Print a call with its lengths filled in, in the units of the text."""
        self.call(template.format(*(f"{value / model.scale:.4f}" for value in values)))

    def move(self, motion: int, end: Point, arc: Arc | None, model: Model) -> None:
        """Print a move in the program's coordinates."""
        end_mm = self._program(end, model)
        if arc is None:
            name = {RAPID: "STRAIGHT_TRAVERSE", LINE: "STRAIGHT_FEED"}[motion]
            self.call(f"{name}({_numbers(end_mm)}, 0.0000, 0.0000, 0.0000)")
            return
        first, second, normal = PLANE_AXES[arc.plane]
        centre = self._program(arc.centre, model)
        turns = -arc.turns if motion == ARC_CW else arc.turns
        flat = _numbers((end_mm[first], end_mm[second], centre[first], centre[second]))
        self.call(f"ARC_FEED({flat}, {turns}, {_numbers((end_mm[normal], 0.0, 0.0, 0.0))})")

    def end(self) -> None:
        """Print what a bare interpreter says when the text is over."""
        self.interpreter.sequence = ""
        if not self.interpreter.model.ended:
            self.call("FINISH()")
        elif self.interpreter.lacks_mark:
            self.call('COMMENT("interpreter: percent sign missing from end of file")')
        self.call("ON_RESET()")
        self.call("ON_RESET()")

    @staticmethod
    def _program(point: Point, model: Model) -> Point:
        x, y, z = ((point[axis] - model.offset[axis]) / model.scale for axis in range(3))
        return x, y, z


def _numbers(values: tuple[float, ...]) -> str:
    return ", ".join(f"{value:.4f}" for value in values)
