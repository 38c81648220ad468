# SPDX-License-Identifier: LGPL-2.1-or-later
"""Puts the path of a program elsewhere by changing words in place: comments, order and form stay as they are written.

    G1 X10.5 Y#1 (edge)    offset by X 2   ->   G1 X12.5 Y#1 (edge)
    G91 X0.333             scale by 2      ->   G91 X0.666      what rounding leaves is carried to the next way

An axis is *free* until a coordinate of the work is said for it: it stands where the machine stood, which no edit moves.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from CNCStepper.gcode.edit.edit_result import Edited
from CNCStepper.gcode.edit.executed_lines import EXPAND, Meaning, Source
from CNCStepper.gcode.edit.line_edits import Line
from CNCStepper.gcode.edit.line_tokens import changed
from CNCStepper.gcode.edit.line_words import UNIT_MM
from CNCStepper.gcode.edit.number_format import decimals_of, dialect_decimals
from CNCStepper.gcode.edit.path_transforms import Map
from CNCStepper.gcode.edit.verification import verified


def transformed(source: Source, where: Map) -> Edited:
    """Return the program whose path lies where the map puts it; raises ProgramError naming the line that cannot."""
    mapper = Mapper(source, where)
    lines = [mapper.line(number, text, meaning) for number, text, meaning in source]
    return verified(source, source.lines.edited(lines), where, mapper.free_rows, mapper.step_mm)


@dataclass
class Mapper:
    """Goes through the lines in their order.

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
        if (
            not self.source.firsts
        ):  # O-words lead to and fro: an axis that no coordinate was said for shows when verified
            self.free = [False, False, False]
        self._decimals = self._most_decimals()
        self.blank = " " if any(" " in text.strip() for _, text, meaning in self.source if meaning) else ""

    @property
    def step_mm(self) -> float:
        """The last digit of the new text in mm."""
        return max(UNIT_MM[units] / 10 ** self._decimals[units] for units in self._units_used())

    def line(self, number: int, text: str, meaning: Meaning | None) -> str:
        """Return the new text of a line."""
        if meaning is None:
            self._check_skipped(number)
            return text
        tokens = self.source.tokens(number)
        if number in self.source.doubtful and any(token.letter in "XYZIJKRQ" for token in tokens):
            what = "this line is executed in modes that differ from one time to the next"
            raise self.source.refusal(number, "edit-doubtful", what, value=text.strip()[:40], advice=EXPAND)
        edits = Line(self, number, meaning, tokens).edits()
        self.free_rows[number] = tuple(self.free)
        return changed(text, edits) if edits else text

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

    def _check_skipped(self, number: int) -> None:
        text = self.source.lines.lines[number - 1]
        if text.strip() != "%" and any(token.letter in "XYZIJKRF" for token in self.source.tokens(number)):
            what = "this line is not executed (deleted, after the end or not led to): what it means is not known"
            raise self.source.refusal(number, "edit-skipped", what, value=text.strip()[:40], advice="take it out")
