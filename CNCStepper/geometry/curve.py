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

import numpy as np

from CNCStepper.errors import GeometryError

LIMIT_MM = 1e6  # coordinates beyond a kilometre are mistakes
COINCIDENT_MM = 1e-9


@dataclass(frozen=True, eq=False)
class Curve:
    """A chain of lines and arcs; see the module's text for the columns."""

    xy: np.ndarray
    bulge: np.ndarray

    def __post_init__(self) -> None:
        xy = np.asarray(self.xy, float).reshape(-1, 2)
        bulge = np.asarray(self.bulge, float).reshape(-1)
        if len(xy) < 2 or len(bulge) != len(xy) - 1:
            raise GeometryError("curve-short", "a curve needs at least two points", value=f"{len(xy)} points")
        if not (np.isfinite(xy).all() and np.isfinite(bulge).all() and np.abs(xy).max() <= LIMIT_MM):
            raise GeometryError("curve-range", "a coordinate is not a length in mm", limit=f"{LIMIT_MM:g} mm")
        object.__setattr__(self, "xy", xy)
        object.__setattr__(self, "bulge", bulge)

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
    def radii_mm(self) -> np.ndarray:
        """The arc radii, float64[n]; NaN for lines."""
        return np.hypot(*(self.xy[:-1] - self.centres).T)

    @property
    def area_mm2(self) -> float:
        """The signed area of a closed curve, positive when it runs counter-clockwise."""
        x, y = self.xy.T
        polygon = 0.5 * float(np.dot(x[:-1], y[1:]) - np.dot(x[1:], y[:-1]))
        sweeps, arcs = self.sweeps_rad, self.bulge != 0.0
        segments = 0.5 * self.radii_mm[arcs] ** 2 * (sweeps[arcs] - np.sin(sweeps[arcs]))
        return polygon + float(segments.sum())

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
        pieces = [self.xy[:1]]
        for i, sweep in enumerate(self.sweeps_rad):
            pieces.append(self._arc_points(i, sweep, tolerance_mm) if sweep else self.xy[i + 1 : i + 2])
        return np.vstack(pieces)

    def at_length(self, length_mm: float) -> tuple[np.ndarray, np.ndarray]:
        """Return the point and the unit direction at `length_mm` from the start (clamped to the curve)."""
        lengths = self.lengths_mm
        before = np.concatenate([[0.0], np.cumsum(lengths)])
        length_mm = min(max(length_mm, 0.0), before[-1])
        i = min(int(np.searchsorted(before, length_mm, side="right")) - 1, len(self) - 1)
        share = (length_mm - before[i]) / lengths[i] if lengths[i] else 0.0
        return self._at_share(i, share)

    def distances_mm(self, points: np.ndarray) -> np.ndarray:
        """Return the distance of each point, float64[m, 2], to the curve."""
        points = np.asarray(points, float).reshape(-1, 2)
        nearest = np.full(len(points), np.inf)
        for i in range(len(self)):
            nearest = np.minimum(nearest, self._segment_distances(i, points))
        return nearest

    def _segment_distances(self, i: int, points: np.ndarray) -> np.ndarray:
        begin, end = self.xy[i], self.xy[i + 1]
        ends = np.minimum(np.hypot(*(points - begin).T), np.hypot(*(points - end).T))
        if self.bulge[i] == 0.0:
            chord = end - begin
            square = float(chord @ chord)
            share = np.clip((points - begin) @ chord / square, 0.0, 1.0) if square else np.zeros(len(points))
            return np.hypot(*(points - begin - share[:, None] * chord).T)
        centre, radius, sweep = self.centres[i], self.radii_mm[i], self.sweeps_rad[i]
        angle = np.arctan2(*(points - centre).T[::-1]) - math.atan2(*(begin - centre)[::-1])
        inside = np.mod(angle * np.sign(sweep), 2.0 * math.pi) <= abs(sweep)
        return np.where(inside, np.abs(np.hypot(*(points - centre).T) - radius), ends)

    def _arc_points(self, i: int, sweep: float, tolerance_mm: float) -> np.ndarray:
        centre, radius = self.centres[i], self.radii_mm[i]
        step = 2.0 * math.acos(max(1.0 - tolerance_mm / radius, -1.0)) if tolerance_mm < 2 * radius else math.pi
        count = max(math.ceil(abs(sweep) / max(step, 1e-6)), 2)
        begin = math.atan2(*(self.xy[i] - centre)[::-1])
        angles = begin + sweep * np.arange(1, count + 1) / count
        points = centre + radius * np.column_stack([np.cos(angles), np.sin(angles)])
        points[-1] = self.xy[i + 1]
        return points

    def _at_share(self, i: int, share: float) -> tuple[np.ndarray, np.ndarray]:
        begin, chord = self.xy[i], self.xy[i + 1] - self.xy[i]
        if self.bulge[i] == 0.0:
            return begin + share * chord, chord / max(float(np.hypot(*chord)), COINCIDENT_MM)
        centre, sweep = self.centres[i], self.sweeps_rad[i]
        angle = sweep * share
        c, s = math.cos(angle), math.sin(angle)
        spoke = np.array([[c, -s], [s, c]]) @ (begin - centre)
        tangent = np.array([-spoke[1], spoke[0]]) * math.copysign(1.0, sweep)
        return centre + spoke, tangent / np.hypot(*tangent)


def from_points(points: Iterable[Iterable[float]], closed: bool = False) -> Curve:
    """Return the polyline through `points`, closed back to the first when asked; doubled points are dropped."""
    xy = np.array([tuple(point) for point in points], float).reshape(-1, 2)
    if not len(xy):
        raise GeometryError("curve-short", "a curve needs at least two points", value="0 points")
    keep = np.concatenate([[True], np.hypot(*np.diff(xy, axis=0).T) > COINCIDENT_MM])
    xy = xy[keep]
    if closed and np.hypot(*(xy[-1] - xy[0])) > COINCIDENT_MM:
        xy = np.vstack([xy, xy[:1]])
    return Curve(xy, np.zeros(len(xy) - 1))


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
