# SPDX-License-Identifier: LGPL-2.1-or-later
"""The half section of a turned part: a region over the axis, its profiles, its diameters, its volume.

      r ^      ____________
        |     |____    ____|   outer profile: the largest diameter at each z; bore profile: the smallest one
        |__________|__|_________ > z      z = 0 is the finished end face, z < 0 lies towards the chuck

Regions are shapely geometries with x = z and y = r, in mm. z is the axis of the spindle, r the radius.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import shapely
from shapely.geometry.base import BaseGeometry

from CNCStepper.errors import JobError, Text
from CNCStepper.tolerances import NO_AREA_MM2, NO_MATERIAL_MM

UPRIGHT_DECIMALS = 8  # of z, mm: an edge whose ends agree in these is upright
Profile = list[tuple[float, float]]


@dataclass(frozen=True)
class HalfSection:
    """A region of the half plane; `region` holds polygons with r >= 0."""

    region: BaseGeometry

    @property
    def volume_mm3(self) -> float:
        """The volume of the region turned about the axis: its area times the way of its centroid."""
        return 2 * np.pi * float(self.region.area * self.region.centroid.y) if self.region.area else 0.0

    @property
    def outer_profile(self) -> Profile:
        """The largest diameter at each z, as points [z_mm, diameter_mm] along growing z; a step has two points."""
        return _profile(*self._envelope(np.maximum, -np.inf))

    @property
    def bore_profile(self) -> Profile:
        """The smallest diameter at each z, 0 where the part is solid; empty where it is solid everywhere."""
        z, sides = self._envelope(np.minimum, np.inf)
        return _profile(z, sides) if len(sides) and sides.max() > NO_MATERIAL_MM else []

    def diameter_mm(self, z_mm: float) -> float:
        """Return the largest diameter at a place along the axis, of both sides of a step the larger one; 0 for none."""
        found = self._at(z_mm)
        return 2 * max(found) if found else 0.0

    def bore_mm(self, z_mm: float) -> float:
        """Return the smallest diameter at a place along the axis; 0 where the part is solid or there is none."""
        found = self._at(z_mm)
        return 2 * min(found) if found else 0.0

    def pieces(self) -> list[BaseGeometry]:
        """Return the connected polygons, along z."""
        parts = [part for part in shapely.get_parts(self.region) if part.area > NO_AREA_MM2]
        return sorted(parts, key=lambda part: part.bounds[0])

    def _at(self, z_mm: float) -> tuple[float, ...]:
        low, high = self.region.bounds[1::2] if not self.region.is_empty else (0.0, 0.0)
        line = shapely.LineString([(z_mm, low - 1), (z_mm, high + 1)])
        met = self.region.intersection(line)
        return () if met.is_empty else (met.bounds[1], met.bounds[3])

    @cached_property
    def _edges(self) -> np.ndarray:
        """Both ends of all edges that are not upright, the left one first, float64[n, 2, 2]."""
        rings = shapely.get_rings(shapely.get_parts(self.region))
        points, ring = shapely.get_coordinates(rings, return_index=True)
        points[:, 0] = np.round(points[:, 0], UPRIGHT_DECIMALS)
        edges = np.stack([points[:-1], points[1:]], axis=1)[ring[:-1] == ring[1:]]
        backwards = edges[:, 0, 0] > edges[:, 1, 0]
        edges[backwards] = edges[backwards][:, ::-1]
        return edges[edges[:, 1, 0] > edges[:, 0, 0]]

    def _envelope(self, extreme: np.ufunc, none: float) -> tuple[np.ndarray, np.ndarray]:
        """Return places z, float64[k], and the extreme radius at both ends of each slab between, float64[k - 1, 2]."""
        edges = self._edges
        if not len(edges):
            return np.zeros(0), np.zeros((0, 2))
        z = np.unique(edges[:, :, 0])
        first, last = (np.searchsorted(z, edges[:, side, 0]) for side in (0, 1))
        edge = np.repeat(np.arange(len(edges)), last - first)
        slab = np.arange(len(edge)) - np.repeat(np.cumsum(last - first) - (last - first), last - first) + first[edge]
        best = np.full(len(z) - 1, none)
        middle = _radius_at(edges[edge], (z[slab] + z[slab + 1]) / 2)
        extreme.at(best, slab, middle)
        sides = np.zeros((len(z) - 1, 2))
        is_best = middle == best[slab]
        for side in (0, 1):
            sides[slab[is_best], side] = _radius_at(edges[edge[is_best]], z[slab[is_best] + side])
        return z, sides


def _radius_at(edges: np.ndarray, z: np.ndarray) -> np.ndarray:
    """Return the radius of each edge at a z, exactly that of an end there."""
    share = (z - edges[:, 0, 0]) / (edges[:, 1, 0] - edges[:, 0, 0])
    return edges[:, 0, 1] * (1 - share) + edges[:, 1, 1] * share


def _profile(z: np.ndarray, sides: np.ndarray) -> Profile:
    """Return the points of an envelope without those in the middle of a straight line."""
    if not len(sides):
        return []
    points = np.empty((2 * len(sides), 2))
    points[0::2] = np.column_stack([z[:-1], 2 * sides[:, 0]])
    points[1::2] = np.column_stack([z[1:], 2 * sides[:, 1]])
    line = shapely.simplify(shapely.LineString(points), NO_MATERIAL_MM, preserve_topology=False)
    return [(float(place), float(diameter)) for place, diameter in shapely.get_coordinates(line)]


def bar(diameter_mm: float, length_mm: float, face_mm: float = 0.0, bore_mm: float = 0.0) -> HalfSection:
    """Return raw stock from the chuck's face at z = -length_mm to z = face_mm; a tube where `bore_mm` is above 0.

    Raises JobError for sizes that leave no material.
    """
    if not (0 <= bore_mm < diameter_mm and -face_mm < length_mm):
        what = Text("a bar of {diameter:g} x {length:g} mm holds no material", diameter=diameter_mm, length=length_mm)
        raise JobError("turning-stock", what, advice="give a diameter above the bore and a length above 0")
    return HalfSection(shapely.box(-length_mm, bore_mm / 2, face_mm, diameter_mm / 2))


def below_chain(points: Iterable[Iterable[float]]) -> BaseGeometry:
    """Return the region between the axis and a chain of points (z, r), along falling or growing z."""
    chain = np.asarray([tuple(point) for point in points], float)
    closed = np.vstack([[(chain[0, 0], 0.0)], chain, [(chain[-1, 0], 0.0)]])
    return shapely.make_valid(shapely.Polygon(closed)).buffer(0)


def solid(region: BaseGeometry) -> BaseGeometry:
    """Return the polygons of a region, without the lines and points that differences leave beside them."""
    parts = shapely.get_parts(region)
    return shapely.union_all(parts[shapely.area(parts) > NO_AREA_MM2])
