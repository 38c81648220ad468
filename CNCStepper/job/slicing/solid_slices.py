# SPDX-License-Identifier: LGPL-2.1-or-later
"""A solid as a stack of sheets: a section at the middle of each, in parts, with registration holes and marks.

    axis X: sections in the plane Y Z        front  ├┤├┤├┤   the stack is as high as the solid or a little higher,
    axis Y: sections in the plane Z X        middle ├┤├┤├┤   both ends alike
    axis Z: sections in the plane X Y        back   ├┤├┤├┤

The volume of a stack is the sum of area times thickness (the midpoint rule); it approaches that of the solid with the
square of the thickness. A registration hole goes straight through all sheets whose section holds it.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import shapely
from shapely import Polygon
from shapely.geometry.base import BaseGeometry

from CNCStepper.cancellation import checkpoint
from CNCStepper.drawing.solids.mesh_outline import section
from CNCStepper.errors import JobError, Text
from CNCStepper.geometry.curve import Curve

AXES = {"x": (1, 2, 0), "y": (2, 0, 1), "z": (0, 1, 2)}  # columns that become X, Y and the height
MOST_SLICES = 2_000
MERGED_DECIMALS = 6  # of mm: corners of triangles that are one
LEAST_PIECE_MM2 = 1.0  # smaller pieces of a section are told and left out
HOLE_GRID = 48  # places along a side where a registration hole may go
FAR_WEIGHT = 0.3  # of the distance to the first hole, beside the number of sheets, in the choice of the second one
APART = 4.0  # diameters between two holes, at least
EXACT = 1e-9


@dataclass(frozen=True)
class Hole:
    """A registration hole, mm, in the coordinates of the sections."""

    x_mm: float
    y_mm: float
    diameter_mm: float


@dataclass(frozen=True)
class Piece:
    """One piece of a section: its name, its outline with the holes of the solid, its registration holes."""

    name: str
    outline: Polygon
    holes: tuple[Hole, ...]


@dataclass(frozen=True)
class Slice:
    """One sheet of the stack: number from 1, its part, where it begins along the axis, its pieces."""

    number: int
    part: str
    begin_mm: float
    pieces: tuple[Piece, ...]

    @property
    def area_mm2(self) -> float:
        """The area of the section, registration holes not taken out."""
        return float(sum(piece.outline.area for piece in self.pieces))


@dataclass(frozen=True)
class Stack:
    """The sheets from the lowest to the highest; notes: what was left out."""

    slices: tuple[Slice, ...]
    thickness_mm: float
    solid_volume_mm3: float
    notes: tuple[str, ...] = ()

    @property
    def volume_mm3(self) -> float:
        """The volume of the stack, registration holes not taken out."""
        return sum(each.area_mm2 for each in self.slices) * self.thickness_mm


def sliced(
    triangles: np.ndarray,
    axis: str,
    thickness_mm: float,
    parts: Sequence[str] = ("front", "middle", "back"),
    hole_diameter_mm: float = 0.0,
) -> Stack:
    """Return the stack of a closed mesh, float64[n, 3, 3] in mm; raises JobError for an open one or too many sheets.

    parts: names of runs of sheets of about the same number, from the lowest. hole_diameter_mm: 0 for no holes.
    """
    mesh = triangles[:, :, AXES[axis]]
    require_closed(mesh)
    low_mm, high_mm = float(mesh[:, :, 2].min()), float(mesh[:, :, 2].max())
    count = max(1, math.ceil((high_mm - low_mm) / thickness_mm - EXACT))
    if count > MOST_SLICES:
        advice = "use thicker sheets"
        raise JobError(
            "slice-count", "the stack has too many sheets", value=f"{count}", limit=f"{MOST_SLICES}", advice=advice
        )
    first_mm = (low_mm + high_mm - count * thickness_mm) / 2.0
    begins = [first_mm + number * thickness_mm for number in range(count)]
    sections = [section_area(mesh, min(max(b + thickness_mm / 2.0, low_mm), high_mm)) for b in begins]
    holes = registration_holes(sections, hole_diameter_mm) if hole_diameter_mm else ()
    slices, notes = [], list[str]()
    for number, (begin_mm, area) in enumerate(zip(begins, sections, strict=True), start=1):
        part = parts[(number - 1) * len(parts) // count]
        pieces, small = _pieces(area, f"{part} {number}", holes)
        notes += [Text("sheet {number}: {small} pieces below 1 mm2 left out", number=number, small=small)] * bool(small)
        slices.append(Slice(number, part, begin_mm, pieces))
    return Stack(tuple(slices), thickness_mm, volume_mm3(mesh), tuple(notes))


def require_closed(mesh: np.ndarray) -> None:
    """Raise JobError unless each edge of the mesh belongs to as many triangles one way as the other."""
    corners, numbers = np.unique(mesh.reshape(-1, 3).round(MERGED_DECIMALS), axis=0, return_inverse=True)
    faces = numbers.reshape(-1, 3)
    begins, ends = faces.ravel(), np.roll(faces, -1, axis=1).ravel()
    real = begins != ends
    keys = np.minimum(begins, ends)[real] * len(corners) + np.maximum(begins, ends)[real]
    ways = np.where(begins < ends, 1, -1)[real]
    _, edges = np.unique(keys, return_inverse=True)
    open_edges = int((np.bincount(edges, ways) != 0).sum())
    if open_edges:
        advice = "repair the mesh, and export it again"
        raise JobError("slice-open", "the solid is not closed", value=f"{open_edges} open edges", advice=advice)


def volume_mm3(mesh: np.ndarray) -> float:
    """Return the volume in a closed mesh."""
    first, second, third = mesh[:, 0], mesh[:, 1], mesh[:, 2]
    return abs(float(np.einsum("ij,ij->i", first, np.cross(second, third)).sum())) / 6.0


def section_area(mesh: np.ndarray, height_mm: float) -> BaseGeometry:
    """Return the section of a closed mesh at a height as polygons: what lies in an odd number of its loops."""
    checkpoint()
    rings = [shapely.make_valid(Polygon(curve.xy)) for curve in section(mesh, height_mm) if _is_ring(curve)]
    whole: BaseGeometry = Polygon()
    for ring in sorted(rings, key=lambda ring: -ring.area):
        whole = whole.symmetric_difference(ring)
    return whole


def _is_ring(curve: Curve) -> bool:
    return curve.closed and len(curve) > 2


def _pieces(area: BaseGeometry, name: str, holes: Sequence[Hole]) -> tuple[tuple[Piece, ...], int]:
    """Return the pieces of a section, the largest first, and how many are too small."""
    found = [part for part in shapely.get_parts(area) if isinstance(part, Polygon) and part.area > 0.0]
    large = sorted((part for part in found if part.area >= LEAST_PIECE_MM2), key=lambda part: -part.area)
    letters = [""] if len(large) < 2 else [f".{number}" for number in range(1, len(large) + 1)]
    pieces = [
        Piece(name + letter, part, tuple(hole for hole in holes if _holds(part, hole)))
        for part, letter in zip(large, letters, strict=bool(large))
    ]
    return tuple(pieces), len(found) - len(large)


def _holds(part: Polygon, hole: Hole) -> bool:
    """Return whether material as wide as the hole's radius stays around the hole."""
    place = shapely.Point(hole.x_mm, hole.y_mm)
    return bool(part.contains(place) and part.boundary.distance(place) >= hole.diameter_mm)


