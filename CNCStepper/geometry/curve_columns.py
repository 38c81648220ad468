# SPDX-License-Identifier: LGPL-2.1-or-later
"""The two columns of a Curve, refused when they are no curve, and the measures of all its segments at once.

Lines and arcs as columns of complex numbers, one row a segment, for the computations of Curve.

    begin  complex128[n]   where the segment begins, x + iy, mm
    end    complex128[n]   where it ends; exactly where the next one of a chain begins
    sweep  float64[n]      the angle it turns through, rad, positive counter-clockwise, 0 for a line

No centre comes in: a nearly straight arc has it so far away that nothing could be computed from it.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from CNCStepper.errors import GeometryError, Text
from CNCStepper.tolerances import COINCIDENT_MM

Row = np.ndarray | slice | int


class Segments(NamedTuple):
    """Columns of segments; see the module's text."""

    begin: np.ndarray
    end: np.ndarray
    sweep: np.ndarray

    @property
    def chord(self) -> np.ndarray:
        """From begin to end, complex128[n]."""
        return self.end - self.begin

    @property
    def curvature(self) -> np.ndarray:
        """One over the radius, float64[n], 1/mm, positive where it turns left, 0 for lines."""
        size = np.abs(self.chord)
        return 2.0 * np.sin(self.sweep / 2.0) / np.where(size > 0.0, size, 1.0)

    @property
    def length_mm(self) -> np.ndarray:
        """The length, float64[n]."""
        half = np.abs(self.sweep) / 2.0
        return np.abs(self.chord) * np.where(half > 0.0, half / np.sin(np.where(half > 0.0, half, 1.0)), 1.0)

    @property
    def along(self) -> np.ndarray:
        """The unit vector of the chord, complex128[n]; 1 where there is none."""
        size = np.abs(self.chord)
        return np.where(size > 0.0, self.chord / np.where(size > 0.0, size, 1.0), 1.0)

    def rows(self, rows: Row) -> Segments:
        """Return some of the segments."""
        return Segments(self.begin[rows], self.end[rows], self.sweep[rows])

    def at(self, share: np.ndarray | float) -> np.ndarray:
        """Return the point at a share of each segment's length, complex128[n].

        The chord to such a point is the whole chord, shortened and turned back.
        """
        whole = np.sin(self.sweep / 2.0)
        shortened = np.where(whole != 0.0, np.sin(share * self.sweep / 2.0) / np.where(whole, whole, 1.0), share)
        return self.begin + self.chord * shortened * np.exp(-0.5j * self.sweep * (1.0 - share))

    def direction(self, share: np.ndarray | float) -> np.ndarray:
        """Return the unit direction of travel at a share of each segment's length, complex128[n]."""
        return self.along * np.exp(1j * self.sweep * (share - 0.5))

    def divided(self, counts: np.ndarray) -> tuple[np.ndarray, Segments]:
        """Return each segment in equal parts, `counts` int64[n] of them, and which segment each part is of."""
        row = np.repeat(np.arange(len(counts)), counts)
        number = np.arange(len(row)) - np.repeat(np.cumsum(counts) - counts, counts)
        whole = self.rows(row)
        first, last = whole.at(number / counts[row]), whole.at((number + 1) / counts[row])
        first = np.where(number == 0, whole.begin, first)
        last = np.where(number + 1 == counts[row], whole.end, last)
        return row, Segments(first, last, whole.sweep / counts[row])

    def boxes_mm(self) -> np.ndarray:
        """Return the box round each segment, float64[n, 4]: least x, least y, greatest x, greatest y."""
        places = [self.begin, self.end]
        for quarter in range(4):  # the point where the outward normal looks along an axis, when the arc has one
            share = self._share_of_direction(np.exp(0.5j * math.pi * quarter))
            places.append(np.where(share <= 1.0, self.at(np.minimum(share, 1.0)), self.begin))
        x, y = np.real(places), np.imag(places)
        return np.column_stack([x.min(axis=0), y.min(axis=0), x.max(axis=0), y.max(axis=0)])

    def _share_of_direction(self, direction: complex | np.ndarray) -> np.ndarray:
        """Return at which share each arc travels along a direction; above 1 where it never does, as no line does."""
        turn = np.angle(direction * np.conj(self.direction(0.0))) * np.sign(self.sweep)
        turn = np.where(turn < 0.0, turn + 2.0 * math.pi, turn)
        return turn / np.where(self.sweep != 0.0, np.abs(self.sweep), 1e-300)

    def monotone(self) -> tuple[np.ndarray, Segments]:
        """Return the segments cut where they run level (least and greatest y), and which segment each part is of."""
        first = self._share_of_direction(1.0 + 0j)
        second = self._share_of_direction(-1.0 + 0j)
        cuts = np.sort(np.minimum(np.column_stack([first, second]), 1.0), axis=1)
        bounds = np.column_stack([np.zeros(len(cuts)), cuts, np.ones(len(cuts))])
        row, part = np.nonzero(np.diff(bounds, axis=1) > 0.0)
        whole, begin, end = self.rows(row), bounds[row, part], bounds[row, part + 1]
        first_place = np.where(begin == 0.0, whole.begin, whole.at(begin))
        last_place = np.where(end == 1.0, whole.end, whole.at(end))
        return row, Segments(first_place, last_place, whole.sweep * (end - begin))


def segments_of(xy: np.ndarray, bulge: np.ndarray) -> Segments:
    """Return the columns of a chain: vertices float64[n + 1, 2] and bulges float64[n]."""
    vertices = complex_of(xy)
    return Segments(vertices[:-1], vertices[1:], 4.0 * np.arctan(bulge))


def complex_of(xy: np.ndarray) -> np.ndarray:
    """Return points, float64[..., 2], as complex numbers."""
    return xy[..., 0] + 1j * xy[..., 1]


