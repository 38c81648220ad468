# SPDX-License-Identifier: LGPL-2.1-or-later
"""The declaration of a basic shape: its name, its dimensions with units and bounds, and its figure, once.

    @shape("Washer", "A disc with a hole in its middle.",
           outer_diameter_mm=length("Outer diameter", 30.0), hole_diameter_mm=length("Hole", 12.0))
    def washer(outer_diameter_mm, hole_diameter_mm): return Figure(disc(outer_diameter_mm), (disc(hole_diameter_mm),))

Job files, the reference, its pictures and FreeCAD's panel follow from it. The zero of a shape is the middle of its box
or of its main circle, as its text says.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import shapely

from CNCStepper.errors import GeometryError, Text
from CNCStepper.geometry.curve import Curve
from CNCStepper.quantities import Bounds, shown
from CNCStepper.tolerances import SAME_MM

CHORD_MM = 0.002  # how far chords leave the arcs where holes and outline are compared


@dataclass(frozen=True)
class Figure:
    """The outline of a shape and its holes, closed curves of lines and arcs, mm, each counter-clockwise."""

    outline: Curve
    holes: tuple[Curve, ...] = ()

    @property
    def curves(self) -> tuple[Curve, ...]:
        """All curves, the outline first."""
        return (self.outline, *self.holes)

    @property
    def area_mm2(self) -> float:
        """The area within the outline and without the holes."""
        return abs(self.outline.area_mm2) - sum(abs(hole.area_mm2) for hole in self.holes)


@dataclass(frozen=True)
class Dimension:
    """One dimension: its title in a panel, its bounds, and the value that a new shape has."""

    title: str
    bounds: Bounds
    usual: float

    @property
    def is_count(self) -> bool:
        """Whether it is a whole number."""
        return self.bounds.kind == "count"


def length(title: str, usual: float, zero: bool = False) -> Dimension:
    """Return the dimension of a length in mm; zero: 0 is allowed too."""
    return Dimension(title, Bounds("length", most=MOST_MM, zero=zero), usual)


def angle(title: str, usual: float, least: float, most: float) -> Dimension:
    """Return the dimension of an angle in degrees."""
    return Dimension(title, Bounds("angle", least, most), usual)


def count(title: str, usual: int, least: int, most: int = 200) -> Dimension:
    """Return the dimension of a whole number."""
    return Dimension(title, Bounds("count", least, most), usual)


MOST_MM = 10_000.0


@dataclass(frozen=True)
class LibraryShape:
    """A shape that can be made: kind, title, a sentence on it, its dimensions by key, and what draws it."""

    kind: str
    title: str
    about: str
    dimensions: Mapping[str, Dimension]
    draw: Callable[..., Figure]

    def figure(self, values: Mapping[str, Any]) -> Figure:
        """Return the figure with these dimensions; those left out have their usual values.

        Raises JobError for a value out of its bounds, GeometryError for an unknown key and for dimensions that do not
        go together.
        """
        unknown = sorted(set(values) - set(self.dimensions))
        if unknown:
            raise GeometryError(
                "shape-key",
                Text("the shape '{kind}' has no dimension {key}", kind=self.kind, key=shown(unknown[0])),
                advice=Text("it has {known}", known=", ".join(self.dimensions)),
            )
        whole = {key: self._value(key, values.get(key, one.usual)) for key, one in self.dimensions.items()}
        figure = self.draw(**whole)
        _require_figure(self.kind, figure)
        return figure

    def _value(self, key: str, value: Any) -> float | int:
        dimension = self.dimensions[key]
        number = dimension.bounds.require(value, f"{self.kind}.{key}")
        if not dimension.is_count:
            return number
        if number != int(number):
            raise dimension.bounds.refusal(value, f"{self.kind}.{key}")
        return int(number)


SHAPES: dict[str, LibraryShape] = {}
Draw = Callable[..., Figure]


def shape(title: str, about: str, **dimensions: Dimension) -> Callable[[Draw], Draw]:
    """Declare the shape that a function draws; its kind is the function's name."""

    def declare(draw: Draw) -> Draw:
        kind = draw.__name__
        SHAPES[kind] = LibraryShape(kind, title, about, dimensions, draw)
        return draw

    return declare


