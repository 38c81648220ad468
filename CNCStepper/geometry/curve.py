# SPDX-License-Identifier: LGPL-2.1-or-later
r"""Curve: an open or closed chain of lines and arcs in the plane, exact, in two columns.

    xy     float64[n + 1, 2]   the vertices, mm
    bulge  float64[n]          tan(sweep / 4) of the arc from vertex i to i + 1; 0 is a line,
                               positive runs counter-clockwise, 1 is a half circle

            bulge[1] = 1
             . - - - .            closed       the last vertex is the first (within COINCIDENT_MM)
      xy[2] /         \ xy[1]     full circle  two half circles
           |           |          inside       left of a closed curve with area_mm2 > 0 (counter-clockwise)
           v           ^          place        a length from xy[0] along the curve; `part` and `started_at_length`
           |           |                       go on round a closed one, all else stops at its ends
      xy[3] ---- > ---- xy[0]     many         what takes a length or a point takes a column of them too

    measures    len · closed · length_mm · lengths_mm · before_mm · area_mm2 · box_mm · sweeps_rad · curvatures ·
                radii_mm · centres · begin_directions · end_directions · segments (all as columns of complex numbers)
    places      at_length(s) -> points, directions · points(tolerance) · nearest(points) -> distances, lengths ·
                distances_mm(points) · winding(points)
    pieces      reversed · started_at(vertex) · started_at_length(s) · part(s, t) · split(lengths) ·
                divided_at(lengths) · without_short
    transforms  moved · rotated · scaled · mirrored_x · transformed(2 x 3 matrix)
    makers      from_points · circle · straight · joined (pieces in order); chain_joining.py joins loose ones

Nothing changes a curve: each method returns a new one or plain arrays, and works on whole columns, so that
100 000 segments are no loop. Segments of no length are allowed and do no harm; without_short takes them out.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterable
from functools import cached_property
from typing import Any

import numpy as np

from CNCStepper.errors import GeometryError, Text
from CNCStepper.geometry.arc_length import area_of, measured, places_along, stretch, with_vertices
from CNCStepper.geometry.curve_columns import LIMIT_MM, Columns, pairs_of, require_lengths, xy_of
from CNCStepper.geometry.nearest_point import nearest, nearest_of
from CNCStepper.geometry.proximity_tree import spines_of
from CNCStepper.geometry.winding_number import windings
from CNCStepper.tolerances import COINCIDENT_MM, SAME_SCALE

__all__ = ["COINCIDENT_MM", "LIMIT_MM", "Curve", "circle", "from_points", "joined", "straight"]

Point = tuple[float, float]


class Curve(Columns):
    """A chain of lines and arcs; see the module's text."""

    @classmethod
    def trusted(cls, xy: np.ndarray, bulge: np.ndarray) -> Curve:
        """Return the curve of columns that are those of a curve for certain, as they are."""
        made = cls.__new__(cls)
        made.__dict__.update(xy=xy, bulge=bulge)
        return made

    @property
    def rows(self) -> np.ndarray:
        """The segments as kernels take them; see box_tree.py."""
        return self._measured[0]

    @property
    def before_mm(self) -> np.ndarray:
        """The length from the start to each vertex, float64[n + 1]."""
        return self._measured[1]

    @cached_property
    def _measured(self) -> tuple[np.ndarray, np.ndarray]:
        return measured(self.xy, self.bulge)  # type: ignore[no-any-return]

    @property
    def lengths_mm(self) -> np.ndarray:
        """The length of each segment, float64[n]."""
        return self.rows[:, 10]

    @cached_property
    def length_mm(self) -> float:
        """The length of the whole curve."""
        return float(self.before_mm[-1])

    @cached_property
    def area_mm2(self) -> float:
        """The signed area of a closed curve, positive when it runs counter-clockwise."""
        return float(area_of(self.xy, self.bulge))

    def reversed(self) -> Curve:
        """Return the same curve run backwards."""
        return Curve.trusted(self.xy[::-1].copy(), -self.bulge[::-1])

    def moved(self, dx_mm: float, dy_mm: float) -> Curve:
        """Return the curve translated."""
        if dx_mm == dy_mm == 0.0:
            return self
        return Curve(self.xy + np.array([dx_mm, dy_mm]), self.bulge.copy())

    def rotated(self, angle_deg: float) -> Curve:
        """Return the curve turned counter-clockwise about the origin."""
        c, s = math.cos(math.radians(angle_deg)), math.sin(math.radians(angle_deg))
        return Curve(self.xy @ np.array([[c, s], [-s, c]]), self.bulge.copy())

    def scaled(self, factor: float) -> Curve:
        """Return the curve scaled about the origin; factor must be positive."""
        if not factor > 0:
            advice = "give a factor above 0"
            raise GeometryError("curve-scale", "a scale must be positive", value=f"{factor:g}", advice=advice)
        return Curve(self.xy * factor, self.bulge.copy())

    def mirrored_x(self) -> Curve:
        """Return the mirror image at the Y axis (x becomes -x), run in the same order of vertices."""
        return Curve(self.xy * (-1.0, 1.0), -self.bulge)

    def transformed(self, matrix: np.ndarray) -> Curve:
        """Return the curve with each point p at matrix[:, :2] @ p + matrix[:, 2]; a mirror image turns arcs round.

        Raises GeometryError for a matrix that would collapse the curve, or make other curves of its arcs.
        """
        linear = np.asarray(matrix, float)[:2, :2]
        sizes, turns = np.linalg.svd(linear, compute_uv=False), float(np.linalg.det(linear))
        if not sizes[1] > 0.0:
            what, advice = "a transform must not collapse the curve", "give each axis a scale other than 0"
            raise GeometryError("curve-scale", what, value=f"scale {sizes[1]:g}", advice=advice)
        if self.bulge.any() and sizes[0] - sizes[1] > SAME_SCALE * sizes[0]:
            raise GeometryError(
                "curve-uneven",
                "an arc scaled unevenly is no arc",
                value=f"{sizes[0]:g} by {sizes[1]:g}",
                advice="fit the scaled curve anew",
            )
        return Curve(self.xy @ linear.T + np.asarray(matrix, float)[:2, 2], self.bulge * math.copysign(1.0, turns))

    def started_at(self, vertex: int) -> Curve:
        """Return a closed curve that starts and ends at another of its vertices."""
        self._require_closed()
        xy, bulge = self.xy, self.bulge
        vertex %= len(bulge)
        ring = np.concatenate([xy[vertex:-1], xy[: vertex + 1]])
        return Curve.trusted(ring, np.concatenate([bulge[vertex:], bulge[:vertex]]))

    def started_at_length(self, length_mm: float) -> Curve:
        """Return a closed curve that starts and ends `length_mm` from its start; a segment may be cut in two."""
        self._require_closed()
        begin_mm = length_mm % self.length_mm
        return self._stretch(begin_mm, begin_mm + self.length_mm)

    def part(self, first_mm: float, last_mm: float) -> Curve:
        """Return the part between two places; on a closed curve it passes the start when last <= first.

        Raises GeometryError when the stretch has no length.
        """
        whole_mm = self.length_mm
        if self.closed:
            begin_mm, long_mm = first_mm % whole_mm, (last_mm - first_mm) % whole_mm
            return self._stretch(begin_mm, begin_mm + (long_mm if long_mm > COINCIDENT_MM else whole_mm))
        begin_mm, end_mm = max(first_mm, 0.0), min(last_mm, whole_mm)
        if end_mm - begin_mm <= COINCIDENT_MM:
            raise GeometryError(
                "curve-part",
                "a part must have a length",
                value=Text("{first_mm:g} to {last_mm:g} mm", first_mm=first_mm, last_mm=last_mm),
                advice="let it end after its begin",
            )
        return self._stretch(begin_mm, end_mm)

    def split(self, lengths_mm: Iterable[float]) -> list[Curve]:
        """Return the pieces between the start, the places named (in any order), and the end, in order.

        A closed curve too begins its first piece and ends its last one at its start. Places that fall on an end or
        on each other make no piece of no length.
        """
        cut, vertices = self._cut(np.sort(np.fromiter(lengths_mm, float)))
        before_mm = cut.before_mm
        place_mm = before_mm[vertices]
        apart = (np.diff(place_mm, prepend=0.0) > COINCIDENT_MM) & (place_mm < before_mm[-1] - COINCIDENT_MM)
        bounds = [0, *vertices[apart].tolist(), len(cut)]
        return [cut._vertices(first, last) for first, last in itertools.pairwise(bounds)]

    def divided_at(self, lengths_mm: np.ndarray) -> Curve:
        """Return the same curve with a vertex at each place, float64[k], a length from the start, in any order."""
        return self._cut(np.sort(lengths_mm))[0]

    def without_short(self, shortest_mm: float = COINCIDENT_MM) -> Curve:
        """Return the curve without segments up to `shortest_mm` long; its neighbours meet where they ended.

        Raises GeometryError when nothing longer is left.
        """
        keep = np.flatnonzero(self.lengths_mm > shortest_mm)
        if not len(keep):
            advice = "draw it larger, or leave it out"
            raise GeometryError("curve-short", "the curve has no length", value=f"{self.length_mm:g} mm", advice=advice)
        xy = np.vstack([self.xy[keep], self.xy[-1:]])
        return Curve(xy, self.bulge[keep])

    def points(self, tolerance_mm: float) -> np.ndarray:
        """Return points on the curve, float64[m, 2], whose chords stay within `tolerance_mm` of it."""
        if not tolerance_mm > 0:
            what, advice = "a tolerance must be above 0", "give a tolerance above 0"
            raise GeometryError("curve-tolerance", what, value=f"{tolerance_mm:g} mm", advice=advice)
        _, parts = self.segments.divided(self._chords(tolerance_mm))
        return np.vstack([self.xy[:1], xy_of(parts.end)])

    def at_length(self, length_mm: Any) -> tuple[np.ndarray, np.ndarray]:
        """Return point and unit direction at a length from the start, or at a column of them: float64[2] or [k, 2].

        A length beyond an end counts as that end.
        """
        lengths_mm = np.asarray(length_mm, float)
        places, directions = places_along(self.rows, self.before_mm, lengths_mm.reshape(-1))
        return (places, directions) if lengths_mm.ndim else (places[0], directions[0])

    def nearest(self, points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return how far each point, float64[m, 2], is from the curve, and at which length the nearest place lies."""
        away_mm, row, on_mm = nearest(self.rows, self._spines, pairs_of(points))
        return away_mm, self.before_mm[row] + on_mm

    def nearest_of(self, points: np.ndarray, limit_mm: float) -> tuple[int, float, float]:
        """Return which point, float64[m, 2], is nearest, how far, and the length there; -1 for none within a limit."""
        which, away_mm, row, on_mm = nearest_of(self.rows, self._spines, points, limit_mm)
        return which, away_mm, float(self.before_mm[row]) + on_mm

    def distances_mm(self, points: np.ndarray) -> np.ndarray:
        """Return the distance of each point, float64[m, 2], to the curve."""
        return self.nearest(points)[0]

    def winding(self, points: np.ndarray) -> np.ndarray:
        """Return how often a closed curve runs round each point, int64[m], counter-clockwise positive, 0 outside."""
        self._require_closed()
        return windings(self.rows, pairs_of(points))  # type: ignore[no-any-return]

    @cached_property
    def _spines(self) -> np.ndarray:
        return spines_of(self.rows)  # type: ignore[no-any-return]

    def _require_closed(self) -> None:
        if not self.closed:
            raise GeometryError("curve-open", "the curve is open, a closed one is needed", advice="close it")

    def _vertices(self, first: int, last: int) -> Curve:
        return Curve.trusted(self.xy[first : last + 1], self.bulge[first:last])

    def _stretch(self, first_mm: float, last_mm: float) -> Curve:
        return Curve.trusted(*stretch(self.xy, self.bulge, self.rows, self.before_mm, first_mm, last_mm))

    def _cut(self, places_mm: np.ndarray) -> tuple[Curve, np.ndarray]:
        """Return the curve with a vertex at each ascending place, and the numbers of these vertices."""
        xy, bulge, vertices = with_vertices(self.xy, self.bulge, self.rows, self.before_mm, places_mm)
        return Curve.trusted(xy, bulge), vertices

    def _chords(self, tolerance_mm: float) -> np.ndarray:
        """Return into how many chords each segment is divided; sagitta = 2 radius sin²(step / 4)."""
        share = np.minimum(np.nan_to_num(tolerance_mm / (2.0 * self.radii_mm)), 1.0)
        steps = np.maximum(4.0 * np.arcsin(np.sqrt(share)), 1e-6)
        counts = np.maximum(np.ceil(np.abs(self.sweeps_rad) / steps), 2.0)
        return np.where(self.bulge != 0.0, counts, 1.0).astype(int)


def from_points(points: Iterable[Iterable[float]], closed: bool = False) -> Curve:
    """Return the polyline through `points`, closed back to the first when asked; doubled points are dropped."""
    xy = pairs_of([tuple(point) for point in points])
    require_lengths(xy)
    keep = np.concatenate([[True], np.hypot(*np.diff(xy, axis=0).T) > COINCIDENT_MM])[: len(xy)]
    xy = xy[keep]
    if closed and len(xy) and np.hypot(*(xy[-1] - xy[0])) > COINCIDENT_MM:
        xy = np.vstack([xy, xy[:1]])
    return Curve(xy, np.zeros(max(len(xy) - 1, 0)))


def circle(centre: tuple[float, float], radius_mm: float) -> Curve:
    """Return a full circle, counter-clockwise from its +X point."""
    x, y = centre
    return Curve(np.array([(x + radius_mm, y), (x - radius_mm, y), (x + radius_mm, y)]), np.ones(2))


def straight(begin: Point, end: Point) -> Curve:
    """Return the straight way from one place to another."""
    return Curve.trusted(np.array([begin, end]), np.zeros(1))


def joined(curves: Iterable[Curve]) -> Curve:
    """Return curves, each beginning where the one before ended, as one."""
    parts = list(curves)
    for before, after in itertools.pairwise(parts):
        gap_mm = math.dist(after.xy[0].tolist(), before.xy[-1].tolist())
        if gap_mm > 1e-6:
            what, advice = "curves do not meet", "let each begin where the one before ends"
            raise GeometryError("curve-gap", what, value=f"{gap_mm:g} mm", limit="0.000001 mm", advice=advice)
    xy = np.concatenate([parts[0].xy, *(part.xy[1:] for part in parts[1:])])
    return Curve.trusted(xy, np.concatenate([part.bulge for part in parts]))