def xy_of(places: np.ndarray) -> np.ndarray:
    """Return complex numbers as points, float64[..., 2]."""
    return np.stack([places.real, places.imag], axis=-1)


LIMIT_MM = 1e6  # coordinates beyond a kilometre are mistakes
STRAIGHT_MM = 1e-7  # an arc that rises less above its chord is kept as a line: its centre would be noise
FLAT_RAD = 1e-3  # below, the area under an arc is sweep / 12 of its chord's square to eight digits


@dataclass(frozen=True, eq=False)
class Columns:
    """Vertices and bulges of a chain, checked, with their measures; see curve.py for the columns.

    What others are computed from is kept: nothing changes a curve.
    """

    xy: np.ndarray
    bulge: np.ndarray

    def __post_init__(self) -> None:
        xy, bulge = pairs_of(self.xy), numbers_of(self.bulge).reshape(-1)
        if len(xy) < 2 or len(bulge) != len(xy) - 1:
            raise GeometryError(
                "curve-short",
                "a curve needs at least two points and a bulge for each segment",
                value=Text("{xy} points, {bulge} bulges", xy=len(xy), bulge=len(bulge)),
                advice="give two points or more, and one bulge fewer",
            )
        require_lengths(xy)
        rise_mm = np.abs(bulge) * np.hypot(*np.diff(xy, axis=0).T) / 2.0
        if not (np.isfinite(bulge).all() and rise_mm.max() <= LIMIT_MM):
            raise GeometryError(
                "curve-range",
                "a bulge is not that of an arc in mm",
                limit=Text("{limit_mm:g} mm high", limit_mm=LIMIT_MM),
                advice="draw a flatter arc",
            )
        object.__setattr__(self, "xy", xy)
        object.__setattr__(self, "bulge", np.where(rise_mm > STRAIGHT_MM, bulge, 0.0))

    def __len__(self) -> int:
        return len(self.bulge)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Columns):
            return NotImplemented
        return np.array_equal(self.xy, other.xy) and np.array_equal(self.bulge, other.bulge)

    __hash__ = None  # type: ignore[assignment]

    @cached_property
    def closed(self) -> bool:
        """Whether the curve ends where it began."""
        return math.dist(self.xy[-1].tolist(), self.xy[0].tolist()) <= COINCIDENT_MM

    @cached_property
    def segments(self) -> Segments:
        """The columns as complex numbers: begin, end, sweep."""
        return segments_of(self.xy, self.bulge)

    @property
    def sweeps_rad(self) -> np.ndarray:
        """The angle through which each segment turns, float64[n], 0 for lines."""
        return 4.0 * np.arctan(self.bulge)

    @property
    def box_mm(self) -> tuple[float, float, float, float]:
        """The least x and y and the greatest x and y, arcs counted whole."""
        boxes = self.segments.boxes_mm()
        return (*map(float, boxes[:, :2].min(axis=0)), *map(float, boxes[:, 2:].max(axis=0)))  # type: ignore[return-value]

    @property
    def begin_directions(self) -> np.ndarray:
        """The unit direction in which each segment begins, float64[n, 2]; (1, 0) for one of no length."""
        return xy_of(self.segments.direction(0.0))

    @property
    def end_directions(self) -> np.ndarray:
        """The unit direction in which each segment ends, float64[n, 2]; (1, 0) for one of no length."""
        return xy_of(self.segments.direction(1.0))

    @cached_property
    def centres(self) -> np.ndarray:
        """The arc centres, float64[n, 2]; NaN for lines."""
        begin, end = self.xy[:-1], self.xy[1:]
        chord = end - begin
        left = np.column_stack([-chord[:, 1], chord[:, 0]])
        with np.errstate(divide="ignore", invalid="ignore"):
            factor = np.where(self.bulge != 0.0, (1.0 - self.bulge**2) / (4.0 * self.bulge), np.nan)
        return (begin + end) / 2.0 + left * factor[:, None]

    @property
    def curvatures(self) -> np.ndarray:
        """One over the radius of each segment, float64[n], 1/mm, positive when it turns left, 0 for lines."""
        return self.segments.curvature

    @property
    def radii_mm(self) -> np.ndarray:
        """The arc radii, float64[n]; NaN for lines."""
        curvatures = np.abs(self.curvatures)
        return 1.0 / np.where(self.bulge != 0.0, curvatures, np.nan)


def numbers_of(values: Any) -> np.ndarray:
    """Return values as a float64 array; raises GeometryError when they are no numbers."""
    try:
        return np.array(values, float, order="C")
    except (TypeError, ValueError, OverflowError) as error:
        raise GeometryError(
            "curve-numbers", Text("not the numbers of a curve: {error}", error=error), advice="give numbers only"
        ) from error


def pairs_of(values: Any) -> np.ndarray:
    """Return values as float64[n, 2]; raises GeometryError when they are not pairs."""
    xy = numbers_of(values)
    if xy.size and (xy.ndim != 2 or xy.shape[1] != 2):
        advice = "give each point an x and a y"
        raise GeometryError("curve-pairs", "points are not pairs of x and y", value=f"shape {xy.shape}", advice=advice)
    return xy.reshape(-1, 2)


def require_lengths(xy: np.ndarray) -> None:
    """Raise GeometryError for coordinates that are not finite, or too large for a length in mm."""
    if not (np.abs(xy) <= LIMIT_MM).all():
        raise GeometryError(
            "curve-range",
            "a coordinate is not a length in mm",
            value=f"{xy[~(np.abs(xy) <= LIMIT_MM)][0]:g} mm",
            limit=f"{LIMIT_MM:g} mm",
            advice="correct the value or its unit",
        )
