# SPDX-License-Identifier: LGPL-2.1-or-later
"""The two columns of a Curve, refused when they are no curve, and the measures of all its segments at once."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from CNCStepper.errors import GeometryError, Text
from CNCStepper.geometry.segments import Segments, segments_of, xy_of

LIMIT_MM = 1e6  # coordinates beyond a kilometre are mistakes
COINCIDENT_MM = 1e-9
STRAIGHT_MM = 1e-7  # an arc that rises less above its chord is kept as a line: its centre would be noise
FLAT_RAD = 1e-3  # below, the area under an arc is sweep / 12 of its chord's square to eight digits


@dataclass(frozen=True, eq=False)
class Columns:
    """Vertices and bulges of a chain, checked, with what is measured on them; see curve.py for the columns.

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
            )
        require_lengths(xy)
        rise_mm = np.abs(bulge) * np.hypot(*np.diff(xy, axis=0).T) / 2.0
        if not (np.isfinite(bulge).all() and rise_mm.max() <= LIMIT_MM):
            raise GeometryError(
                "curve-range",
                "a bulge is not that of an arc in mm",
                limit=Text("{limit_mm:g} mm high", limit_mm=LIMIT_MM),
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
        raise GeometryError("curve-numbers", Text("not the numbers of a curve: {error}", error=error)) from error


def pairs_of(values: Any) -> np.ndarray:
    """Return values as float64[n, 2]; raises GeometryError when they are not pairs."""
    xy = numbers_of(values)
    if xy.size and (xy.ndim != 2 or xy.shape[1] != 2):
        raise GeometryError("curve-pairs", "points are not pairs of x and y", value=f"shape {xy.shape}")
    return xy.reshape(-1, 2)


def require_lengths(xy: np.ndarray) -> None:
    """Raise GeometryError for coordinates that are not finite, or too large for a length in mm."""
    if not (np.abs(xy) <= LIMIT_MM).all():
        raise GeometryError(
            "curve-range",
            "a coordinate is not a length in mm",
            value=f"{xy[~(np.abs(xy) <= LIMIT_MM)][0]:g} mm",
            limit=f"{LIMIT_MM:g} mm",
        )
