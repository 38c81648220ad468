# SPDX-License-Identifier: LGPL-2.1-or-later
"""The grid of numbers that a text can hold: lengths as whole counts of its last digit.

The writer works on this grid, so that it knows exactly where the machine stands after each line.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TypeVar

import numpy as np

from CNCStepper.units import MM_PER_INCH

Lengths = TypeVar("Lengths", float, np.ndarray)


@dataclass(frozen=True)
class Grid:
    """units: "mm" or "inch" of the text; decimals: digits after the point."""

    units: str
    decimals: int

    @cached_property
    def unit_mm(self) -> float:
        """One unit of the text in mm."""
        return MM_PER_INCH if self.units == "inch" else 1.0

    @cached_property
    def counts(self) -> int:
        """How many counts of the last digit one unit of the text has."""
        return 10**self.decimals

    @property
    def step_mm(self) -> float:
        """The last digit in mm."""
        return self.unit_mm / self.counts

    def exact(self, length_mm: Lengths) -> Lengths:
        """Return a length, or an array of them, in counts of the last digit, not rounded."""
        return length_mm / self.unit_mm * self.counts

    def count(self, length_mm: float) -> int:
        """Return a length in whole counts of the last digit."""
        return round(self.exact(length_mm))

    def text(self, count: int) -> str:
        """Return a length as text with all its decimals; there is no -0."""
        sign = "-" if count < 0 else ""
        whole, rest = divmod(abs(count), self.counts)
        return f"{sign}{whole}.{rest:0{self.decimals}d}"

    def short(self, length_mm: float) -> str:
        """Return a length (a feed) as text without trailing zeros."""
        return self.text(self.count(length_mm)).rstrip("0").rstrip(".")
