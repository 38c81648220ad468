# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two tool paths laid over each other: what only the first has, what only the second has, and what both have.

Both paths are taken as chords and divided into pieces of at most a thousandth of their size. A piece belongs to both
when its begin, middle and end lie within the tolerance of the other path, cuts on cuts and rapids on rapids, wherever
in the program that is. How a program writes a path (units, comments, modal words, arcs or chords, one line or several)
is no difference.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from CNCStepper.cancellation import checkpoint
from CNCStepper.simulation.comparison.first_difference import Course, Parting, first_differences
from CNCStepper.simulation.comparison.segment_tree import SegmentTree
from CNCStepper.simulation.tip_segments import Segments, parted, segments
from CNCStepper.state import State
from CNCStepper.tolerances import NO_LENGTH_MM, SAME_PATH_MM
from CNCStepper.toolpath import RAPID, Toolpath, distinct, require_straight_axes

CHORD_SHARE = 0.25  # of the tolerance: how far our own chords may leave an arc
PIECES = 1000  # of the size of both paths: a piece is no longer
MOST_PIECES = 1_000_000  # of a path's whole length
PARTED = 0.1  # of the work is done when it is known where the paths part
BLOCK = 100_000  # pieces that are judged between two looks whether the work is still wanted

Share = Callable[[float], None]


@dataclass(frozen=True)
class Deviation:
    """The place of a path that is farthest from the other one. first: whether it is of the first. line: of its text."""

    distance_mm: float
    place_mm: tuple[float, float, float]
    first: bool
    line: int


@dataclass(frozen=True)
class Judged:
    """The pieces of one path. cuts: bool[n]. away_mm: float64[n], from the other path, infinite where that has no such
    moves. places_mm: float64[n, 3]. common: bool[n]."""

    pieces: Segments
    cuts: np.ndarray
    away_mm: np.ndarray
    places_mm: np.ndarray
    common: np.ndarray

    def chosen(self, cuts: bool, common: bool) -> Segments:
        """Return the cuts, or the rapids, that are common or are not."""
        return self.pieces[(self.cuts == cuts) & (self.common == common)]

    def length_mm(self, cuts: bool, common: bool) -> float:
        """Return the length of those."""
        return float(self.chosen(cuts, common).length_mm.sum())


@dataclass(frozen=True)
class PathComparison:
    """Both paths. parting: rows of both tables. deviation: the largest of the cuts that only one has, None for none."""

    first: Judged
    second: Judged
    parting: Parting
    deviation: Deviation | None

    @property
    def same_places(self) -> bool:
        """Whether no path has anything alone."""
        return bool(self.first.common.all() and self.second.common.all())

    @property
    def same(self) -> bool:
        """Whether both go the same way in the same order, at the same feeds with the same tools and speeds."""
        return self.same_places and self.parting == Parting(None, None, None)


def compare_paths(
    first: Toolpath, second: Toolpath, same_mm: float = SAME_PATH_MM, share: Share = lambda share: None
) -> PathComparison:
    """Return what two tool paths have alone and in common; raises ProgramError for axes other than X, Y and Z.

    share: called with the share that is done, from 0 to 1.
    """
    paths = require_straight_axes(first), require_straight_axes(second)
    modes: dict[tuple, int] = {}
    one, other = (_course(path, same_mm, modes) for path in paths)
    parting = first_differences(one, other, same_mm)
    share(PARTED)
    longest_mm, half = _longest_mm([one, other]), (1.0 - PARTED) / 2.0
    judged = (
        _judged(one, other, same_mm, longest_mm, lambda done: share(PARTED + half * done)),
        _judged(other, one, same_mm, longest_mm, lambda done: share(PARTED + half + half * done)),
    )
    share(1.0)
    return PathComparison(*judged, parting, _deviation(judged, paths))


def _course(path: Toolpath, same_mm: float, modes: dict[tuple, int]) -> Course:
    """Return a path to follow, without moves of no length or from unknown places."""
    pieces = segments(path, CHORD_SHARE * same_mm)
    pieces = pieces.known_in(_known_axes(pieces))
    pieces = pieces[pieces.length_mm > NO_LENGTH_MM]
    table = path.table()
    mode = np.zeros(len(path.states), np.int64)
    for state in distinct(table.state).tolist():
        mode[state] = modes.setdefault(_mode(path.states[state]), len(modes))
    row = pieces.row
    return Course(pieces, table.kind[row] != RAPID, table.feed[row], mode[table.state[row]])


def _known_axes(pieces: Segments) -> tuple[int, ...]:
    """Return the axes that are known somewhere: a table without Z, or a lathe without Y, never knows the other."""
    return tuple(axis for axis in range(3) if np.isfinite(pieces.end[:, axis]).any())


def _mode(state: State) -> tuple:
    """Return what is on while a row is run, the same for states that cut alike."""
    turns = state.spindle_turns
    return state.tool, turns and state.spindle, turns and state.spindle_rpm, state.mist, state.flood


def _longest_mm(courses: list[Course]) -> float:
    """Return how long a piece of both paths may be."""
    ends = np.vstack([each for course in courses for each in (course.segments.begin, course.segments.end)])
    if not len(ends):
        return 1.0
    size_mm = float(np.linalg.norm(ends.max(axis=0) - ends.min(axis=0)))
    whole_mm = max(float(course.segments.length_mm.sum()) for course in courses)
    return max(size_mm / PIECES, whole_mm / MOST_PIECES, NO_LENGTH_MM)


def _judged(own: Course, other: Course, same_mm: float, longest_mm: float, share: Share) -> Judged:
    """Return the pieces of a path with their distances from the other one."""
    whole = own.segments
    counts = np.maximum(np.ceil(whole.length_mm / longest_mm), 1).astype(np.int64)
    pieces, cuts = parted(whole, counts), np.repeat(own.cuts, counts)
    away_mm, places_mm = np.full(len(pieces), np.inf), pieces.begin.copy()
    done = 0
    for kind in (True, False):
        there = other.segments[other.cuts == kind]
        if not len(there):
            continue
        tree = SegmentTree(there)
        for block in _blocks(np.flatnonzero(cuts == kind)):
            away_mm[block], places_mm[block] = tree.distances(pieces[block], same_mm)
            done += len(block)
            share(done / len(pieces))
    return Judged(pieces, cuts, away_mm, places_mm, away_mm <= same_mm)


def _blocks(which: np.ndarray) -> Iterator[np.ndarray]:
    for first in range(0, len(which), BLOCK):
        checkpoint()
        yield which[first : first + BLOCK]


def _deviation(judged: tuple[Judged, Judged], paths: tuple[Toolpath, Toolpath]) -> Deviation | None:
    """Return the cut that is farthest from the other path's cuts."""
    found = None
    for number, (own, path) in enumerate(zip(judged, paths, strict=True)):
        alone = np.flatnonzero(own.cuts & ~own.common & np.isfinite(own.away_mm))
        if not len(alone):
            continue
        worst = alone[np.argmax(own.away_mm[alone])]
        distance_mm = float(own.away_mm[worst])
        if found is None or distance_mm > found.distance_mm:
            x, y, z = own.places_mm[worst].tolist()
            line = int(path.table().line[own.pieces.row[worst]])
            found = Deviation(distance_mm, (x, y, z), number == 0, line)
    return found
