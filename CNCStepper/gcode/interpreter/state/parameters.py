# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parameters of a program: `#1` by number and `#<name>` by name, and what a call keeps of them.

    numbers   #1–#5601      one table for the whole program; #1–#30 belong to the subroutine that runs
    names     #<_name>      global, in the first frame
              #<name>       local, in the frame of the subroutine that runs

What a block assigns is pending until the block is good: `commit` keeps it, `rollback` forgets it.
"""

from __future__ import annotations

from CNCStepper.errors import ProgramError
from CNCStepper.state import WORK_SYSTEMS, Start

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
        self.returned: float | None = None  # what the last subroutine returned

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
        """Give `#number` a value, pending until `commit`; what a program may assign is checked by its reader."""
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
            raise ProgramError("too-many-parameters", what, value=f"#<{name}>", limit=str(_MOST_NAMES))
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
