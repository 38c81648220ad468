# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curve: a chain of lines and arcs in the plane, exact, in two columns.

    xy     float64[n + 1, 2]   the vertices, mm
    bulge  float64[n]          tan(sweep / 4) of the arc from vertex i to i + 1; 0 is a line,
                               positive runs counter-clockwise, 1 is a half circle

A curve is closed when its last vertex is its first. A full circle is two half circles.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

import numpy as np

from CNCStepper.errors import GeometryError

LIMIT_MM = 1e6  # coordinates beyond a kilometre are mistakes
COINCIDENT_MM = 1e-9
STRAIGHT_MM = 1e-7  # an arc that rises less above its chord is kept as a line: its centre would be noise
FLAT_RAD = 1e-3  # below, the area under an arc is sweep / 12 of its chord's square to eight digits
BLOCK = 1 << 18  # distances held at once


@dataclass(frozen=True, eq=False)
class Curve:
    """A chain of lines and arcs; see the module's text for the columns."""

    xy: np.ndarray
    bulge: np.ndarray

    def __post_init__(self) -> None:
        xy, bulge = _pairs(self.xy), _numbers(self.bulge).reshape(-1)
        if len(xy) < 2 or len(bulge) != len(xy) - 1:
            raise GeometryError(
                "curve-short",
                "a curve needs at least two points and a bulge for each segment",
                value=f"{len(xy)} points, {len(bulge)} bulges",
            )
        _require_lengths(xy)
        rise_mm = np.abs(bulge) * np.hypot(*np.diff(xy, axis=0).T) / 2.0
        if not (np.isfinite(bulge).all() and rise_mm.max() <= LIMIT_MM):
            raise GeometryError("curve-range", "a bulge is not that of an arc in mm", limit=f"{LIMIT_MM:g} mm high")
        object.__setattr__(self, "xy", xy)
        object.__setattr__(self, "bulge", np.where(rise_mm > STRAIGHT_MM, bulge, 0.0))

    def __len__(self) -> int:
        return len(self.bulge)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Curve):
            return NotImplemented
        return np.array_equal(self.xy, other.xy) and np.array_equal(self.bulge, other.bulge)

    __hash__ = None  # type: ignore[assignment]

    @property
    def closed(self) -> bool:
        """Whether the curve ends where it began."""
        return bool(np.hypot(*(self.xy[-1] - self.xy[0])) <= COINCIDENT_MM)

    @property
    def sweeps_rad(self) -> np.ndarray:
        """The angle through which each segment turns, float64[n], 0 for lines."""
        return 4.0 * np.arctan(self.bulge)

    @property
    def lengths_mm(self) -> np.ndarray:
        """The length of each segment, float64[n]."""
        chord = np.hypot(*np.diff(self.xy, axis=0).T)
        half = self.sweeps_rad / 2.0
        sine = np.sin(np.abs(half))
        return np.where(sine > 1e-12, chord * np.abs(half) / np.where(sine > 1e-12, sine, 1.0), chord)

    @property
    def length_mm(self) -> float:
        """The length of the whole curve."""
        return float(self.lengths_mm.sum())

    @property
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
        chord = np.hypot(*np.diff(self.xy, axis=0).T)
        return 2.0 * np.sin(self.sweeps_rad / 2.0) / np.where(chord > 0.0, chord, 1.0)

    @property
    def radii_mm(self) -> np.ndarray:
        """The arc radii, float64[n]; NaN for lines."""
        curvatures = np.abs(self.curvatures)
        return 1.0 / np.where(self.bulge != 0.0, curvatures, np.nan)

    @property
    def area_mm2(self) -> float:
        """The signed area of a closed curve, positive when it runs counter-clockwise."""
        x, y = self.xy.T
        polygon = 0.5 * float(np.dot(x[:-1], y[1:]) - np.dot(x[1:], y[:-1]))
        sweeps, square = self.sweeps_rad, (np.diff(self.xy, axis=0) ** 2).sum(axis=1)
        arcs = np.abs(sweeps) > FLAT_RAD
        rounded = np.where(arcs, sweeps, math.pi)
        segments = (rounded - np.sin(rounded)) / (8.0 * np.sin(rounded / 2.0) ** 2)
        return polygon + float(np.dot(square, np.where(arcs, segments, sweeps / 12.0)))

    def reversed(self) -> Curve:
        """Return the same curve run backwards."""
        return Curve(self.xy[::-1].copy(), -self.bulge[::-1])

    def moved(self, dx_mm: float, dy_mm: float) -> Curve:
        """Return the curve translated."""
        return Curve(self.xy + np.array([dx_mm, dy_mm]), self.bulge.copy())

    def rotated(self, angle_deg: float) -> Curve:
        """Return the curve turned counter-clockwise about the origin."""
        c, s = math.cos(math.radians(angle_deg)), math.sin(math.radians(angle_deg))
        return Curve(self.xy @ np.array([[c, s], [-s, c]]), self.bulge.copy())

    def scaled(self, factor: float) -> Curve:
        """Return the curve scaled about the origin; factor must be positive."""
        if not factor > 0:
            raise GeometryError("curve-scale", "a scale must be positive", value=f"{factor:g}")
        return Curve(self.xy * factor, self.bulge.copy())

    def mirrored_x(self) -> Curve:
        """Return the mirror image at the Y axis (x becomes -x), run in the same order of vertices."""
        return Curve(self.xy * (-1.0, 1.0), -self.bulge)

    def started_at(self, vertex: int) -> Curve:
        """Return a closed curve that starts and ends at another of its vertices."""
        if not self.closed:
            raise GeometryError("curve-open", "only a closed curve can start elsewhere")
        ring, bulge = np.roll(self.xy[:-1], -vertex, axis=0), np.roll(self.bulge, -vertex)
        return Curve(np.vstack([ring, ring[:1]]), bulge)

    def points(self, tolerance_mm: float) -> np.ndarray:
        """Return points on the curve, float64[m, 2], whose chords stay within `tolerance_mm` of it."""
        if not tolerance_mm > 0:
            raise GeometryError("curve-tolerance", "a tolerance must be above 0", value=f"{tolerance_mm:g} mm")
        counts = self._chords(tolerance_mm)
        last = np.cumsum(counts)
        segment = np.repeat(np.arange(len(self)), counts)
        share = (np.arange(1, last[-1] + 1) - (last - counts)[segment]) / counts[segment]
        points = _xy(self._at(segment, share))
        points[last - 1] = self.xy[1:]
        return np.vstack([self.xy[:1], points])

    def at_length(self, length_mm: float) -> tuple[np.ndarray, np.ndarray]:
        """Return the point and the unit direction at `length_mm` from the start (clamped to the curve)."""
        lengths = self.lengths_mm
        before = np.concatenate([[0.0], np.cumsum(lengths)])
        length_mm = min(max(length_mm, 0.0), before[-1])
        i = min(int(np.searchsorted(before, length_mm, side="right")) - 1, len(self) - 1)
        share = (length_mm - before[i]) / lengths[i] if lengths[i] else 0.0
        chord = np.diff(_complex(self.xy[i : i + 2]))[0]
        direction = chord / max(abs(chord), COINCIDENT_MM) * np.exp(1j * self.sweeps_rad[i] * (share - 0.5))
        return _xy(self._at(i, share)), _xy(direction)

    def distances_mm(self, points: np.ndarray) -> np.ndarray:
        """Return the distance of each point, float64[m, 2], to the curve."""
        places = _complex(_pairs(points))
        nearest = np.full(len(places), np.inf)
        width = max(BLOCK // max(len(places), 1), 1)
        for first in range(0, len(self), width):
            nearest = np.minimum(nearest, self._distances(places, first, first + width).min(axis=1))
        return nearest

    def _chords(self, tolerance_mm: float) -> np.ndarray:
        """Return into how many chords each segment is divided; sagitta = 2 radius sin²(step / 4)."""
        share = np.minimum(np.nan_to_num(tolerance_mm / (2.0 * self.radii_mm)), 1.0)
        steps = np.maximum(4.0 * np.arcsin(np.sqrt(share)), 1e-6)
        counts = np.maximum(np.ceil(np.abs(self.sweeps_rad) / steps), 2.0)
        return np.where(self.bulge != 0.0, counts, 1.0).astype(int)

    def _at(self, segment: np.ndarray | int, share: np.ndarray | float) -> np.ndarray:
        """Return the points at a share of the segments' sweeps, as complex numbers.

        The chord to such a point is the whole chord, shortened and turned back; no centre, however far, comes in.
        """
        begin, chord, sweep = _complex(self.xy)[segment], np.diff(_complex(self.xy))[segment], self.sweeps_rad[segment]
        whole = np.sin(sweep / 2.0)
        shortened = np.where(whole != 0.0, np.sin(share * sweep / 2.0) / np.where(whole != 0.0, whole, 1.0), share)
        return begin + chord * shortened * np.exp(-0.5j * sweep * (1.0 - share))

    def _distances(self, places: np.ndarray, first: int, last: int) -> np.ndarray:
        """Return the distances, float64[m, k], to the segments [first, last).

        `local` is a point seen from the segment's begin along its tangent: | |k local - i| - 1 | / k, with the
        curvature k, is its distance to the circle; written so that lines (k = 0) need no case of their own.
        """
        vertices, part = _complex(self.xy[first : last + 1]), slice(first, last)
        chord, sweep, curvature = np.diff(vertices), self.sweeps_rad[part], self.curvatures[part]
        tangent = chord / np.where(chord != 0.0, np.abs(chord), 1.0) + (chord == 0.0)
        turn = np.exp(0.5j * sweep)
        local = (places[:, None] - vertices[:-1]) * np.conj(tangent / turn)
        beyond = (places[:, None] - vertices[1:]) * np.conj(tangent * turn)
        ahead, behind = local.real >= 0.0, beyond.real <= 0.0
        beside = np.where(np.abs(sweep) <= math.pi, ahead & behind, ahead | behind)
        away = np.abs(curvature * np.abs(local) ** 2 - 2.0 * local.imag) / (np.abs(curvature * local - 1j) + 1.0)
        return np.where(beside, away, np.minimum(np.abs(local), np.abs(beyond)))


def from_points(points: Iterable[Iterable[float]], closed: bool = False) -> Curve:
    """Return the polyline through `points`, closed back to the first when asked; doubled points are dropped."""
    xy = _pairs([tuple(point) for point in points])
    _require_lengths(xy)
    keep = np.concatenate([[True], np.hypot(*np.diff(xy, axis=0).T) > COINCIDENT_MM])[: len(xy)]
    xy = xy[keep]
    if closed and len(xy) and np.hypot(*(xy[-1] - xy[0])) > COINCIDENT_MM:
        xy = np.vstack([xy, xy[:1]])
    return Curve(xy, np.zeros(max(len(xy) - 1, 0)))


def circle(centre: tuple[float, float], radius_mm: float) -> Curve:
    """Return a full circle, counter-clockwise from its +X point."""
    x, y = centre
    return Curve(np.array([(x + radius_mm, y), (x - radius_mm, y), (x + radius_mm, y)]), np.ones(2))


def joined(curves: Iterable[Curve]) -> Curve:
    """Return curves, each beginning where the one before ended, as one."""
    parts = list(curves)
    for before, after in itertools.pairwise(parts):
        gap_mm = float(np.hypot(*(after.xy[0] - before.xy[-1])))
        if gap_mm > 1e-6:
            raise GeometryError("curve-gap", "curves do not meet", value=f"{gap_mm:g} mm", limit="0.000001 mm")
    xy = np.vstack([parts[0].xy, *(part.xy[1:] for part in parts[1:])])
    return Curve(xy, np.concatenate([part.bulge for part in parts]))


def _numbers(values: Any) -> np.ndarray:
    try:
        return np.array(values, float)
    except (TypeError, ValueError, OverflowError) as error:
        raise GeometryError("curve-numbers", f"not the numbers of a curve: {error}") from error


def _pairs(values: Any) -> np.ndarray:
    """Return values as float64[n, 2]; raises GeometryError when they are not pairs."""
    xy = _numbers(values)
    if xy.size and (xy.ndim != 2 or xy.shape[1] != 2):
        raise GeometryError("curve-pairs", "points are not pairs of x and y", value=f"shape {xy.shape}")
    return xy.reshape(-1, 2)


def _require_lengths(xy: np.ndarray) -> None:
    if not (np.abs(xy) <= LIMIT_MM).all():
        raise GeometryError(
            "curve-range",
            "a coordinate is not a length in mm",
            value=f"{xy[~(np.abs(xy) <= LIMIT_MM)][0]:g} mm",
            limit=f"{LIMIT_MM:g} mm",
        )


def _complex(xy: np.ndarray) -> np.ndarray:
    return xy[..., 0] + 1j * xy[..., 1]


def _xy(places: np.ndarray) -> np.ndarray:
    return np.stack([places.real, places.imag], axis=-1)
