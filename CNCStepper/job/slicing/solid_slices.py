# SPDX-License-Identifier: LGPL-2.1-or-later
"""A solid as a stack of sheets: a section at the middle of each, in parts, with registration holes and marks.

    axis X: sections in the plane Y Z        front  ├┤├┤├┤   the stack is as high as the solid or a little higher,
    axis Y: sections in the plane Z X        middle ├┤├┤├┤   both ends alike
    axis Z: sections in the plane X Y        back   ├┤├┤├┤

The volume of a stack is the sum of area times thickness (the midpoint rule); it approaches that of the solid with the
square of the thickness. A registration hole goes straight through all sheets whose section holds it.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np
import shapely
from shapely import Polygon
from shapely.geometry.base import BaseGeometry

from CNCStepper.cancellation import checkpoint
from CNCStepper.errors import Text
from CNCStepper.geometry.curve import Curve
from CNCStepper.job.slicing.sections import Outline, Sections

THIN_SHARE = 0.9  # of a sheet that a solid fills where it is not told to be thinner
MOST_OFF = 0.01  # of the volume that a stack may be off before it is told
LEAST_PIECE_MM2 = 1.0  # smaller pieces of a section are told and left out
HOLE_GRID = 48  # places along a side where a registration hole may go
FAR_WEIGHT = 0.3  # of the distance to the first hole, beside the number of sheets, in the choice of the second one
APART = 4.0  # diameters between two holes, at least


@dataclass(frozen=True)
class Hole:
    """A registration hole, mm, in the coordinates of the sections."""

    x_mm: float
    y_mm: float
    diameter_mm: float


@dataclass(frozen=True)
class Piece:
    """One piece of a section: its name, its outline with the holes of the solid, its registration holes.

    outline: holds the piece; rings: its lines and arcs, as they are cut.
    """

    name: str
    outline: Polygon
    rings: tuple[Curve, ...]
    area_mm2: float
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
        return float(sum(piece.area_mm2 for piece in self.pieces))


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


def stack_of(
    sections: Sections, parts: Sequence[str] = ("front", "middle", "back"), hole_diameter_mm: float = 0.0
) -> Stack:
    """Return the stack of a solid's sections.

    parts: names of runs of sheets of about the same number, from the lowest. hole_diameter_mm: 0 for no holes.
    """
    areas = [shapely.union_all([outline.polygon for outline in own]) for own in sections.outlines]
    holes = registration_holes(areas, hole_diameter_mm) if hole_diameter_mm else ()
    slices, notes = [], list[str]()
    for number, (begin_mm, own) in enumerate(zip(sections.begins_mm, sections.outlines, strict=True), start=1):
        part = parts[(number - 1) * len(parts) // len(areas)]
        pieces, small = _pieces(own, f"{part} {number}", holes)
        notes += [Text("sheet {number}: {small} pieces below 1 mm2 left out", number=number, small=small)] * bool(small)
        slices.append(Slice(number, part, begin_mm, pieces))
    stack = Stack(tuple(slices), sections.thickness_mm, sections.volume_mm3)
    if hole_diameter_mm:
        notes += _hole_notes(slices, hole_diameter_mm)
    return replace(stack, notes=(*notes, *_volume_notes(stack, sections)))


def _hole_notes(slices: Sequence[Slice], diameter_mm: float) -> Iterator[str]:
    """Yield how many sheets have no registration hole."""
    count = sum(not any(piece.holes for piece in each.pieces) for each in slices)
    if count:
        yield Text(
            "{count} of {all} sheets have no registration hole: one of {hole:g} mm takes {least:g} mm across",
            count=count,
            all=len(slices),
            hole=diameter_mm,
            least=2.0 * diameter_mm,
        )


def _volume_notes(stack: Stack, sections: Sections) -> Iterator[str]:
    """Yield each sheet of which the solid fills less than its section says, and how far the whole stack is off."""
    for each, volume_mm3 in zip(stack.slices, sections.sheet_volumes_mm3, strict=False):
        sheet_mm3 = each.area_mm2 * stack.thickness_mm
        if volume_mm3 < THIN_SHARE * sheet_mm3:
            share = 100.0 * volume_mm3 / sheet_mm3
            yield Text(
                "sheet {number}: the solid is thinner there than the sheet and fills {share:.0f} % of it",
                number=each.number,
                share=share,
            )
    off = stack.volume_mm3 / stack.solid_volume_mm3 - 1.0
    if abs(off) > MOST_OFF:
        yield Text(
            "the volume of the stack is off by {off:+.1f} %: take thinner sheets, or let thin walls stand on them",
            off=100.0 * off,
        )


def _pieces(outlines: Sequence[Outline], name: str, holes: Sequence[Hole]) -> tuple[tuple[Piece, ...], int]:
    """Return the pieces of a section, the largest first, and how many are too small."""
    large = sorted((each for each in outlines if each.area_mm2 >= LEAST_PIECE_MM2), key=lambda each: -each.area_mm2)
    letters = [""] if len(large) < 2 else [f".{number}" for number in range(1, len(large) + 1)]
    pieces = [
        Piece(
            name + letter,
            each.polygon,
            each.rings,
            each.area_mm2,
            tuple(hole for hole in holes if _holds(each.polygon, hole)),
        )
        for each, letter in zip(large, letters, strict=bool(large))
    ]
    return tuple(pieces), len(outlines) - len(large)


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
