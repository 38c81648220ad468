# SPDX-License-Identifier: LGPL-2.1-or-later
"""The difference of two parts that two programs leave of the same stock."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from CNCStepper.job.comparison.turned_difference import DifferentRing, different_rings, gone_only
from CNCStepper.simulation.removal.heightmap import HeightMap
from CNCStepper.simulation.turning.half_section import HalfSection
from CNCStepper.simulation.turning.turned_part import TurnedPart

CutPart = HeightMap | TurnedPart


@dataclass(frozen=True)
class PartDifference:
    """What each program alone removes, mm³, and the place where the parts differ most.

    deepest_mm: there, along Z of a milled part and as a distance in the half section of a turned one. place_mm: X Y, or
    X (radius) Z; None where the parts are the same. rings: of a turned part, the deepest first, those within the
    tolerance left out.
    """

    only_first_mm3: float
    only_second_mm3: float
    deepest_mm: float
    place_mm: tuple[float, float] | None
    axes: str
    rings: tuple[DifferentRing, ...] = ()


def part_difference(first: CutPart, second: CutPart, same_mm: float) -> PartDifference:
    """Return the difference of two parts of one kind, cut of the same stock; turned ones may be `same_mm` apart."""
    if isinstance(first, TurnedPart):
        assert isinstance(second, TurnedPart)
        return _of_sections(first.section, second.section, same_mm)
    assert isinstance(second, HeightMap)
    return _of_heights(first, second)


def _of_heights(first: HeightMap, second: HeightMap) -> PartDifference:
    """Compare two height maps; cells beside the stock count as far as they hold stock."""
    bottom_mm = first.stock.bottom_mm
    deeper_mm = np.maximum(second.heights_mm, bottom_mm) - np.maximum(first.heights_mm, bottom_mm)
    shares = first.stock.shares(first.x_mm, first.y_mm, first.cell_mm)
    deeper_mm = np.where(shares > 0.0, deeper_mm, 0.0)
    cell_mm2 = shares * first.cell_mm[0] * first.cell_mm[1]
    row, column = np.unravel_index(np.argmax(np.abs(deeper_mm)), deeper_mm.shape)
    deepest_mm = float(abs(deeper_mm[row, column]))
    place = (float(first.x_mm[column]), float(first.y_mm[row])) if deepest_mm else None
    one, other = (float((np.maximum(sign * deeper_mm, 0.0) * cell_mm2).sum()) for sign in (1.0, -1.0))
    return PartDifference(one, other, deepest_mm, place, "XY")


def _of_sections(first: HalfSection, second: HalfSection, same_mm: float) -> PartDifference:
    """Compare two half sections."""
    rings = tuple(different_rings(first, second, same_mm))
    one, other = (HalfSection(gone_only(*both)).volume_mm3 for both in ((first, second), (second, first)))
    deepest_mm, place = (rings[0].depth_mm, rings[0].place_mm) if rings else (0.0, None)
    return PartDifference(one, other, deepest_mm, place, "XZ", rings)
