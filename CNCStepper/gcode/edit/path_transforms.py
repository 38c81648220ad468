# SPDX-License-Identifier: LGPL-2.1-or-later
"""The map of an edit's path: offset, scale, rotation about Z, mirror image, or another unit.

new = linear @ old + shift        work coordinates in mm, about the work zero in force

What the lines of a transformed program hand on from one to the next, and the digits that they write.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.edit.line_states import Meaning, Source
from CNCStepper.gcode.edit.word_values import decimals_of, dialect_decimals
from CNCStepper.tolerances import SAME_MATRIX_SCALE
from CNCStepper.toolpath import PLANE_AXES, PLANE_NAMES
from CNCStepper.units import UNIT_MM


@dataclass(frozen=True)
class Map:
    """linear: float64[3, 3]. shift: float64[3], mm. units: of the new text, "" for those of the old one."""

    linear: np.ndarray
    shift: np.ndarray
    units: str = ""

    @property
    def is_diagonal(self) -> bool:
        """Whether each new coordinate follows from the old one alone."""
        return not (self.linear - np.diag(np.diag(self.linear))).any()

    @property
    def moves_only(self) -> bool:
        """Whether nothing is turned or scaled."""
        return not (self.linear - np.eye(3)).any()

    @cached_property
    def scale(self) -> float | None:
        """By what every way grows, None where that depends on its direction."""
        square = self.linear @ self.linear.T
        factor = math.sqrt(float(np.trace(square)) / 3.0)
        even = np.abs(square - factor**2 * np.eye(3)).max() <= SAME_MATRIX_SCALE * max(factor**2, 1.0)
        return factor if even else None

    def of(self, point: np.ndarray) -> np.ndarray:
        """Return the image of a point, or of each row of many."""
        return point @ self.linear.T + self.shift

    @cached_property
    def rows(self) -> list[list[float]]:
        """The linear part as plain numbers, for frequent callers."""
        return self.linear.tolist()

    def in_plane(self, plane: str) -> tuple[float, float] | None:
        """Return (scale, sense) of arcs in a plane: sense -1 turns them round; None where they would be no arcs."""
        return self._planes[PLANE_NAMES.index(plane)]

    @cached_property
    def _planes(self) -> list[tuple[float, float] | None]:
        return [self._in_plane(*axes) for axes in PLANE_AXES]

    def _in_plane(self, first: int, second: int, normal: int) -> tuple[float, float] | None:
        block = self.linear[np.ix_((first, second), (first, second))]
        leaves = self.linear[normal, [first, second]].any() or self.linear[[first, second], normal].any()
        scale = math.sqrt(abs(np.linalg.det(block)))
        even = np.abs(block @ block.T - scale**2 * np.eye(2)).max() <= SAME_MATRIX_SCALE * max(scale**2, 1.0)
        if leaves or not even:
            return None
        return scale, math.copysign(1.0, float(np.linalg.det(block)))


def moved(x_mm: float, y_mm: float, z_mm: float = 0.0) -> Map:
    """Return the map that moves everything."""
    return Map(np.eye(3), np.array([x_mm, y_mm, z_mm]))


def scaled(x: float, y: float, z: float, about_mm: tuple[float, ...] = (0.0, 0.0, 0.0)) -> Map:
    """Return the map that multiplies each coordinate, seen from a point; raises ProgramError for one not above 0."""
    factors = np.array([x, y, z])
    if not (factors > 0).all():
        advice = "to turn a side round use mirror"
        raise ProgramError("edit-scale", "a scale must be above 0", value=f"{factors.min():g}", advice=advice)
    return _about(np.diag(factors), about_mm)


def rotated(angle_deg: float, about_mm: tuple[float, ...] = (0.0, 0.0)) -> Map:
    """Return the map that turns everything counter-clockwise about Z through a point of X and Y."""
    quarters = angle_deg / 90.0
    if quarters == round(quarters):  # exactly
        c, s = ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))[round(quarters) % 4]
    else:
        c, s = math.cos(math.radians(angle_deg)), math.sin(math.radians(angle_deg))
    return _about(np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]]), (*about_mm, 0.0)[:3])


def mirrored(axis: str, at_mm: float = 0.0) -> Map:
    """Return the map that changes the sign of X or Y, seen from the line where it is `at_mm`."""
    signs = {"X": (-1.0, 1.0, 1.0), "Y": (1.0, -1.0, 1.0)}
    if axis.upper() not in signs:
        raise ProgramError("edit-mirror", "a path is mirrored along X or Y", value=axis, advice="use X or Y")
    linear = np.diag(signs[axis.upper()])
    return _about(linear, (at_mm, at_mm, 0.0))


def _about(linear: np.ndarray, point: tuple[float, ...]) -> Map:
    centre = np.array(point, float)
    return Map(linear, centre - linear @ centre)


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
