# SPDX-License-Identifier: LGPL-2.1-or-later
"""Records of turned parts: of each its height and three diameters, their mean, deviation and ratio to the nominal.

    part   height   d1      d2      d3      mean      deviation   ratio
    1      150.02   49.98   50.01   50.00   49.9967   0.0153      0.99993

The diameters are measured along a cylinder; those of a cone at its base.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from CNCStepper.machine.axis_tests import Readings, check_reading

DIAMETERS = 3


@dataclass(frozen=True)
class PartRecord:
    """One part as it was measured, mm."""

    height_mm: float
    diameters_mm: Readings

    def height_ratio(self, nominal_mm: float) -> float:
        """Return the height by the nominal one."""
        return self.height_mm / nominal_mm

    def diameter_ratio(self, nominal_mm: float) -> float:
        """Return the mean of the diameters by the nominal one."""
        return self.diameters_mm.mean_mm / nominal_mm


def part_record(values_mm: Sequence[float], height_mm: float, diameter_mm: float) -> PartRecord:
    """Return the record of a height and the diameters, which must be near the nominal ones; raises JobError."""
    check_reading(values_mm[0], height_mm)
    for value in values_mm[1:]:
        check_reading(value, diameter_mm)
    return PartRecord(values_mm[0], Readings(tuple(values_mm[1:])))


def over_parts(records: Sequence[PartRecord]) -> tuple[Readings, Readings]:
    """Return the heights and the mean diameters of several parts, as readings."""
    return (
        Readings(tuple(record.height_mm for record in records)),
        Readings(tuple(record.diameters_mm.mean_mm for record in records)),
    )
