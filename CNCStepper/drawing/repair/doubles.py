# SPDX-License-Identifier: LGPL-2.1-or-later
"""Stretches of lines and arcs that are drawn twice, also partly, in either direction and in pieces.

    first    ----------------            a stretch of a later segment is a double where it runs along an earlier one:
    later          ----------------      the earlier one stays, of the later one what is beyond it
                   ^^^^^^^^^

Where two segments run along each other, an end of one lies on the other: a tree over the segments finds these pairs.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
import shapely

from CNCStepper.errors import GeometryError
from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.curve_columns import Segments, xy_of

QUARTER_RAD = np.pi / 2.0
LOOKED_AT = 5  # places of a stretch that are compared with the other segment
MOST_PAIRS = 5_000_000
MOST_CHORDS = 64  # of an arc, for the tree
SHORTEST = 4.0  # tolerances: what is shorter is the touch of two ends


@dataclass(frozen=True)
class Doubles:
    """The stretches of segments that are doubles.

    segments: those of all curves, arcs divided so that none turns by more than a quarter. curve: int64[n], the number
    of the curve of each. later: int64[k], the segment of each double. first, last: float64[k], its shares.
    """

    segments: Segments
    curve: np.ndarray
    later: np.ndarray
    first: np.ndarray
    last: np.ndarray

    def remaining(self) -> dict[int, list[Curve]]:
        """Return, for each curve with a double, what is left of it: runs of whole and shortened segments."""
        kept = self._kept_shares()
        touched = sorted({int(self.curve[segment]) for segment in kept})
        begins = np.searchsorted(self.curve, touched)
        ends = np.searchsorted(self.curve, touched, side="right")
        return {
            number: list(self._runs(range(begin, end), kept))
            for number, begin, end in zip(touched, begins.tolist(), ends.tolist(), strict=True)
        }

    def places(self) -> Iterator[tuple[tuple[float, float], float]]:
        """Yield the middle and the length of each stretch that is drawn twice; what goes on in one curve is one."""
        lengths_mm = self.segments.length_mm
        stretch: list[tuple[int, float, float]] = []
        for segment, shares in sorted(self._covered().items()):
            for first, last in shares:
                if stretch and not self._goes_on(stretch[-1], segment, first):
                    yield self._place(stretch, lengths_mm)
                    stretch = []
                stretch.append((segment, first, last))
        if stretch:
            yield self._place(stretch, lengths_mm)

    def _goes_on(self, before: tuple[int, float, float], segment: int, first: float) -> bool:
        same_curve = self.curve[before[0]] == self.curve[segment]
        return bool(same_curve and segment == before[0] + 1 and first == 0.0 and before[2] == 1.0)

    def _place(
        self, stretch: Sequence[tuple[int, float, float]], lengths_mm: np.ndarray
    ) -> tuple[tuple[float, float], float]:
        segment, first, last = stretch[len(stretch) // 2]
        middle = complex(self.segments.rows(segment).at((first + last) / 2.0))
        whole_mm = sum(float(lengths_mm[row]) * (last - first) for row, first, last in stretch)
        return (middle.real, middle.imag), whole_mm

    def _covered(self) -> dict[int, list[tuple[float, float]]]:
        """Return the shares of each segment that are doubles, ascending, none overlapping another."""
        found: dict[int, list[tuple[float, float]]] = {}
        order = np.lexsort((self.first, self.later))
        columns = (column[order].tolist() for column in (self.later, self.first, self.last))
        for segment, first, last in zip(*columns, strict=True):
            shares = found.setdefault(segment, [])
            if shares and first <= shares[-1][1]:
                shares[-1] = (shares[-1][0], max(shares[-1][1], last))
            else:
                shares.append((first, last))
        return found

    def _kept_shares(self) -> dict[int, list[tuple[float, float]]]:
        """Return the shares that stay of each segment with a double."""
        kept = {}
        for segment, covered in self._covered().items():
            bounds = [0.0, *(bound for shares in covered for bound in shares), 1.0]
            pairs = zip(bounds[::2], bounds[1::2], strict=True)
            kept[segment] = [(first, last) for first, last in pairs if last > first]
        return kept

    def _runs(self, segments: range, kept: dict[int, list[tuple[float, float]]]) -> Iterator[Curve]:
        """Yield what stays of one curve, segments that follow each other in one run."""
        run: list[tuple[int, float, float]] = []
        for segment in segments:
            for first, last in kept.get(segment, [(0.0, 1.0)]):
                if run and (first > 0.0 or run[-1][2] < 1.0 or run[-1][0] < segment - 1):
                    yield self._curve(run)
                    run = []
                run.append((segment, first, last))
        if run:
            yield self._curve(run)

    def _curve(self, run: Sequence[tuple[int, float, float]]) -> Curve:
        rows, first, last = (np.array(column) for column in zip(*run, strict=True))
        part = self.segments.rows(rows)
        begin = np.where(first > 0.0, part.at(first), part.begin)
        end = np.where(last < 1.0, part.at(last), part.end)
        xy = xy_of(np.append(begin, end[-1]))
        return Curve(xy, np.tan(part.sweep * (last - first) / 4.0))


def doubles_of(curves: Sequence[Curve], same_mm: float) -> Doubles:
    """Return the stretches of curves that run within `same_mm` along an earlier segment.

    Raises GeometryError where so many segments lie on each other that their pairs fill the memory.
    """
    segments, curve = _divided(curves)
    one, other = _touching(segments, same_mm) if len(curve) else (np.zeros(0, int), np.zeros(0, int))
    later, first, last = _along(segments, one, other, same_mm)
    return Doubles(segments, curve, later, first, last)


def _divided(curves: Sequence[Curve]) -> tuple[Segments, np.ndarray]:
    """Return the segments of all curves, arcs in parts of at most a quarter, and the number of each one's curve."""
    if not curves:
        return Segments(np.zeros(0, complex), np.zeros(0, complex), np.zeros(0)), np.zeros(0, int)
    columns = [np.concatenate(parts) for parts in zip(*(curve.segments for curve in curves), strict=True)]
    number = np.repeat(np.arange(len(curves)), [len(curve) for curve in curves])
    whole = Segments(*columns)
    counts = np.maximum(np.ceil(np.abs(whole.sweep) / QUARTER_RAD - 1e-9), 1.0).astype(int)
    row, parts = whole.divided(counts)
    return parts, number[row]