def registration_holes(sections: Sequence[BaseGeometry], diameter_mm: float) -> tuple[Hole, ...]:
    """Return two holes through as many sheets as can be, far from each other; one or none where they do not fit."""
    left, low, right, high = shapely.total_bounds(sections)
    x, y = np.meshgrid(np.linspace(left, right, HOLE_GRID + 2)[1:-1], np.linspace(low, high, HOLE_GRID + 2)[1:-1])
    places = np.column_stack([x.ravel(), y.ravel()])
    points = shapely.points(places)
    counts = np.zeros(len(points), int)
    for area in sections:
        checkpoint()
        room = area.buffer(-diameter_mm)
        shapely.prepare(room)
        counts += shapely.contains(room, points)
    if not counts.any():
        return ()
    middle = places[counts == counts.max()].mean(axis=0)
    first = int(np.argmax(counts - 1e-6 * np.hypot(*(places - middle).T) / max(right - left, high - low)))
    away = np.hypot(*(places - places[first]).T)
    able = (away >= APART * diameter_mm) & (counts > 0)
    chosen = [first]
    if able.any():
        chosen.append(int(np.argmax(np.where(able, counts / counts.max() + FAR_WEIGHT * away / away.max(), -1.0))))
    return tuple(Hole(float(places[n, 0]), float(places[n, 1]), diameter_mm) for n in chosen)
