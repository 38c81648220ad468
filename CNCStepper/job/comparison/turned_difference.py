# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two turned parts of one bar compared by their half sections: where along Z they differ, and by which diameters.

      r ^        ____________
        |       |____________|   <- a ring that only one program has removed: from ø49.9 to ø50, from Z-40 to Z0
        |       |            |
        |_______|____________|______> z

Rings are the connected regions of the difference, as exact as the sections are. One counts where a place of it is
farther from the other part than the tolerance; a shoulder that is moved by 0.01 mm is no difference of 5 mm.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Literal, NamedTuple

import numpy as np
import shapely
from shapely.geometry.base import BaseGeometry

from CNCStepper.simulation.turning.half_section import HalfSection, solid
from CNCStepper.tolerances import SAME_MM

PARTS = 16  # into which the longer side of a ring is divided, to look how far it is from the other part
MOST_CORNERS = 1000  # of a ring and of the part beside it, that are looked at as they are
DECIMALS = 6  # of lengths, mm
BESIDE_MM = 1e-7  # how far beside a corner a region is looked at
NO_DIFFERENCE_MM = 1e-4  # between the side of a ring and that of a part, a little beside a place
Side = Literal["outer", "bore", "within"]


@dataclass(frozen=True)
class DifferentRing:
    """A ring that one of two programs has removed, and the other has left; lengths in mm.

    first: whether the first one has removed it. side: of the part that has it, "within" for neither of its outlines.
    z_mm: where it begins and ends, as far as it is thicker than the tolerance. depth_mm: how far it reaches from the
    other part. at_z_mm: where that is. diameters_mm: there, the smaller and the larger one.
    """

    first: bool
    side: Side
    z_mm: tuple[float, float]
    depth_mm: float
    at_z_mm: float
    diameters_mm: tuple[float, float]

    @property
    def place_mm(self) -> tuple[float, float]:
        """X as a radius, and Z, of its deepest place."""
        return self.diameters_mm[0 if self.side == "bore" else 1] / 2, self.at_z_mm

    @property
    def of_both_mm(self) -> tuple[float, float] | None:
        """The diameter, outer or of the bore, of the first and the second part there; None within."""
        if self.side == "within":
            return None
        low, high = self.diameters_mm
        return (low, high) if self.first == (self.side == "outer") else (high, low)


@dataclass(frozen=True)
class ComparedSections:
    """Two parts of one bar; rings: by which they differ, the deepest first. volumes_mm3: what each alone removes."""

    stock: HalfSection
    first: HalfSection
    second: HalfSection
    rings: Sequence[DifferentRing]
    volumes_mm3: tuple[float, float]


def gone_only(own: HalfSection, other: HalfSection) -> BaseGeometry:
    """Return what the other part has and this one has not."""
    return solid(shapely.difference(other.region, own.region))


def different_rings(first: HalfSection, second: HalfSection, same_mm: float) -> list[DifferentRing]:
    """Return the rings by which two parts differ more than `same_mm`, the deepest first."""
    found = [*_rings(first, second, True, same_mm), *_rings(second, first, False, same_mm)]
    return sorted(found, key=lambda ring: -ring.depth_mm)


def _rings(own: HalfSection, other: HalfSection, first: bool, same_mm: float) -> Iterator[DifferentRing]:
    """Yield the rings that are in the other part and not in this one."""
    for region in shapely.get_parts(gone_only(own, other)):
        z_low, r_low, z_high, r_high = region.bounds
        size = z_high - z_low, r_high - r_low
        if min(size) <= same_mm:
            continue
        slabs = _slabs(shapely.segmentize(_thinned(region), max(size) / PARTS))
        depth_mm, z_mm, (low, high) = _deepest(slabs, _thinned(_near(own.region, region, max(size))))
        if depth_mm > same_mm:
            beside_mm = z_mm + BESIDE_MM * np.sign((z_low + z_high) / 2 - z_mm)  # not on a step
            side, span = _side(beside_mm, low, high, other), _thicker_than(slabs, same_mm) or (z_low, z_high)
            ring = first, side, _rounded(*span), *_rounded(depth_mm, z_mm), _rounded(2 * low, 2 * high)
            yield DifferentRing(*ring)


def _rounded(one_mm: float, other_mm: float) -> tuple[float, float]:
    return round(one_mm, DECIMALS) + 0.0, round(other_mm, DECIMALS) + 0.0


