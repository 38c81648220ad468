# SPDX-License-Identifier: LGPL-2.1-or-later
"""LinuxCNC's parameter file (.var): what a machine remembers over night, and the start state that follows from it.

5161  10.000000     number and value, one parameter a line, in the order of their numbers
5221  -3.500000     lengths in the machine's own unit
"""

from __future__ import annotations

from dataclasses import replace

from CNCStepper.errors import Place, ProgramError, Text
from CNCStepper.gcode.interpreter.state.parameters import (
    FIRST_G92,
    G92_IN_FORCE,
    LARGEST,
    WORK_SYSTEM,
    Parameters,
    offset_number,
)
from CNCStepper.gcode.interpreter.state.stored_points import stored_point
from CNCStepper.state import WORK_SYSTEMS, ZERO3, Start


def read_parameters(text: str, file: str = "") -> dict[int, float]:
    """Return the parameters of LinuxCNC's file by number.

    Raises ProgramError at a line that is not a number of a parameter and its value, or that is out of order.
    """
    numbers: dict[int, float] = {}
    last = 0
    for count, line in enumerate(text.splitlines(), start=1):
        if not line.strip():
            continue
        number, value = _entry(line, Place(file, count, 1))
        if number <= last:
            what = "the parameters of the file are not in the order of their numbers"
            raise ProgramError("parameter-file", what, value=str(number), place=Place(file, count, 1))
        numbers[number] = value
        last = number
    return numbers


def _entry(line: str, place: Place) -> tuple[int, float]:
    """Return number and value of a line."""
    try:
        number, value = line.split()
        entry = int(number), float(value)
    except ValueError:
        entry = 0, 0.0
    if not 1 <= entry[0] <= LARGEST or not abs(entry[1]) < float("inf"):
        what = "a line of a parameter file is the number of a parameter and its value"
        limit = Text("numbers 1 to {largest}", largest=LARGEST)
        raise ProgramError("parameter-file", what, value=line.strip()[:40], limit=limit, place=place)
    return entry


def with_parameters(start: Start, numbers: dict[int, float]) -> Start:
    """Return a start state that remembers these parameters: its work offsets and its G92 are theirs.

    Raises ProgramError where parameter 5220 names no work system.
    """
    system = numbers.get(WORK_SYSTEM, 1.0)
    if system not in range(1, len(WORK_SYSTEMS) + 1):
        what = "parameter 5220 names no work system"
        raise ProgramError("parameter-file", what, value=f"{system:g}", limit=f"1 to {len(WORK_SYSTEMS)}")
    parameters, unit_mm = Parameters(numbers), start.machine_unit_mm
    offsets = {name: stored_point(parameters, offset_number(name), unit_mm) for name in WORK_SYSTEMS}
    g92_mm = stored_point(parameters, FIRST_G92, unit_mm) if numbers.get(G92_IN_FORCE) else ZERO3
    return replace(
        start,
        work_system=WORK_SYSTEMS[int(system) - 1],
        work_offsets_mm={name: _short(point) for name, point in offsets.items() if any(point)},
        g92_mm=_short(g92_mm),
        zero_known=True,
        parameters=start.parameters | numbers,
    )


def _short(point: tuple[float, ...]) -> tuple[float, ...]:
    """Return X, Y and Z of a point, and its further axes where they are not 0."""
    return point if any(point[3:]) else point[:3]
