# SPDX-License-Identifier: LGPL-2.1-or-later
"""An arc put onto the grid of a text so that every controller runs it as it was meant.

A controller computes the circle from the rounded start point and I, J, and refuses an arc whose rounded end
point does not lie on it (grbl: error:33); an arc whose ends round to one point it runs as a whole circle.

    begin (rounded, where the machine is) --I J--> centre     of the centres near the true one, that is taken
    end   (rounded)                                           whose circle passes best through end and middle

All points are in counts of the text's last digit (`block_emitter.py`), in the plane of the arc.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from math import acos, ceil, cos, hypot, pi, sin

from CNCStepper.gcode.dialects import ArcRule
from CNCStepper.gcode.interpreter.motion.arcs import FULL_TURN, Flat, sweep
from CNCStepper.tolerances import SAME_COUNT

Count = tuple[int, int]
NEIGHBOURS = sorted(((i, j) for i in range(-2, 3) for j in range(-2, 3)), key=lambda ij: (hypot(*ij), ij))
WORTHWHILE = 0.05  # counts by which a centre farther from the true one must be better
MOST_SPLITS = 4
MOST_KEPT = 8192  # arcs whose pieces are remembered


@dataclass(frozen=True)
class TrueArc:
    """The arc as it is meant; sweep_rad in (0, 2 pi]."""

    begin: Flat
    end: Flat
    centre: Flat
    clockwise: bool

    @property
    def radius(self) -> float:
        """The mean of the radii at both ends."""
        return (hypot(*_minus(self.begin, self.centre)) + hypot(*_minus(self.end, self.centre))) / 2

    @property
    def sweep_rad(self) -> float:
        """The angle swept, a whole turn where the ends are one point."""
        if hypot(*_minus(self.end, self.begin)) < SAME_COUNT:
            return FULL_TURN
        return sweep(self.begin, self.end, self.centre, self.clockwise)

    @property
    def rise(self) -> float:
        """By how much the arc leaves its chord."""
        return self.radius * (1 - cos(self.sweep_rad / 2))

    def at(self, share: float) -> Flat:
        """Return the point after `share` of the sweep; where the radii at the ends differ, on the spiral between."""
        angle = self.sweep_rad * share * (-1 if self.clockwise else 1)
        x, y = _minus(self.begin, self.centre)
        at_begin, at_end = hypot(x, y), hypot(*_minus(self.end, self.centre))
        scale = 1 + share * (at_end - at_begin) / at_begin if at_begin else 1.0
        return (
            self.centre[0] + scale * (x * cos(angle) - y * sin(angle)),
            self.centre[1] + scale * (x * sin(angle) + y * cos(angle)),
        )


@dataclass(frozen=True)
class Piece:
    """One line of text: a straight move to `end`, or an arc with its centre at begin + offset.

    share: how much of the true arc is done at its end, for the height of a helix.
    """

    end: Count
    share: float
    offset: Count | None = None


@dataclass(frozen=True)
class Limits:
    """The rule of the controller in counts, the flatness under which a line will do, and the largest radius."""

    rule: ArcRule
    flat: float
    largest_radius: float


@lru_cache(MOST_KEPT)  # every level of a pocket has the same arcs, and so has its next edit
def rounded(begin: Count, arc: TrueArc, limits: Limits) -> tuple[Piece, ...]:
    """Return the pieces of `arc` from the rounded `begin`; empty where nothing is left of it."""
    if arc.radius > limits.largest_radius:
        return tuple(_chords(begin, arc, limits.flat))
    return tuple(_pieces(begin, arc, limits, MOST_SPLITS))


def _pieces(begin: Count, arc: TrueArc, limits: Limits, splits: int) -> list[Piece]:
    end = (round(arc.end[0]), round(arc.end[1]))
    is_long = arc.sweep_rad > pi
    if not is_long and (end == begin or arc.rise < limits.flat):
        return [Piece(end, 1.0)] if end != begin else []
    offset = _offset(begin, end, arc)
    if offset is not None and _is_right(begin, end, offset, arc, limits.rule):
        written = TrueArc(begin, end, (begin[0] + offset[0], begin[1] + offset[1]), arc.clockwise)
        flat = end != begin and written.rise < limits.flat
        return [Piece(end, 1.0, None if flat else offset)]
    if splits:
        return _halves(begin, arc, limits, splits - 1)
    return list(_chords(begin, arc, limits.flat))


def _halves(begin: Count, arc: TrueArc, limits: Limits, splits: int) -> list[Piece]:
    """Return the arc as two, each with rounded ends of its own."""
    middle = arc.at(0.5)
    first = _pieces(begin, TrueArc(arc.begin, middle, arc.centre, arc.clockwise), limits, splits)
    at = first[-1].end if first else begin
    second = _pieces(at, TrueArc(middle, arc.end, arc.centre, arc.clockwise), limits, splits)
    return [
        *(Piece(piece.end, piece.share / 2, piece.offset) for piece in first),
        *(Piece(piece.end, 0.5 + piece.share / 2, piece.offset) for piece in second),
    ]


def _offset(begin: Count, end: Count, arc: TrueArc) -> Count | None:
    """Return I, J: the true centre where it lies on the grid, else the neighbour with the best circle."""
    wanted = _minus(arc.centre, begin)
    nearest = (round(wanted[0]), round(wanted[1]))
    if hypot(*_minus(wanted, nearest)) < SAME_COUNT and _difference(nearest, begin, end) < 2:
        return nearest if any(nearest) else None
    middle = arc.at(0.5)
    best, least = None, float("inf")
    for i, j in NEIGHBOURS:
        offset = (nearest[0] + i, nearest[1] + j)
        if not any(offset):
            continue
        centre = (begin[0] + offset[0], begin[1] + offset[1])
        missed = abs(hypot(*_minus(middle, centre)) - hypot(*offset))
        score = _difference(offset, begin, end) + missed
        if score < least - WORTHWHILE:
            best, least = offset, score
    return best


def _is_right(begin: Count, end: Count, offset: Count, arc: TrueArc, rule: ArcRule) -> bool:
    """Whether a controller accepts the arc and sweeps it as it was meant."""
    radius = hypot(*offset)
    difference = _difference(offset, begin, end)
    allowed = max(rule.slack, min(rule.gap, rule.relative * radius))
    if difference > 0.9 * allowed or radius - difference <= rule.smallest_radius:
        return False
    centre = (begin[0] + offset[0], begin[1] + offset[1])
    swept = sweep(begin, end, centre, arc.clockwise)
    if begin != end and min(swept, FULL_TURN - swept) < 2 * rule.smallest_angle_rad:
        return False
    return abs(swept - arc.sweep_rad) < pi / 2


def _difference(offset: Count, begin: Count, end: Count) -> float:
    """Return by how much the radii at both ends differ."""
    return abs(hypot(*offset) - hypot(end[0] - begin[0] - offset[0], end[1] - begin[1] - offset[1]))


def _chords(begin: Count, arc: TrueArc, flat: float) -> Iterator[Piece]:
    """Yield straight lines that stay within `flat` of the arc."""
    steps = max(1, ceil(arc.sweep_rad / (2 * acos(max(-1.0, 1 - flat / arc.radius)))))
    at = begin
    for step in range(1, steps + 1):
        point = arc.at(step / steps) if step < steps else arc.end
        end = (round(point[0]), round(point[1]))
        if end != at or step == steps:
            yield Piece(end, step / steps)
        at = end


def _minus(a: Flat | Count, b: Flat | Count) -> Flat:
    return a[0] - b[0], a[1] - b[1]
