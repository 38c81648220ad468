# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parameters of a program: `#1` by number and `#<name>` by name, and what a call keeps of them.

    numbers   #1–#5601      one table for the whole program; #1–#30 belong to the subroutine that runs
    names     #<_name>      global, in the first frame
              #<name>       local, in the frame of the subroutine that runs

What a block assigns is pending until the block is good: `commit` keeps it, `rollback` forgets it.

Points that parameters hold: nine numbers in a row for X Y Z A B C U V W, lengths in the machine's own unit.

LinuxCNC's parameter file (.var): the persistent parameters of a machine, and the start state that follows from them.

5161  10.000000     number and value, one parameter a line, in the order of their numbers
5221  -3.500000     lengths in the machine's own unit
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

from CNCStepper.errors import Place, ProgramError, Text
from CNCStepper.gcode.dialects.codes import ALL_AXES
from CNCStepper.state import WORK_SYSTEMS, ZERO3, ZERO9, Start

LARGEST = 5601
ARGUMENTS = 30  # the arguments of a subroutine are #1 to #30
WORK_SYSTEM, FIRST_OFFSET, OFFSETS_APART = 5220, 5221, 20
G92_IN_FORCE, FIRST_G92 = 5210, 5211
FIRST_POSITION = 5420
TURNING = range(3, 6)  # of the nine axes A, B and C are degrees in any unit
READ_ONLY = frozenset((*range(5400, 5414), *range(FIRST_POSITION, FIRST_POSITION + 9)))
_MOST_NAMES = 20_000

Key = int | tuple[int, str]  # a number, or frame and name


class Parameters:
    """Values by number and by name; a number that was never set is 0."""

    def __init__(self, numbers: dict[int, float] | None = None):
        self._values: dict[Key, float] = {number: float(value) for number, value in (numbers or {}).items()}
        self._pending: dict[Key, float] = {}
        self._kept: list[dict[int, float]] = []  # the callers' #1 to #30
        self.returned: float | None = None  # the return value of the last subroutine

    @property
    def level(self) -> int:
        """How many subroutines are being run inside each other."""
        return len(self._kept)

    # by number

    def __contains__(self, number: int) -> bool:
        return number in self._pending or number in self._values

    def get(self, number: int) -> float:
        """Return the value of `#number`, 0 when it was never set."""
        value = self._pending.get(number)
        return self._values.get(number, 0.0) if value is None else value

    def set(self, number: int, value: float) -> None:
        """Set `#number`, pending until `commit`; the reader checks which parameters a program may set."""
        self._pending[number] = value

    # by name

    def has_name(self, name: str) -> bool:
        """Whether the named parameter has a value here."""
        key = self._key(name)
        return key in self._pending or key in self._values

    def get_named(self, name: str) -> float:
        """Return the value of `#<name>`; raises KeyError when it has none."""
        key = self._key(name)
        return self._pending[key] if key in self._pending else self._values[key]

    def set_named(self, name: str, value: float) -> None:
        """Give `#<name>` a value, pending until `commit`; raises ProgramError when there are too many names."""
        if len(self._values) + len(self._pending) > _MOST_NAMES:
            what = "the program has too many parameters"
            advice = "use fewer, or split the program"
            raise ProgramError("too-many-parameters", what, value=f"#<{name}>", limit=str(_MOST_NAMES), advice=advice)
        self._pending[self._key(name)] = value

    def _key(self, name: str) -> Key:
        return (0 if name.startswith("_") else self.level, name)

    # blocks and calls

    def commit(self) -> None:
        """Keep what was set since last time."""
        self._values.update(self._pending)
        self._pending.clear()

    def rollback(self) -> None:
        """Forget what was set since the last commit."""
        self._pending.clear()

    def enter(self, arguments: list[float] | None) -> None:
        """Begin a subroutine with its arguments in #1 to #30, all others 0; None leaves the caller's as they are."""
        self._kept.append({number: self.get(number) for number in range(1, ARGUMENTS + 1) if number in self})
        if arguments is not None:
            given = (*arguments, *(0.0,) * (ARGUMENTS - len(arguments)))
            self._values.update(zip(range(1, ARGUMENTS + 1), given, strict=True))

    def leave(self, restore: bool) -> None:
        """End a subroutine: its names are forgotten and, with `restore`, the caller's #1 to #30 are back."""
        level = self.level
        for key in [key for key in self._values if isinstance(key, tuple) and key[0] == level]:
            del self._values[key]
        kept = self._kept.pop()
        if restore:
            self._values.update({number: kept.get(number, 0.0) for number in range(1, ARGUMENTS + 1)})


