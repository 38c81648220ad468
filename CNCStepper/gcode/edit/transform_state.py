# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the lines of a transformed program hand on from one to the next, and the digits that they write."""

from __future__ import annotations

from dataclasses import dataclass, field

from CNCStepper.gcode.edit.executed_lines import Meaning, Source
from CNCStepper.gcode.edit.number_format import decimals_of, dialect_decimals
from CNCStepper.gcode.edit.path_transforms import Map
from CNCStepper.units import UNIT_MM


@dataclass
class TransformState:
    """The map by which lines are moved, one after the other, and what those before leave to the next.

    free: axes that no coordinate of the work has been said for. carry_mm: how far the new place is from the exact one.
    motion: the arc word in force in the new text. free_rows: which axes are free, for each line that moves.
    """

    source: Source
    where: Map
    free: list[bool] = field(default_factory=lambda: [True, True, True])
    carry_mm: list[float] = field(default_factory=lambda: [0.0, 0.0, 0.0])
    motion: str = ""
    free_rows: dict[int, tuple[bool, ...]] = field(default_factory=dict)

    def __post_init__(self) -> None:
        if not self.source.firsts:  # O-words lead to and fro: an axis that nothing was said for shows when verified
            self.free = [False, False, False]
        self._decimals = self._most_decimals()
        self.blank = " " if any(" " in text.strip() for _, text, meaning in self.source if meaning) else ""

    @property
    def step_mm(self) -> float:
        """The last digit of the new text in mm."""
        return max(UNIT_MM[units] / 10 ** self._decimals[units] for units in self._units_used())

    def units_of(self, meaning: Meaning) -> str:
        """Return the units of the new line."""
        return self.where.units or meaning.units

    def decimals(self, units: str) -> int:
        """Return the digits after the point that new numbers have."""
        return self._decimals[units]

    def _units_used(self) -> set[str]:
        if self.where.units:
            return {self.where.units}
        return {meaning.units for meaning in self.source.meanings if meaning} or {"mm"}

    def _most_decimals(self) -> dict[str, int]:
        """Return by unit the digits that the program's lengths have, and no fewer than its dialect writes."""
        most = {units: dialect_decimals(self.source.dialect, units) for units in UNIT_MM}
        for number, _, meaning in self.source:
            if meaning and meaning.units == self.units_of(meaning):
                written = (token.written for token in self.source.tokens(number) if token.letter in "XYZIJKR")
                digits = max((decimals_of(one) for one in written if "[" not in one and "#" not in one), default=0)
                most[meaning.units] = max(most[meaning.units], digits)
        return most