def require_above(value: float, limit: float, what: str, than: str, unit: str = " mm") -> None:
    """Raise GeometryError where a dimension is not larger than another one."""
    if not value > limit + SAME_MM:
        what_text = Text("{what} must be larger than {than}", what=what, than=than)
        shown_value, shown_limit = f"{value:g}{unit}", f"{limit:g}{unit}"
        raise GeometryError("shape-size", what_text, value=shown_value, limit=shown_limit, advice="change one of them")


def _require_figure(kind: str, figure: Figure) -> None:
    """Raise GeometryError for an outline that crosses itself, and for holes that leave it or meet each other."""
    outline, *holes = (shapely.Polygon(curve.points(CHORD_MM)) for curve in figure.curves)
    if not outline.is_valid or not outline.area > SAME_MM:
        raise _impossible(kind, _crossing(outline))
    room = shapely.STRtree(holes)
    for number, hole in enumerate(holes):
        if not hole.is_valid or not outline.contains_properly(hole):
            raise _impossible(kind, _beyond(hole, outline))
        for other in room.query(hole, predicate="intersects").tolist():
            if other != number:
                raise _impossible(kind, _meeting(hole, holes[other]))


def _crossing(outline: shapely.Polygon) -> str:
    """Return that an outline crosses itself, and where it does so first."""
    place = re.search(r"\[(\S+) (\S+)\]", shapely.is_valid_reason(outline))
    if place is None:
        return Text("its outline would have no area")
    x, y = map(float, place.groups())
    return Text("its outline would cross itself at X{x:.2f} Y{y:.2f}", x=x, y=y)


def _beyond(hole: shapely.Polygon, outline: shapely.Polygon) -> str:
    """Return which hole reaches beyond the outline, and how far."""
    middle, points = shapely.centroid(hole), shapely.points(shapely.get_coordinates(hole))
    over_mm = float(shapely.distance(outline, points).max())
    return Text(
        "the hole at X{x:.2f} Y{y:.2f} would reach {over:.3g} mm beyond its outline",
        x=_hundredths(middle.x),
        y=_hundredths(middle.y),
        over=over_mm,
    )


def _meeting(one: shapely.Polygon, other: shapely.Polygon) -> str:
    """Return which holes meet, and how far they overlap between their middles."""
    first, second = shapely.centroid(one), shapely.centroid(other)
    return Text(
        "the holes at X{x:.2f} Y{y:.2f} and X{x2:.2f} Y{y2:.2f} would overlap by {over:.3g} mm",
        x=_hundredths(first.x),
        y=_hundredths(first.y),
        x2=_hundredths(second.x),
        y2=_hundredths(second.y),
        over=_overlap_mm(one, other),
    )


def _hundredths(value_mm: float) -> float:
    """Return a coordinate as it is told, without -0."""
    return round(value_mm, 2) + 0.0


def _overlap_mm(one: shapely.Polygon, other: shapely.Polygon) -> float:
    """Return the width of what two areas have in common: the shorter side of the least box round it."""
    corners = shapely.get_coordinates(shapely.minimum_rotated_rectangle(shapely.intersection(one, other)))
    if len(corners) < 4:  # they touch
        return 0.0
    return float(min(math.dist(corners[0], corners[1]), math.dist(corners[1], corners[2])))


def _impossible(kind: str, why: str) -> GeometryError:
    what = Text("the dimensions of the shape '{kind}' do not go together: {why}", kind=kind, why=why)
    return GeometryError("shape-size", what, advice="change one of its dimensions")