def offset_number(system: str) -> int:
    """Return the number of the parameter that holds the X offset of a work system ("G54": 5221)."""
    return FIRST_OFFSET + OFFSETS_APART * WORK_SYSTEMS.index(system)


def parameters_at(start: Start) -> Parameters:
    """Return the parameters of a machine in the state `start`: its own, its offsets and G92 in its own unit."""
    numbers = dict(start.parameters)
    numbers[WORK_SYSTEM] = WORK_SYSTEMS.index(start.work_system) + 1.0
    points = {offset_number(system): offset for system, offset in start.work_offsets_mm.items()}
    if any(start.g92_mm):
        points[FIRST_G92] = start.g92_mm
    for first, point in points.items():
        for axis, value in enumerate(point):
            numbers[first + axis] = value / (1.0 if axis in TURNING else start.machine_unit_mm)
    numbers[G92_IN_FORCE] = float(any(start.g92_mm))
    return Parameters(numbers)


FURTHER = ALL_AXES[3:]
ROTATION = 9  # of a work system: its parameter comes after the nine offsets


def nine(values: Sequence[float]) -> tuple[float, ...]:
    """Return values of the first axes with 0 for the others."""
    return tuple(map(float, values)) + ZERO9[len(values) :]


def further_of(point: tuple[float, ...]) -> tuple[float, ...]:
    """Return A B C U V W of a point."""
    return point[3:]


def length_scale(axis: int, scale: float) -> float:
    """Return `scale` for an axis that measures lengths, 1 for one that turns."""
    return 1.0 if axis in TURNING else scale


def stored_point(parameters: Parameters, first: int, unit_mm: float) -> tuple[float, ...]:
    """Return the point that begins at parameter `first`, mm and degrees."""
    return tuple(parameters.get(first + axis) * length_scale(axis, unit_mm) for axis in range(9))


def store_point(
    parameters: Parameters, first: int, point: Sequence[float], unit_mm: float, axes: Iterable[int]
) -> None:
    """Keep some axes of a point, mm and degrees, in the parameters from `first` on."""
    for axis in axes:
        parameters.set(first + axis, point[axis] / length_scale(axis, unit_mm))


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
            advice = "sort its lines by number, each once"
            raise ProgramError("parameter-file", what, value=str(number), place=Place(file, count, 1), advice=advice)
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
        advice = "write a line such as: 5221 12.5"
        raise ProgramError("parameter-file", what, value=line.strip()[:40], limit=limit, place=place, advice=advice)
    return entry


def with_parameters(start: Start, numbers: dict[int, float]) -> Start:
    """Return a start state that remembers these parameters: its work offsets and its G92 are theirs.

    Raises ProgramError where parameter 5220 names no work system.
    """
    system = numbers.get(WORK_SYSTEM, 1.0)
    if system not in range(1, len(WORK_SYSTEMS) + 1):
        what = "parameter 5220 names no work system"
        raise ProgramError(
            "parameter-file",
            what,
            value=f"{system:g}",
            limit=f"1 to {len(WORK_SYSTEMS)}",
            advice="write 1 for G54, 2 for G55 and so on",
        )
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
