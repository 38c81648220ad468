# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two sets of a controller's settings side by side, line by line, with their names and units."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from CNCStepper.control.protocol.grbl.settings import TOLERANCE
from CNCStepper.control.settings.setting_names import SettingName, setting_name

SHARE = 1e-6  # of the value: what a firmware that calculates with single precision may change


@dataclass(frozen=True)
class ComparedSetting:
    """One setting on both sides; None where a side does not have it."""

    number: int
    left: float | None
    right: float | None

    @property
    def name(self) -> SettingName:
        """Its name and unit."""
        return setting_name(self.number)

    @property
    def differs(self) -> bool:
        """Whether both sides have it, with another value."""
        return self.left is not None and self.right is not None and not same_value(self.left, self.right)

    @property
    def is_one_sided(self) -> bool:
        """Whether only one side has it."""
        return (self.left is None) != (self.right is None)


def same_value(one: float, other: float) -> bool:
    """Return whether two values are one setting: a firmware prints three decimals."""
    return abs(one - other) <= TOLERANCE + SHARE * abs(other)


def compare_settings(left: Mapping[int, float], right: Mapping[int, float]) -> Iterator[ComparedSetting]:
    """Yield the settings of either side, by number."""
    for number in sorted({*left, *right}):
        yield ComparedSetting(number, left.get(number), right.get(number))