def _touching(segments: Segments, same_mm: float) -> tuple[np.ndarray, np.ndarray]:
    """Return pairs of segments, the earlier one first, of which an end of one lies on the other."""
    lines = _lines(segments, same_mm)
    ends = np.concatenate([segments.begin, segments.end])
    _require_apart(segments, same_mm)
    points = shapely.points(ends.real, ends.imag)
    at, on = shapely.STRtree(lines).query(points, predicate="dwithin", distance=2.0 * same_mm)
    if len(at) > MOST_PAIRS:
        raise _crowded(len(at))
    of = at % len(segments.begin)
    one, other = np.minimum(of, on), np.maximum(of, on)
    pairs = np.unique(np.column_stack([one, other])[one < other], axis=0)
    return pairs[:, 0], pairs[:, 1]


def _lines(segments: Segments, same_mm: float) -> np.ndarray:
    """Return the segments as lines of chords that leave arcs by less than `same_mm`, of shapely."""
    rise_mm = np.abs(segments.sweep) * segments.length_mm / 8.0
    counts = np.clip(np.ceil(np.sqrt(rise_mm / same_mm)), 1, MOST_CHORDS).astype(int)
    row, parts = segments.divided(counts)
    first = np.flatnonzero(np.diff(row, prepend=-1))
    places = np.insert(parts.end, first, parts.begin[first])
    number = np.repeat(np.arange(len(counts)), counts + 1)
    return np.asarray(shapely.linestrings(xy_of(places), indices=number))


def _require_apart(segments: Segments, same_mm: float) -> None:
    """Raise GeometryError where the middles of so many segments lie in one place that their pairs fill the memory."""
    middles = segments.at(0.5)
    cells = np.floor(middles.real / same_mm) + 1j * np.floor(middles.imag / same_mm)
    _, counts = np.unique(cells, return_counts=True)
    if float((counts.astype(float) ** 2).sum()) / 2.0 > MOST_PAIRS:
        raise _crowded(int(counts.max()))


def _crowded(count: int) -> GeometryError:
    what = "too many lines are on top of each other"
    advice = "correct the drawing's unit, or take out what is drawn many times"
    return GeometryError("doubles-crowded", what, value=f"{count}", limit=f"{MOST_PAIRS} pairs", advice=advice)


def _along(
    segments: Segments, one: np.ndarray, other: np.ndarray, same_mm: float
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return which later segments of the pairs run along the earlier one, and from which share to which."""
    earlier, later = segments.rows(one), segments.rows(other)
    lengths_mm = later.length_mm
    shares = np.column_stack([_shares(later, earlier.begin), _shares(later, earlier.end)])
    first, last = np.clip(shares.min(axis=1), 0.0, 1.0), np.clip(shares.max(axis=1), 0.0, 1.0)
    near = (last - first) * lengths_mm > SHORTEST * same_mm
    for share in np.linspace(0.0, 1.0, LOOKED_AT):
        place = later.at(first + share * (last - first))
        near &= _distances(earlier, place) <= same_mm
    reach = same_mm / np.maximum(lengths_mm, same_mm)  # what is left of it within the tolerance goes too
    first = np.where(first <= reach, 0.0, first)
    last = np.where(last >= 1.0 - reach, 1.0, last)
    return other[near], first[near], last[near]


def _shares(segments: Segments, places: np.ndarray) -> np.ndarray:
    """Return at which share of each segment's length the place nearest to a point of its line or circle lies."""
    local = (places - segments.begin) * np.conj(segments.direction(0.0))
    curvature, length_mm = segments.curvature, segments.length_mm
    bent = np.where(curvature != 0.0, curvature, 1.0)
    turn = np.arctan2(bent * local.real, 1.0 - bent * local.imag)
    way = np.where(curvature != 0.0, turn / bent, local.real)
    return way / np.where(length_mm > 0.0, length_mm, 1.0)


def _distances(segments: Segments, places: np.ndarray) -> np.ndarray:
    nearest = segments.at(np.clip(_shares(segments, places), 0.0, 1.0))
    return np.abs(nearest - places)