class _Slabs(NamedTuple):
    """A region between any two of its corners along z: columns are the begin, the middle and the end of each slab.

    z, low, high: float64[n, 3], places and the least and the greatest radius there; at a step those within the slab,
    NaN at a tip that is too thin to be met.
    """

    z: np.ndarray
    low: np.ndarray
    high: np.ndarray


def _thinned(region: BaseGeometry) -> BaseGeometry:
    """Return a region of many chords with fewer of them, so that the work does not grow with their square."""
    many = shapely.get_num_coordinates(region) > MOST_CORNERS
    return shapely.simplify(region, NO_DIFFERENCE_MM) if many else region


def _slabs(region: BaseGeometry) -> _Slabs:
    bounds = np.unique(shapely.get_coordinates(region)[:, 0])
    if len(bounds) > MOST_CORNERS:
        bounds = bounds[np.linspace(0, len(bounds) - 1, MOST_CORNERS).astype(int)]
    wide = np.flatnonzero(np.diff(bounds) > 2 * BESIDE_MM)
    begin, end = bounds[wide], bounds[wide + 1]
    z = np.column_stack([begin, (begin + end) / 2, end])
    inside = z + np.array([BESIDE_MM, 0.0, -BESIDE_MM])
    _, r_low, _, r_high = region.bounds
    ends = np.stack([np.broadcast_to(r, z.shape) for r in (r_low - 1.0, r_high + 1.0)], axis=-1)
    lines = shapely.linestrings(np.stack([np.broadcast_to(inside[..., None], ends.shape), ends], axis=-1))
    met = shapely.bounds(shapely.intersection(region, lines))
    return _Slabs(z, met[..., 1], met[..., 3])


def _deepest(slabs: _Slabs, part: BaseGeometry) -> tuple[float, float, tuple[float, float]]:
    """Return how far a region reaches from a part, at which z, and the radii of the region there.

    Looked at are its lower and upper sides and their middle; where several are as far, the one nearest to the region's
    middle.
    """
    z, low, high = slabs
    radii = np.nan_to_num(np.stack([low, (low + high) / 2, high]))
    away_mm = shapely.distance(shapely.points(np.broadcast_to(z, radii.shape), radii), part).max(axis=0)
    if part.is_empty:
        away_mm = high - low
    away_mm = np.where(np.isnan(low), -np.inf, away_mm)
    off_mm = np.where(away_mm >= away_mm.max() - SAME_MM, np.abs(z - (z.min() + z.max()) / 2), np.inf)
    place = np.unravel_index(np.argmin(off_mm), off_mm.shape)
    return float(away_mm.max()), float(z[place]), (float(low[place]), float(high[place]))


def _near(part: BaseGeometry, region: BaseGeometry, size_mm: float) -> BaseGeometry:
    """Return as much of a part as can be nearest to a place of a region beside it."""
    low_z, low_r, high_z, high_r = region.bounds
    near = shapely.clip_by_rect(part, low_z - size_mm, low_r - size_mm, high_z + size_mm, high_r + size_mm)
    return part if near.is_empty else near


def _thicker_than(slabs: _Slabs, least_mm: float) -> tuple[float, float] | None:
    """Return from where to where along z a region is thicker than that along r; None where it is so nowhere."""
    thick = np.nan_to_num(slabs.high - slabs.low)[:, [0, 2]] - least_mm
    some = np.flatnonzero((thick > 0).any(axis=1))
    if not len(some):
        return None
    first, last = int(some[0]), int(some[-1])
    begin, end = (slabs.z[slab, [0, 2]] for slab in (first, last))
    return _crossing(begin, thick[first]), _crossing(end[::-1], thick[last, ::-1])


def _crossing(z: np.ndarray, thick: np.ndarray) -> float:
    """Return where a straight course from the first place to the second one comes above 0."""
    share = 0.0 if thick[0] > 0 else thick[0] / (thick[0] - thick[1])
    return float(z[0] + share * (z[1] - z[0]))


def _side(z_mm: float, low_mm: float, high_mm: float, part: HalfSection) -> Side:
    """Return the side of a part on which a ring lies, between two radii at a place."""
    if 2 * high_mm >= part.diameter_mm(z_mm) - NO_DIFFERENCE_MM:
        return "outer"
    return "bore" if 2 * low_mm <= part.bore_mm(z_mm) + NO_DIFFERENCE_MM else "within"
