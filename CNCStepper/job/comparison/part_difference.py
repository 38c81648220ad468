# SPDX-License-Identifier: LGPL-2.1-or-later
"""The difference of two parts that two programs leave of the same stock."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import shapely

from CNCStepper.simulation.removal.heightmap import HeightMap
from CNCStepper.simulation.turning.half_section import HalfSection, solid

CutPart = HeightMap | HalfSection


@dataclass(frozen=True)
class PartDifference:
    """What each program alone removes, mm³, and the place where the parts differ most.

    deepest_mm: there, along Z of a milled part and as a distance in the half section of a turned one. place_mm: X Y, or
    X (radius) Z; None where the parts are the same.
    """

    only_first_mm3: float
    only_second_mm3: float
    deepest_mm: float
    place_mm: tuple[float, float] | None
    axes: str


def part_difference(first: CutPart, second: CutPart) -> PartDifference:
    """Return the difference of two parts of one kind, cut of the same stock."""
    if isinstance(first, HalfSection):
        assert isinstance(second, HalfSection)
        return _of_sections(first, second)
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


def _of_sections(first: HalfSection, second: HalfSection) -> PartDifference:
    """Compare two half sections."""
    gone = [
        solid(shapely.difference(other.region, own.region)) for own, other in ((first, second), (second, first))
    ]  # what is in the other part, and not in this one
    deepest_mm, place = 0.0, None
    for region, part in zip(gone, (first, second), strict=True):
        corners = shapely.get_coordinates(region)
        if len(corners) and not part.region.is_empty:
            away_mm = shapely.distance(shapely.points(corners), part.region)
            worst = int(np.argmax(away_mm))
            if away_mm[worst] > deepest_mm:
                z_mm, radius_mm = corners[worst].tolist()
                deepest_mm, place = float(away_mm[worst]), (radius_mm, z_mm)
    one, other = (HalfSection(region).volume_mm3 for region in gone)
    return PartDifference(one, other, deepest_mm, place, "XZ")
