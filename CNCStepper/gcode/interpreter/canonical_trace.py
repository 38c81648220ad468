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
from CNCStepper.gcode.interpreter.flow.run_with_subroutines import run
from CNCStepper.gcode.interpreter.flow.subprogram_files import library_of
from CNCStepper.gcode.interpreter.functions.coordinate_offsets import HOMES, SET_G92, SET_WORK
from CNCStepper.gcode.interpreter.functions.tools import read_tool_table
from CNCStepper.gcode.interpreter.line_interpreter import Interpreter
from CNCStepper.gcode.interpreter.motion.arcs import Arc
from CNCStepper.gcode.interpreter.state.interpreter_state import Model
from CNCStepper.state import WORK_SYSTEMS, Start
from CNCStepper.toolpath import ARC_CW, LINE, PLANE_AXES, RAPID

BARE_UNIT_MM = 1 / 0.03937007874016  # the inch, with the digits that the bare interpreter has for it
SAMPLE_TOOLS = """
T1 P1 D0.125 Z0.511
T2 P2 D0.0625 Z0.1
T3 P3 D0.201 Z1.273
T99999 P123 Z0.1
"""  # the table of LinuxCNC's samples, inches, with which a bare `rs274` runs
MOTION_CALLS = ("STRAIGHT_TRAVERSE", "STRAIGHT_FEED", "ARC_FEED", "DWELL")


def canonical_calls(
    text: str,
    dialect: str | Dialect = "linuxcnc",
    file: str = "",
    tool_lengths_mm: dict[int, float] | None = None,
    start: Start | None = None,
) -> Iterator[str]:
    """Yield the canonical calls of a program as `rs274 -g` numbers and prints them.

    start: None is that of a bare interpreter. tool_lengths_mm: lengths that come before its tool table, by number.
    Raises ProgramError at the line that is refused, after the calls of the lines before it.
    """
    start = replace(start or default_start(), tool_lengths_mm=tool_lengths_mm or {})
    for calls in canonical_text(text, start, dialect, file):
        yield from calls.removesuffix("\n").split("\n")


def canonical_text(text: str, start: Start, dialect: str | Dialect = "linuxcnc", file: str = "") -> Iterator[str]:
    """Yield the lines of `canonical_calls`, one or many at once, each with its line end."""
    calls = _Calls()
    interpreter = Interpreter(start, dialect, file, canon=calls)
    calls.interpreter = interpreter
    for call in _begin(interpreter.model):
        calls.call(call)
    try:
        for _ in run(interpreter, text, library_of(file, start)):
            yield from calls.taken()
            interpreter.table.forget()
        interpreter.toolpath()
        calls.end()
    finally:
        yield from calls.taken()


def motion_calls(lines: Iterator[str] | list[str]) -> list[str]:
    """Return only the calls that move or wait, without their numbers: the path that a trace describes."""
    calls = (line[13:] for line in lines)
    return [call for call in calls if call.startswith(MOTION_CALLS)]


def traced_path(text: str, dialect: str | Dialect = "linuxcnc") -> list[str]:
    """Return the motion calls of a program."""
    return motion_calls(canonical_calls(text, dialect))


def default_start() -> Start:
    """Return the start of a bare interpreter: all at zero, the stored positions too; its own unit is the inch.

    It has the tools of LinuxCNC's samples.
    """
    stored = {first + axis: 0.0 for first in HOMES.values() for axis in range(9)}
    tools = read_tool_table(SAMPLE_TOOLS, BARE_UNIT_MM)
    return replace(Start.at_zero(), parameters=stored, machine_unit_mm=BARE_UNIT_MM, tools=tools)


def _begin(model: Model) -> Iterator[str]:
    """Yield the calls by which the stand-alone interpreter shows its initial state, in mm."""
    yield "USE_LENGTH_UNITS(CANON_UNITS_MM)"
    six = (f"{value:.4f}" for value in model.origin[:6])
    yield (SET_WORK % (WORK_SYSTEMS.index(model.state.work_system) + 1)).format(*six)
    yield SET_G92.format(*(f"{value:.4f}" for value in model.g92[:6]))
    yield f"SET_XY_ROTATION({model.state.rotation_deg:.4f})"
    yield "SET_FEED_REFERENCE(CANON_XYZ)"
    yield "ON_RESET()"


class _Calls:
    """Numbers and formats the calls as they come."""

    interpreter: Interpreter

    def __init__(self) -> None:
        self.count = 0
        self._lines: deque[str] = deque()

    def taken(self) -> Iterator[str]:
        """Yield and forget the calls since last time."""
        while self._lines:
            yield self._lines.popleft()

    def call(self, text: str) -> None:
        """Print a call."""
        self.count += 1
        number = self.interpreter.sequence
        name = f"N{number}" if number else "N....."
        self._lines.append(f"{self.count:5d} {name:<7s}{text}\n")

    def printed(self, text: str) -> None:
        """Print the output of the program itself."""
        self._lines.append(text + "\n")

    def calls(self, text: str, count: int) -> None:
        """Print the calls of a run."""
        self._lines.append(text)
        self.count = count

    def end_of_move(self, model: Model) -> str:
        """Return the turning axes of a move that does not turn them."""
        return f", {_numbers(self._turning(model.position, model))})"

    def lengths(self, template: str, values: tuple[float, ...], model: Model) -> None:
        """Print a call with its lengths filled in, in the units of the text."""
        self.call(template.format(*(f"{value / model.scale:.4f}" for value in values)))

    def move(self, motion: int, end: tuple[float, ...], arc: Arc | None, model: Model) -> None:
        """Print a move in the program's coordinates; those of U, V and W are not printed."""
        x_y_z = _program((end[0], end[1], end[2]), model)
        a_b_c = self._turning(end, model)
        if arc is None:
            name = {RAPID: "STRAIGHT_TRAVERSE", LINE: "STRAIGHT_FEED"}[motion]
            self.call(f"{name}({_numbers((*x_y_z, *a_b_c))})")
            return
        first, second, normal = PLANE_AXES[arc.plane]
        centre = _program(arc.centre, model)
        turns = -arc.turns if motion == ARC_CW else arc.turns
        flat = _numbers((x_y_z[first], x_y_z[second], centre[first], centre[second]))
        self.call(f"ARC_FEED({flat}, {turns}, {_numbers((x_y_z[normal], *a_b_c))})")

    @staticmethod
    def _turning(end: tuple[float, ...], model: Model) -> tuple[float, ...]:
        places = end[3:6] or (0.0, 0.0, 0.0)
        return tuple(place - offset for place, offset in zip(places, model.further_offset, strict=False))

    def end(self) -> None:
        """Print a bare interpreter's calls at the end of the text."""
        self.interpreter.sequence = ""
        if not self.interpreter.model.ended:
            self.call("FINISH()")
        elif self.interpreter.tape.lacks_mark:
            self.call('COMMENT("interpreter: percent sign missing from end of file")')
        self.call("ON_RESET()")
        self.call("ON_RESET()")


def _program(point: tuple[float, float, float], model: Model) -> tuple[float, ...]:
    return tuple(value / model.scale for value in model.work(point))


def _numbers(values: tuple[float, ...]) -> str:
    return ", ".join(f"{value:.4f}" for value in values)
